// Spectra of codes, against ordinates worked by hand from their formulas.
#include "motions/spectra/code_spectra.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/units.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;
using Ordinates = std::vector<std::pair<double, double>>;  // s, g

void expect_ordinates(const TargetSpectrum& spectrum, const Ordinates& ordinates, double accuracy = 1e-7) {
  for (const auto& [period, value] : ordinates)
    EXPECT_NEAR(spectrum.acceleration(period * s) / g / value, 1.0, accuracy) << spectrum.name << ' ' << period;
}

// No branch jumps at a corner.
void expect_continuous(const TargetSpectrum& spectrum) {
  for (const Time corner : spectrum.corners) {
    if (corner == spectrum.longest) continue;
    EXPECT_NEAR(spectrum.acceleration((1.0 - 1e-9) * corner) / spectrum.acceleration((1.0 + 1e-9) * corner), 1.0, 1e-7)
        << spectrum.name << ' ' << corner.si();
  }
}

const Asce7Spectrum asce_7{.s_ds = 1.0, .s_d1 = 0.6, .long_period = 8 * s};

TEST(Asce7Spectrum, HasTheOrdinatesOfItsBranches) {
  const Ordinates ordinates{{0.0, 0.4}, {0.05, 0.65}, {0.3, 1.0}, {3.0, 0.2}, {10.0, 0.048}, {20.0, 0.012}};
  expect_ordinates(asce_7.design(), ordinates);
  for (const auto& [period, value] : ordinates) expect_ordinates(asce_7.mce_r(), {{period, 1.5 * value}});
  expect_continuous(asce_7.design());
  static_assert(!std::is_convertible_v<Asce7Spectrum, TargetSpectrum>, "a script says design or MCE_R");
  const TargetSpectrum spectrum = asce_7.mce_r();
  EXPECT_EQ(spectrum.name, "ASCE 7 MCE_R");
  EXPECT_NE(spectrum.source.find("recalled, not read in the code"), std::string::npos);
  EXPECT_EQ(spectrum.damping_ratio, 0.05);
  ASSERT_EQ(spectrum.corners.size(), 3u);
  EXPECT_NEAR(spectrum.corners[0].si(), 0.12, 1e-15);
  EXPECT_NEAR(spectrum.corners[1].si(), 0.6, 1e-15);
  EXPECT_EQ(spectrum.corners[2], 8 * s);
}

// S_a falls straight from 2 g at 0.1 s to 1.6 g at 0.3 s, to 1.2 g at 1 s, to 0.5 g at 5 s: at 0.2 s 1.8 g. On [1, 5]
// S_a = 1.375 - 0.175 T, so that T S_a is largest at 3.92857 s with 2.70089, on [1, 2] at 2 s with 2.05.
TEST(Asce7Parameters, AreThoseOfTheTableWorkedByHand) {
  const SpectrumTable table{.name = "site",
                            .periods = {0 * s, 0.1 * s, 0.3 * s, 1 * s, 5 * s},
                            .accelerations = {0.8 * g, 2 * g, 1.6 * g, 1.2 * g, 0.5 * g}};
  const auto of = [&](const SpectrumTable& each, SpectrumLevel level, double velocity) {
    return asce_7_parameters(each, level, velocity * m / s, 8 * s);
  };
  const Asce7Spectrum soft = of(table, SpectrumLevel::mce_r, 442), stiff = of(table, SpectrumLevel::mce_r, 443);
  EXPECT_NEAR(soft.s_ds, 2.0 / 3.0 * 0.9 * 1.8, 1e-9);
  EXPECT_NEAR(soft.s_d1, 2.0 / 3.0 * 0.9 * 1.375 * 1.375 / 0.7, 1e-6);
  EXPECT_NEAR(stiff.s_ds, soft.s_ds, 1e-15);
  EXPECT_NEAR(stiff.s_d1, 2.0 / 3.0 * 0.9 * 2.05, 1e-9);
  EXPECT_EQ(soft.long_period.value(), 8 * s);
  const Asce7Spectrum design = of(table, SpectrumLevel::design, 443);
  EXPECT_NEAR(design.s_ds, 1.5 * stiff.s_ds, 1e-12);
  EXPECT_NEAR(design.s_d1, 1.5 * stiff.s_d1, 1e-12);
  // Falling faster than 1/T: all of S_a(1 s), where T S_a would give 0.9 of it.
  SpectrumTable steep = table;
  steep.accelerations[4] = 0.01 * g;
  steep.periods = {0 * s, 0.1 * s, 0.3 * s, 1 * s, 5 * s};
  steep.periods.insert(steep.periods.begin() + 4, 1.5 * s);
  steep.accelerations.insert(steep.accelerations.begin() + 4, 0.4 * g);
  EXPECT_NEAR(of(steep, SpectrumLevel::mce_r, 200).s_d1, 2.0 / 3.0 * 1.2, 1e-12);
}

