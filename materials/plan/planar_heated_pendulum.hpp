// Friction pendulum that heats, in plan.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/carrying.hpp"
#include "materials/isolation/heated_friction_pendulum.hpp"
#include "materials/plan/circular_friction.hpp"
#include "materials/plan/planar_response.hpp"

namespace moat {

/// HeatedFrictionPendulum in plan, under a weight N that may change.
///
///     F = (N/R) d + q,   q' = k_0 d' inside |q| < mu N, and on the circle with slip along q
///
/// mu follows pressure, speed |v| and temperature as on a line, and k_0 is that under the static weight. Friction and
/// temperature at the end of a step solve each other. Whether it slides over the centre, |d| < r_c sqrt(pi)/2, is for
/// them that of the start of the step; then the heat counts for the part of the way on which it does. A step that
/// stays in its regime on a straight path is that of the law on a line.
///
/// Stored energy is N d^2/(2 R) + q^2/(2 k_0); dissipated is the mean friction of a step times the change of slip.
/// Where it lifts, N <= 0, the force is zero, and the slip follows.
struct PlanarHeatedPendulum {
  static constexpr std::string_view name = "PlanarHeatedPendulum";

  HeatedSlidingIsolator line;  ///< The law on a line, under the static weight.

  struct State {
    PlanVector friction_force{};  ///< q, N
    PlanVector deformation{};     ///< m
    PlanVector rate{};            ///< m/s
    double compression = 0.0;     ///< N, of the instant
    double heat = 0.0;            ///< J, dissipated so far
    bool slides = false;          ///< with the motion of the instant
    /// Temperature, memory and, while it slides over the centre or would do so, flux.
    HeatedSlidingIsolator::State surface{};

    friend bool operator==(const State&, const State&) = default;
  };

