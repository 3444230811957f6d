// High-damping rubber of Grant, Fenves and Whittaker in two components.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "materials/isolation/grant_rubber.hpp"
#include "materials/plan/planar_response.hpp"

namespace moat {

/// High-damping rubber bearing in plan: the parts of GrantRubber with U = |d| and vectors d, n, F1 and F2.
///
///     F1 = K_S1 K_M (a1 + a2 U^2 + a3 U^4) d
///     F2 = R n - g,   R = b1 + K_S2 b2 U^2,   dg = -b3 g |dd|,   n = direction of motion
///
/// g is R n - F2 where the motion took its direction. Along a line it is `GrantRubber`. Every step is taken as a
/// straight increment, for which the force is exact: U falls to the point nearest to the origin and rises behind it.
/// The dissipation follows by quadrature. Source: Grant, Fenves & Whittaker (2004).
struct BiaxialGrantRubber {
  static constexpr std::string_view name = "BiaxialGrantRubber";

  /// The parameters of the rubber in one direction.
  GrantRubber rubber;

  struct State {
    PlanVector deformation{};      ///< m
    PlanVector hysteretic{};       ///< F2, N
    GrantRubber::Damage damage{};  ///< Thresholds and wear so far.
    double heat = 0.0;             ///< J, dissipated so far

    friend bool operator==(const State&, const State&) = default;
  };

  void check(const Check& check) const { rubber.check(check); }
  [[nodiscard]] std::vector<Parameter> parameters() const { return rubber.parameters(); }

  PlanarResponse evaluate(const State& committed, PlanVector deformation, PlanVector rate, double, State& trial) const {
    const PlanVector increment = deformation - committed.deformation;
    const double size = length(increment);
    constexpr double negligible = 1e-12;  // m
    trial = committed;
    if (size <= negligible) {
      // No direction of its own: that of the rate, along which the next increment will go.
      const PlanVector n = direction_of(rate, deformation);
      const PlanMatrix stiffness = tangent_at_start(committed, n);
      trial.deformation = deformation;
      return {.force = force_of(trial, rubber.wear_of(trial.damage).elastic),
              .stiffness = stiffness,
              .force_rate = stiffness * rate};
    }
    const PlanVector n = increment / size, m = turned_left(n);
    const Nearest nearest{committed.deformation, n, size};
    const double u = length(deformation);
    const GrantRubber::Radii radii{length(committed.deformation), nearest.distance, u};
    trial.deformation = deformation;
    trial.damage = GrantRubber::worn(committed.damage, radii);
    const GrantRubber::Wear wear = rubber.wear_of(trial.damage, radii, committed.damage.lower);
    const double start_bound = rubber.bound(rubber.wear_of(committed.damage), radii.start),
                 end_bound = rubber.bound(wear, u), fading = std::exp(-rubber.b3.si() * size);
    const PlanVector gap = start_bound * n - committed.hysteretic;
    trial.hysteretic = end_bound * n - fading * gap;
    trial.heat += heat_of(committed, trial, nearest, n, dot(gap, n), size);

    // The increment turns by dphi = (m . dd)/size, so that dn = m dphi.
    const PlanVector lowest_slope = nearest.slope(deformation, m, size);
    const PlanMatrix turning = ((end_bound - start_bound * fading) / size) * PlanMatrix::product(m, m);
    const PlanMatrix hysteretic = PlanMatrix::product(n, bound_slope(wear, deformation, lowest_slope)) +
                                  PlanMatrix::product(rubber.b3.si() * fading * gap, n) + turning;
    const PlanVector going_on = direction_of(rate, increment);
    return {.force = force_of(trial, wear.elastic),
            .stiffness = elastic_tangent(wear, deformation, lowest_slope) + hysteretic,
            .force_rate = tangent_at_start(trial, going_on) * rate};
  }
  double stored_energy(const State& committed, PlanVector deformation) const {
    return rubber.wear_of(committed.damage).elastic * rubber.potential(dot(deformation, deformation));
  }
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const { return rubber.linear_stiffness(stage); }

