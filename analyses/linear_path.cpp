#include "analyses/linear_path.hpp"

#include <cmath>

#include "analyses/step_grid.hpp"

namespace moat {
namespace {

// Relative to a piece: lengths closer than this count as equal.
constexpr double round_off = 1e-9;

// Term k is about phase^k / k! of the motion, times the square root of a ratio of masses. With phase <= 1/2 the first
// that is left out is 1e-26.
constexpr Eigen::Index terms = 21;

}  // namespace

void LinearPath::begin(const LinearSystem& system, const Vector& offset, const MotionState& start,
                       const StepTask& step) {
  system_ = &system;
  start_time_ = start.time;
  const double h = system.step();
  pieces_ = 0;
  ground_[0] = step.ground_acceleration_at_start.x;
  // Pieces end on multiples of the system's step.
  double end = step.length > h ? StepGrid::next_multiple(step.start_time, h) - step.start_time : step.length;
  for (; end < (1.0 - round_off) * step.length && pieces_ + 1 < most_pieces; end += h) {
    times_[++pieces_] = end;
    ground_[pieces_] =
        step.ground ? step.ground->acceleration_at(step.start_time + end) : ground_[0] + end * step.ground_jerk.x;
  }
  times_[++pieces_] = step.length;
  ground_[pieces_] = step.ground_acceleration.x;

  const Eigen::Index n = offset.size();
  states_.resize(3 * n + 1, most_pieces + 1);
  series_.resize(3 * n + 1, terms);
  states_.col(0).head(n) = start.displacement.head(n);
  states_.col(0).segment(n, n) = h * start.velocity.head(n);
  for (Eigen::Index piece = 0; piece <= pieces_; ++piece)
    states_.col(piece).segment(2 * n, n) = h * h * (offset.array() - ground_[piece]);
  for (Eigen::Index piece = 0; piece < pieces_; ++piece)
    states_(3 * n, piece) = h * h * h * (ground_[piece] - ground_[piece + 1]) / (times_[piece + 1] - times_[piece]);
  states_(3 * n, pieces_) = 0.0;
  known_ = 0;
  expanded_ = most_pieces;
}

void LinearPath::move(double h, MotionState& motion) {
  const Eigen::MatrixXd& rates = system_->rates();
  const Eigen::Index n = rates.rows() / 3;
  const double step = system_->step();
  Eigen::Index piece = 0;
  while (piece < pieces_ && h >= times_[piece + 1]) ++piece;
  // Only the first and the last piece may be shorter than the system's step.
  for (; known_ < piece; ++known_) {
    const double share = (times_[known_ + 1] - times_[known_]) / step;
    auto end = states_.col(known_ + 1).head(2 * n);
    if (std::abs(share - 1.0) <= round_off) {
      end.noalias() = system_->over_step() * states_.col(known_);
    } else {
      go_inside(known_, share);
      end = inside_.head(2 * n);
    }
  }
  const bool inside = h > times_[piece];
  if (inside) go_inside(piece, (h - times_[piece]) / step);

  const Eigen::Map<const Vector> state{inside ? inside_.data() : states_.col(piece).data(), rates.rows()};
  const double per_step = 1.0 / step, per_square = per_step * per_step;
  auto velocity = motion.velocity.head(n), acceleration = motion.acceleration.head(n), jerk = motion.jerk.head(n);
  motion.time = start_time_ + h;
  motion.displacement.head(n) = state.head(n);
  velocity = per_step * state.segment(n, n);
  acceleration.noalias() = (per_square * rates.middleRows(n, n)) * state;
  jerk.noalias() = (per_square * rates.block(n, 0, n, n)) * velocity;
  jerk.noalias() += (per_step * rates.block(n, n, n, n)) * acceleration;
}

// The state of the system this share of its step after the start of a piece.
void LinearPath::go_inside(Eigen::Index piece, double share) {
  if (expanded_ != piece) {
    series_.col(0) = states_.col(piece);
    for (Eigen::Index k = 1; k < terms; ++k)
      series_.col(k).noalias() = (1.0 / static_cast<double>(k) * system_->rates()) * series_.col(k - 1);
    expanded_ = piece;
  }
  inside_ = series_.col(terms - 1);
  for (Eigen::Index k = terms - 2; k >= 0; --k) inside_ = share * inside_ + series_.col(k);
}

}  // namespace moat