TEST(Asce7Parameters, NeedTheWholeRangeAndAVelocity) {
  SpectrumTable table{.name = "short", .periods = {0.1 * s, 4 * s}, .accelerations = {1 * g, 0.2 * g}};
  EXPECT_NE(message_of([&] {
              (void)asce_7_parameters(table, SpectrumLevel::mce_r, 300 * m / s, 8 * s);
            }).find("TargetSpectrum \"short\": period = 5 s"),
            std::string::npos);
  table.periods.back() = 6 * s;
  EXPECT_NE(message_of([&] {
              (void)asce_7_parameters(table, SpectrumLevel::mce_r, 0 * m / s, 8 * s);
            }).find("asce_7_parameters \"short\": shear_wave_velocity = 0 m/s"),
            std::string::npos);
}

TEST(En1998Spectrum, HasTheOrdinatesOfItsBranches) {
  const auto type_1 = [](double ratio) {
    return En1998Spectrum{.ground_acceleration = 0.3 * g, .ground = 'C', .damping_ratio = ratio};
  };
  expect_ordinates(type_1(0.05), {{0.0, 0.345}, {0.1, 0.60375}, {1.0, 0.5175}, {3.0, 0.115}, {4.0, 0.0646875}});
  expect_ordinates(type_1(0.20), {{0.1, 0.4452464}, {1.0, 0.3272957}, {3.0, 0.0727324}}, 5e-7);
  expect_ordinates(type_1(0.30), {{3.0, 0.06325}});
  expect_ordinates(En1998Spectrum{.ground_acceleration = 0.3 * g, .type = 2, .ground = 'B'},
                   {{0.1, 1.0125}, {1.0, 0.253125}, {3.0, 0.03375}});
  // Vertical, by hand: a_vg 0.27 and 0.135 g, plateau 3, corners 0.05, 0.15 and 1 s.
  expect_ordinates(En1998Spectrum{.ground_acceleration = 0.3 * g, .vertical = true},
                   {{0.0, 0.27}, {0.025, 0.54}, {0.1, 0.81}, {0.5, 0.243}, {2.0, 0.030375}});
  expect_ordinates(En1998Spectrum{.ground_acceleration = 0.3 * g, .type = 2, .vertical = true}, {{0.1, 0.405}});
  EXPECT_EQ(static_cast<TargetSpectrum>(type_1(0.05)).name, "EN 1998-1 type 1, ground C");
  EXPECT_EQ(static_cast<TargetSpectrum>(type_1(0.05)).source.find("recalled"), std::string::npos);
}

TEST(En1998Spectrum, HasTheRecommendedShapesOfBothTypes) {
  // S from T = 0, T_B and T_C from the ends of the plateau, T_D from the last branch.
  const double shapes[2][5][4]{{{1.0, 0.15, 0.4, 2.0},
                                {1.2, 0.15, 0.5, 2.0},
                                {1.15, 0.2, 0.6, 2.0},
                                {1.35, 0.2, 0.8, 2.0},
                                {1.4, 0.15, 0.5, 2.0}},
                               {{1.0, 0.05, 0.25, 1.2},
                                {1.35, 0.05, 0.25, 1.2},
                                {1.5, 0.1, 0.25, 1.2},
                                {1.8, 0.1, 0.3, 1.2},
                                {1.6, 0.05, 0.25, 1.2}}};
  for (const int type : {1, 2})
    for (const char ground : {'A', 'B', 'C', 'D', 'E'}) {
      const TargetSpectrum spectrum = En1998Spectrum{.ground_acceleration = 1 * g, .type = type, .ground = ground};
      const auto& [soil, t_b, t_c, t_d] = shapes[type - 1][ground - 'A'];
      expect_ordinates(spectrum, {{0.0, soil},
                                  {0.5 * t_b, soil * 1.75},
                                  {t_b, 2.5 * soil},
                                  {t_c, 2.5 * soil},
                                  {t_d, 2.5 * soil * t_c / t_d},
                                  {4.0, 2.5 * soil * t_c * t_d / 16.0}});
      expect_continuous(spectrum);
    }
}