 private:
  // The point of a straight move that is nearest to the origin.
  struct Nearest {
    Nearest(PlanVector start, PlanVector n, double size)
        : at{std::clamp(-dot(start, n), 0.0, size)},
          offset{dot(start, turned_left(n))},
          distance{length(start + at * n)} {}

    // d(distance)/d(end of the move).
    [[nodiscard]] PlanVector slope(PlanVector end, PlanVector m, double size) const {
      if (at == 0.0) return {};
      if (at == size) return distance > 0.0 ? end / distance : PlanVector{};
      return std::copysign(at / size, offset) * m;
    }

    double at;        // along the move, m
    double offset;    // of the origin from the line, m
    double distance;  // m
  };

  static PlanVector direction_of(PlanVector rate, PlanVector otherwise) {
    if (const double size = length(rate); size > 0.0) return rate / size;
    const double size = length(otherwise);
    return size > 0.0 ? otherwise / size : PlanVector{1.0, 0.0};
  }
  [[nodiscard]] PlanVector force_of(const State& state, double wear) const {
    return wear * rubber.secant(length(state.deformation)) * state.deformation + state.hysteretic;
  }
  [[nodiscard]] PlanMatrix elastic_tangent(const GrantRubber::Wear& wear, PlanVector d, PlanVector lowest_slope) const {
    const double square = dot(d, d), secant = rubber.secant(std::sqrt(square));
    const double per_square = 2.0 * rubber.a2.si() + 4.0 * rubber.a3.si() * square;
    return wear.elastic * (PlanMatrix::diagonal(secant) + per_square * PlanMatrix::product(d, d)) +
           wear.elastic_slope * secant * PlanMatrix::product(d, lowest_slope);
  }
  // dR/dd.
  [[nodiscard]] PlanVector bound_slope(const GrantRubber::Wear& wear, PlanVector d, PlanVector lowest_slope) const {
    return rubber.b2.si() * (2.0 * wear.bound * d + wear.bound_slope * dot(d, d) * lowest_slope);
  }
  // Returns the tangent of a move in direction n that begins in this state.
  [[nodiscard]] PlanMatrix tangent_at_start(const State& state, PlanVector n) const {
    const PlanVector d = state.deformation, m = turned_left(n);
    const double u = length(d);
    const bool falls = dot(d, n) < 0.0;
    const GrantRubber::Wear wear =
        falls ? rubber.wear_of(state.damage, {u, u, u}, state.damage.lower) : rubber.wear_of(state.damage);
    const PlanVector lowest_slope = falls ? d / u : PlanVector{}, slope = bound_slope(wear, d, lowest_slope);
    const double bound = rubber.bound(wear, u), decay = rubber.b3.si();
    return elastic_tangent(wear, d, lowest_slope) + PlanMatrix::product(n, slope) +
           PlanMatrix::product(decay * (bound * n - state.hysteretic), n) +
           (decay * bound + dot(slope, n)) * PlanMatrix::product(m, m);
  }

  [[nodiscard]] double heat_of(const State& from, const State& to, const Nearest& nearest, PlanVector n, double along,
                               double size) const {
    double work = rubber.decaying_work(along, size);
    const auto add = [&](double begin, double end) {
      if (begin == end) return;
      const auto path = [&](double share) {
        const PlanVector d = from.deformation + (begin + share * (end - begin)) * n;
        const double u = length(d);
        return std::pair{u, u > 0.0 ? dot(d, n) / u : 0.0};
      };
      const GrantRubber::Damage damage =
          begin == 0.0 ? from.damage
                       : GrantRubber::worn(from.damage, {length(from.deformation), nearest.distance, nearest.distance});
      work += rubber.smooth_work(damage, end - begin, path);
    };
    add(0.0, nearest.at);
    add(nearest.at, size);
    return work - stored_energy(to, to.deformation) + stored_energy(from, from.deformation);
  }
};

/// The law of a bearing in plan.
inline BiaxialGrantRubber in_plan(const GrantRubber& rubber) { return {rubber}; }

}  // namespace moat
