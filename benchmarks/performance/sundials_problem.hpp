// The five-storey building as SUNDIALS sees it.
#pragma once

#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <memory>

#include "measuring/five_peaks.hpp"
#include "model/model.hpp"
#include "motions/ground_motion.hpp"

namespace moat::performance {

/// y' = f(t, y) with y = (u, v), restarted at every change of regime.
class SundialsProblem {
 public:
  explicit SundialsProblem(const GroundMotion& ground_motion) : motion{ground_motion} {}
  virtual ~SundialsProblem() = default;

  virtual void rate(double t, const realtype* y, realtype* rates) = 0;
  /// Into a matrix of zeros.
  virtual void jacobian(double t, const realtype* y, SUNMatrix matrix) = 0;
  /// How many functions there are whose roots are events.
  [[nodiscard]] virtual int margin_count() const = 0;
  /// Those functions, > 0 before an event.
  virtual void margins(double t, const realtype* y, realtype* margin) = 0;
  [[nodiscard]] virtual Peaks sample(double t, const realtype* y) = 0;
  /// `crossed`: for each margin, not zero where it fell below zero.
  virtual void change_regimes(double t, const realtype* y, const int* crossed) = 0;

  const GroundMotion& motion;
};

/// The equations written by hand for this very building. The motion must outlive the problem.
std::unique_ptr<SundialsProblem> hand_problem(const GroundMotion& motion);

/// The elements of a model of the building, SUNDIALS in the place of Newmark and NOX: M v' = -f(u, v) - M a_g. Regimes
/// of all elements change where the smallest of their margins falls below zero. The motion must outlive the problem.
std::unique_ptr<SundialsProblem> model_problem(const Model& model, const GroundMotion& motion);

}  // namespace moat::performance
