#include "analyses/linear_path.hpp"

#include <algorithm>
#include <bit>
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
  path_.setZero(result, most_pieces + 1);
  start_.setZero(result);
  inside_.setZero(result);
}

void LinearPath::begin(const LinearSystem& system, const MotionState& start, const StepTask& step) {
  system_ = &system;
  divide(step);
  join_pieces();
  std::copy_n(start.displacement.data(), count_, start_of_part(0));
  std::copy_n(start.velocity.data(), count_, start_of_part(0) + count_);
  std::copy_n(start.acceleration.data(), count_, start_of_part(0) + 2 * count_);
  std::copy_n(start.jerk.data(), count_, start_of_part(0) + 3 * count_);
  known_ = 0;
  expanded_ = none;
}

// Pieces end on multiples of the system's step.
void LinearPath::divide(const StepTask& step) {
  const double piece = system_->step();
  pieces_ = 0;
  ground_[0] = step.ground_acceleration_at_start.x;
  if (step.length > piece) {
    double end = StepGrid::next_multiple(step.start_time, piece) - step.start_time;
    for (; end < (1.0 - round_off) * step.length && pieces_ + 1 < most_pieces; end += piece) {
      times_[++pieces_] = end;
      ground_[pieces_] = ground_inside(step, step.start_time + end);
    }
  }
  times_[++pieces_] = step.length;
  ground_[pieces_] = step.ground_acceleration.x;
}

bool LinearPath::is_whole(std::size_t piece) const {
  return std::abs(times_[piece + 1] - times_[piece] - system_->step()) <= round_off * system_->step();
}

// Whole pieces are taken 2, 4 or 8 at once, but never all of them: the motion must be known inside the step, where the
// cubic is compared with it. Only the first and the last piece may be shorter.
void LinearPath::join_pieces() {
  constexpr std::size_t fewest_parts = 2;
  std::size_t at_once = 1;
  while (at_once < LinearSystem::most_steps_at_once && 2 * at_once * fewest_parts <= pieces_) at_once *= 2;
  const std::size_t end_of_whole = is_whole(pieces_ - 1) ? pieces_ : pieces_ - 1;
  parts_ = 0;
  for (std::size_t piece = 0; piece < pieces_;) {
    first_pieces_[parts_++] = piece;
    std::size_t taken = is_whole(piece) ? at_once : 1;
    while (taken > 1 && piece + taken > end_of_whole) taken /= 2;
    piece += taken;
  }
  first_pieces_[parts_] = pieces_;
}

const double* LinearPath::at(double h) {
  std::size_t part = 0;
  while (part + 1 < parts_ && h > start_of(part + 1)) ++part;
  if (h != start_of(part + 1)) return inside(part, h);
  advance_to(part + 1);
  return start_of_part(part + 1);
}

// The path up to the start of this part.
void LinearPath::advance_to(std::size_t part) {
  for (; known_ < part; ++known_) {
    const std::size_t first = first_pieces_[known_], taken = first_pieces_[known_ + 1] - first;
    if (is_whole(first))
      system_->advance(static_cast<std::size_t>(std::countr_zero(taken)), start_of_part(known_), &ground_[first],
                       start_of_part(known_ + 1));
    else
      std::copy_n(inside(known_, times_[first + 1]), path_.rows(), start_of_part(known_ + 1));
  }
}

// After h s, in this part.
const double* LinearPath::inside(std::size_t part, double h) {
  advance_to(part);
  std::size_t piece = first_pieces_[part];
  while (h > times_[piece + 1]) ++piece;
  const double time = h - times_[piece];
  if (expanded_ != piece || time > expanded_until_) {
    const double* start = start_of_part(part);
    for (std::size_t i = first_pieces_[part]; i < piece; ++i) {
      system_->advance(0, start, &ground_[i], inside_.data());
      start_.swap(inside_);
      start = start_.data();
    }
    const double length = times_[piece + 1] - times_[piece];
    // The next time that is asked for is not much later.
    constexpr double reserve = 1.25;
    expanded_until_ = std::min(reserve * time, length);
    series_.expand(*system_, start, ground_[piece], (ground_[piece + 1] - ground_[piece]) / length, expanded_until_);
    expanded_ = piece;
  }
  series_.evaluate(time, inside_.data());
  return inside_.data();
}

}  // namespace moat
