#include "analyses/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace moat {

StepControl::StepControl(const Model& model, Options options) : options_{options} {
  before_.setZero(model.degrees_of_freedom());
  last_ = before_;
  for (int halvings = 0; halvings <= options_.largest_halvings; ++halvings)
    steps_.push_back(std::ldexp(options_.grid_interval, -halvings));
}

double StepControl::next_step(const Model& model) {
  if (!adaptive()) {
    fewest_steps_per_contact_ = std::min(fewest_steps_per_contact_, model.shortest_contact() / options_.fixed_step);
    return options_.fixed_step;
  }
  constexpr double durations_until_leaning = 4.0;
  const double contact = model.shortest_contact();
  const bool pounding = since_event_ < durations_until_leaning * contact && std::isfinite(contact);
  int halvings = halvings_;
  if (pounding)
    while (halvings < options_.largest_halvings && step_at(halvings) * options_.steps_per_contact > contact) ++halvings;
  const double step = step_at(std::min(halvings + ramp_, options_.largest_halvings));
  if (pounding) fewest_steps_per_contact_ = std::min(fewest_steps_per_contact_, contact / step);
  return step;
}

bool StepControl::accepts(const Model& model, double h, double ground_acceleration) {
  if (!adaptive() || known_ < 2) return true;
  const auto now = model.trial().acceleration.head(model.degrees_of_freedom()).array() + ground_acceleration;
  const double largest = std::max(largest_acceleration_, now.abs().maxCoeff());
  if (largest <= 0.0) return true;
  const double per_step = 1.0 / h, per_last_step = 1.0 / last_h_;
  const double largest_bend =
      ((now - last_.array()) * per_step - (last_ - before_).array() * per_last_step).abs().maxCoeff();
  const double error_per_square = largest_bend / (6.0 * (h + last_h_) * largest);
  constexpr double repeat_above = 4.0, lengthen_below = 0.2;
  if (error_per_square * h * h > repeat_above * options_.tolerance && halvings_ < options_.largest_halvings &&
      step_at(halvings_ + 1) < h) {
    ++halvings_;
    return false;
  }
  const double nominal = step_at(halvings_);
  const double nominal_error = error_per_square * nominal * nominal;
  if (nominal_error > options_.tolerance && halvings_ < options_.largest_halvings)
    ++halvings_;
  else if (nominal_error < lengthen_below * options_.tolerance && halvings_ > 0)
    --halvings_;
  return true;
}

void StepControl::accepted(const Model& model, double h, double ground_acceleration) {
  if (!adaptive()) return;
  since_event_ += h;
  // A step cut to nearly nothing tells nothing of the curvature, and dividing by its length would amplify round-off.
  constexpr double negligible = 1e-6;
  if (h < negligible * step_at(std::min(halvings_ + ramp_, options_.largest_halvings))) return;
  remember(model, h, ground_acceleration);
  known_ = std::min(known_ + 1, 2);
  ramp_ = std::max(ramp_ - 1, 0);
}

void StepControl::passed(const Model& model, double ground_acceleration) {
  const auto acceleration = model.state().acceleration.head(model.degrees_of_freedom()).array() + ground_acceleration;
  largest_acceleration_ = std::max(largest_acceleration_, acceleration.abs().maxCoeff());
}

void StepControl::restart(const Model& model, double ground_acceleration) {
  if (!adaptive()) return;
  constexpr int at_start = 8, at_touch = 6, at_separation = 3;
  ramp_ = known_ == 0 ? at_start : std::isfinite(model.shortest_contact()) ? at_touch : at_separation;
  remember(model, 0.0, ground_acceleration);
  known_ = 1;
  since_event_ = 0.0;
}

void StepControl::remember(const Model& model, double h, double ground_acceleration) {
  before_.swap(last_);
  last_ = model.state().acceleration.head(model.degrees_of_freedom()).array() + ground_acceleration;
  largest_acceleration_ = std::max(largest_acceleration_, last_.lpNorm<Eigen::Infinity>());
  last_h_ = h;
}

}  // namespace moat
