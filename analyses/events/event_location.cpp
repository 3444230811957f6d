#include "analyses/events/event_location.hpp"

#include <limits>

namespace moat {
namespace {

// A step and the margin at its end.
struct Trial {
  double length = 0.0;  // s
  double margin = 0.0;  // m
};

// The length at which the straight line through both margins reaches the aim.
double secant(const Trial& a, const Trial& b, double aim) {
  return a.length + (b.length - a.length) * (a.margin - aim) / (a.margin - b.margin);
}

// The part of a step in which the first change lies: from a length whose step ends before it to one that ends beyond.
struct Bracket {
  Trial before, beyond;

  [[nodiscard]] double width() const { return beyond.length - before.length; }
  [[nodiscard]] bool contains(double length) const { return length > before.length && length < beyond.length; }
};

}  // namespace

bool is_located(const RegimeScan& seen, double location_tolerance) {
  return !seen.crossed_back && seen.margin < 0.0 && seen.margin >= -location_tolerance;
}

double locate_change(StepSolver& step, double h, RegimeScan seen) {
  const double tolerance = step.location_tolerance();
  const double start = step.state().time();
  const double shortest = 4.0 * std::numeric_limits<double>::epsilon() * (start + h);
  Bracket bracket{.before = {}, .beyond = {h, seen.margin}};
  double next = seen.fraction * h;
  constexpr int solves_by_motion = 8;
  for (int count = 0;; ++count) {
    // Every iterate solves the step again with a new length. The length comes from the motion at the end of the last
    // trial. Where this leaves the bracket, it comes from the interpolated margin of a step that ends beyond the
    // change, or else from the straight line between the margins of the bracket. Bisection replaces a length outside
    // the bracket, and every second one after the eighth (ContactEvents tests count the solves). A bracket of round-off
    // width ends the search.
    const double width = bracket.width();
    const bool slow = count > solves_by_motion && count % 2 == 0;
    if (!bracket.contains(next) || slow) next = bracket.before.length + 0.5 * width;
    if (width <= shortest) next = bracket.beyond.length;
    ++step.statistics().event_solves;
    if (!step.solve(next)) {
      // The cut step may end before the change, or far beyond it: scan it again.
      const double shorter = step.solve_cutting(0.5 * next);
      seen = step.scan(shorter);
      return seen.crossed ? locate_change(step, shorter, seen) : shorter;
    }
    seen = step.scan(next);
    if (is_located(seen, tolerance) || (seen.margin < 0.0 && width <= shortest)) return next;
    if (seen.crossed && width <= shortest) return next;  // crossed and came back within round-off: no change
    // This step has no change. If the longer step crossed a margin and came back, the change lies in the rest of it,
    // which the next step scans again.
    if (!seen.crossed && (width <= shortest || bracket.beyond.margin >= 0.0)) return next;
    (seen.crossed ? bracket.beyond : bracket.before) = {next, seen.margin};
    // Where a margin was crossed and came back, the motion at the end of the step is not that of the change.
    const double by_motion = seen.crossed_back ? 0.0 : next + step.state().time_to_next_change(step.aim());
    next = bracket.contains(by_motion) ? by_motion
           : seen.crossed              ? seen.fraction * next
                                       : secant(bracket.before, bracket.beyond, step.aim());
  }
}

}  // namespace moat
