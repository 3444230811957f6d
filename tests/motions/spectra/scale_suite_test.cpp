// Suites scaled to a target spectrum.
#include "motions/spectra/scale_suite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/spectra/code_spectra.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

TEST(SuiteFactors, AreThoseOfTheTableWorkedByHand) {
  Eigen::ArrayXXd spectra(3, 3);  // a row per period
  spectra << 0.9, 1.5, 0.7, 0.6, 0.8, 0.7, 0.4, 0.3, 0.5;
  const Eigen::Array3d target{1.2, 0.8, 0.5}, ones = Eigen::Array3d::Ones();
  const auto expect = [&](OwnFactor kind, double fraction, const std::vector<double>& own, double common,
                          int governing) {
    const SuiteFactors factors = suite_factors(spectra, target, fraction * target, ones, kind);
    for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(factors.own[i], own[static_cast<std::size_t>(i)], 1e-8);
    EXPECT_NEAR(factors.common, common, 1e-8);
    EXPECT_EQ(factors.governing, governing);
  };
  expect(OwnFactor::logarithmic, 1.0, {1.30495588, 1.10064242, 1.25129118}, 1.01500813, 2);
  expect(OwnFactor::logarithmic, 0.9, {1.30495588, 1.10064242, 1.25129118}, 0.91350732, 2);
  expect(OwnFactor::linear, 1.0, {1.32330827, 0.86912752, 1.34146341}, 1.04843382, 0);
  // A weight on one period alone fits every pair there; the common factor still serves the other periods.
  const SuiteFactors one =
      suite_factors(spectra, target, target, Eigen::Array3d{0.0, 2.0, 0.0}, OwnFactor::logarithmic);
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(one.own[i], 0.8 / spectra(1, i), 1e-15);
  EXPECT_GE(one.common, 1.0);
}

PlanMotion pair_of(double period, double across) {
  const auto pulse = [](double of) {
    return near_fault_pulse({.pulse_period = of * s, .time_step = 0.02 * s, .quiet_after = 1 * s});
  };
  return {pulse(period), pulse(0.7 * period).scaled_by(across)};
}

std::vector<NamedPair> suite_of_seven() {
  std::vector<NamedPair> pairs;
  for (int i = 0; i < 7; ++i) pairs.push_back({"record " + std::to_string(i), pair_of(1.3 + 0.3 * i, 0.4 + 0.1 * i)});
  return pairs;
}

const TargetSpectrum mce_r = Asce7Spectrum{.s_ds = 1.0, .s_d1 = 0.6, .long_period = 8 * s}.mce_r();
const SuiteScaling asce_7_16 = SuiteScaling::asce_7_16(2.16 * s, 2.82 * s);

// The mean of a spectrum of the scaled pairs over the target: least and largest in the range.
std::pair<double, double> ratios(const ScaledSuite& suite, PairSpectrum kind) {
  std::vector<double> mean(suite.periods.size(), 0.0);
  for (const NamedPair& pair : suite.pairs) {
    const auto values = pair_spectra(pair.motion, suite.periods, 0.05).of(kind);
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += values[k] / static_cast<double>(suite.pairs.size());
  }
  double least = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (std::size_t k = 0; k < mean.size(); ++k) {
    const double ratio = mean[k] / suite.target.acceleration(suite.periods[k]).si();
    least = std::min(least, ratio);
    largest = std::max(largest, ratio);
  }
  return {least, largest};
}

TEST(ScaleSuite, LiftsTheMeanToTheFractionOverTheRange) {
  for (const SuiteScaling& scaling :
       {asce_7_16, SuiteScaling::asce_7_22(2.16 * s, 2.82 * s), SuiteScaling::asce_7_10(2 * s, 2.5 * s),
        SuiteScaling::asce_7_ch16(1 * s, 2 * s)}) {
    const ScaledSuite suite = scale_suite(suite_of_seven(), mce_r, scaling);
    const auto [least, largest] = ratios(suite, scaling.spectrum);
    EXPECT_NEAR(least, scaling.fraction, 1e-9) << scaling.name;
    EXPECT_NEAR(suite.least_ratio, least, 1e-9);
    EXPECT_NEAR(suite.largest_ratio, largest, 1e-9);
    EXPECT_NEAR(suite.least_srss_ratio, ratios(suite, PairSpectrum::srss).first, 1e-9);
    EXPECT_NEAR(suite.least_rotd100_ratio, ratios(suite, PairSpectrum::rotd100).first, 1e-9);
    EXPECT_LE(suite.least_rotd100_ratio, suite.least_srss_ratio);
    EXPECT_EQ(suite.periods.front(), scaling.shortest);
    EXPECT_EQ(suite.periods.back(), scaling.longest);
  }
}

