// A model of moat as SUNDIALS sees it: what one gets by putting SUNDIALS in the place of Newmark and NOX.
#pragma once

#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <array>
#include <vector>

#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "performance/five_peaks.hpp"

namespace moat::performance {

/// y = (u, v), M v' = -f(u, v) - M a_g. It knows nothing of the elements; regimes of all of them change where the
/// smallest of their margins falls below zero, so that yield must be located (LeadRubberBearing::locate_yield).
class SundialsModelProblem {
 public:
  static constexpr int sides = 1;  ///< functions whose roots are events: the smallest margin

  /// `model`: with the degrees of freedom of the five-storey building.
  SundialsModelProblem(const Model& model, const GroundMotion& ground_motion);

  SundialsModelProblem(const SundialsModelProblem&) = delete;
  SundialsModelProblem& operator=(const SundialsModelProblem&) = delete;

  static int rate(realtype t, N_Vector y, N_Vector ydot, void* data);
  static int jacobian(realtype t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector, N_Vector);
  static int margins(realtype t, N_Vector y, realtype* margin, void* data);

  [[nodiscard]] Peaks sample(double t, const realtype* y);
  void change_regimes(double t, const realtype* y, const std::array<int, sides>& found);

  const GroundMotion* motion;
  FivePeaks peaks;

 private:
  void put_into_trial(double t, const realtype* y);
  void evaluate(double t, const realtype* y);

  Model model_;
  const ElementBlock* gaps_ = nullptr;
  Vector inverse_masses_;
  SparseMatrix stiffness_, damping_;
  std::vector<RegimeChange> changes_;
};

}  // namespace moat::performance
