// The exact motion of a linear system over one step.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "analyses/linear_system.hpp"
#include "analyses/step_equations.hpp"
#include "model/model.hpp"

namespace moat {

/// The motion of a linear system over one step. The step is divided into pieces, each at most one step of the system
/// long and within one interval of the motion's samples, so that the ground acceleration is linear in it. Where there
/// are many, a product takes several of them at once: the step has about two parts, at whose ends the motion is known.
/// Inside a part it goes from piece to piece, and inside a piece by the Taylor series from its start. It is computed as
/// far as it was asked for.
class LinearPath {
 public:
  static constexpr std::size_t most_pieces = 32;  ///< Of a step.

  /// So many degrees of freedom.
  explicit LinearPath(Eigen::Index count);

  /// Begins at this state. The system must exist until the next begin() or the end of the path.
  void begin(const LinearSystem& system, const MotionState& start, const StepTask& step);

  /// The motion (analyses/linear_system.hpp) after h s, 0 < h <= the length of the step. Valid until the next call.
  [[nodiscard]] const double* at(double h);

  [[nodiscard]] std::size_t parts() const { return parts_; }  ///< Of this step.
  /// Start of a part; of parts(): the end of the step. s from the start of the step.
  [[nodiscard]] double start_of(std::size_t part) const { return times_[first_pieces_[part]]; }
  /// The ground acceleration there, m/s^2.
  [[nodiscard]] double ground_at(std::size_t part) const { return ground_[first_pieces_[part]]; }
  /// The motion there. at() must have gone as far.
  [[nodiscard]] const double* motion(std::size_t part) const {
    return path_.col(static_cast<Eigen::Index>(part)).data();
  }

 private:
  void divide(const StepTask& step);
  void join_pieces();
  void advance_to(std::size_t part);
  const double* inside(std::size_t part, double h);
  [[nodiscard]] bool is_whole(std::size_t piece) const;
  [[nodiscard]] double* start_of_part(std::size_t part) { return path_.col(static_cast<Eigen::Index>(part)).data(); }

  Eigen::Index count_;
  const LinearSystem* system_ = nullptr;
  // At the start of every piece and at the end of the last: time from the start of the step, s; ground acceleration,
  // m/s^2.
  std::size_t pieces_ = 0;
  std::array<double, most_pieces + 1> times_{}, ground_{};
  std::size_t parts_ = 0;
  std::array<std::size_t, most_pieces + 1> first_pieces_{};  // of every part, and pieces_
  Eigen::MatrixXd path_;                                     // column i: the motion at the start of part i
  std::size_t known_ = 0;                                    // parts whose end is known
  LinearMotionSeries series_;
  static constexpr std::size_t none = most_pieces;
  std::size_t expanded_ = none;  // the piece of the series
  double expanded_until_ = 0.0;  // from its start, s
  Vector start_, inside_;        // the motion at the start of a piece, and at a time inside
};

}  // namespace moat
