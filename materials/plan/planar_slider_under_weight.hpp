// A slider in plan under a weight that changes.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "materials/carrying.hpp"
#include "materials/isolation/flat_slider.hpp"
#include "materials/isolation/friction_pendulum.hpp"
#include "materials/plan/circular_friction.hpp"

namespace moat {

/// A pendulum or flat slider in plan under an axial force N: friction opposite to the sliding, on a spherical surface.
///
///     F = (N/R + k_r) d + q,   q' = k_0 d' inside |q| < L = mu(|v|, N) N, and on the circle with slip along q
///
/// Along a line it is SlidingUnderWeight but for events, which are not located in plan; under a constant weight it is
/// BiaxialFrictionPendulum. The circle of a step belongs to speed and N at its end, and the direction turns with the
/// circle of the mean N: friction that depends on speed, and N that changes, are of second order in the step. A circle
/// that shrinks takes the force along. Lifted, N <= 0, it has no friction, and its direction starts again.
struct PlanarSliderUnderWeight {
  static constexpr std::string_view name = "PlanarSliderUnderWeight";

  SlidingUnderWeight line;  ///< The law along a line.

  void check(const Check& check) const { check.positive("static_weight", line.static_weight, "N"); }
  [[nodiscard]] std::vector<Parameter> parameters() const { return line.parameters(); }

  struct State {
    PlanVector friction_force{};  ///< q, N
    PlanVector deformation{};     ///< m
    PlanVector rate{};            ///< m/s
    double heat = 0.0;            ///< J, dissipated so far
    double compression = 0.0;     ///< N, N

    friend bool operator==(const State&, const State&) = default;
  };

  PlanarAxialResponse evaluate(const State& committed, PlanVector deformation, PlanVector rate, double interval,
                               AxialForce axial, State& trial) const {
    const double normal = axial.compression, speed = length(rate), start = length(committed.friction_force);
    trial = {{}, deformation, rate, committed.heat, normal};
    PlanarAxialResponse response;
    if (normal <= 0.0) {
      trial.heat += 0.5 * start * start / line.elastic_stiffness;
      response.stiffness = PlanMatrix::diagonal(line.restoring_stiffness);
      response.force = line.restoring_stiffness * deformation;
      response.force_rate = line.restoring_stiffness * rate;
      return response;
    }
    const FrictionCoefficient mu = line.friction.at(speed, normal);
    const double before = committed.compression > 0.0 ? committed.compression : normal,
                 mean_normal = 0.5 * (before + normal), limit = mu.value * normal, mean = mu.value * mean_normal;
    const CircularFriction circle = CircularFriction::after(
        committed.friction_force, limit, mean, line.elastic_stiffness, [&](const SaturatingSlip& slip, PlanVector z0) {
          return slip.advance(z0, deformation - committed.deformation, committed.rate, rate, interval);
        });
    trial.friction_force = circle.force;
    const double given_up = std::max(start - limit, 0.0);
    trial.heat += (limit * mean * circle.step.dissipated + 0.5 * given_up * (start + limit)) / line.elastic_stiffness;

    const PlanVector z = circle.step.z, direction = speed > 0.0 ? rate / speed : PlanVector{};
    constexpr double round_off = 1e-9;
    const bool slides = dot(z, z) >= 1.0 - round_off && dot(z, rate) > 0.0;
    const double restoring = normal / line.radius + line.restoring_stiffness, rise = mu.value + mu.by_force * normal;
    response.force = restoring * deformation + circle.force;
    response.stiffness = PlanMatrix::diagonal(restoring) + circle.by_increment;
    response.damping =
        circle.by_rate +
        PlanMatrix::product(mu.slope * (normal * circle.by_limit + mean_normal * circle.by_mean), direction);
    response.force_rate = restoring * rate + limit * circle.step.rate;
    if (slides) response.viscosity = PlanMatrix::product(mu.slope * normal * z, direction);
    response.by_compression =
        deformation / line.radius + rise * circle.by_limit +
        (0.5 * mu.value * (committed.compression > 0.0 ? 1.0 : 2.0) + mu.by_force * mean_normal) * circle.by_mean;
    response.rate_by_compression = deformation / line.radius + (slides ? rise : 0.0) * z;
    return response;
  }
  double stored_energy(const State& state, PlanVector deformation) const {
    return 0.5 * (std::max(state.compression, 0.0) / line.radius + line.restoring_stiffness) *
               dot(deformation, deformation) +
           0.5 * dot(state.friction_force, state.friction_force) / line.elastic_stiffness;
  }
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double weight_lever(const State&, PlanVector deformation, const State&, PlanVector end_deformation) const {
    return 0.5 * dot(deformation, end_deformation) / line.radius;
  }
  double linear_stiffness(StiffnessStage stage) const { return line.linear_stiffness(stage); }
};

/// The law of a pendulum or flat slider in plan whose weight changes; `static_weight` > 0 N is that at rest.
/// Throws InputError for a bad parameter.
template <class Design>
requires requires(const Design& design, Force weight) {
  { design.under_changing_weight(weight) } -> std::same_as<SlidingUnderWeight>;
}
PlanarSliderUnderWeight in_plan_under_changing_weight(const Design& design, Force static_weight) {
  design.check(Check{Design::name, ""});
  return {design.under_changing_weight(static_weight)};
}

/// A flat slider in plan under this weight, N, unless it has a weight of its own.
inline Carrying<PlanarSliderUnderWeight> in_plan(const FlatSlider& slider, Force weight) {
  const Force carried = slider.weight.si() > 0.0 ? slider.weight : weight;
  return {in_plan_under_changing_weight(slider, carried), carried.si()};
}

}  // namespace moat
