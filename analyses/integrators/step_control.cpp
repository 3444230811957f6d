#include "analyses/integrators/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/equation_of_motion.hpp"

namespace moat {
namespace {

// Trials below changed one constant of an earlier set, of 200 random models of ./moat bench accuracy whose worst peaks
// had an error of 0.0056 % in the 90th percentile and of 0.030 % in the 99th. Other trials were of two floors joined by
// a spring many times as stiff as their storey, or by a dashpot.

// Further halvings of the first step after a touch. Trial: with 4 both errors double; 8 gains nothing.
constexpr int at_touch = 6;
// A contact is sustained after so many of its durations without an event. Trial: with 2 the 99th percentile is 0.071 %;
// with 8 it is 0.024 %, for 7 % more steps where there are many.
constexpr double durations_until_leaning = 4.0;
// The fourth-order scheme takes h w and h c/m up to here; its bounds of stability are 2.45 and 4, each without the
// other. Trial: 1.2 costs 7 % more steps where there are many and gains a sixth of the error; 2.3 gains nothing.
constexpr double stable_phase = 1.8;
// Up to so many halvings the fourth-order scheme costs less than average acceleration and than strongly_damped().
// Trial: 3, 6 and 9 give the same in random models; with 6 a spring of 1e6 times the storey's stiffness takes nine
// times the steps. StrongDashpots tests guard it.
constexpr int worth_halving = 1;
// For an equal estimate the error of average acceleration is larger: its error of period equals the estimate. Trial: 4
// and 16 give the same in random models; with 1 a spring of 1e4 times the storey's stiffness leaves an error of 0.012 %
// instead of 0.002 %, for half the steps.
constexpr double stricter_at_second_order = 8.0;
// A step is repeated above so many tolerances, halved if it would be so at full length, and doubled where that leaves
// it below one divided by this. Trial: 1.3 for repetitions takes a tenth off the error for 1 % more steps; 1.6 in place
// of 1.2 for halvings saves 2 % of the steps, and errors stay.
constexpr double too_large = 2.0;
// The error of a step that was cut to less than this share is no measure for longer steps.
constexpr double shortest_usable = 0.25;

bool is_stable(double step, double rate) { return step * rate <= stable_phase; }

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
  if (scheme_of_all_) {
    scheme = *scheme_of_all_;
  } else if (ramp_ < at_touch) {
    const double of_contact = std::numbers::pi / contact;  // zero without contact, which lasts forever
    const double frequency = std::sqrt(stiffest_squared_ + of_contact * of_contact);
    const int most = std::min(halvings + worth_halving, settings_.max_halvings);
    const auto halve_for = [&](double rate) {
      if (!is_stable(step_at(most), rate)) return false;
      while (!is_stable(step_at(halvings), rate)) ++halvings;
      return true;
    };
    if (halve_for(frequency))
      scheme = halve_for(most_damped_) ? StepScheme::fourth_order() : StepScheme::strongly_damped();
  }
  planned_ = step_at(std::min(halvings + ramp_, settings_.max_halvings));
  scheme.filters_corrections |= !scheme_of_all_ && scheme.order() == 2 && !is_stable(planned_, most_damped_);
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
  if (error > too_large && 2.0 * step_at(settings_.max_halvings) <= h) {
    // In contact or for stability h may be shorter than the nominal step.
    while (2.0 * step_at(halvings_) > h) ++halvings_;
    return false;
  }
  // The error of a much shorter step cannot be extrapolated to the nominal step.
  const double nominal = step_at(halvings_);
  if (h < shortest_usable * nominal) return true;
  const int power = scheme.order() > 2 ? 3 : 2;
  const double nominal_error = error * std::pow(nominal / h, power);
  if (nominal_error > too_large && halvings_ < settings_.max_halvings)
    ++halvings_;
  else if (too_large * std::ldexp(nominal_error, power) < 1.0 && halvings_ > 0)
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
