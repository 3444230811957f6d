// Friction that depends on pressure, temperature and speed.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/units.hpp"

namespace moat {

/// The friction of a PTFE-type composite on stainless steel, mu = mu_ref k_p k_v k_T:
///
///     k_p = 0.7^(0.02 (p - p_0)), p in MPa      k_v = 1 - 0.5 exp(-a |v|)      k_T(T) falls as the surface heats
///
///     T(t) = T_0 + (1/k) sqrt(D/pi) integral of q(t - tau)/sqrt(tau) dtau,      q = mu p |v|
///
/// q is the heat flux while the slider covers the centre of the surface, |d| < r_c sqrt(pi)/2, else 0. The memory
/// 1/sqrt(tau) is a sum of sixteen exponentials, right to 0.13 % from 1 ms to one hour. After a longer rest the surface
/// counts as too cold, by less than sqrt(D/s)/120 of the rise after sliding for a time D.
/// Sources: Kumar, Whittaker & Constantinou (2015); Kim & Constantinou (2023); FPBearingPTV of OpenSees.
struct PressureTemperatureVelocity {
  /// How far heating reduces friction: k_T at 200 degrees Celsius.
  enum class Weakening { none, to_two_thirds, to_half, to_third };

  /// mu_ref, 0 < mu_ref <= 0.3: at p_0, at high speed, at 20 degrees Celsius.
  Required<double> reference_coefficient;
  /// p_0 > 0 Pa.
  Required<decltype(units::N / (units::m * units::m))> reference_pressure;
  /// r_c > 0 m, of the contact of one slider.
  Required<Length> slider_radius;
  /// 0 <= a <= 300 s/m.
  decltype(units::s / units::m) rate = 100.0 * units::s / units::m;
  bool depends_on_pressure = true;           ///< Whether mu falls with pressure.
  bool depends_on_speed = true;              ///< Whether mu rises with speed.
  Weakening weakening = Weakening::to_half;  ///< How far mu falls with temperature.
  /// D > 0 m^2/s, of the steel.
  double diffusivity = 4.44e-6;
  /// k > 0 W/(m K), of the steel.
  double conductivity = 18.0;
  /// T_0, degrees Celsius, from -50 to 100.
  double initial_temperature = 20.0;

  static constexpr std::size_t memory_size = 16;  ///< Number of exponentials.
  /// Times of the exponentials, s.
  static constexpr std::array<double, memory_size> memory_times = [] {
    constexpr double shortest = 4e-4, ratio = 3.21166;
    std::array<double, memory_size> times{};
    double time = shortest;
    for (double& each : times) {
      each = time;
      time *= ratio;
    }
    return times;
  }();
  /// Weights of the exponentials, s^-1/2.
  static constexpr std::array<double, memory_size> memory_weights{
      31.0271,  18.8793,  10.0178,  5.84403,  3.12446,  1.81896, 0.971398, 0.567258,
      0.302257, 0.176759, 0.093914, 0.055447, 0.028274, 0.0201,  0.000813, 0.017939};
  /// The part of the integral that the sum lacks below 1 ms, s^1/2.
  static constexpr double memory_rest = 0.017077;

  /// Factor of mu at a pressure, Pa.
  [[nodiscard]] double pressure_factor(double pressure) const {
    return depends_on_pressure ? std::pow(0.7, 0.02e-6 * (pressure - reference_pressure.si())) : 1.0;
  }
  /// Rate of pressure_factor() with pressure over itself, 1/Pa.
  [[nodiscard]] double pressure_slope() const { return depends_on_pressure ? 0.02e-6 * std::log(0.7) : 0.0; }
  /// Factor of mu at a speed, m/s.
  [[nodiscard]] double speed_factor(double speed) const {
    return depends_on_speed ? 1.0 - 0.5 * std::exp(-rate.si() * speed) : 1.0;
  }
  /// Rate of speed_factor() with speed, s/m.
  [[nodiscard]] double speed_slope(double speed) const {
    return depends_on_speed ? 0.5 * rate.si() * std::exp(-rate.si() * speed) : 0.0;
  }
  /// Factor of mu at a temperature, degrees Celsius.
  [[nodiscard]] double temperature_factor(double celsius) const {
    const Fit fit = fit_of(weakening);
    return fit.scale * (std::pow(0.7, fit.rate * celsius) + fit.rest);
  }
  /// Rate of temperature_factor() with temperature, 1/K.
  [[nodiscard]] double temperature_slope(double celsius) const {
    const Fit fit = fit_of(weakening);
    return fit.scale * fit.rate * std::log(0.7) * std::pow(0.7, fit.rate * celsius);
  }
  /// Kelvin over W/m^2 s^1/2.
  [[nodiscard]] double heating_factor() const { return std::sqrt(diffusivity / std::numbers::pi) / conductivity; }

  void check(const Check& check) const {
    check.above_up_to("friction.reference_coefficient", reference_coefficient, 0.0, 0.3, "1");
    check.positive("friction.reference_pressure", reference_pressure.si(), "Pa");
    check.positive("friction.slider_radius", slider_radius);
    check.between("friction.rate", rate.si(), 0.0, 300.0, "s/m", "20 to 100 s/m is usual.");
    check.positive("friction.diffusivity", diffusivity, "m^2/s");
    check.positive("friction.conductivity", conductivity, "W/(m K)");
    check.between("friction.initial_temperature", initial_temperature, -50.0, 100.0, "degrees Celsius");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"friction.reference_coefficient", reference_coefficient, "1"},
            {"friction.reference_pressure", reference_pressure.si(), "Pa"},
            {"friction.slider_radius", slider_radius.si(), "m"},
            {"friction.rate", rate.si(), "s/m"},
            {"friction.depends_on_pressure", depends_on_pressure ? 1.0 : 0.0, "1"},
            {"friction.depends_on_speed", depends_on_speed ? 1.0 : 0.0, "1"},
            {"friction.factor_at_200_degrees", temperature_factor(200.0), "1"},
            {"friction.diffusivity", diffusivity, "m^2/s"},
            {"friction.conductivity", conductivity, "W/(m K)"},
            {"friction.initial_temperature", initial_temperature, "degC"}};
  }

  /// Throws InputError unless mu N rises with the normal force N up to three times the static pressure > 0 Pa: for laws
  /// whose normal force changes.
  void check_rising(const Check& check, double static_pressure) const {
    const double highest = 3.0 * static_pressure;
    check.that(1.0 + highest * pressure_slope() > 0.0, "static pressure", static_pressure, "Pa", "below 46.7 MPa",
               "Beyond three times that the friction force would fall where the normal force rises.");
  }

 private:
  struct Fit {
    double scale, rate, rest;
  };
  static Fit fit_of(Weakening weakening) {
    switch (weakening) {
      case Weakening::to_two_thirds:
        return {0.84, 0.0085, 0.25};
      case Weakening::to_half:
        return {0.79, 0.02, 0.40};
      case Weakening::to_third:
        return {0.97, 0.029, 0.22};
      case Weakening::none:
        break;
    }
    return {0.5, 0.0, 1.0};
  }
};

}  // namespace moat
