#include "analyses/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace moat {

StepControl::StepControl(const Model& model, Options options) : options_{options} {
  before_.setZero(model.degrees_of_freedom());
  last_ = before_;
}

double StepControl::step_at(int halvings) const { return std::ldexp(options_.grid_interval, -halvings); }

double StepControl::next_step(const Model& model) {
  const double contact = model.shortest_contact();
  const double nominal = adaptive() ? step_at(halvings_) : options_.fixed_step;
  if (!std::isfinite(contact)) return nominal;
  double step = nominal;
  if (adaptive()) {
    const double wanted = contact / options_.steps_per_contact;
    int halvings = halvings_;
    while (halvings < options_.largest_halvings && step_at(halvings) > wanted) ++halvings;
    step = step_at(std::min(halvings + ramp_, options_.largest_halvings));
  }
  fewest_steps_per_contact_ = std::min(fewest_steps_per_contact_, contact / step);
  return step;
}

bool StepControl::accepts(const Model& model, double h, double ground_acceleration) {
  if (!adaptive() || known_ < 2) return true;
  const int count = model.degrees_of_freedom();
  const auto& acceleration = model.trial().acceleration;
  const double mean = 0.5 * (h + last_h_);
  double largest_difference = 0.0, largest = largest_acceleration_;
  for (int i = 0; i < count; ++i) {
    const double now = acceleration[i] + ground_acceleration;
    const double bend = ((now - last_[i]) / h - (last_[i] - before_[i]) / last_h_) / mean;
    largest_difference = std::max(largest_difference, std::abs(bend));
    largest = std::max(largest, std::abs(now));
  }
  if (largest <= 0.0) return true;
  const double error_per_square = largest_difference / (12.0 * largest);
  const double error = error_per_square * h * h;
  constexpr double repeat_above = 4.0, lengthen_below = 0.2;
  if (error > repeat_above * options_.tolerance && halvings_ < options_.largest_halvings && step_at(halvings_ + 1) < h) {
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
  const int count = model.degrees_of_freedom();
  before_.swap(last_);
  last_ = model.state().acceleration.head(count).array() + ground_acceleration;
  largest_acceleration_ = std::max(largest_acceleration_, last_.lpNorm<Eigen::Infinity>());
  last_h_ = h;
  known_ = std::min(known_ + 1, 2);
  ramp_ = std::max(ramp_ - 1, 0);
}

void StepControl::restart(const Model& model, double ground_acceleration) {
  if (!adaptive()) return;
  accepted(model, 0.0, ground_acceleration);
  known_ = 1;
  ramp_ = 6;
}

}  // namespace moat
