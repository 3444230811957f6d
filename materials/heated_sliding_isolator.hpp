// A slider whose surface heats, beside a restoring spring.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "materials/friction/pressure_temperature_velocity.hpp"
#include "materials/response.hpp"

namespace moat {

/// The law of a HeatedFrictionPendulum under its weight: stick and slip are located as in SlidingIsolator, and so are
/// the instants at which the flux of heat begins or ends, because the slider reaches or leaves the centre.
///
/// Temperature and friction at the end of a step solve each other; the flux is linear in a step.
struct HeatedSlidingIsolator {
  static constexpr std::string_view name = "HeatedSlidingIsolator";

  double restoring_stiffness = 0.0;      ///< N/m
  double elastic_stiffness = 0.0;        ///< N/m
  double normal_force = 0.0;             ///< N
  PressureTemperatureVelocity friction;  ///< Friction of the surface.

  struct State {
    double slip = 0.0;                                                      ///< m
    double friction_force = 0.0;                                            ///< N
    double rise = 0.0;                                                      ///< of the temperature of the surface, K
    double flux = 0.0;                                                      ///< W/m^2
    std::array<double, PressureTemperatureVelocity::memory_size> memory{};  ///< of the heat that flowed in earlier
    int direction = 0;                                                      ///< of sliding; 0: sticks
    int side = 0;  ///< of the centre, where the last slide left it, -1 or +1; 0: over the centre

    /// Whether the force jumps at a change of regime: the flux of heat begins or ends there.
    [[nodiscard]] bool jumps_to(const State& next) const { return side != next.side; }
    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 3> quantities{
      {{"friction_coefficient", "1"}, {"isolator_slip", "m"}, {"surface_temperature", "degC"}}};
  static constexpr double time_of_rate = 1.0, threshold = 1e-9;  ///< Constants of the search for a change of regime.

  Response evaluate(const State& committed, double deformation, double rate, Interval interval, State& trial) const {
    trial = committed;
    const Surface end = heat(committed, committed.direction * rate, interval.length, trial);
    if (interval.length == 0.0) trial = committed;
    if (committed.direction == 0) {
      trial.friction_force = elastic_stiffness * (deformation - committed.slip);
      return {restoring_stiffness * deformation + trial.friction_force, restoring_stiffness + elastic_stiffness, 0.0};
    }
    if (interval.length == 0.0)
      return {restoring_stiffness * deformation + committed.friction_force, restoring_stiffness,
              end.slope * normal_force};
    trial.friction_force = committed.direction * end.coefficient * normal_force;
    trial.slip = deformation - trial.friction_force / elastic_stiffness;
    return {restoring_stiffness * deformation + trial.friction_force, restoring_stiffness, end.slope * normal_force,
            committed.direction * (end.coefficient + normal_force * end.by_compression)};
  }
  double force_rate(const State& state, double, double rate, double second_rate) const {
    if (state.direction == 0) return (restoring_stiffness + elastic_stiffness) * rate;
    const Rates rates = rates_of(state, std::max(state.direction * rate, 0.0), state.direction * second_rate);
    return restoring_stiffness * rate + state.direction * normal_force * rates.coefficient;
  }
  double stored_energy(const State& committed, double deformation) const {
    return 0.5 * restoring_stiffness * deformation * deformation +
           0.5 * committed.friction_force * committed.friction_force / elastic_stiffness;
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    return committed.direction * rate > 0.0 ? limit(committed, std::abs(rate)) * std::abs(rate) : 0.0;
  }
  double dissipated_energy(const State& from, const State& to) const {
    return 0.5 * (from.friction_force + to.friction_force) * (to.slip - from.slip);
  }
  double linear_stiffness(StiffnessStage stage) const {
    return restoring_stiffness + (stage == StiffnessStage::initial ? elastic_stiffness : 0.0);
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    if (committed.direction != 0)
      return std::min(committed.direction * rate * time_of_rate, margin_of_edge(committed, deformation));
    return limit(committed, std::abs(rate)) / elastic_stiffness * (1.0 + threshold) -
           std::abs(deformation - committed.slip);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    State next = committed;
    if (committed.direction == 0) {
      next.direction = deformation > committed.slip ? 1 : -1;
      next.side = std::abs(deformation) < edge() ? 0 : deformation > 0.0 ? 1 : -1;
    } else if (committed.direction * rate * time_of_rate <= margin_of_edge(committed, deformation)) {
      next.direction = 0;
    } else {
      next.side = committed.side == 0 ? committed.direction : 0;
    }
    const double sliding = committed.direction != 0 ? committed.direction : next.direction;
    const Surface surface = heat(next, next.direction * rate, 0.0, next);
    next.friction_force = sliding * surface.coefficient * normal_force;
    next.slip = deformation - next.friction_force / elastic_stiffness;
    return next;
  }
  ReportedValue quantity(std::size_t index, const State& state, double, double rate, double second_rate) const {
    // The rate at the end of a slide may have the other sign by round-off.
    const int direction = state.direction != 0 ? state.direction : rate < 0.0 ? -1 : 1;
    const double speed = std::max(direction * rate, 0.0);
    const Rates rates = rates_of(state, speed, direction * second_rate);
    if (index == 0) return {unheated(state, speed).coefficient, rates.coefficient};
    if (index == 2) return {friction.initial_temperature + state.rise, rates.rise};
    return {state.slip,
            state.direction == 0 ? 0.0 : rate - state.direction * rates.coefficient * normal_force / elastic_stiffness};
  }