// A record that is the target but for a factor q has the own factor 1/q.
TEST(ScaleSuite, OfEqualRecordsTakesOutTheirFactors) {
  const NamedPair unit{"one", pair_of(1.3, 0.5)};
  const std::vector<Time> grid = periods_between(asce_7_16.shortest, asce_7_16.longest);
  SpectrumTable own{.name = "its spectrum", .periods = grid, .accelerations = {}};
  for (const double value : pair_spectra(unit.motion, grid).srss) own.accelerations.emplace_back(value);
  for (const OwnFactor kind : {OwnFactor::logarithmic, OwnFactor::linear}) {
    SuiteScaling scaling = asce_7_16;
    scaling.own_factor = kind;
    const ScaledSuite suite =
        scale_suite({unit, {"two", unit.motion.scaled_by(0.4)}, {"three", unit.motion.scaled_by(-3.0)}}, own, scaling);
    EXPECT_NEAR(suite.own_factors[0], 1.0, 1e-9);
    EXPECT_NEAR(suite.own_factors[1], 2.5, 1e-9);
    EXPECT_NEAR(suite.own_factors[2], 1.0 / 3.0, 1e-9);
    EXPECT_NEAR(suite.common_factor, 1.0, 1e-9);
    EXPECT_NEAR(suite.largest_ratio, 1.0, 1e-9);
  }
}

TEST(ScaleSuite, GivesTheSameMotionsWhateverTheRecordsAreMultipliedBy) {
  const std::vector<NamedPair> pairs = suite_of_seven();
  std::vector<NamedPair> multiplied = pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    multiplied[i].motion = pairs[i].motion.scaled_by(std::pow(1.7, static_cast<double>(i) - 3.0));
  for (const OwnFactor kind : {OwnFactor::logarithmic, OwnFactor::linear}) {
    SuiteScaling scaling = asce_7_16;
    scaling.own_factor = kind;
    const auto factors = scale_suite(pairs, mce_r, scaling).factors(),
               others = scale_suite(multiplied, mce_r, scaling).factors();
    for (std::size_t i = 0; i < factors.size(); ++i)
      EXPECT_NEAR(others[i] * std::pow(1.7, static_cast<double>(i) - 3.0) / factors[i], 1.0, 1e-12);
  }
}

TEST(ScaleSuite, HasOneFactorForAllComponents) {
  std::vector<NamedPair> pairs = suite_of_seven();
  pairs[2].motion.vertical = pairs[3].motion.first;
  const ScaledSuite suite = scale_suite(pairs, mce_r, asce_7_16);
  const double factor = suite.factors()[2];
  EXPECT_NEAR(factor, suite.common_factor * suite.own_factors[2], 1e-15);
  EXPECT_EQ(suite.pairs[2].name, "record 2");
  EXPECT_NEAR(suite.pairs[2].motion.first.scale_factor() / pairs[2].motion.first.scale_factor(), factor, 1e-14);
  EXPECT_NEAR(suite.pairs[2].motion.second.scale_factor() / pairs[2].motion.second.scale_factor(), factor, 1e-14);
  EXPECT_NEAR(suite.pairs[2].motion.vertical->scale_factor() / pairs[2].motion.vertical->scale_factor(), factor, 1e-14);
}

TEST(ScaleSuite, TakesAWeightAndOnlyLiftsWhereItIsAskedTo) {
  SuiteScaling scaling = asce_7_16;
  scaling.fraction = 0.1;
  EXPECT_LT(scale_suite(suite_of_seven(), mce_r, scaling).common_factor, 1.0);
  scaling.only_up = true;
  const ScaledSuite up = scale_suite(suite_of_seven(), mce_r, scaling);
  EXPECT_EQ(up.common_factor, 1.0);
  EXPECT_GT(up.least_ratio, 0.1);
  // All the weight at the end of the range: every pair has the target there.
  scaling.weight = [](Time period) { return period > 3.5 * s ? 1.0 : 0.0; };
  const ScaledSuite at_end = scale_suite(suite_of_seven(), mce_r, scaling);
  for (const NamedPair& pair : at_end.pairs)
    EXPECT_NEAR(pair_spectra(pair.motion, std::vector{3.525 * s}).srss[0] / mce_r.acceleration(3.525 * s).si(), 1.0,
                0.03);
}

