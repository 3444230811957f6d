// Models of friction: their derivatives, and friction forces that rise with the normal force.
#include "materials/friction/friction_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "materials/friction/pressure_temperature_velocity.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Unfilled PTFE on polished steel: the row of pressures, MPa, and coefficients of Constantinou, Mokha & Reinhorn.
constexpr double pressures[] = {6.9, 13.8, 20.7, 44.9}, measured[] = {0.119, 0.087, 0.070, 0.057};

VelocityPressureDependent by_pressure() {
  return {.slow = 0.02,
          .at_zero_pressure = 0.165,
          .reduction = 0.109,
          .pressure_factor = 0.0657e-6 * m * m / N,
          .area = 0.1 * m * m,
          .rate = 28 * s / m};
}

VelocityForceDependent by_force() {
  return {.slow_at_reference = 0.05,
          .fast_at_reference = 0.08,
          .reference_force = 1 * MN,
          .slow_exponent = 0.8,
          .fast_exponent = 0.7,
          .rate = 25 * s / m};
}

KumarFriction kumar() {
  return {.reference_coefficient = 0.06, .reference_pressure = 50e6 * N / (m * m), .area = 0.02 * m * m};
}

std::vector<Friction> all_models() {
  return {0.05,
          VelocityDependent{.slow = 0.02, .fast = 0.07, .rate = 80 * s / m},
          by_pressure(),
          by_force(),
          kumar(),
          LomientoFriction{.at_zero_force = 0.1, .reference_force = 12 * MN},
          LubricatedPtfe{.area = 0.05 * m * m, .temperature_factor = 2.0 / 3.0}};
}

TEST(FrictionModels, HaveTheDerivativesOfTheirCoefficient) {
  for (const Friction& friction : all_models())
    for (const double speed : {0.0, 0.004, 0.05, 0.6})
      for (const double force : {0.3e6, 0.9e6, 2.6e6}) {
        const FrictionCoefficient mu = friction.at(speed, force);
        const double step = 1e-5 * force, way = 1e-6;
        const double by_n =
                         (friction.at(speed, force + step).value - friction.at(speed, force - step).value) / (2 * step),
                     by_v = (friction.at(speed + way, force).value - friction.at(speed - way, force).value) / (2 * way);
        EXPECT_NEAR(mu.by_force * force, by_n * force, 1e-9) << friction.parameters().front().name << " " << force;
        EXPECT_NEAR(mu.slope, by_v, 1e-7);
        EXPECT_EQ(friction.is_constant(), friction.at(0.0, force).value == friction.at(1.0, force).value);
      }
  PressureTemperatureVelocity heated{
      .reference_coefficient = 0.06, .reference_pressure = 50e6 * N / (m * m), .slider_radius = 0.2 * m};
  for (const double pressure : {1e6, 50e6, 130e6})
    EXPECT_NEAR(heated.pressure_factor(pressure) * heated.pressure_slope(),
                (heated.pressure_factor(pressure + 1e3) - heated.pressure_factor(pressure - 1e3)) / 2e3, 1e-15);
  heated.depends_on_pressure = false;
  EXPECT_EQ(heated.pressure_slope(), 0.0);
}