  /// Pressure of the slider on the surface, N/m^2.
  [[nodiscard]] double pressure() const { return normal_force / area(); }

  /// Friction of the surface: mu, dmu/d|v| and dmu/dN.
  struct Surface {
    /// Friction, its slope with the speed, and with the compression.
    double coefficient, slope, by_compression;
  };

  /// Rates of friction and temperature, 1/s and K/s.
  struct Rates {
    /// Rates of the friction and of the temperature rise.
    double coefficient, rise;
  };
  /// At a speed and its rate.
  [[nodiscard]] Rates rates_of(const State& state, double speed, double faster) const {
    const double celsius = friction.initial_temperature + state.rise;
    const double by_speed = factor() * friction.speed_factor(speed),
                 by_speed_slope = factor() * friction.speed_slope(speed),
                 of_temperature = friction.temperature_factor(celsius),
                 temperature_slope = friction.temperature_slope(celsius);
    double heating = 0.0;  // of the exponentials
    for (std::size_t j = 0; j < state.memory.size(); ++j)
      heating += PressureTemperatureVelocity::memory_weights[j] * state.flux -
                 state.memory[j] / PressureTemperatureVelocity::memory_times[j];
    // The flux p mu |v| heats at once by memory_rest, and the warmer surface lowers mu.
    const double scale = friction.heating_factor(),
                 at_once = state.direction != 0 && state.side == 0
                               ? scale * PressureTemperatureVelocity::memory_rest * pressure()
                               : 0.0;
    const double rise_rate =
        (scale * heating + at_once * of_temperature * (by_speed + speed * by_speed_slope) * faster) /
        (1.0 - at_once * speed * by_speed * temperature_slope);
    return {by_speed_slope * faster * of_temperature + by_speed * temperature_slope * rise_rate, rise_rate};
  }