TEST(En1998Spectrum, TakesParametersOneByOneAndAnnexA) {
  expect_ordinates(
      En1998Spectrum{.ground_acceleration = 0.2 * g,
                     .shape = En1998Shape{.soil_factor = 1.3, .t_b = 0.1 * s, .t_c = 0.45 * s, .t_d = 2.5 * s}},
      {{0.05, 0.455}, {0.3, 0.65}, {0.9, 0.325}, {3.0, 0.08125}});
  const En1998Spectrum beyond{.ground_acceleration = 0.3 * g, .ground = 'C', .damping_ratio = 0.2, .beyond_4_s = true};
  const TargetSpectrum spectrum = beyond;
  // 2.5 eta = 1.5811388; at 8 s halfway between T_E and T_F, at T_F the displacement of the ground.
  const auto displacement = [&](double t) { return spectrum.acceleration(t * s).si() * t * t / (4.0 * pi * pi); };
  const double ground = 0.025 * 0.3 * g.si() * 1.15 * 0.6 * 2.0, plateau = 2.5 * std::sqrt(0.4);
  EXPECT_NEAR(displacement(8.0) / (ground * 0.5 * (plateau + 1.0)), 1.0, 1e-12);
  EXPECT_NEAR(displacement(10.0) / ground, 1.0, 1e-12);
  // 0.025 stands for 1/(4 pi^2) = 0.02533: the code itself jumps at T_E.
  EXPECT_NEAR(displacement(5.0) / (ground * plateau), 1.0, 0.014);
  EXPECT_NE(spectrum.source.find("annex A, recalled, not read in the code"), std::string::npos);
}

TEST(Gb50011Spectrum, HasTheOrdinatesOfItsBranches) {
  const auto rare = [](double ratio, bool isolation = false) {
    return Gb50011Spectrum{
        .alpha_max = 0.9, .characteristic_period = 0.45 * s, .damping_ratio = ratio, .isolation = isolation};
  };
  expect_ordinates(rare(0.05),
                   {{0.0, 0.405}, {0.05, 0.6525}, {0.2, 0.9}, {1.0, 0.4386658}, {3.0, 0.1979314}, {5.0, 0.1619314}},
                   5e-7);
  expect_ordinates(rare(0.2), {{0.05, 0.48375}, {1.0, 0.2969563}, {3.0, 0.1514552}}, 5e-7);
  expect_ordinates(rare(0.1, true), {{3.0, 0.1435621}}, 5e-7);
  expect_continuous(rare(0.2));
  // eta_2 >= 0.55, eta_1 >= 0.
  expect_ordinates(rare(0.7), {{0.2, 0.55 * 0.9}});
  const TargetSpectrum damped = rare(0.7);
  EXPECT_EQ(damped.acceleration(3 * s), damped.acceleration(5 * s));
  EXPECT_NE(static_cast<TargetSpectrum>(rare(0.1, true)).source.find("recalled"), std::string::npos);
}

TEST(CodeSpectra, RefusePeriodsOutsideTheirRange) {
  const auto message = [](const TargetSpectrum& spectrum, Time period) {
    return message_of([&] { (void)spectrum.acceleration(period); });
  };
  En1998Spectrum en{.ground_acceleration = 0.3 * g, .ground = 'C'};
  EXPECT_EQ(message(en, 12 * s),
            "TargetSpectrum \"EN 1998-1 type 1, ground C\": period = 12 s is not allowed; it must be from 0 s to 4 s. "
            "Set beyond_4_s, which takes annex A, to 10 s.");
  en.beyond_4_s = true;
  EXPECT_EQ(message(en, 12 * s),
            "TargetSpectrum \"EN 1998-1 type 1, ground C\": period = 12 s is not allowed; it must be from 0 s to 10 s. "
            "Check its sign and its unit.");
  EXPECT_NE(
      message(Gb50011Spectrum{.alpha_max = 0.9, .characteristic_period = 0.4 * s}, 6.1 * s).find("from 0 s to 6 s"),
      std::string::npos);
  EXPECT_EQ(message(asce_7.design(), -1 * s),
            "TargetSpectrum \"ASCE 7 design\": period = -1 s is not allowed; it must be >= 0 s. Check its sign and its "
            "unit.");
}

