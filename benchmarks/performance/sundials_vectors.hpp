// Vectors, matrix and linear solver of SUNDIALS for the five-storey building.
#pragma once

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nvector.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cstdlib>
#include <string>

#include "base/error.hpp"
#include "performance/pairs.hpp"

namespace moat::performance {

/// y = (u, v): displacements, then velocities.
inline constexpr sunindextype state_size = 2 * (floors + 1);

/// Throws Error for a negative return value.
inline int checked(int flag, const char* call) {
  if (flag < 0) throw Error{std::string{call} + " of SUNDIALS failed with code " + std::to_string(flag) + "."};
  return flag;
}

/// What all of its integrators need, given back at the end.
class SundialsVectors {
 public:
  SundialsVectors() {
    SUNContext made = nullptr;
    checked(-std::abs(SUNContext_Create(nullptr, &made)), "SUNContext_Create");
    context_ = made;
    y = N_VNew_Serial(state_size, context_);
    between = N_VNew_Serial(state_size, context_);
    tolerances = N_VNew_Serial(state_size, context_);
    matrix = SUNDenseMatrix(state_size, state_size, context_);
    solver = SUNLinSol_Dense(y, matrix, context_);
    N_VConst(0.0, y);
  }
  SundialsVectors(const SundialsVectors&) = delete;
  SundialsVectors& operator=(const SundialsVectors&) = delete;
  ~SundialsVectors() {
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(tolerances);
    N_VDestroy(between);
    N_VDestroy(y);
    SUNContext_Free(&context_);
  }

  /// Absolute tolerances from the relative one: of 1 cm and 10 cm/s.
  void set_tolerances(double relative) {
    for (sunindextype i = 0; i < state_size; ++i)
      NV_Ith_S(tolerances, i) = relative * (2 * i < state_size ? 0.01 : 0.1);
  }

  [[nodiscard]] SUNContext context() const { return context_; }

  N_Vector y = nullptr, between = nullptr, tolerances = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver solver = nullptr;

 private:
  SUNContext context_ = nullptr;
};

}  // namespace moat::performance