TEST(FrictionModels, AreTheirFormulas) {
  // To the last digit, at forces that do not change.
  const double force = 2.3e6, fading = std::exp(-28.0 * 0.03), power_fading = std::exp(-25.0 * 0.03);
  const double fast = 0.165 - 0.109 * std::tanh(0.0657e-6 * force / 0.1);
  EXPECT_EQ(by_pressure().at(0.03, force).value, fast - (fast - 0.02) * fading);
  EXPECT_EQ(by_pressure().at(0.03, force).slope, 28.0 * ((fast - 0.02) * fading));
  EXPECT_EQ(by_pressure().fast(force), fast);
  const double slow_power = 0.05 * std::pow(force / 1e6, 0.8 - 1.0),
               fast_power = 0.08 * std::pow(force / 1e6, 0.7 - 1.0);
  EXPECT_EQ(by_force().at(0.03, force).value, fast_power - (fast_power - slow_power) * power_fading);

  // 30 % less per 50 MPa; half of it at rest; the factors of the heated surface.
  EXPECT_NEAR(kumar().at(1e3, 1e6).value, 0.06, 1e-15);
  EXPECT_NEAR(kumar().at(1e3, 2e6).value, 0.06 * 0.7, 1e-15);
  EXPECT_NEAR(kumar().at(0.0, 2e6).value, 0.03 * 0.7, 1e-15);
  const PressureTemperatureVelocity heated{
      .reference_coefficient = 0.06, .reference_pressure = 50e6 * N / (m * m), .slider_radius = 0.2 * m};
  EXPECT_NEAR(kumar().at(0.013, 0.4e6).value, 0.06 * heated.pressure_factor(20e6) * heated.speed_factor(0.013), 1e-16);

  const LomientoFriction lomiento{.at_zero_force = 0.1, .reference_force = 12 * MN};
  EXPECT_NEAR(lomiento.at(0.4, 12e6).value, 0.1 / std::exp(1.0), 1e-16);

  // EN 1337-2: 0.08 up to 5 MPa, 0.03 from 30 MPa on, in between 1.2/(10 + p).
  const LubricatedPtfe ptfe{.area = 1 * m * m};
  const struct {
    double pressure, coefficient;
  } rows[] = {{0.0, 0.08}, {4.9, 0.08}, {5.0, 0.08}, {14.0, 0.05}, {20.0, 0.04}, {30.0, 0.03}, {60.0, 0.03}};
  for (const auto& row : rows) EXPECT_NEAR(ptfe.at(0.2, 1e6 * row.pressure).value, row.coefficient, 1e-15);
  EXPECT_NEAR((LubricatedPtfe{.area = 1 * m * m, .temperature_factor = 2.0 / 3.0}.at(0.0, 6e6).value), 0.05, 1e-15);
}

TEST(FrictionModels, FitTheMeasuredRow) {
  // The measured numbers have three digits.
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(by_pressure().fast(1e6 * pressures[i] * 0.1), measured[i], 0.0015) << pressures[i];
  // The power law of least squares in logarithms has the exponent 0.60.
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = std::log(pressures[i]), b = std::log(measured[i]);
    x += a / 4.0;
    y += b / 4.0;
    xx += a * a / 4.0;
    xy += a * b / 4.0;
  }
  EXPECT_NEAR(1.0 + (xy - x * y) / (xx - x * x), 0.60, 0.005);
}

TEST(FrictionModels, HaveAForceThatVanishesWithTheNormalForce) {
  for (const Friction& friction : all_models())
    for (const double speed : {0.0, 1.0}) {
      double last = 0.0;
      for (const double force : {1e-9, 1e-3, 1.0, 1e3, 1e5}) {
        const double limit = friction.at(speed, force).value * force;
        EXPECT_GT(limit, last);
        EXPECT_LE(limit, 10.0 * force);
        last = limit;
      }
      for (const double lifted : {0.0, -1e6}) {
        EXPECT_TRUE(std::isfinite(friction.at(speed, lifted).value));
        EXPECT_TRUE(std::isfinite(friction.at(speed, lifted).by_force));
      }
    }
  // Power law: the coefficient stays that of 1e-6 N_ref.
  EXPECT_NEAR(by_force().at(0.0, 0.0).value, 0.05 * std::pow(1e-6, -0.2), 1e-14);
  EXPECT_EQ(by_force().at(0.0, 0.5).by_force, 0.0);
  EXPECT_EQ(by_force().at(0.3, 1.0 - 1e-12).value, by_force().at(0.3, 0.0).value);
}

