// A linear system under a ground acceleration that is linear in time.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"

namespace moat {

/// The motion of
///
///     u'' = -M^-1 (K u + C u' + f0) - iota a_g
///
/// over steps of one length. The ground's acceleration is linear over each. The motion at the end is a matrix times the
/// motion at the start and the ground's accelerations, exact to round-off: the Taylor series of the solution.
///
/// A motion is an array of u, u', u'' and the absolute jerk -M^-1 (K u' + C u''), or of u and u' alone where it starts.
class LinearSystem {
 public:
  /// Steps that one product passes: 1, 2, 4, ... up to this.
  static constexpr std::size_t most_steps_at_once = 8;

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
  /// From the start of 2^doublings steps to their end. `ground` is the acceleration of the ground at the start and at
  /// the end of each of them, m/s^2. `end` has room for result_size() numbers.
  void advance(std::size_t doublings, const double* start, const double* ground, double* end) const;
  /// The numbers that advance() writes for so many degrees of freedom.
  static Eigen::Index result_size(Eigen::Index degrees_of_freedom) { return filled_up(4 * degrees_of_freedom); }
  /// The next multiple of the rows that a product computes at once.
  static Eigen::Index filled_up(Eigen::Index rows);

  /// With h the step: the columns of -h^2 M^-1 K, and behind them those of -h M^-1 C. Each has filled_up(n) rows.
  [[nodiscard]] const double* scaled_rates() const { return rates_.data(); }
  /// -M^-1 f0, m/s^2.
  [[nodiscard]] const Vector& offset() const { return offset_; }

 private:
  // The motion at the end of some steps. Rows are filled up.
  struct Transition {
    Eigen::MatrixXd from_constant;  // per constant acceleration of each degree of freedom
    Eigen::MatrixXd from_start;     // per 1 with the present offset, acceleration of the ground, entry of the start
  };

  [[nodiscard]] Transition of_one_step();
  [[nodiscard]] Transition twice(const Transition& transition) const;

  std::vector<double> stiffness_values_, damping_values_;
  Eigen::MatrixXd rates_;  // -h^2 M^-1 K and -h M^-1 C, side by side; rows are filled up
  Vector offset_;
  double step_;
  std::vector<Transition> transitions_;  // of 1, 2, 4, ... steps
};

/// The Taylor series of a linear motion, summed to round-off, for lengths up to the step of the system.
class LinearMotionSeries {
 public:
  /// So many degrees of freedom.
  explicit LinearMotionSeries(Eigen::Index count);

  /// The motion of a system from a start, (u, u'), under a ground with this acceleration, m/s^2, and slope, m/s^3, for
  /// the longest time that evaluate() will be asked for, s: less needs fewer terms.
  void expand(const LinearSystem& system, const double* start, double ground, double slope, double longest);
  /// The motion after h <= longest s; `result` has room for LinearSystem::result_size() numbers.
  void evaluate(double h, double* result);

 private:
  Eigen::Index count_, rows_;  // rows_: count_, filled up
  const LinearSystem* system_ = nullptr;
  double ground_ = 0.0, slope_ = 0.0;
  // Column k holds the coefficients of (t/h)^k in u, and rows_ below in h u', with h the step of the system; terms_ are
  // known.
  Eigen::MatrixXd coefficients_;
  int terms_ = 0;
  Vector constant_;                  // part of a term, in expand()
  Vector state_, velocity_, rates_;  // of evaluate(): (u, h u'), (u', h u''), the rates of one of them
};

}  // namespace moat
