// The coefficient of sliding friction.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/units.hpp"

namespace moat {

/// Friction coefficient mu at a speed |v| m/s and a normal force N > 0 N, with its derivatives. The friction force
/// mu N ends at 0 where N = 0; the coefficient of a surface that has lifted has no meaning.
struct FrictionCoefficient {
  double value = 0.0;     ///< mu
  double slope = 0.0;     ///< dmu/d|v|, s/m
  double by_force = 0.0;  ///< dmu/dN, 1/N
};

/// One coefficient at all speeds: 0 < mu <= 0.3.
struct Coulomb {
  static constexpr std::string_view name = "Coulomb";
  Required<double> coefficient;  ///< mu

  [[nodiscard]] FrictionCoefficient at(double, double) const { return {coefficient, 0.0, 0.0}; }
  void check(const Check& check) const { check.above_up_to("friction.coefficient", coefficient, 0.0, 0.3, "1"); }
  [[nodiscard]] std::vector<Parameter> parameters() const { return {{"friction.coefficient", coefficient, "1"}}; }
};

/// mu = fast - (fast - slow) exp(-rate |v|).
///
/// Source: Constantinou, Mokha & Reinhorn (1990). PTFE-type composite on stainless steel: fast 0.05 to 0.12, slow about
/// half of it, rate 20 to 100 s/m; lubricated 0.01 to 0.02.
struct VelocityDependent {
  static constexpr std::string_view name = "VelocityDependent";
  /// At rest: 0 < slow <= fast.
  Required<double> slow;
  /// At high speed: 0 < fast <= 0.3.
  Required<double> fast;
  /// 0 < rate <= 300 s/m.
  Required<decltype(units::s / units::m)> rate;

  [[nodiscard]] FrictionCoefficient at(double speed, double) const {
    const double fallen = (fast - slow) * std::exp(-rate.si() * speed);
    return {fast - fallen, rate.si() * fallen, 0.0};
  }
  void check(const Check& check) const {
    check.above_up_to("friction.fast", fast, 0.0, 0.3, "1");
    check.above_up_to("friction.slow", slow, 0.0, fast, "1", "Friction at rest is at most that at high speed.");
    check.above_up_to("friction.rate", rate.si(), 0.0, 300.0, "s/m", "20 to 100 s/m is usual.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"friction.slow", slow, "1"}, {"friction.fast", fast, "1"}, {"friction.rate", rate.si(), "s/m"}};
  }
};

/// VelocityDependent with fast = at_zero_pressure - reduction tanh(pressure_factor p), p = N/area.
///
/// Unfilled PTFE on polished steel at 6.9 to 44.9 MPa: at_zero_pressure 0.165, reduction 0.109, pressure_factor 0.0657
/// 1/MPa. Source: Constantinou, Mokha & Reinhorn (1990); the pressure is that of the mean normal force.
struct VelocityPressureDependent {
  static constexpr std::string_view name = "VelocityPressureDependent";
  /// 0 < slow <= the coefficient at high speed.
  Required<double> slow;
  /// 0 < mu <= 0.3.
  Required<double> at_zero_pressure;
  /// 0 <= reduction < at_zero_pressure.
  Required<double> reduction;
  /// > 0 1/Pa.
  Required<decltype(units::m * units::m / units::N)> pressure_factor;
  /// > 0 m^2: of all sliders that carry the normal force of the law. Where one isolator stands for all bearings that is
  /// the area of all; where each bearing, or a group of them, has its own force, that of this bearing or group.
  Required<decltype(units::m * units::m)> area;
  /// 0 < rate <= 300 s/m.
  Required<decltype(units::s / units::m)> rate;

