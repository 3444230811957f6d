// Friction pendulum in two components.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/isolation/friction_pendulum.hpp"
#include "materials/plan/planar_response.hpp"
#include "materials/saturating_slip.hpp"

namespace moat {

/// Friction pendulum in plan: the friction of FrictionPendulum, opposite to the sliding, on a spherical surface.
///
///     F = (W/R) d + q,   q' = k_0 d' inside |q| < mu(|v|) W, and on the circle with slip along q,   k_0 = mu W/u_y
///
/// Along a line it is `FrictionPendulum`. With constant friction the update is exact for straight increments
/// (Krieg & Krieg 1977), and so is the dissipation; the bend of a path counts to fourth order
/// (materials/saturating_slip.hpp). The circle of a step is that of the speed at its end: friction that
/// depends on speed is of second order in the step. The weight is constant;
/// PlanarSliderUnderWeight follows it.
struct BiaxialFrictionPendulum {
  static constexpr std::string_view name = "BiaxialFrictionPendulum";

  /// The parameters; `weight` is the static load of this bearing, > 0 N.
  FrictionPendulum pendulum;

  struct State {
    PlanVector friction_force{};  ///< q, N
    PlanVector deformation{};     ///< m
    PlanVector rate{};            ///< m/s
    double heat = 0.0;            ///< J, dissipated so far

    friend bool operator==(const State&, const State&) = default;
  };

  void check(const Check& check) const {
    pendulum.check(check);
    check.positive("weight", pendulum.weight, "Give the weight on this bearing; a PlanBuilding knows its share.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    std::vector<Parameter> list = pendulum.parameters();
    list.push_back({"weight", pendulum.weight.si(), "N"});
    return list;
  }

  PlanarResponse evaluate(const State& committed, PlanVector deformation, PlanVector rate, double interval,
                          State& trial) const {
    const SlidingIsolator line = pendulum.carrying(pendulum.weight);
    const double speed = length(rate), stiffness = line.elastic_stiffness;
    const FrictionCoefficient mu = line.friction.at(speed, line.normal_force);
    const double limit = mu.value * line.normal_force;
    const SaturatingSlip slip{SaturatingSlip::Begins::on_the_circle, limit / stiffness};
    const PlanVector increment = deformation - committed.deformation;
    // A circle that shrank takes the force along.
    const double start = length(committed.friction_force), given_up = std::max(start - limit, 0.0);
    const PlanVector z = committed.friction_force / (given_up > 0.0 ? start : limit);
    const SaturatingSlip::Step step = slip.advance(z, increment, committed.rate, rate, interval);
    trial = {
        limit * step.z, deformation, rate,
        committed.heat + limit * limit / stiffness * step.dissipated + 0.5 * given_up * (start + limit) / stiffness};

    // q is homogeneous of the first degree in the force at the start, the path and the limit.
    PlanVector by_limit = step.z - step.by_scale;
    if (given_up == 0.0) by_limit = by_limit - step.by_start * z;
    const PlanVector speed_slope = speed > 0.0 ? mu.slope * line.normal_force / speed * rate : PlanVector{};
    constexpr double round_off = 1e-9;
    const bool slides = dot(step.z, step.z) >= 1.0 - round_off && dot(step.z, rate) > 0.0;
    const PlanMatrix restoring = PlanMatrix::diagonal(line.restoring_stiffness);
    return {.force = line.restoring_stiffness * deformation + trial.friction_force,
            .stiffness = restoring + limit * step.by_increment,
            .damping = limit * step.by_rate + PlanMatrix::product(by_limit, speed_slope),
            .force_rate = restoring * rate + limit * step.rate,
            .viscosity = slides ? PlanMatrix::product(step.z, speed_slope) : PlanMatrix{}};
  }
  double stored_energy(const State& committed, PlanVector deformation) const {
    const SlidingIsolator line = pendulum.carrying(pendulum.weight);
    return 0.5 * line.restoring_stiffness * dot(deformation, deformation) +
           0.5 * dot(committed.friction_force, committed.friction_force) / line.elastic_stiffness;
  }
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const {
    return pendulum.carrying(pendulum.weight).linear_stiffness(stage);
  }
};

/// The law of a bearing in plan under this weight, N, unless it has a weight of its own.
inline BiaxialFrictionPendulum in_plan(FrictionPendulum pendulum, Force weight) {
  if (pendulum.weight.si() == 0.0) pendulum.weight = weight;
  return {pendulum};
}

}  // namespace moat
