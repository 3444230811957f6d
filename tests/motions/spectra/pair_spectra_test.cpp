// Spectra of two components.
#include "motions/spectra/pair_spectra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <random>
#include <vector>

#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/readers/read_motion.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

GroundMotion noise(const char* name, double step, std::size_t count, unsigned seed) {
  std::mt19937 generator{seed};
  std::normal_distribution<double> normal;
  std::vector<double> samples(count);
  double filtered = 0.0;
  for (double& sample : samples) sample = filtered = 0.8 * filtered + normal(generator);
  samples.back() = 0.0;  // a shorter component then ends as it does alone
  return {name, step, samples};
}

const GroundMotion one = noise("one", 0.01, 400, 1), two = noise("two", 0.01, 300, 2);
const std::vector<Time> some_periods{0 * s, 0.03 * s, 0.2 * s, 0.7 * s, 2 * s};

// The displacements at 2000 instants of a period, of an oscillator by the method of Runge and Kutta of fourth order.
std::vector<double> displacements(const GroundMotion& motion, double period, double damping_ratio, double end) {
  const double w = 2.0 * pi / period, steps_of_sample = std::ceil(2000.0 * motion.time_step() / period);
  const double h = motion.time_step() / steps_of_sample;
  const auto acceleration = [&](double time, double u, double v) {
    return -motion.acceleration_at(time) - 2.0 * damping_ratio * w * v - w * w * u;
  };
  std::vector<double> all;
  double u = 0.0, v = 0.0;
  for (double i = 0.0; i * h < end + period; ++i) {
    // Never exactly on a sample, where the ground may jump at its end.
    const double t = i * h, left = t + 1e-9 * h, right = t + (1.0 - 1e-9) * h;
    const double v1 = v, a1 = acceleration(left, u, v1);
    const double v2 = v + 0.5 * h * a1, a2 = acceleration(t + 0.5 * h, u + 0.5 * h * v1, v2);
    const double v3 = v + 0.5 * h * a2, a3 = acceleration(t + 0.5 * h, u + 0.5 * h * v2, v3);
    const double v4 = v + h * a3, a4 = acceleration(right, u + h * v3, v4);
    u += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    all.push_back(u);
  }
  return all;
}

TEST(PairSpectra, AreThoseOfTheDefinitionAtEveryDegree) {
  for (const double ratio : {0.02, 0.05, 0.3}) {
    const std::vector<Time> periods{0.02 * s, 0.1 * s, 0.33 * s, 1 * s, 4 * s};
    const PairSpectra spectra = pair_spectra({one, two}, periods, ratio);
    for (std::size_t k = 0; k < periods.size(); ++k) {
      const double period = periods[k].si(), w = 2.0 * pi / period;
      const auto x = displacements(one, period, ratio, one.duration()),
                 y = displacements(two, period, ratio, one.duration());
      std::vector<double> along;
      for (int degree = 0; degree < 180; ++degree) {
        const double c = std::cos(degree * deg), sine = std::sin(degree * deg);
        double largest = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::abs(c * x[i] + sine * y[i]));
        along.push_back(w * w * largest);
      }
      EXPECT_NEAR(spectra.first[k] / along[0], 1.0, 1e-5) << period;
      EXPECT_NEAR(spectra.second[k] / along[90], 1.0, 1e-5) << period;
      EXPECT_NEAR(spectra.srss[k] / std::hypot(along[0], along[90]), 1.0, 1e-5) << period;
      EXPECT_NEAR(spectra.geometric_mean[k] / std::sqrt(along[0] * along[90]), 1.0, 1e-5) << period;
      std::sort(along.begin(), along.end());
      EXPECT_NEAR(spectra.rotd50[k] / (0.5 * (along[89] + along[90])), 1.0, 1e-5) << period;
      EXPECT_NEAR(spectra.rotd100[k] / along[179], 1.0, 1e-5) << period;
    }
  }
}