  void check(const Check& check) const {
    check.positive("weight", line.normal_force * units::N,
                   "Give the weight on this bearing; a PlanBuilding knows its share.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const { return {{"weight", line.normal_force, "N"}}; }

  PlanarAxialResponse evaluate(const State& committed, PlanVector deformation, PlanVector rate, double interval,
                               AxialForce axial, State& trial) const {
    const double weight = std::max(axial.compression, 0.0), elastic = line.elastic_stiffness, speed = length(rate);
    const HeatedSlidingIsolator under = under_weight(weight);
    const PlanMatrix restoring = PlanMatrix::diagonal(under.restoring_stiffness);
    trial = committed;
    trial.deformation = deformation;
    trial.rate = rate;
    trial.compression = axial.compression;
    if (weight == 0.0) {
      trial.friction_force = {};
      trial.slides = false;
      trial.surface = surface_after(line, committed.surface, 0.0, speed, interval);
      trial.heat += slip_heat(committed, trial);
      return {};
    }
    const bool heats = committed.slides && length(committed.deformation) < line.edge();
    HeatedSlidingIsolator::State ignored;
    const HeatedSlidingIsolator::Surface surface =
        committed.slides && interval > 0.0 ? under.heat(with_flux(committed.surface, heats), speed, interval, ignored)
                                           : under.unheated(committed.surface, speed);
    const double mu = surface.coefficient, before = committed.compression > 0.0 ? committed.compression : weight,
                 mean_weight = 0.5 * (before + weight), of_before = committed.compression > 0.0 ? 0.5 : 1.0;
    const PlanVector increment = deformation - committed.deformation;
    const CircularFriction friction =
        CircularFriction::after(committed.friction_force, mu * weight, mu * mean_weight, elastic,
                                [&](const SaturatingSlip& slip, PlanVector z0) {
                                  return slip.advance(z0, increment, committed.rate, rate, interval);
                                });
    const PlanVector z = friction.step.z;
    constexpr double round_off = 1e-8;
    trial.friction_force = friction.force;
    trial.slides = dot(z, z) >= 1.0 - round_off && dot(z, rate) > 0.0;
    trial.heat += slip_heat(committed, trial);
    trial.surface =
        surface_after(under, committed.surface, share_over_centre(committed, increment, mu * weight), speed, interval);
    const bool covers = length(deformation) < line.edge();
    // The flux of a slide that begins heats from the next step on.
    if (interval == 0.0)
      trial.surface.rise = committed.surface.rise;
    else if (committed.slides && trial.slides && covers)
      trial.surface.rise = sliding(under, trial.surface, speed).rise;
    const PlanVector by_friction = weight * friction.by_limit + mean_weight * friction.by_mean,
                     along = speed > 0.0 ? rate / speed : PlanVector{};
    const HeatedSlidingIsolator::State now = with_flux(trial.surface, covers);
    const double mu_rate = under.rates_of(now, speed, 0.0).coefficient,
                 mu_slope = under.rates_of(now, speed, 1.0).coefficient - mu_rate;
    PlanarAxialResponse response;
    response.force = restoring * deformation + friction.force;
    response.stiffness = restoring + friction.by_increment;
    response.damping = friction.by_rate + PlanMatrix::product(by_friction, surface.slope * along);
    response.force_rate = restoring * rate + mu * weight * friction.step.rate;
    const PlanVector by_spring = under.restoring_stiffness / weight * deformation;
    response.by_compression =
        by_spring + mu * (friction.by_limit + of_before * friction.by_mean) + surface.by_compression * by_friction;
    response.rate_by_compression = by_spring;
    if (trial.slides) {
      response.force_rate = response.force_rate + weight * mu_rate * z;
      response.viscosity = PlanMatrix::product(z, weight * mu_slope * along);
      response.rate_by_compression += (mu + weight * surface.by_compression) * z;
    }
    return response;
  }
  double stored_energy(const State& committed, PlanVector deformation) const {
    return std::max(committed.compression, 0.0) * weight_lever(committed, deformation, committed, deformation) +
           0.5 * dot(committed.friction_force, committed.friction_force) / line.elastic_stiffness;
  }
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const { return line.linear_stiffness(stage); }
  /// d(from).d(to)/(2 R), m: the work of a changing compression in a step is (N1 - N0) times it.
  double weight_lever(const State&, PlanVector from, const State&, PlanVector to) const {
    return 0.5 * line.restoring_stiffness / line.normal_force * dot(from, to);
  }

 private:
  [[nodiscard]] HeatedSlidingIsolator under_weight(double weight) const {
    HeatedSlidingIsolator law = line;
    law.restoring_stiffness = weight / line.normal_force * line.restoring_stiffness;
    law.normal_force = weight;
    return law;
  }
  [[nodiscard]] double slip_heat(const State& from, const State& to) const {
    const PlanVector slip =
        to.deformation - from.deformation - (to.friction_force - from.friction_force) / line.elastic_stiffness;
    return 0.5 * dot(from.friction_force + to.friction_force, slip);
  }
  // A surface on which it slides, over the centre or not.
  static HeatedSlidingIsolator::State with_flux(HeatedSlidingIsolator::State surface, bool covers) {
    surface.direction = 1;
    surface.side = covers ? 0 : 1;
    if (!covers) surface.flux = 0.0;
    return surface;
  }
  // The surface at this instant, where it slides over the centre from now on.
  static HeatedSlidingIsolator::State sliding(const HeatedSlidingIsolator& under,
                                              const HeatedSlidingIsolator::State& surface, double speed) {
    HeatedSlidingIsolator::State now;
    under.heat(with_flux(surface, true), speed, 0.0, now);
    return now;
  }
  // The surface after a step on a part of which it slides over the centre. The memory is linear in the flux.
  static HeatedSlidingIsolator::State surface_after(const HeatedSlidingIsolator& under,
                                                    const HeatedSlidingIsolator::State& committed, double share,
                                                    double speed, double interval) {
    HeatedSlidingIsolator::State resting = committed, after, heated;
    resting.flux = 0.0;
    under.heat(resting, 0.0, interval, after);
    if (share > 0.0) {
      under.heat(with_flux(committed, true), speed, interval, heated);
      for (std::size_t j = 0; j < after.memory.size(); ++j)
        after.memory[j] += share * (heated.memory[j] - after.memory[j]);
      resting = after;
      under.heat(resting, 0.0, 0.0, after);
    }
    after.flux = sliding(under, after, speed).flux;
    return after;
  }
  [[nodiscard]] double share_over_centre(const State& committed, PlanVector increment, double limit) const {
    const double size = length(increment);
    if (size == 0.0) return committed.slides && length(committed.deformation) < line.edge() ? 1.0 : 0.0;
    const PlanVector way = increment / size;
    // It slides from here on, where the friction has grown to the circle, ...
    const double p = dot(committed.friction_force, way), q = cross(way, committed.friction_force);
    const double slides_from =
        committed.slides && p > 0.0
            ? 0.0
            : std::max(std::sqrt(std::max(limit * limit - q * q, 0.0)) - p, 0.0) / line.elastic_stiffness;
    // ... and is over the centre between these points.
    const double along = dot(committed.deformation, way), across = cross(way, committed.deformation);
    const double half = std::sqrt(std::max(line.edge() * line.edge() - across * across, 0.0));
    return std::max(std::min(half - along, size) - std::max(-half - along, std::min(slides_from, size)), 0.0) / size;
  }
};

/// The law of a bearing in plan with this weight at rest, N, unless it has a weight of its own. Throws InputError for a
/// bad parameter.
inline PlanarHeatedPendulum in_plan_under_changing_weight(const HeatedFrictionPendulum& pendulum, Force static_weight) {
  pendulum.check(Check{HeatedFrictionPendulum::name, ""});
  return {pendulum.carrying(pendulum.weight.si() > 0.0 ? pendulum.weight : static_weight)};
}
/// The law under a weight that does not change.
inline Carrying<PlanarHeatedPendulum> in_plan(const HeatedFrictionPendulum& pendulum, Force weight) {
  const PlanarHeatedPendulum law = in_plan_under_changing_weight(pendulum, weight);
  return {law, law.line.normal_force};
}

}  // namespace moat
