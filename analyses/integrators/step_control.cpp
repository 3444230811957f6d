#include "analyses/integrators/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/equation_of_motion.hpp"

namespace moat {
namespace {

// Trials below are those of the 200 random models of ./moat bench accuracy, whose worst peaks have an error of 0.0056 %
// in the 90th percentile and of 0.030 % in the 99th.

// Further halvings of the first step after a touch. Trial: with 4 both errors double; 8 gains nothing.
constexpr int at_touch = 6;
// A contact is sustained after so many of its durations without an event. Trial: with 2 the 99th percentile is 0.071 %;
// with 8 it is 0.024 %, for 7 % more steps where there are many.
constexpr double durations_until_leaning = 4.0;
// The fourth-order scheme is stable up to h w = 2.45 without damping; h w and h c/m together leave room below that.
// Trial: 1.2 costs 7 % more steps where there are many and gains a sixth of the error; 2.3 gains nothing.
constexpr double of_frequency = 1.8, of_damping = 4.0;
// A contact under load has so many times the frequency of a free impact. Trial: with 1 the 90th percentile is 0.0059 %,
// with 4 it is 0.0047 %, for 1 % more steps.
constexpr double harder = 2.0;
// Up to so many halvings the fourth-order scheme costs less than average acceleration, and than strongly_damped().
constexpr int worth_halving = 6, worth_halving_for_dashpots = 1;
// For an equal estimate the error of average acceleration is larger: its error of period equals the estimate.
constexpr double stricter_at_second_order = 8.0;
// A step is repeated above so many tolerances.
constexpr double repeat_above = 2.0;
// A step that is repeated is cut to this share or less.
constexpr double shorter = 0.75;
// A step is halved above so many tolerances, and doubled where that leaves it below one divided by this. The distance
// keeps the length from alternating.
constexpr double halve_above = 1.2;
// The error of a step that was cut to less than this share is no measure for longer steps.
constexpr double shortest_usable = 0.25;
// Round-off of accelerations is not looked for below this squared frequency, 1/s^2.
constexpr double harmless_squared_frequency = 1e10;

// The factor of a step's error when its length doubles.
double change_by_doubling(StepScheme scheme) { return scheme.order() > 2 ? 8.0 : 4.0; }

}  // namespace

StepControl::StepControl(const AnalysisState& state, const StepSettings& settings, std::optional<StepScheme> scheme)
    : settings_{settings},
      scheme_of_all_{scheme},
      resultants_{state.model()},
      scales_{state, settings.peak_ground_acceleration} {
  SparseMatrix matrix = state.model().linear_stiffness(StiffnessStage::initial);
  const MassMatrix& mass = state.model().mass_matrix();
  const Vector stiffness = mass.largest_accelerations(resultants_.row_sums(matrix));
  stiffest_squared_ = stiffness.maxCoeff();
  constexpr double last_digits = 4.0 * std::numeric_limits<double>::epsilon();
  round_off_per_displacement_ = last_digits * stiffness;
  state.assemble_tangent(0.0, 1.0, 0.0, matrix);
  most_damped_ = mass.largest_accelerations(resultants_.row_sums(matrix)).maxCoeff();
  for (int halvings = 0; halvings <= settings_.max_halvings; ++halvings)
    steps_.push_back(std::ldexp(settings_.longest_step, -halvings));
  restart(state, false);
}

// Longest step inside the bound of stability of the fourth-order scheme, and of strongly_damped(), during a contact of
// this duration.
double StepControl::stable_step(double contact) const {
  const double of_contact = harder * std::numbers::pi / contact;  // zero without contact, which lasts forever
  const double frequency = std::sqrt(stiffest_squared_ + of_contact * of_contact);
  return of_frequency / std::max(frequency, std::numeric_limits<double>::min());
}
double StepControl::stable_damped_step() const {
  return of_damping / std::max(most_damped_, std::numeric_limits<double>::min());
}

StepControl::Step StepControl::next_step(const AnalysisState& state) {
  const double contact = state.shortest_contact();
  if (!adaptive()) {
    fewest_steps_per_contact_ = std::min(fewest_steps_per_contact_, contact / settings_.fixed_step);
    return {settings_.fixed_step, scheme_of_all_.value_or(StepScheme::average_acceleration())};
  }
  const bool pounding = since_event_ < durations_until_leaning * contact && std::isfinite(contact);
  // The nominal step is halved further for the contact, for stability, and for the first steps after a touch.
  int halvings = halvings_;
  if (pounding)
    while (halvings < settings_.max_halvings && step_at(halvings) * settings_.steps_per_contact > contact) ++halvings;
  StepScheme scheme = StepScheme::average_acceleration();
  const int halvings_without_bounds = halvings;
  if (scheme_of_all_) {
    scheme = *scheme_of_all_;
  } else if (ramp_ < at_touch) {
    const auto halved = [&](double stable, int worth) {
      int stable_halvings = halvings;
      while (stable_halvings < std::min(halvings_without_bounds + worth, settings_.max_halvings) &&
             step_at(stable_halvings) > stable)
        ++stable_halvings;
      if (step_at(stable_halvings) > stable) return false;
      halvings = stable_halvings;
      return true;
    };
    if (halved(stable_step(contact), worth_halving))
      scheme = halved(stable_damped_step(), worth_halving_for_dashpots) ? StepScheme::fourth_order()
                                                                        : StepScheme::strongly_damped();
  }
  if (scheme.order() == 2) halvings = halvings_without_bounds;
  planned_ = step_at(std::min(halvings + ramp_, settings_.max_halvings));
  scheme.filters_corrections |= !scheme_of_all_ && scheme.order() == 2 && planned_ > stable_damped_step();
  if (pounding) fewest_steps_per_contact_ = std::min(fewest_steps_per_contact_, contact / planned_);
  return {planned_, scheme};
}

// Largest error of all nodes, divided by the tolerance.
double StepControl::error_of(const AnalysisState& state, const StepTask& step, StepScheme scheme,
                             const double* filtered_curve) {
  const int count = state.model().degrees_of_freedom();
  const MotionState &start = state.motion(), &end = state.trial();
  const double *a0 = start.acceleration.data(), *a1 = end.acceleration.data(), *j0 = start.jerk.data(),
               *j1 = end.jerk.data(), *u1 = end.displacement.data(), *scales = scales_.values().data(),
               *round_off_per_displacement = round_off_per_displacement_.data();
  const double h = step.length;
  const bool fourth_order = scheme.order() > 2;
  // The parabola and the cubic may agree by chance where a force has a corner inside the step. The jump of the jerk
  // still shows the corner, and the model knows the force that is lost where a path turns.
  const UnlocatedCorners corners = state.find_corners(lost_forces_);
  const double of_jump = !fourth_order || corners.jump ? h : 0.0, of_curve = fourth_order ? 1.0 : 0.0;
  if (corners.turn) state.model().mass_matrix().solve(lost_forces_.data());
  const double* lost = lost_forces_.data();
  double largest = 0.0;
  with_ground_component(state.model(), h * step.ground_jerk, [&](const auto& rise_of_ground) {
    const auto curve = [&](int i) {
      if (filtered_curve != nullptr) return filtered_curve[i];
      return 2.0 * (a1[i] - a0[i] + rise_of_ground(i)) - h * (j0[i] + j1[i]);
    };
    const auto jump = [&](int i) {
      return filtered_curve != nullptr && !fourth_order ? filtered_curve[i] / h : j1[i] - j0[i];
    };
    const auto displacement = [&](int i) { return u1[i]; };
    const auto lost_acceleration = [&](int i) { return lost[i]; };
    const GroundColumns shares = state.model().ground_influence();
    const auto acceleration = [&](int i) { return a1[i] + shares.times(step.ground_acceleration, i); };
    resultants_.with([&](const auto& size) {
      for (int i = 0; i < count; ++i) {
        double difference = std::max(of_curve * size(i, curve), of_jump * size(i, jump)) / 12.0;
        if (corners.turn) difference += size(i, lost_acceleration);
        // Most nodes are far from the worst one, and need no look at their round-off.
        if (difference <= largest * scales[i]) continue;
        const double beyond_round_off = difference - round_off_per_displacement[i] * size(i, displacement);
        const double scale = std::max(scales[i], size(i, acceleration));
        if (beyond_round_off > largest * scale) largest = beyond_round_off / scale;
      }
    });
  });
  return (fourth_order ? 1.0 : stricter_at_second_order) * largest / settings_.tolerance;
}

bool StepControl::accepts(const AnalysisState& state, const StepTask& step, StepScheme scheme,
                          const double* filtered_curve) {
  if (!adaptive() || ramp_ > 0) return true;
  const double h = step.length;
  const double error = error_of(state, step, scheme, filtered_curve);
  if (error > repeat_above && step_at(settings_.max_halvings) < shorter * h) {
    // The repeated step must be shorter than h, by more than the round-off of its end. In contact or for stability h
    // may be shorter than the nominal step.
    while (step_at(halvings_) >= shorter * h) ++halvings_;
    return false;
  }
  // The error of a much shorter step cannot be extrapolated to the nominal step.
  const double nominal = step_at(halvings_);
  if (h < shortest_usable * nominal) return true;
  const double of_doubling = change_by_doubling(scheme);
  const double nominal_error = error * std::pow(nominal / h, scheme.order() > 2 ? 3 : 2);
  if (nominal_error > halve_above && halvings_ < settings_.max_halvings)
    ++halvings_;
  else if (halve_above * of_doubling * nominal_error < 1.0 && halvings_ > 0)
    --halvings_;
  return true;
}

void StepControl::accepted(const AnalysisState& state, double h, GroundVector ground_acceleration) {
  if (!adaptive()) return;
  since_event_ += h;
  scales_.accepted(state, h, ground_acceleration);
  watch_round_off(state);
  // The ramp after a touch does not count steps cut short by a sample of the motion: the jerk behind one that is short
  // enough is still that of the touch, which is infinite for some laws.
  if (h >= shortest_usable * planned_) ramp_ = std::max(ramp_ - 1, 0);
}

void StepControl::watch_round_off(const AnalysisState& state) {
  if (stiffest_squared_ < harmless_squared_frequency) return;
  const Vector& displacement = state.motion().displacement;
  resultants_.with([&](const auto& size) {
    for (int i = 0; i < state.model().degrees_of_freedom(); ++i) {
      // A displacement has a relative error of about epsilon; times stiffness over mass this is an error of
      // acceleration.
      const double share =
          round_off_per_displacement_[i] * size(i, [&](int k) { return displacement[k]; }) / scales_.values()[i];
      if (share <= largest_round_off_) continue;
      largest_round_off_ = share;
      place_of_round_off_ = NodeId{i};
    }
  });
}

void StepControl::restart(const AnalysisState& state, bool touched) {
  if (touched)
    ramp_ = at_touch;
  else if (ramp_ < at_touch)  // a whole step was taken since the touch
    ramp_ = 0;
  since_event_ = 0.0;
  if (adaptive()) scales_.regimes_changed(state);
}

}  // namespace moat
