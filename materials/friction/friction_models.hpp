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

/// Friction coefficient mu at a speed |v| m/s and a normal force N > 0 N, with its slope dmu/d|v|, s/m.
struct FrictionCoefficient {
  double value = 0.0;  ///< mu
  double slope = 0.0;  ///< dmu/d|v|, s/m
};

/// One coefficient at all speeds: 0 < mu <= 0.3.
struct Coulomb {
  static constexpr std::string_view name = "Coulomb";
  Required<double> coefficient;  ///< mu

  [[nodiscard]] FrictionCoefficient at(double, double) const { return {coefficient, 0.0}; }
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
    return {fast - fallen, rate.si() * fallen};
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
/// Source: Constantinou, Mokha & Reinhorn (1990); the pressure is that of the mean normal force.
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
  /// > 0 m^2: of the sliders of all bearings that carry the weight.
  Required<decltype(units::m * units::m)> area;
  /// 0 < rate <= 300 s/m.
  Required<decltype(units::s / units::m)> rate;

  /// Coefficient at high speed under a normal force, N.
  [[nodiscard]] double fast(double normal_force) const {
    return at_zero_pressure - reduction * std::tanh(pressure_factor.si() * normal_force / area.si());
  }
  [[nodiscard]] FrictionCoefficient at(double speed, double normal_force) const {
    const double fallen = (fast(normal_force) - slow) * std::exp(-rate.si() * speed);
    return {fast(normal_force) - fallen, rate.si() * fallen};
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

/// VelocityDependent with slow = slow_at_reference (N/N_ref)^(slow_exponent - 1), fast likewise.
///
/// Source: VelNormalFrcDep of OpenSees; a triple pendulum tested at E-Defense has slow_exponent 0.8, fast_exponent 0.7.
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
    const double share = normal_force / reference_force.si();
    const double slow = slow_at_reference * std::pow(share, slow_exponent - 1.0),
                 fast = fast_at_reference * std::pow(share, fast_exponent - 1.0);
    const double fallen = (fast - slow) * std::exp(-rate.si() * speed);
    return {fast - fallen, rate.si() * fallen};
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

/// Any of the models above; a plain number is Coulomb's.
///
///     .friction = 0.05
///     .friction = VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 50 * s / m}
class Friction {
 public:
  /// All models.
  using Model = std::variant<Coulomb, VelocityDependent, VelocityPressureDependent, VelocityForceDependent>;

  Friction(double coefficient) : model_{Coulomb{coefficient}} {}  ///< Coulomb's, 0 < mu <= 0.3.
  /// One of the models.
  template <class Any>
  requires std::constructible_from<Model, const Any&> Friction(const Any& model) : model_{model} {}

  [[nodiscard]] FrictionCoefficient at(double speed, double normal_force) const {
    return std::visit([&](const auto& model) { return model.at(speed, normal_force); }, model_);
  }
  [[nodiscard]] bool is_constant() const { return std::holds_alternative<Coulomb>(model_); }  ///< At all speeds.
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

}  // namespace moat
