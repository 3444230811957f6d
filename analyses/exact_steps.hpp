// Exact steps of a model that is linear between events.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "analyses/stepper.hpp"
#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat {

/// Between touches, yields and unloadings a building of linear storeys, dashpots and located bilinear bearings is a
/// linear system under a ground acceleration that is linear between samples:
///
///     u'' = -M^-1 (K u + C u' + f0) - iota (a_g + s t)
///
/// with the tangents K and C of the current regimes and f0, the elements' forces at zero displacement and velocity.
/// Its solution over a whole step is a matrix times (u, u', 1, a_g, s), exact to round-off: the exponential of the
/// augmented first-order system, computed once for every K and C that occur. Other lengths (to an event, and back to
/// the grid) take the Taylor series of the solution, summed to round-off once per step and then evaluated at any
/// length. There is no error of period, so there is no tolerance.
///
/// A step is the longest step of the analysis (longest_step()), halved until the fastest eigenvalue of the system times
/// the step is at most 1/2: the series converges quickly then, changes of regime inside a step are seen, and the cubic
/// of the peak tracker finds peaks between samples to (1/2)^4/384, about 2e-4, of the fastest vibration.
///
/// While a gap is closed the model is not linear and applies() is false; Transient takes Newmark's steps there.
class ExactSteps final : public Stepper {
 public:
  /// Matrices are full: this is for small models.
  static constexpr int most_degrees_of_freedom = 50;

  /// The model must be prepared and outlive this object. grid_interval > 0 s is the longest step.
  /// Throws InputError for a model with too many degrees of freedom, an element that is not linear between events, or
  /// an eigenvalue that needs thousands of steps from sample to sample.
  ExactSteps(Model& model, double grid_interval);

  /// Whether the model is linear now: no gap is closed.
  [[nodiscard]] bool applies() const { return !touching_; }
  /// Elements changed their regime, or the model its state: the linear system must be made again.
  void restart();

  /// Length of a whole step in the current regimes, s.
  double next_length() override;
  /// The ground's acceleration goes linearly from one end of the step to the other.
  void begin(const StepTask& step) override;
  bool solve(const StepTask& part) override;
  /// Always: exact steps have no error.
  bool accepts(const StepTask&, std::span<const RegimeChange>) override { return true; }
  WorkRule work_rule() const override { return WorkRule::quadrature; }

 private:
  using Matrix = Eigen::MatrixXd;

  // One pair of K and C.
  struct LinearSystem {
    std::vector<double> stiffness_values, damping_values;  // by which it is found again
    Matrix stiffness, damping;                             // M^-1 K, M^-1 C
    double step = 0.0;                                     // length of a whole step, s
    Matrix transition;     // (u, u', u'') after a whole step, per entry of (u, u', 1, a_g, s); rows filled up
    Matrix from_constant;  // (u, u', u'') after a whole step, per constant acceleration of each degree of freedom
  };

  void check() const;
  void linearise();
  [[nodiscard]] LinearSystem make_system() const;
  void expand();
  void evaluate_series(double h);

  Model* model_;
  double grid_interval_;
  bool touching_ = false;
  bool linearised_ = false;
  std::vector<LinearSystem> systems_;
  std::size_t current_ = 0;
  SparseMatrix stiffness_, damping_;
  Vector offset_;  // -M^-1 f0

  // The step that begin() set up.
  double longest_ = 0.0, ground_ = 0.0, ground_slope_ = 0.0;
  Vector start_, end_;  // (u, u', 1, a_g, s) and (u, u', u''), filled up
  // Column k holds the coefficients of (t / longest)^k in u, of which terms_ are known.
  Matrix series_;
  int terms_ = 0;
};

}  // namespace moat