TEST(ScaleSuite, OfEn1998ReachesTheGroundAccelerationToo) {
  const TargetSpectrum target = En1998Spectrum{.ground_acceleration = 0.3 * g, .ground = 'C'};
  const ScaledSuite suite = scale_suite(suite_of_seven(), target, SuiteScaling::en_1998_1(1.5 * s));
  const auto mean_at_0 = [](const ScaledSuite& scaled) {
    double sum = 0.0;
    for (const NamedPair& pair : scaled.pairs) sum += pair.motion.first.peak_acceleration().si();
    return sum / static_cast<double>(scaled.pairs.size());
  };
  EXPECT_NEAR(suite.scaling.shortest.si(), 0.3, 1e-15);
  EXPECT_EQ(suite.scaling.longest, 3 * s);
  EXPECT_GE(mean_at_0(suite), 0.345 * g.si() * (1.0 - 1e-9));
  EXPECT_GE(suite.least_ratio, 0.9 * (1.0 - 1e-9));
  EXPECT_EQ(suite.periods.back(), 3 * s);
  // Of long pulses alone the ground acceleration governs.
  const std::vector<NamedPair> slow{{"slow", pair_of(4.0, 1.0)}};
  const ScaledSuite governed = scale_suite(slow, target, SuiteScaling::en_1998_1(1.9 * s));
  SuiteScaling without = SuiteScaling::en_1998_1(1.9 * s);
  without.mean_at_zero = false;
  const ScaledSuite free = scale_suite(slow, target, without);
  if (governed.governing_period == 0 * s)
    EXPECT_NEAR(mean_at_0(governed), 0.345 * g.si(), 1e-9);
  else
    EXPECT_EQ(governed.common_factor, free.common_factor);
}

// Records whose second component is the weaker one: it governs, not `first`.
TEST(ScaleSuite, OfEn1998LiftsTheMeanOfEachComponent) {
  const TargetSpectrum target = En1998Spectrum{.ground_acceleration = 0.3 * g, .ground = 'C'};
  std::vector<NamedPair> pairs;
  for (int i = 0; i < 7; ++i) {
    const GroundMotion first = pair_of(1.3 + 0.3 * i, 1.0).first;
    pairs.push_back({"record " + std::to_string(i), PlanMotion{first, first.scaled_by(0.4)}});
  }
  SuiteScaling scaling = SuiteScaling::en_1998_1(1.4 * s, 1.8 * s);
  EXPECT_NEAR(scaling.shortest.si(), 0.28, 1e-15);
  EXPECT_NEAR(scaling.longest.si(), 3.6, 1e-15);
  scaling.mean_at_zero = false;
  const ScaledSuite suite = scale_suite(pairs, target, scaling);
  const auto [least, largest] = ratios(suite, PairSpectrum::second);
  EXPECT_NEAR(least, 0.9, 1e-9);
  EXPECT_NEAR(suite.least_ratio, least, 1e-9);
  EXPECT_NEAR(suite.largest_ratio, largest / 0.4, 1e-9) << "that of the first";
  // Own factors fit both: f = exp(mean(ln t - ln S)/2 + mean(ln t - ln 0.4 S)/2) = f(first)/sqrt(0.4).
  scaling.spectrum = PairSpectrum::first;
  const ScaledSuite one = scale_suite(pairs, target, scaling);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    EXPECT_NEAR(suite.own_factors[i] / one.own_factors[i], 1.0 / std::sqrt(0.4), 1e-9);
  EXPECT_NEAR(suite.factors()[0] / one.factors()[0], 1.0 / 0.4, 1e-9);
  EXPECT_EQ(suite.governing_period, one.governing_period);
  EXPECT_EQ(suite.description()[2].substr(0, 19), "Mean each component");
  pairs[0].motion.second = pairs[0].motion.second.scaled_by(0.0);
  EXPECT_EQ(message_of([&] { (void)scale_suite(pairs, target, SuiteScaling::en_1998_1(1.5 * s)); }),
            "scale_suite \"EN 1998-1\": pair record 0 has no motion in the range in one of its components. Leave it "
            "out, or set `spectrum`.");
}

TEST(ScaleSuite, SaysWhereItsRuleComesFrom) {
  const ScaledSuite suite = scale_suite(suite_of_seven(), mce_r, SuiteScaling::asce_7_22(2.16 * s, 2.82 * s));
  const std::vector<std::string> lines = suite.description();
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0],
            "Scaling by ASCE 7-22: ASCE/SEI 7-22 17.3 with 16.2.3.2; range recalled, not read in the code, fraction as "
            "in the program QuakeManager");
  EXPECT_EQ(lines[1].substr(0, 22), "Target: ASCE 7 MCE_R: ");
  EXPECT_EQ(lines[2], "Mean RotD100 of 7 records >= 0.9 target from 1.62 to 3.525 s, damping 5 %");
  EXPECT_EQ(asce_7_16.source, "ASCE/SEI 7-16 17.3.3; range and fraction recalled, not read in the code");
}

