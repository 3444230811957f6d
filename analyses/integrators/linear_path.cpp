#include "analyses/integrators/linear_path.hpp"

#include <cmath>

namespace moat {
namespace {

// Term k is about phase^k / k! of the motion, times the square root of a ratio of masses. With phase <= 1/2 the first
// that is left out is 1e-26.
constexpr Eigen::Index terms = 21;

}  // namespace

void LinearPath::begin(const LinearSystem& system, const Vector& offset, const MotionState& start,
                       const StepTask& step) {
  system_ = &system;
  start_time_ = start.time;
  const double h = system.step();
  const Eigen::Index n = offset.size();
  start_.resize(3 * n + 1);
  there_.resize(3 * n + 1);
  start_.head(n) = start.displacement.head(n);
  start_.segment(n, n) = h * start.velocity.head(n);
  start_.segment(2 * n, n) =
      h * h * (offset - step.ground_acceleration_at_start.x * system.rates().block(2 * n, 3 * n, n, 1));
  start_[3 * n] = -h * h * h * step.ground_jerk.x;
  expanded_ = false;
}

void LinearPath::move(double h, MotionState& motion) {
  constexpr double round_off = 1e-9;  // of a step
  const Eigen::MatrixXd& rates = system_->rates();
  const Eigen::Index n = rates.rows() / 3;
  const double step = system_->step(), share = h / step;
  if (std::abs(share - 1.0) <= round_off) {
    there_.head(2 * n).noalias() = system_->over_step() * start_;
    there_.segment(2 * n, n) = start_.segment(2 * n, n) + start_[3 * n] * rates.block(2 * n, 3 * n, n, 1);
    there_[3 * n] = start_[3 * n];
  } else {
    go_inside(share);
  }
  const double per_step = 1.0 / step, per_square = per_step * per_step;
  auto velocity = motion.velocity.head(n), acceleration = motion.acceleration.head(n), jerk = motion.jerk.head(n);
  motion.time = start_time_ + h;
  motion.displacement.head(n) = there_.head(n);
  velocity = per_step * there_.segment(n, n);
  acceleration.noalias() = (per_square * rates.middleRows(n, n)) * there_;
  jerk.noalias() = (per_square * rates.block(n, 0, n, n)) * velocity;
  jerk.noalias() += (per_step * rates.block(n, n, n, n)) * acceleration;
}

// The state of the system this share of its step after the start.
void LinearPath::go_inside(double share) {
  if (!expanded_) {
    series_.resize(start_.size(), terms);
    series_.col(0) = start_;
    for (Eigen::Index k = 1; k < terms; ++k)
      series_.col(k).noalias() = (1.0 / static_cast<double>(k) * system_->rates()) * series_.col(k - 1);
    expanded_ = true;
  }
  there_ = series_.col(terms - 1);
  for (Eigen::Index k = terms - 2; k >= 0; --k) there_ = share * there_ + series_.col(k);
}

}  // namespace moat