  /// Coefficient at high speed under a normal force, N.
  [[nodiscard]] double fast(double normal_force) const {
    return at_zero_pressure - reduction * std::tanh(pressure_factor.si() * normal_force / area.si());
  }
  [[nodiscard]] FrictionCoefficient at(double speed, double normal_force) const {
    // The formula of fast(), with the derivative 1 - t^2 of the tanh t.
    const double t = std::tanh(pressure_factor.si() * normal_force / area.si()),
                 highest = at_zero_pressure - reduction * t;
    const double fading = std::exp(-rate.si() * speed), fallen = (highest - slow) * fading;
    const double fast_by_force = -reduction * (1.0 - t * t) * pressure_factor.si() / area.si();
    return {highest - fallen, rate.si() * fallen, (1.0 - fading) * fast_by_force};
  }
  void check(const Check& check) const {
    check.above_up_to("friction.at_zero_pressure", at_zero_pressure, 0.0, 0.3, "1");
    check.that(reduction >= 0.0 && reduction < at_zero_pressure, "friction.reduction", reduction, "1",
               ">= 0 and below at_zero_pressure");
    check.positive("friction.pressure_factor", pressure_factor.si(), "1/Pa");
    check.positive("friction.area", area.si(), "m^2");
    check.above_up_to("friction.slow", slow, 0.0, at_zero_pressure - reduction, "1",
                      "Friction at rest is at most that at high speed, at any pressure.");
    check.above_up_to("friction.rate", rate.si(), 0.0, 300.0, "s/m", "20 to 100 s/m is usual.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"friction.slow", slow, "1"},           {"friction.at_zero_pressure", at_zero_pressure, "1"},
            {"friction.reduction", reduction, "1"}, {"friction.pressure_factor", pressure_factor.si(), "1/Pa"},
            {"friction.area", area.si(), "m^2"},    {"friction.rate", rate.si(), "s/m"}};
  }
};

/// VelocityDependent with slow = slow_at_reference (N/N_ref)^(slow_exponent - 1), fast likewise. Below 1e-6 N_ref both
/// keep their values, so that they remain finite.
///
/// Unfilled PTFE on polished steel has fast_exponent 0.6. Source: VelNormalFrcDep of OpenSees; a triple pendulum tested
/// at E-Defense has slow_exponent 0.8, fast_exponent 0.7.
struct VelocityForceDependent {
  static constexpr std::string_view name = "VelocityForceDependent";
  Required<double> slow_at_reference;  ///< 0 < mu <= fast_at_reference.
  Required<double> fast_at_reference;  ///< <= 0.3.
  /// N_ref > 0 N.
  Required<Force> reference_force;
  /// 0 < exponent <= 1.
  double slow_exponent = 1.0;
  double fast_exponent = 1.0;  ///< 0 < exponent <= 1.
  /// 0 < rate <= 300 s/m.
  Required<decltype(units::s / units::m)> rate;

