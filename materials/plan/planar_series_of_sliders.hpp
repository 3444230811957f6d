// Sliders one upon another, in plan: the law of double and triple pendulums.
#pragma once

#include <array>
#include <cstddef>

#include "materials/carrying.hpp"
#include "materials/isolation/double_pendulum.hpp"
#include "materials/isolation/triple_pendulum.hpp"
#include "materials/plan/planar_response.hpp"
#include "materials/series_of_sliders.hpp"

namespace moat {

/// SeriesOfSliders in plan, under a weight N that may change: all sliders carry the same force vector F, and the
/// deformation is the sum of their displacements.
///
///     slider i:   F = N/R_i u_i + q_i + stops along u_i,   q_i' = k_e u_i' inside |q_i| < mu_i N,
///                                                          and on this circle with slip along q_i
///
/// R_i = W/k_i and mu_i = f_i/W are those of the law on a line under its static weight W; k_e and the stiffness of the
/// stops do not change with N. On a straight path it is the law on a line. On a path that turns it is not the law of
/// |d|, because the sliders turn one after another.
///
/// In a step every slider moves straight, and its friction follows exactly (materials/saturating_slip.hpp): a path that
/// turns is right to second order. Newton's method finds the displacements at which all forces are equal, from the
/// return mapping or in up to 64 equal pieces of the step where it does not converge at once. The force does not depend
/// on speed. Below W/100 it is that under W/100 times N/(W/100): zero where the bearing lifts, N <= 0.
///
/// Stored energy is that of the springs; dissipated is the mean friction of a step times the change of slip.
struct PlanarSeriesOfSliders {
  static constexpr std::string_view name = "PlanarSeriesOfSliders";
  static constexpr std::size_t most = SeriesOfSliders::most;  ///< Largest number of sliders.

  SeriesOfSliders line;        ///< The law on a line, under `static_weight`.
  double static_weight = 0.0;  ///< W > 0 N

  /// One slider of the series.
  struct Slider {
    PlanVector displacement{};    ///< u_i, m
    PlanVector friction_force{};  ///< q_i, N

    friend bool operator==(const Slider&, const Slider&) = default;
  };
  struct State {
    std::array<Slider, most> sliders{};  ///< the first `line.count` of them exist
    double compression = 0.0;            ///< N, of the instant
    double heat = 0.0;                   ///< J, dissipated so far

    friend bool operator==(const State&, const State&) = default;
  };

  void check(const Check& check) const {
    check.positive("weight", static_weight * units::N,
                   "Give the weight on this bearing; a PlanBuilding knows its share.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const { return {{"weight", static_weight, "N"}}; }

  PlanarAxialResponse evaluate(const State& committed, PlanVector deformation, PlanVector rate, double interval,
                               AxialForce axial, State& trial) const;
  double stored_energy(const State& committed, PlanVector deformation) const;
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const { return line.linear_stiffness(stage); }
  /// The sum of u_i(from).u_i(to)/(2 R_i), m: the work of a changing compression in a step is (N1 - N0) times it.
  double weight_lever(const State& from, PlanVector from_deformation, const State& to, PlanVector to_deformation) const;
};

/// The law of a bearing in plan with this weight at rest, N, unless it has a weight of its own. Throws InputError for a
/// bad parameter.
template <class Pendulum>
requires std::same_as<Pendulum, DoublePendulum> || std::same_as<Pendulum, TriplePendulum> PlanarSeriesOfSliders
in_plan_under_changing_weight(const Pendulum& pendulum, Force static_weight) {
  pendulum.check(Check{Pendulum::name, ""});
  const Force weight = pendulum.weight.si() > 0.0 ? pendulum.weight : static_weight;
  return {pendulum.carrying(weight), weight.si()};
}
/// The law under a weight that does not change.
template <class Pendulum>
requires std::same_as<Pendulum, DoublePendulum> || std::same_as<Pendulum, TriplePendulum>
    Carrying<PlanarSeriesOfSliders> in_plan(const Pendulum& pendulum, Force weight) {
  const PlanarSeriesOfSliders law = in_plan_under_changing_weight(pendulum, weight);
  return {law, law.static_weight};
}

}  // namespace moat