TEST(ScaleSuite, WarnsOfFewRecordsAndLargeFactors) {
  std::vector<NamedPair> pairs = suite_of_seven();
  for (const std::string& warning : scale_suite(pairs, mce_r, asce_7_16).warnings) ADD_FAILURE() << warning;
  SuiteScaling chapter_16 = SuiteScaling::asce_7_ch16(2 * s, 2.5 * s);
  ASSERT_FALSE(scale_suite(pairs, mce_r, chapter_16).warnings.empty());
  EXPECT_EQ(scale_suite(pairs, mce_r, chapter_16).warnings.back(),
            "Only 7 records: ASCE 7 chapter 16 asks for 11. The design value of a response is the mean of at least 7, "
            "else the "
            "largest.");
  pairs.erase(pairs.begin() + 5, pairs.end());
  pairs[1].motion = pairs[1].motion.scaled_by(0.01);
  const ScaledSuite suite = scale_suite(pairs, mce_r, asce_7_16);
  ASSERT_EQ(suite.warnings.size(), 2u);
  EXPECT_EQ(suite.warnings[0], "The factor " + to_text(suite.factors()[1]) + " of record 1 is outside 0.25 to 4.");
  EXPECT_EQ(suite.warnings[1],
            "Only 5 records: ASCE 7-16 asks for 7. The design value of a response is the mean of at least 7, else the "
            "largest.");
  SuiteScaling wide = asce_7_16;
  wide.allowed = {0.001, 1000.0};
  EXPECT_EQ(scale_suite(pairs, mce_r, wide).warnings.size(), 1u);
}

TEST(ScaleSuite, RefusesBadInput) {
  EXPECT_EQ(message_of([] { (void)SuiteScaling::asce_7_16(2.82 * s, 2.16 * s); }),
            "SuiteScaling \"ASCE 7-16\": the first period, 2.82 s, is longer than the second, 2.16 s. T_M of upper "
            "bounds is the shorter.");
  const auto message = [](auto change) {
    std::vector<NamedPair> pairs = suite_of_seven();
    SuiteScaling scaling = asce_7_16;
    TargetSpectrum target = mce_r;
    change(pairs, scaling, target);
    return message_of([&] { (void)scale_suite(pairs, target, scaling); });
  };
  using Pairs = std::vector<NamedPair>;
  using Rule = SuiteScaling;
  using Target = TargetSpectrum;
  EXPECT_EQ(message([](Pairs& pairs, Rule&, Target&) { pairs.clear(); }),
            "scale_suite \"ASCE 7-16\": the suite has no records. Give at least one pair.");
  EXPECT_EQ(message([](Pairs& pairs, Rule&, Target&) { pairs[3].name = pairs[0].name; }),
            "scale_suite \"ASCE 7-16\": two records have the name record 0. Name them apart.");
  EXPECT_NE(message([](Pairs& pairs, Rule&, Target&) { pairs[3].name = "=1"; }).find("begins with"), std::string::npos);
  EXPECT_EQ(message([](Pairs& pairs, Rule&, Target&) { pairs[3].motion = pairs[3].motion.scaled_by(0.0); }),
            "scale_suite \"ASCE 7-16\": pair record 3 has no motion in the range. Leave it out.");
  EXPECT_EQ(message([](Pairs&, Rule& rule, Target&) {
              rule.shortest = 3.5 * s;
              rule.longest = 1.6 * s;
            }),
            "scale_suite \"ASCE 7-16\": the range of scaling, 3.5 to 1.6 s, ends before it begins. T_M of upper bounds "
            "is the shorter.");
  EXPECT_NE(message([](Pairs&, Rule& rule, Target&) { rule = {}; }).find("shortest = 0 s"), std::string::npos);
  EXPECT_NE(message([](Pairs&, Rule& rule, Target&) { rule.fraction = 0.0; }).find("fraction = 0"), std::string::npos);
  EXPECT_NE(message([](Pairs&, Rule& rule, Target&) {
              rule.weight = [](Time) { return -1.0; };
            }).find("weight at 1.62 s = -1"),
            std::string::npos);
  EXPECT_EQ(message([](Pairs&, Rule& rule, Target&) { rule.weight = [](Time) { return 0.0; }; }),
            "scale_suite \"ASCE 7-16\": all weights are zero. Give a weight > 0 to a period of the range.");
  EXPECT_NE(message([](Pairs&, Rule& rule, Target& target) {
              rule.longest = 5 * s;
              target = En1998Spectrum{.ground_acceleration = 0.3 * g, .ground = 'C'};
            }).find("must be from 0 s to 4 s. Set beyond_4_s"),
            std::string::npos);
  EXPECT_NE(message([](Pairs&, Rule&, Target& target) { target.damping_ratio = 5; }).find("Give 5 % as 0.05."),
            std::string::npos);
}

}  // namespace
}  // namespace moat