  [[nodiscard]] FrictionCoefficient at(double speed, double normal_force) const {
    constexpr double least_share = 1e-6;
    const bool grows = normal_force > least_share * reference_force.si();
    const double share = grows ? normal_force / reference_force.si() : least_share;
    const double slow = slow_at_reference * std::pow(share, slow_exponent - 1.0),
                 fast = fast_at_reference * std::pow(share, fast_exponent - 1.0);
    const double fading = std::exp(-rate.si() * speed), fallen = (fast - slow) * fading;
    const double slow_by_force = grows ? (slow_exponent - 1.0) * slow / normal_force : 0.0,
                 fast_by_force = grows ? (fast_exponent - 1.0) * fast / normal_force : 0.0;
    return {fast - fallen, rate.si() * fallen, fast_by_force - (fast_by_force - slow_by_force) * fading};
  }
  void check(const Check& check) const {
    check.above_up_to("friction.fast_at_reference", fast_at_reference, 0.0, 0.3, "1");
    check.above_up_to("friction.slow_at_reference", slow_at_reference, 0.0, fast_at_reference, "1");
    check.positive("friction.reference_force", reference_force);
    check.above_up_to("friction.slow_exponent", slow_exponent, 0.0, 1.0, "1");
    check.above_up_to("friction.fast_exponent", fast_exponent, 0.0, 1.0, "1");
    check.above_up_to("friction.rate", rate.si(), 0.0, 300.0, "s/m", "20 to 100 s/m is usual.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {
        {"friction.slow_at_reference", slow_at_reference, "1"},  {"friction.fast_at_reference", fast_at_reference, "1"},
        {"friction.reference_force", reference_force.si(), "N"}, {"friction.slow_exponent", slow_exponent, "1"},
        {"friction.fast_exponent", fast_exponent, "1"},          {"friction.rate", rate.si(), "s/m"}};
  }
};

/// mu = reference_coefficient 0.7^(0.02 (p - p_0)) (1 - 0.5 exp(-rate |v|)), p = N/area in MPa: the factors of pressure
/// and speed of PressureTemperatureVelocity, at 20 degrees Celsius. Per 50 MPa mu falls by 30 %; the friction force
/// rises up to 140 MPa.
///
/// Source: Kumar, Whittaker & Constantinou (2015).
struct KumarFriction {
  static constexpr std::string_view name = "KumarFriction";
  /// 0 < mu <= 0.3: at p_0, at high speed.
  Required<double> reference_coefficient;
  /// p_0 > 0 Pa: the static pressure.
  Required<decltype(units::N / (units::m * units::m))> reference_pressure;
  /// > 0 m^2: as in VelocityPressureDependent.
  Required<decltype(units::m * units::m)> area;
  /// 0 < rate <= 300 s/m.
  decltype(units::s / units::m) rate = 100.0 * units::s / units::m;

  [[nodiscard]] FrictionCoefficient at(double speed, double normal_force) const {
    const double exponent = 0.02e-6 * (normal_force / area.si() - reference_pressure.si());
    const double fast = reference_coefficient * std::pow(0.7, exponent);
    const double fallen = 0.5 * fast * std::exp(-rate.si() * speed), value = fast - fallen;
    return {value, rate.si() * fallen, 0.02e-6 / area.si() * std::log(0.7) * value};
  }
  void check(const Check& check) const {
    check.above_up_to("friction.reference_coefficient", reference_coefficient, 0.0, 0.3, "1");
    check.positive("friction.reference_pressure", reference_pressure.si(), "Pa");
    check.positive("friction.area", area.si(), "m^2");
    check.above_up_to("friction.rate", rate.si(), 0.0, 300.0, "s/m", "20 to 100 s/m is usual.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"friction.reference_coefficient", reference_coefficient, "1"},
            {"friction.reference_pressure", reference_pressure.si(), "Pa"},
            {"friction.area", area.si(), "m^2"},
            {"friction.rate", rate.si(), "s/m"}};
  }
};

/// mu = at_zero_force exp(-N/N_ref), at all speeds. The friction force rises up to N = N_ref.
///
/// Source: Lomiento, Bonessio & Benzoni (2013): their factor of the normal force, with constants from tests of each
/// bearing. Their factors of speed and of repeated cycles are 1 here.
struct LomientoFriction {
  static constexpr std::string_view name = "LomientoFriction";
  /// 0 < mu <= 0.3.
  Required<double> at_zero_force;
  /// N_ref > 0 N.
  Required<Force> reference_force;

  [[nodiscard]] FrictionCoefficient at(double, double normal_force) const {
    const double value = at_zero_force * std::exp(-normal_force / reference_force.si());
    return {value, 0.0, -value / reference_force.si()};
  }
  void check(const Check& check) const {
    check.above_up_to("friction.at_zero_force", at_zero_force, 0.0, 0.3, "1");
    check.positive("friction.reference_force", reference_force);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"friction.at_zero_force", at_zero_force, "1"}, {"friction.reference_force", reference_force.si(), "N"}};
  }
};

