// The motion and the regimes of links inside a step.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "elements/block/law_response.hpp"
#include "elements/block/link_motion.hpp"
#include "elements/block/regime_search.hpp"
#include "model/element_states.hpp"

namespace moat {

/// Laws, states and motion of all links of a block at both ends of a step of `length` s.
///
/// Whether a margin of a law with regimes is crossed inside the step is judged on the cubic through deformation and
/// rate at both ends, and where on the quintic through both rates.
template <class Law>
struct LinkStep {
  using State = typename Law::State;  ///< History of one link.
  using Vector = VectorOf<Law>;       ///< Deformations and forces.
  /// The motion at one instant.
  using Motion = DeformationAndRate<Vector>;
  /// Whether the law takes an axial force.
  static constexpr bool takes_axial_force = AxialForceLaw<Law> || PlanarAxialForceLaw<Law>;

  const std::vector<Law>& laws;         ///< of all links
  const std::vector<State>& committed;  ///< at the start
  const std::vector<State>& trial;      ///< at the end
  const LinkMotion<Vector>& start;      ///< at the start
  const LinkMotion<Vector>& end;        ///< at the end
  const LinkCompressions& start_axial;  ///< at the start
  const LinkCompressions& end_axial;    ///< at the end
  const std::vector<Vector>& forces;    ///< at the end, N
  double length;                        ///< s, >= 0

  /// The axial force of a link at the end; none for a law that takes none.
  [[nodiscard]] AxialForce axial_at_end([[maybe_unused]] std::size_t i) const {
    if constexpr (takes_axial_force) return {end_axial.values[i], start_axial.rates[i]};
    return {};
  }
  /// Returns the rate of the compression, N/s.
  [[nodiscard]] double compression_rate_at_end([[maybe_unused]] std::size_t i) const {
    if constexpr (takes_axial_force) return end_axial.rates[i];
    return 0.0;
  }
  /// Evaluates the law of a link at a fraction of the step, where it has this motion.
  ResponseOf<Law> respond(std::size_t i, double fraction, Motion motion, State& after) const {
    AxialForce axial;
    if constexpr (takes_axial_force)
      axial = {compression_between(start_axial, end_axial, i, length).value(fraction), start_axial.rates[i]};
    return respond_over(laws[i], committed[i], motion, {start.deformations[i], start.rates[i]}, fraction * length,
                        axial, after);
  }

  /// The force that a law loses where its path turns at this fraction of the step, N: the difference at the end if the
  /// law is led to the turn first. With one component it is the larger of that and the distance of its force at the
  /// turn from its tangent, of this stiffness, at the end.
  [[nodiscard]] Vector lost_by_turn(std::size_t i, double turn, [[maybe_unused]] auto stiffness) const {
    const Motion at_end{end.deformations[i], end.rates[i]};
    State at_turn, after;
    const auto from_turn = [&] {
      return respond_over(laws[i], at_turn, at_end, {}, (1.0 - turn) * length, axial_at_end(i), after).force -
             forces[i];
    };
    if constexpr (PlanarLaw<Law>) {
      const PlanPath path = path_between(start, end, i, length);
      respond(i, turn, {path.value(turn), path.rate(turn)}, at_turn);
      return from_turn();
    } else {
      const double farthest = cubic_between(start, end, i, length).value(turn);
      const double force = respond(i, turn, {farthest, at_end.rate}, at_turn).force, lost = from_turn(),
                   from_tangent = force - forces[i] - stiffness * (farthest - at_end.deformation);
      return std::abs(lost) > std::abs(from_tangent) ? lost : from_tangent;
    }
  }

  /// The margin of a law at an instant, from the committed state and the state there. It takes the compression of that
  /// state, on one of equal laws.
  static double margin_at(const Law& law, const State& committed, [[maybe_unused]] const State& there,
                          double deformation, double rate) {
    if constexpr (MarginUnderAxialForce<Law>)
      return law.regime_margin(committed, deformation, rate, AxialForce{there.compression});
    else if constexpr (takes_axial_force)
      return law.regime_margin(there, deformation, rate);
    else
      return law.regime_margin(committed, deformation, rate);
  }

  /// Adds the margin of a link at the end, and where it falls to `aim` inside the step.
  void scan(std::size_t i, double aim, RegimeScan& scan) const {
    const double end_margin = margin_at(laws[i], committed[i], trial[i], end.deformations[i], end.rates[i]);
    scan.margin = std::min(scan.margin, end_margin);
    double beyond = 1.0;
    if (end_margin >= 0.0) {
      // A crossing that returns within the step is possible only where the deformation, or the axial force, turns in
      // it.
      const HermiteCubic path = cubic_between(start, end, i, length);
      const auto is_crossed = [&](double turn) {
        return turn > 0.0 && margin(i, turn, path.value(turn), path.rate(turn)) < 0.0;
      };
      beyond = turning_point(start.rates[i], end.rates[i]);
      bool is_back = is_crossed(beyond);
      if constexpr (takes_axial_force) {
        if (!is_back) {
          beyond = turning_point(start_axial.rates[i], end_axial.rates[i]);
          is_back = is_crossed(beyond);
        }
      }
      if (!is_back) return;
      scan.crossed_back = true;
    }
    scan.crossed = true;
    // The step ends in the band that locate_change() aims at: to look for the instant would be in vain.
    if (end_margin >= 2.0 * aim && !scan.crossed_back) return;
    if (scan.fraction <= 0.0) return;
    const HermiteQuintic path = path_between(start, end, i, length);
    const auto margin_inside = [&](double fraction) {
      return margin(i, fraction, path.value(fraction), path.rate(fraction));
    };
    scan.fraction = std::min(scan.fraction, first_fall(margin_inside, beyond, aim));
  }

  /// The time after the end, s, near which the margin of a link falls to `aim`; infinite if it does not.
  [[nodiscard]] double next_fall(std::size_t i, double aim) const {
    const double deformation = end.deformations[i], rate = end.rates[i], second_rate = end.second_rates[i];
    State there;
    const auto margin_above_aim = [&](double time) {
      const Motion motion{deformation + time * (rate + 0.5 * time * second_rate), rate + time * second_rate};
      if constexpr (takes_axial_force)
        respond_over(laws[i], committed[i], motion, {start.deformations[i], start.rates[i]}, length + time,
                     {end_axial.values[i] + time * end_axial.rates[i], start_axial.rates[i]}, there);
      return margin_at(laws[i], committed[i], there, motion.deformation, motion.rate) - aim;
    };
    return fall_near(margin_above_aim);
  }

 private:
  // The margin of a law under an axial force is of its state there.
  [[nodiscard]] double margin(std::size_t i, double fraction, double deformation, double rate) const {
    if constexpr (takes_axial_force) {
      if (fraction == 1.0) return margin_at(laws[i], committed[i], trial[i], deformation, rate);
      State there;
      respond(i, fraction, {deformation, rate}, there);
      return margin_at(laws[i], committed[i], there, deformation, rate);
    } else {
      return laws[i].regime_margin(committed[i], deformation, rate);
    }
  }
};

}  // namespace moat