  /// Friction at a speed, at the temperature of a state.
  [[nodiscard]] Surface unheated(const State& state, double speed) const {
    const double of_temperature = friction.temperature_factor(friction.initial_temperature + state.rise),
                 coefficient = factor() * friction.speed_factor(speed) * of_temperature;
    return {coefficient, factor() * friction.speed_slope(speed) * of_temperature,
            coefficient * friction.pressure_slope() / area()};
  }
  /// Returns the friction at which it slides, N.
  [[nodiscard]] double limit(const State& state, double speed) const {
    return unheated(state, speed).coefficient * normal_force;
  }
  /// The distance from the centre at which a slider of this contact stops to cover it, m.
  [[nodiscard]] double edge() const { return 0.5 * std::sqrt(std::numbers::pi) * friction.slider_radius.si(); }
  /// Temperature and friction after a time h >= 0, at a rate in the direction of sliding. A step may overshoot the turn
  /// of the rate: friction goes on along its tangent, so that it stays smooth.
  Surface heat(const State& committed, double rate, double h, State& trial) const {
    const double speed = std::max(rate, 0.0), initial = friction.initial_temperature;
    const double by_speed_slope = factor() * friction.speed_slope(speed);
    const double by_speed = factor() * friction.speed_factor(speed) + by_speed_slope * std::min(rate, 0.0);
    // rise = known + gain q1 with q1 = share mu(rise); the flux is linear from q0 to q1.
    const bool covers = committed.direction != 0 && committed.side == 0;
    const double share = covers ? pressure() * speed : 0.0;
    double from_start = 0.0, per_flux = 0.0;
    std::array<double, PressureTemperatureVelocity::memory_size> known_memory, added;
    for (std::size_t j = 0; j < added.size(); ++j) {
      const double time = PressureTemperatureVelocity::memory_times[j], x = -std::expm1(-h / time);
      // The share of a flux that rises from 0 to 1.
      added[j] = h > 0.0 ? PressureTemperatureVelocity::memory_weights[j] * time * (1.0 - x * time / h) : 0.0;
      known_memory[j] = committed.memory[j] * (1.0 - x) +
                        (PressureTemperatureVelocity::memory_weights[j] * time * x - added[j]) * committed.flux;
      from_start += known_memory[j];
      per_flux += added[j];
    }
    const double scale = friction.heating_factor();
    const double known = scale * from_start;
    const double gain = scale * (per_flux + PressureTemperatureVelocity::memory_rest) * share;
    double rise = committed.rise;
    constexpr int iterations = 30;
    for (int i = 0; i < iterations; ++i) {
      const double error = rise - known - gain * by_speed * friction.temperature_factor(initial + rise);
      const double slope = 1.0 - gain * by_speed * friction.temperature_slope(initial + rise);
      const double correction = error / slope;
      rise -= correction;
      if (std::abs(correction) < 1e-12 * (1.0 + std::abs(rise))) break;
    }
    const double of_temperature = friction.temperature_factor(initial + rise);
    const double coefficient = by_speed * of_temperature;
    trial.rise = rise;
    trial.flux = share * coefficient;
    for (std::size_t j = 0; j < added.size(); ++j) trial.memory[j] = known_memory[j] + added[j] * trial.flux;
    // d(rise)/dv from rise = known + gain(v) by_speed(v) k_T(rise).
    const double temperature_slope = friction.temperature_slope(initial + rise);
    const double gain_slope = speed > 0.0 ? gain / speed : 0.0;
    const double rise_slope =
        of_temperature * (gain_slope * by_speed + gain * by_speed_slope) / (1.0 - gain * by_speed * temperature_slope);
    // Friction and flux change with N by the factor of pressure, the flux also by the pressure itself.
    const double by_factor = friction.pressure_slope() / area(),
                 gain_by_compression =
                     covers ? scale * (per_flux + PressureTemperatureVelocity::memory_rest) * speed / area() : 0.0,
                 rise_by_compression = coefficient * (gain * by_factor + gain_by_compression) /
                                       (1.0 - gain * by_speed * temperature_slope);
    return {coefficient, by_speed_slope * of_temperature + by_speed * temperature_slope * rise_slope,
            coefficient * by_factor + by_speed * temperature_slope * rise_by_compression};
  }

 private:
  [[nodiscard]] double factor() const { return friction.reference_coefficient * friction.pressure_factor(pressure()); }
  [[nodiscard]] double area() const {
    return std::numbers::pi * friction.slider_radius.si() * friction.slider_radius.si();
  }
  // The way of a slide until its flux of heat begins or ends, m.
  [[nodiscard]] double margin_of_edge(const State& sliding, double deformation) const {
    if (sliding.side == 0) return edge() - sliding.direction * deformation;
    if (sliding.side == sliding.direction) return std::numeric_limits<double>::infinity();
    return sliding.side * deformation - edge();
  }
};

}  // namespace moat
