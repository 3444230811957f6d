// The exact motion of a linear system over one step.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "analyses/linear_system.hpp"
#include "analyses/step_equations.hpp"
#include "model/model.hpp"

namespace moat {

/// The motion of a linear system over a step that is divided into pieces, each at most one step of the system long and
/// within one interval of the motion's samples, so that the ground acceleration is linear in it. The motion goes from
/// piece to piece by a matrix product, and to times inside a piece by the Taylor series from its start. It is computed
/// as far as it was asked for.
class LinearPath {
 public:
  static constexpr std::size_t most_pieces = 16;  ///< Of a step.

  /// So many degrees of freedom.
  explicit LinearPath(Eigen::Index count);

  /// Begins at this state. The system must exist until the next begin() or the end of the path.
  void begin(const LinearSystem& system, const MotionState& start, const StepTask& step);

  /// (u, u', u'') after h s, 0 < h <= the length of the step. Valid until the next call.
  [[nodiscard]] const double* at(double h);

  [[nodiscard]] std::size_t pieces() const { return pieces_; }  ///< Of this step.
  /// Start of a piece; of pieces(): the end of the step. s from the start of the step.
  [[nodiscard]] double start_of(std::size_t piece) const { return piece == 0 ? 0.0 : ends_[piece - 1]; }
  /// The ground acceleration there, m/s^2.
  [[nodiscard]] double ground_at(std::size_t piece) const { return ground_[piece]; }
  /// Velocity (m/s) and absolute acceleration (m/s^2) there. The piece must not be the first, and at() must have gone
  /// as far.
  [[nodiscard]] double velocity(std::size_t piece, Eigen::Index degree_of_freedom) const {
    return path_(LinearStart::motion + count_ + degree_of_freedom, static_cast<Eigen::Index>(piece));
  }
  /// See velocity().
  [[nodiscard]] double absolute_acceleration(std::size_t piece, Eigen::Index degree_of_freedom) const {
    return path_(LinearStart::motion + 2 * count_ + degree_of_freedom, static_cast<Eigen::Index>(piece)) +
           ground_[piece];
  }

 private:
  void advance_to(std::size_t piece);
  void expand(std::size_t piece);
  [[nodiscard]] double length_of(std::size_t piece) const { return ends_[piece] - start_of(piece); }
  [[nodiscard]] double* column(std::size_t piece) { return path_.col(static_cast<Eigen::Index>(piece)).data(); }

  Eigen::Index count_;
  const LinearSystem* system_ = nullptr;
  std::size_t pieces_ = 0;
  std::array<double, most_pieces + 1> ends_{};
  std::array<double, most_pieces + 2> ground_{};
  // Column i: the start of piece i (LinearStart) and, beyond its inputs, the end of piece i - 1. Known up to known_.
  Eigen::MatrixXd path_;
  std::size_t known_ = 0;
  LinearMotionSeries series_;
  static constexpr std::size_t none = most_pieces + 1;
  std::size_t expanded_ = none;  // the piece of the series
  Vector inside_;                // (u, u', u'') at a time inside a piece
};

}  // namespace moat
