// A linear system under a ground acceleration that is linear in time.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"

namespace moat {

/// The start of a linear motion, in one array: 1, the ground's acceleration and its slope, then u and u' of every
/// degree of freedom. The motion that it leads to is an array of u, u' and u''. Both have room for whole groups of rows
/// (LinearSystem::result_size()).
struct LinearStart {
  static constexpr int one = 0;     ///< Index of the constant 1.
  static constexpr int ground = 1;  ///< Index of the ground's acceleration, m/s^2.
  static constexpr int slope = 2;   ///< Index of its slope, m/s^3.
  static constexpr int motion = 3;  ///< Index of the first displacement.
};

/// The motion of
///
///     u'' = -M^-1 (K u + C u' + f0) - iota (a_g + s t)
///
/// over a step of one length. It is a matrix times the start, exact to round-off: the exponential of the augmented
/// first-order system.
class LinearSystem {
 public:
  /// Tangents of a model, with its masses in kg. The step is the longest, in s, halved until the fastest eigenvalue
  /// times the step is at most the largest phase, 0 < phase <= 1/2. Throws InputError where 1/2 needs more than 12
  /// halvings.
  LinearSystem(const SparseMatrix& stiffness, const SparseMatrix& damping, const Vector& masses, double longest_step,
               double largest_phase = 0.5);

  /// Whether it was made of these tangents.
  [[nodiscard]] bool is_of(const SparseMatrix& stiffness, const SparseMatrix& damping) const {
    return stiffness_values_ == stiffness.values && damping_values_ == damping.values;
  }
  /// -M^-1 f0, m/s^2.
  void set_offset(const Vector& offset);

  /// s
  [[nodiscard]] double step() const { return step_; }
  /// From the start of a step to (u, u', u'') at its end.
  void advance(const double* start, double* result) const;
  /// The numbers that advance() writes for so many degrees of freedom.
  static Eigen::Index result_size(Eigen::Index degrees_of_freedom);

  [[nodiscard]] const Eigen::MatrixXd& stiffness() const { return stiffness_; }  ///< M^-1 K, 1/s^2.
  [[nodiscard]] const Eigen::MatrixXd& damping() const { return damping_; }      ///< M^-1 C, 1/s.
  [[nodiscard]] const Vector& offset() const { return offset_; }                 ///< -M^-1 f0, m/s^2.

 private:
  void make_transition();

  std::vector<double> stiffness_values_, damping_values_;
  Eigen::MatrixXd stiffness_, damping_;
  Vector offset_;
  double step_;
  Eigen::MatrixXd transition_;     // (u, u', u'') at the end of a step, per entry of its start; rows filled up
  Eigen::MatrixXd from_constant_;  // the same per constant acceleration of each degree of freedom
};

/// The Taylor series of a linear motion, summed to round-off, for lengths other than the step of the system.
class LinearMotionSeries {
 public:
  /// So many degrees of freedom.
  explicit LinearMotionSeries(Eigen::Index count);

  /// The motion of a system from a start, for lengths up to `longest` s.
  void expand(const LinearSystem& system, const double* start, double longest);
  /// (u, u', u'') after h s.
  void evaluate(double h, double* result) const;

 private:
  const LinearSystem* system_ = nullptr;
  double longest_ = 0.0, ground_ = 0.0, slope_ = 0.0;
  // Column k holds the coefficients of (t / longest)^k in u, of which terms_ are known.
  Eigen::MatrixXd coefficients_;
  int terms_ = 0;
};

}  // namespace moat
