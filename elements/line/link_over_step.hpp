// The force and the work of a link over a step inside which its regime changes.
#pragma once

#include <cstddef>
#include <span>

#include "base/gauss.hpp"
#include "elements/line/link_changes.hpp"
#include "elements/line/link_energies.hpp"
#include "elements/line/link_motion.hpp"
#include "materials/response.hpp"
#include "model/impulses.hpp"

namespace moat {

/// One link along its interpolated deformation from the start to the end of a step, in parts between its changes. All
/// integrals follow Gauss's rule with five points in every part.
template <ForceLaw Law>
class LinkOverStep {
 public:
  /// History of the link.
  using State = typename Law::State;
  /// A change of its regime.
  using Change = typename LinkChanges<State>::Change;

  /// Motions at both ends of a step of `step` s, and the state after all changes; all must outlive this object.
  LinkOverStep(const Law& law, const LinkMotion& start, const LinkMotion& end, std::size_t link, double step,
               std::span<const Change> changes, const State& last)
      : law_{&law},
        start_{start.deformations[link], start.rates[link], start.second_rates[link]},
        end_{end.deformations[link], end.rates[link], end.second_rates[link]},
        path_{path_between(start, end, link, step)},
        step_{step},
        changes_{changes},
        last_{&last} {}

  /// The force and its integrals.
  [[nodiscard]] ForceOverStep force() const {
    ForceOverStep force;
    for_each_point([&](const State& state, double x, double length) {
      const double impulse = length * respond_at(state, x).force;
      force.impulse += impulse;
      force.falling += (1.0 - x) * impulse;
    });
    const ForceAndRate first = force_at(changes_.empty() ? *last_ : changes_.front().before, 0.0, start_),
                       last = force_at(*last_, step_, end_);
    force.start = first.force;
    force.start_rate = first.rate;
    force.end = last.force;
    force.end_rate = last.rate;
    return force;
  }

  /// The work, and the dissipation of laws that have a rate of it.
  [[nodiscard]] TotalWork work() const {
    TotalWork total;
    for_each_point([&](const State& state, double x, double length) {
      total.work += length * respond_at(state, x).force * path_.rate(x);
      if constexpr (!LinkEnergies<Law>::hysteretic)
        total.dissipated += length * law_->dissipation_rate(state, path_.value(x), path_.rate(x));
    });
    return total;
  }

 private:
  struct Motion {
    double deformation, rate, second_rate;  // m, m/s, m/s^2
  };
  struct ForceAndRate {
    double force, rate;  // N, N/s
  };

  // Calls add(state, x, length) at the points of the quadrature; `length` s is the weight of the point.
  template <class Add>
  void for_each_point(const Add& add) const {
    double from = 0.0;
    const auto add_part = [&](const State& state, double to) {
      Gauss::visit(from, to, [&](double x, double weight) { add(state, x, weight * step_); });
      from = to;
    };
    for (const Change& change : changes_) add_part(change.before, change.fraction);
    add_part(*last_, 1.0);
  }
  [[nodiscard]] Response respond_at(const State& state, double x) const {
    State after;
    return respond(*law_, state, path_.value(x), path_.rate(x), interval(x * step_), after);
  }
  // At an end of the step, with the rate that the scheme sees there (Links::evaluate_rates()).
  [[nodiscard]] ForceAndRate force_at(const State& state, double time, const Motion& motion) const {
    State after;
    const Response response = respond(*law_, state, motion.deformation, motion.rate, interval(time), after);
    if constexpr (requires { law_->force_rate(after, motion.deformation, motion.rate, motion.second_rate); })
      return {response.force, law_->force_rate(after, motion.deformation, motion.rate, motion.second_rate)};
    else
      return {response.force, response.stiffness * motion.rate + response.damping * motion.second_rate};
  }
  [[nodiscard]] Interval interval(double time) const { return {time, start_.deformation, start_.rate}; }

  const Law* law_;
  Motion start_, end_;
  HermiteQuintic path_;
  double step_;
  std::span<const Change> changes_;
  const State* last_;
};

}  // namespace moat