/// Dimpled, lubricated PTFE on austenitic steel for design: mu = 1.2 k/(10 + p), p = N/area in MPa, but at least 0.03
/// and at most 0.08, at all speeds.
///
/// Source: EN 1337-2.
struct LubricatedPtfe {
  static constexpr std::string_view name = "LubricatedPtfe";
  /// > 0 m^2: as in VelocityPressureDependent.
  Required<decltype(units::m * units::m)> area;
  /// 0 < k <= 1: 1 where the bearing may be as cold as -35 degrees Celsius, 2/3 where at least at -5.
  double temperature_factor = 1.0;

  [[nodiscard]] FrictionCoefficient at(double, double normal_force) const {
    constexpr double lowest = 0.03, highest = 0.08;
    const double pressure = 1e-6 * std::max(normal_force, 0.0) / area.si();
    const double value = 1.2 * temperature_factor / (10.0 + pressure);
    const bool varies = value > lowest && value < highest;
    return {std::clamp(value, lowest, highest), 0.0, varies ? -1e-6 / area.si() * value / (10.0 + pressure) : 0.0};
  }
  void check(const Check& check) const {
    check.positive("friction.area", area.si(), "m^2");
    check.above_up_to("friction.temperature_factor", temperature_factor, 0.0, 1.0, "1");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"friction.area", area.si(), "m^2"}, {"friction.temperature_factor", temperature_factor, "1"}};
  }
};

/// Any of the models above; a plain number is Coulomb's.
///
///     .friction = 0.05
///     .friction = VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 50 * s / m}
class Friction {
 public:
  /// Lists all models.
  using Model = std::variant<Coulomb, VelocityDependent, VelocityPressureDependent, VelocityForceDependent,
                             KumarFriction, LomientoFriction, LubricatedPtfe>;

  Friction(double coefficient) : model_{Coulomb{coefficient}} {}  ///< Coulomb's, 0 < mu <= 0.3.
  /// One of the models.
  template <class Any>
  requires std::constructible_from<Model, const Any&> Friction(const Any& model) : model_{model} {}

  [[nodiscard]] FrictionCoefficient at(double speed, double normal_force) const {
    return std::visit([&](const auto& model) { return model.at(speed, normal_force); }, model_);
  }
  /// Whether it is the same at all speeds.
  [[nodiscard]] bool is_constant() const {
    return std::holds_alternative<Coulomb>(model_) || std::holds_alternative<LomientoFriction>(model_) ||
           std::holds_alternative<LubricatedPtfe>(model_);
  }
  /// At high speed.
  [[nodiscard]] double fast(double normal_force) const {
    constexpr double very_fast = 1e3;  // m/s
    return at(very_fast, normal_force).value;
  }

  void check(const Check& check) const {
    std::visit([&](const auto& model) { model.check(check); }, model_);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return std::visit([](const auto& model) { return model.parameters(); }, model_);
  }

 private:
  Model model_;
};

/// Throws InputError unless the friction force mu N rises with the normal force N, at rest and at high speed, from 0 to
/// three times the static weight > 0 N: for laws whose normal force changes. A falling friction force would have no
/// unique motion.
inline void check_rising(const Check& check, const Friction& friction, double static_weight) {
  constexpr int points = 300;
  constexpr double times_weight = 3.0, very_fast = 1e3;  // 1, m/s
  for (int i = 1; i <= points; ++i)
    for (const double speed : {0.0, very_fast}) {
      const double normal_force = static_weight * times_weight * i / points;
      const FrictionCoefficient mu = friction.at(speed, normal_force);
      if (mu.value + normal_force * mu.by_force > 0.0) continue;
      check.that(false,
                 "its friction force falls where the normal force rises beyond " + to_text(normal_force) +
                     " N; it must rise up to three times the static weight, " + to_text(static_weight) + " N.",
                 "Take constants of friction that were measured up to that force.");
    }
}

}  // namespace moat