TEST(CodeSpectra, RefuseBadParameters) {
  const auto asce = [](double s_ds, double s_d1, Time long_period) {
    return message_of([&] { (void)Asce7Spectrum{.s_ds = s_ds, .s_d1 = s_d1, .long_period = long_period}.design(); });
  };
  EXPECT_EQ(asce(100, 60, 8 * s),
            "Asce7Spectrum: s_ds = 100 is not allowed; it must be > 0 and <= 10. Give a fraction of g.");
  EXPECT_EQ(asce(1, 60, 8 * s),
            "Asce7Spectrum: s_d1 = 60 is not allowed; it must be > 0 and <= 10. Give a fraction of g.");
  EXPECT_EQ(asce(1, 6, 8 * s),
            "Asce7Spectrum: T_S = s_d1 / s_ds = 6 s is not allowed; it must be from 0.05 s to 3 s. Give fractions of "
            "g.");
  EXPECT_EQ(asce(1, 0.6, 0.4 * s),
            "Asce7Spectrum: long_period = 0.4 s is not allowed; it must be > T_S = 0.6 s and finite. Take T_L from the "
            "map of the code, 4 to 16 s.");

  const auto en = [](auto change) {
    En1998Spectrum spectrum{.ground_acceleration = 0.3 * g, .ground = 'C'};
    change(spectrum);
    return message_of([&] { (void)static_cast<TargetSpectrum>(spectrum); });
  };
  using En = En1998Spectrum;
  EXPECT_EQ(en([](En& each) { each.damping_ratio = 5; }),
            "En1998Spectrum: damping_ratio = 5 is not allowed; it must be >= 0 and < 1. Give 5 % as 0.05.");
  EXPECT_NE(en([](En& each) { each.ground_acceleration = 30 * g; }).find("Give it as 0.3 * g."), std::string::npos);
  EXPECT_EQ(en([](En& each) { each.type = 3; }),
            "En1998Spectrum: type = 3 is not allowed; it must be 1 or 2. Give a number in this range.");
  EXPECT_EQ(en([](En& each) { each.ground = 'S'; }),
            "En1998Spectrum: its ground is not A, B, C, D or E. Give a shape for ground S1 or S2.");
  EXPECT_EQ(en([](En& each) { each.ground.reset(); }), "En1998Spectrum: the ground is missing. Give .ground = 'C'.");
  EXPECT_EQ(en([](En& each) { each.vertical = each.beyond_4_s = true; }),
            "En1998Spectrum: a vertical spectrum has neither shape nor annex A. Leave out shape and beyond_4_s.");
  const auto shape = [&](double soil, Time t_b, Time t_c) {
    return en([&](En& each) { each.shape = En1998Shape{.soil_factor = soil, .t_b = t_b, .t_c = t_c, .t_d = 2 * s}; });
  };
  EXPECT_EQ(shape(1, 0.5 * s, 0.4 * s),
            "En1998Spectrum: T_B, T_C, T_D = 0.5, 0.4, 2 s do not increase from above 0 s to at most 4 s. "
            "Give the corners of the national annex in their order.");
  EXPECT_EQ(shape(0, 0.1 * s, 0.4 * s),
            "En1998Spectrum: soil_factor = 0 is not allowed; it must be > 0 and <= 10. Give a number in this range.");

  const auto gb = [](double alpha_max, Time period, double ratio) {
    return message_of([&] {
      (void)static_cast<TargetSpectrum>(
          Gb50011Spectrum{.alpha_max = alpha_max, .characteristic_period = period, .damping_ratio = ratio});
    });
  };
  EXPECT_NE(gb(90, 0.4 * s, 0.05).find("alpha_max = 90 is not allowed"), std::string::npos);
  EXPECT_NE(gb(0.9, 2 * s, 0.05).find("characteristic_period = 2 s is not allowed"), std::string::npos);
  EXPECT_NE(gb(0.9, 0.4 * s, 5).find("Give 5 % as 0.05."), std::string::npos);
}

}  // namespace
}  // namespace moat
