// A rubber bearing under a weight that changes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "materials/bearings/axial_softening.hpp"
#include "materials/bilinear.hpp"

namespace moat {

/// The common part of rubber bearings under an axial force N, on a line and in plan:
///
///     F = k_2 d + q,     k_2 = k_20 max(0.01, 1 - (N/P_cr)^2) for N > 0, else k_20 (AxialSoftening)
///
/// k_20 and q, the part of the lead or of the damping rubber, are those of the law without axial force: strength and
/// dissipation do not change. The stored energy is k_2 d^2/2 and that of q. Tension positive; N is compression.
template <class Yielding, class Vector>
struct SofteningLaw {
  Yielding bilinear;           ///< The law without axial force.
  RubberBearing rubber;        ///< Gives P_cr; on a line d of a rectangle is along x.
  double static_weight = 0.0;  ///< > 0 N, of linear analyses

  void check(const Check& check) const {
    bilinear.check(check);
    rubber.check(check);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    std::vector<Parameter> list = bilinear.parameters();
    list.push_back({"critical_load", rubber.critical_load().si(), "N"});
    list.push_back({"static_weight", static_weight, "N"});
    return list;
  }

  struct State {
    /// History of the yielding part.
    typename Yielding::State yielding{};
    Vector farthest{};         ///< the displacement with the smallest overlap so far, m
    bool grows = false;        ///< whether that is the present displacement
    double compression = 0.0;  ///< N, N

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 1> quantities{{{"critical_load", "N"}}};

  double stored_energy(const State& state, Vector deformation) const {
    return bilinear.stored_energy(state.yielding, deformation) + 0.5 * change(state) * dot(deformation, deformation);
  }
  double dissipated_energy(const State& from, const State& to) const {
    return bilinear.dissipated_energy(from.yielding, to.yielding);
  }
  double weight_work(const State& from, Vector deformation, const State& to, Vector end_deformation) const {
    return 0.5 * dot(deformation, end_deformation) * (change(to) - change(from));
  }
  double weight_power(const State& state, Vector deformation, Vector rate, double compression_rate) const {
    const AxialSoftening softening = at(state);
    return 0.5 * k_20() * dot(deformation, deformation) *
           (softening.by_compression * compression_rate + fall(state, softening.by_displacement, rate));
  }
  double linear_stiffness(StiffnessStage stage) const {
    return bilinear.linear_stiffness(stage) + change({.compression = static_weight});
  }
  ReportedValue quantity(std::size_t, const State& state, Vector, Vector rate, Vector) const {
    const AxialSoftening softening = at(state);
    return {softening.critical_load, fall(state, softening.critical_slope, rate)};
  }

 protected:
  /// Returns the vector along the line.
  static PlanVector plan_vector(double along) { return {along, 0.0}; }
  /// Returns the vector itself.
  static PlanVector plan_vector(PlanVector vector) { return vector; }
  /// Returns the stiffness after yield without weight, N/m.
  [[nodiscard]] double k_20() const { return bilinear.post_yield_stiffness.si(); }
  /// Returns the softening of a state.
  [[nodiscard]] AxialSoftening at(const State& state) const {
    return {rubber, state.compression, plan_vector(state.farthest)};
  }
  /// Returns k_2 - k_20, N/m.
  [[nodiscard]] double change(const State& state) const { return k_20() * (at(state).factor - 1.0); }
  /// Returns the rate of a number with this slope, which falls while the farthest displacement grows.
  static double fall(const State& state, PlanVector slope, Vector rate) {
    return state.grows ? std::min(dot(slope, plan_vector(rate)), 0.0) : 0.0;
  }
};

/// A rubber bearing whose stiffness falls with the axial force and its largest displacement so far, D, on which P_cr
/// depends; the rest of it is `Bilinear`. While |d| = D moves outwards, D grows; beginning and end of that are located,
/// as those of yielding.
struct RubberUnderWeight : SofteningLaw<Bilinear, double> {
  static constexpr std::string_view name = "RubberUnderWeight";

  Response evaluate(const State& committed, double deformation, double rate, Interval, AxialForce axial,
                    State& trial) const {
    trial = committed;
    trial.compression = axial.compression;
    if (committed.grows) trial.farthest = deformation;
    Response response = bilinear.evaluate(committed.yielding, deformation, rate, trial.yielding);
    const AxialSoftening softening = at(trial);
    const double change = k_20() * (softening.factor - 1.0), by_deformation = k_20() * deformation;
    response.force += change * deformation;
    response.stiffness += change + (committed.grows ? by_deformation * softening.by_displacement.x : 0.0);
    response.by_compression = by_deformation * softening.by_compression;
    return response;
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    return bilinear.dissipation_rate(committed.yielding, deformation, rate);
  }

  double regime_margin(const State& committed, double deformation, double rate, AxialForce) const {
    return std::min(bilinear.regime_margin(committed.yielding, deformation, rate),
                    margin_of_farthest(committed, deformation, rate));
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    State next = committed;
    if (bilinear.regime_margin(committed.yielding, deformation, rate) < 0.0)
      next.yielding = bilinear.next_regime(committed.yielding, deformation, rate);
    if (margin_of_farthest(committed, deformation, rate) < 0.0) {
      next.farthest = deformation;
      next.grows = !committed.grows;
    }
    return next;
  }

 private:
  [[nodiscard]] double margin_of_farthest(const State& committed, double deformation, double rate) const {
    if (committed.grows) return std::copysign(Bilinear::time_of_rate, committed.farthest) * rate;
    return std::abs(committed.farthest) + Bilinear::threshold * bilinear.yield_displacement.si() -
           std::abs(deformation);
  }
};

}  // namespace moat
