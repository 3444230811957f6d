#include "analyses/linear_path.hpp"

#include <algorithm>
#include <cmath>

#include "analyses/step_grid.hpp"

namespace moat {
namespace {

// Relative to a piece: lengths closer than this count as equal.
constexpr double round_off = 1e-9;

// The ground acceleration at a time inside a step, m/s^2.
double ground_inside(const StepTask& step, double time) {
  return step.ground ? step.ground->acceleration_at(time)
                     : step.ground_acceleration_at_start.x + (time - step.start_time) * step.ground_jerk.x;
}

}  // namespace

LinearPath::LinearPath(Eigen::Index count) : count_{count}, series_{count} {
  const Eigen::Index result = LinearSystem::result_size(count);
  path_.setZero(LinearStart::motion + result, most_pieces + 2);
  inside_.setZero(result);
}

void LinearPath::begin(const LinearSystem& system, const MotionState& start, const StepTask& step) {
  system_ = &system;
  const double piece = system.step();
  ground_[0] = step.ground_acceleration_at_start.x;
  pieces_ = 0;
  if (step.length > piece) {
    double end = StepGrid::next_multiple(step.start_time, piece) - step.start_time;
    for (; end < (1.0 - round_off) * step.length && pieces_ < most_pieces; end += piece) {
      ends_[pieces_++] = end;
      ground_[pieces_] = ground_inside(step, step.start_time + end);
    }
  }
  ends_[pieces_++] = step.length;
  ground_[pieces_] = step.ground_acceleration.x;

  double* first = column(0);
  first[LinearStart::one] = 1.0;
  first[LinearStart::ground] = ground_[0];
  first[LinearStart::slope] = (ground_[1] - ground_[0]) / ends_[0];
  const double *displacement = start.displacement.data(), *velocity = start.velocity.data();
  std::copy_n(displacement, count_, first + LinearStart::motion);
  std::copy_n(velocity, count_, first + LinearStart::motion + count_);
  known_ = 0;
  expanded_ = none;
}

const double* LinearPath::at(double h) {
  std::size_t piece = 0;
  while (piece + 1 < pieces_ && h > ends_[piece]) ++piece;
  if (h == ends_[piece]) {
    advance_to(piece + 1);
    return column(piece + 1) + LinearStart::motion;
  }
  advance_to(piece);
  expand(piece);
  series_.evaluate(h - start_of(piece), inside_.data());
  return inside_.data();
}

// The path up to the start of this piece.
void LinearPath::advance_to(std::size_t piece) {
  for (; known_ < piece; ++known_) {
    const std::size_t next = known_ + 1;
    double* end = column(next);
    const double length = length_of(known_);
    if (std::abs(length - system_->step()) <= round_off * system_->step()) {
      system_->advance(column(known_), end + LinearStart::motion);
    } else {
      expand(known_);
      series_.evaluate(length, end + LinearStart::motion);
    }
    if (next == pieces_) continue;
    end[LinearStart::one] = 1.0;
    end[LinearStart::ground] = ground_[next];
    end[LinearStart::slope] = (ground_[next + 1] - ground_[next]) / length_of(next);
  }
}

void LinearPath::expand(std::size_t piece) {
  if (expanded_ != piece) series_.expand(*system_, column(piece), length_of(piece));
  expanded_ = piece;
}

}  // namespace moat