TEST(PairSpectra, OfOneComponentAndOfEqualOnesAreExact) {
  const auto alone = response_spectrum(one, some_periods, 0.05).pseudo_acceleration;
  const PairSpectra still = pair_spectra({one, one.scaled_by(0.0)}, some_periods),
                    equal = pair_spectra({one, one}, some_periods);
  for (std::size_t k = 0; k < alone.size(); ++k) {
    EXPECT_NEAR(still.first[k] / alone[k], 1.0, 1e-12);
    EXPECT_NEAR(still.rotd100[k] / alone[k], 1.0, 1e-12);
    EXPECT_NEAR(still.srss[k] / alone[k], 1.0, 1e-12);
    EXPECT_NEAR(still.geometric_mean[k], 0.0, 1e-7 * alone[k]);
    EXPECT_NEAR(equal.rotd100[k] / (std::sqrt(2.0) * alone[k]), 1.0, 1e-12);
    EXPECT_NEAR(equal.srss[k] / (std::sqrt(2.0) * alone[k]), 1.0, 1e-12);
    EXPECT_NEAR(still.rotd50[k] / alone[k], std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(equal.rotd50[k] / alone[k], 1.0, 1e-12);
  }
  EXPECT_EQ(still.period, (std::vector<double>{0.0, 0.03, 0.2, 0.7, 2.0}));
  EXPECT_EQ(still.damping_ratio, 0.05);
}

TEST(PairSpectra, InAllDirectionsDoNotDependOnTheAxes) {
  const PairSpectra spectra = pair_spectra({one, two}, some_periods);
  for (const double degrees : {17.0, 90.0, -120.0}) {
    const PairSpectra turned = pair_spectra({one, two, degrees * deg}, some_periods);
    for (std::size_t k = 0; k < some_periods.size(); ++k) {
      EXPECT_NEAR(turned.rotd50[k] / spectra.rotd50[k], 1.0, 1e-5);
      EXPECT_NEAR(turned.rotd100[k] / spectra.rotd100[k], 1.0, 1e-5);
      EXPECT_LE(turned.rotd100[k], turned.srss[k]);
      EXPECT_LE(turned.srss[k], std::sqrt(2.0) * turned.rotd100[k]);
      if (degrees == 17.0) {
        EXPECT_GT(std::abs(turned.srss[k] / spectra.srss[k] - 1.0), 1e-3);
      }
    }
  }
  // The vertical component does not count.
  EXPECT_EQ(pair_spectra({one, two, {}, one, 2.0}, some_periods).rotd100, spectra.rotd100);
}

TEST(PairSpectra, OfARecordAreThoseOfTwoOtherPrograms) {
  const char* folder = std::getenv("MOAT_RECORDS");
  if (!folder) GTEST_SKIP() << "set MOAT_RECORDS to a folder with PEER AT2 files to run this test";
  const std::filesystem::path first = std::filesystem::path{folder} / "RSN1044_NORTHR_NWH360.AT2",
                              second = std::filesystem::path{folder} / "RSN1044_NORTHR_NWH090.AT2";
  for (const auto& file : {first, second})
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file.filename() << " is not in the folder of MOAT_RECORDS";
  const std::vector<Time> periods{0.3 * s, 1 * s, 3 * s};
  const PairSpectra spectra = pair_spectra({read_motion(first), read_motion(second)}, periods);
  const double expected[][6]{{19.159136, 23.840122, 30.584700, 21.371854, 21.902353, 27.555803},
                             {11.447783, 7.1963174, 13.521787, 9.0764466, 9.8379891, 13.493391},
                             {1.8278669, 1.5130633, 2.3728586, 1.6630329, 1.5237992, 1.8415780}};
  for (std::size_t k = 0; k < periods.size(); ++k) {
    const double found[]{spectra.first[k],          spectra.second[k], spectra.srss[k],
                         spectra.geometric_mean[k], spectra.rotd50[k], spectra.rotd100[k]};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i] / expected[k][i], 1.0, 4e-6) << k << ' ' << i;
  }
}

TEST(PeriodsBetween, HaveEqualRatiosOfAtMostTwoPercent) {
  const std::vector<Time> periods = periods_between(0.5 * s, 3 * s);
  ASSERT_EQ(periods.size(), 92u);  // ceil(ln 6 / ln 1.02) + 1
  EXPECT_EQ(periods.front(), 0.5 * s);
  EXPECT_EQ(periods.back(), 3 * s);
  for (std::size_t i = 1; i < periods.size(); ++i)
    EXPECT_NEAR(periods[i] / periods[i - 1], std::pow(6.0, 1.0 / 91.0), 1e-12);
  const std::vector<Time> close = periods_between(1 * s, 1.001 * s);
  EXPECT_EQ(close, (std::vector{1 * s, 1.001 * s})) << "both ends at least";
  EXPECT_EQ(message_of([] { (void)periods_between(3 * s, 1 * s); }),
            "periods_between: longest = 1 s is not allowed; it must be > 3 s. Check its sign and its unit.");
}

TEST(PairSpectra, RefuseBadInput) {
  const auto message = [](const PlanMotion& motion, Time period, double ratio) {
    return message_of([&] { (void)pair_spectra(motion, std::vector{period}, ratio); });
  };
  EXPECT_EQ(message({one, two}, 1 * s, 5.0),
            "pair_spectra \"one + two\": damping_ratio = 5 is not allowed; it must be >= 0 and < 1. Give 5 % as 0.05.");
  EXPECT_EQ(message({one, two}, 1e-5 * s, 0.05),
            "pair_spectra \"one + two\": period = 1e-05 s is not allowed; it must be 0 s, or from 0.0001 s to 1000 s. "
            "Give 0 s for a rigid oscillator.");
  EXPECT_NE(message({one, GroundMotion{"odd", 0.015, {0.0, 1.0}}}, 1 * s, 0.05).find("do not divide each other"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