TEST(FrictionModels, MustRiseWithTheNormalForce) {
  const Check check{"FlatSlider", "corner"};
  for (const Friction& friction : all_models())
    EXPECT_EQ(message_of([&] { check_rising(check, friction, 0.8e6); }), "nothing was thrown");
  const Friction lomiento = LomientoFriction{.at_zero_force = 0.1, .reference_force = 12 * MN};
  EXPECT_EQ(message_of([&] { check_rising(check, lomiento, 3.99e6); }), "nothing was thrown");
  EXPECT_EQ(
      message_of([&] { check_rising(check, lomiento, 6e6); }),
      "FlatSlider \"corner\": its friction force falls where the normal force rises beyond 1.2e+07 N; it must rise "
      "up to three times the static weight, 6e+06 N. Take constants of friction that were measured up to that "
      "force.");
  // Kumar: up to 140.18 MPa, on 0.02 m^2 2.8037 MN.
  EXPECT_EQ(message_of([&] { check_rising(check, kumar(), 2.80e6 / 3.0); }), "nothing was thrown");
  EXPECT_NE(message_of([&] { check_rising(check, kumar(), 2.83e6 / 3.0); }), "nothing was thrown");
  // A reduction so quick that the force falls at low pressure.
  VelocityPressureDependent quick = by_pressure();
  quick.reduction = 0.16;
  quick.slow = 0.004;
  EXPECT_NE(message_of([&] { check_rising(check, Friction{quick}, 1e6); }), "nothing was thrown");
  const PressureTemperatureVelocity heated{
      .reference_coefficient = 0.06, .reference_pressure = 40e6 * N / (m * m), .slider_radius = 0.2 * m};
  EXPECT_EQ(message_of([&] { heated.check_rising(check, 46.7e6); }), "nothing was thrown");
  EXPECT_EQ(
      message_of([&] { heated.check_rising(check, 46.8e6); }),
      "FlatSlider \"corner\": static pressure = 4.68e+07 Pa is not allowed; it must be below 46.7 MPa. Beyond three "
      "times that the friction force would fall where the normal force rises.");
}

TEST(FrictionModels, RefuseBadConstants) {
  const Check check{"FlatSlider", "corner"};
  const auto refusal = [&](const Friction& friction) { return message_of([&] { friction.check(check); }); };
  const std::string start = "FlatSlider \"corner\": friction.";
  for (const Friction& friction : all_models()) EXPECT_EQ(refusal(friction), "nothing was thrown");
  KumarFriction wrong = kumar();
  wrong.reference_coefficient = 0.31;
  EXPECT_EQ(
      refusal(wrong),
      start + "reference_coefficient = 0.31 is not allowed; it must be > 0 and <= 0.3. Give a number in this range.");
  wrong = kumar();
  wrong.reference_pressure = -1.0 * N / (m * m);
  EXPECT_EQ(
      refusal(wrong),
      start + "reference_pressure = -1 Pa is not allowed; it must be > 0 Pa and finite. Check its sign and its unit.");
  wrong = kumar();
  wrong.area = 0.0 * m * m;
  EXPECT_EQ(refusal(wrong),
            start + "area = 0 m^2 is not allowed; it must be > 0 m^2 and finite. Check its sign and its unit.");
  wrong = kumar();
  wrong.rate = 0.0 * s / m;
  EXPECT_EQ(refusal(wrong),
            start + "rate = 0 s/m is not allowed; it must be > 0 s/m and <= 300 s/m. 20 to 100 s/m is usual.");
  EXPECT_EQ(refusal(LomientoFriction{.at_zero_force = 0.0, .reference_force = 1 * MN}),
            start + "at_zero_force = 0 is not allowed; it must be > 0 and <= 0.3. Give a number in this range.");
  EXPECT_EQ(refusal(LomientoFriction{.at_zero_force = 0.1, .reference_force = 0 * MN}),
            start + "reference_force = 0 N is not allowed; it must be > 0 N and finite. Check its sign and its unit.");
  EXPECT_EQ(refusal(LubricatedPtfe{.area = -1.0 * m * m}),
            start + "area = -1 m^2 is not allowed; it must be > 0 m^2 and finite. Check its sign and its unit.");
  EXPECT_EQ(refusal(LubricatedPtfe{.area = 1.0 * m * m, .temperature_factor = 1.2}),
            start + "temperature_factor = 1.2 is not allowed; it must be > 0 and <= 1. Give a number in this range.");
}

}  // namespace
}  // namespace moat::testing
