#include "performance/sundials.hpp"

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nvector.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "performance/five_storey_equations.hpp"

namespace moat::performance {
namespace {

constexpr sunindextype state_size = 2 * unknowns;
constexpr double intervals_in_longest_step = 20.0;

int checked(int flag, const char* call) {
  if (flag < 0) throw Error{std::string{call} + " of SUNDIALS failed with code " + std::to_string(flag) + "."};
  return flag;
}

SundialsProblem& problem_of(void* data) { return *static_cast<SundialsProblem*>(data); }
int rate(realtype t, N_Vector y, N_Vector ydot, void* data) {
  problem_of(data).rate(t, NV_DATA_S(y), NV_DATA_S(ydot));
  return 0;
}
int jacobian(realtype t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector, N_Vector) {
  problem_of(data).jacobian(t, NV_DATA_S(y), matrix);
  return 0;
}
int margins(realtype t, N_Vector y, realtype* margin, void* data) {
  problem_of(data).margins(t, NV_DATA_S(y), margin);
  return 0;
}

// The vectors of any integrator. Tolerances are relative to 1 cm and 10 cm/s.
struct Vectors {
  explicit Vectors(double relative_tolerance) {
    SUNContext made = nullptr;
    checked(-std::abs(SUNContext_Create(nullptr, &made)), "SUNContext_Create");
    context = made;
    for (N_Vector* vector : {&y, &between, &tolerances}) *vector = N_VNew_Serial(state_size, context);
    N_VConst(0.0, y);
    for (sunindextype i = 0; i < state_size; ++i)
      NV_Ith_S(tolerances, i) = relative_tolerance * (i < unknowns ? 0.01 : 0.1);
  }
  Vectors(const Vectors&) = delete;
  Vectors& operator=(const Vectors&) = delete;
  ~Vectors() {
    for (N_Vector vector : {tolerances, between, y}) N_VDestroy(vector);
    SUNContext_Free(&context);
  }

  SUNContext context = nullptr;
  N_Vector y = nullptr, between = nullptr, tolerances = nullptr;
};

class Integrator {
 public:
  enum Outcome { stepped = 0, stop_reached = 1, margin_crossed = 2 };  // as SUNDIALS numbers them

  virtual ~Integrator() = default;
  virtual int step(double end, double& t) = 0;
  virtual void find_crossings(int* crossed) = 0;
  virtual void restart(double t) = 0;                    // from y
  virtual void interpolate(double t, N_Vector out) = 0;  // inside the last step
};

class Cvode final : public Integrator {
 public:
  Cvode(SundialsProblem& problem, Vectors& vectors, bool bdf, double relative_tolerance)
      : vectors_{&vectors}, memory_{CVodeCreate(bdf ? CV_BDF : CV_ADAMS, vectors.context)} {
    checked(CVodeInit(memory_, rate, 0.0, vectors.y), "CVodeInit");
    checked(CVodeSetUserData(memory_, &problem), "CVodeSetUserData");
    checked(CVodeSVtolerances(memory_, relative_tolerance, vectors.tolerances), "CVodeSVtolerances");
    if (bdf) {
      matrix_ = SUNDenseMatrix(state_size, state_size, vectors.context);
      linear_ = SUNLinSol_Dense(vectors.y, matrix_, vectors.context);
      checked(CVodeSetLinearSolver(memory_, linear_, matrix_), "CVodeSetLinearSolver");
      checked(CVodeSetJacFn(memory_, jacobian), "CVodeSetJacFn");
    } else {
      fixed_point_ = SUNNonlinSol_FixedPoint(vectors.y, 0, vectors.context);
      checked(CVodeSetNonlinearSolver(memory_, fixed_point_), "CVodeSetNonlinearSolver");
    }
    checked(CVodeSetMaxStep(memory_, intervals_in_longest_step * problem.motion.time_step()), "CVodeSetMaxStep");
    checked(CVodeSetMaxNumSteps(memory_, -1), "CVodeSetMaxNumSteps");
    checked(CVodeRootInit(memory_, problem.margin_count(), margins), "CVodeRootInit");
    std::vector<int> falling(static_cast<std::size_t>(problem.margin_count()), -1);
    checked(CVodeSetRootDirection(memory_, falling.data()), "CVodeSetRootDirection");
    checked(CVodeSetNoInactiveRootWarn(memory_), "CVodeSetNoInactiveRootWarn");
  }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;
  ~Cvode() override {
    CVodeFree(&memory_);
    if (fixed_point_ != nullptr) SUNNonlinSolFree(fixed_point_);
    if (linear_ != nullptr) SUNLinSolFree(linear_);
    if (matrix_ != nullptr) SUNMatDestroy(matrix_);
  }

  int step(double end, double& t) override {
    checked(CVodeSetStopTime(memory_, end), "CVodeSetStopTime");
    return checked(CVode(memory_, end, vectors_->y, &t, CV_ONE_STEP), "CVode");
  }
  void find_crossings(int* crossed) override { checked(CVodeGetRootInfo(memory_, crossed), "CVodeGetRootInfo"); }
  void restart(double t) override { checked(CVodeReInit(memory_, t, vectors_->y), "CVodeReInit"); }
  void interpolate(double t, N_Vector out) override { checked(CVodeGetDky(memory_, t, 0, out), "CVodeGetDky"); }

 private:
  Vectors* vectors_;
  void* memory_;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  SUNNonlinearSolver fixed_point_ = nullptr;
};

class Arkode final : public Integrator {
 public:
  Arkode(SundialsProblem& problem, Vectors& vectors, ARKODE_ERKTableID table, double relative_tolerance)
      : vectors_{&vectors}, memory_{ERKStepCreate(rate, 0.0, vectors.y, vectors.context)} {
    checked(ERKStepSetUserData(memory_, &problem), "ERKStepSetUserData");
    checked(ERKStepSVtolerances(memory_, relative_tolerance, vectors.tolerances), "ERKStepSVtolerances");
    checked(ERKStepSetTableNum(memory_, table), "ERKStepSetTableNum");
    checked(ERKStepSetMaxStep(memory_, intervals_in_longest_step * problem.motion.time_step()), "ERKStepSetMaxStep");
    checked(ERKStepSetMaxNumSteps(memory_, -1), "ERKStepSetMaxNumSteps");
    checked(ERKStepRootInit(memory_, problem.margin_count(), margins), "ERKStepRootInit");
    std::vector<int> falling(static_cast<std::size_t>(problem.margin_count()), -1);
    checked(ERKStepSetRootDirection(memory_, falling.data()), "ERKStepSetRootDirection");
    checked(ERKStepSetNoInactiveRootWarn(memory_), "ERKStepSetNoInactiveRootWarn");
  }
  Arkode(const Arkode&) = delete;
  Arkode& operator=(const Arkode&) = delete;
  ~Arkode() override { ERKStepFree(&memory_); }

  int step(double end, double& t) override {
    checked(ERKStepSetStopTime(memory_, end), "ERKStepSetStopTime");
    return checked(ERKStepEvolve(memory_, end, vectors_->y, &t, ARK_ONE_STEP), "ERKStepEvolve");
  }
  void find_crossings(int* crossed) override { checked(ERKStepGetRootInfo(memory_, crossed), "ERKStepGetRootInfo"); }
  void restart(double t) override { checked(ERKStepReset(memory_, t, vectors_->y), "ERKStepReset"); }
  void interpolate(double t, N_Vector out) override { checked(ERKStepGetDky(memory_, t, 0, out), "ERKStepGetDky"); }

 private:
  Vectors* vectors_;
  void* memory_;
};

std::unique_ptr<Integrator> integrator_for(SundialsProblem& problem, Vectors& vectors, SundialsMethod method,
                                           double tolerance) {
  using enum SundialsMethod;
  if (method == bdf || method == adams) return std::make_unique<Cvode>(problem, vectors, method == bdf, tolerance);
  const auto table = method == bogacki_shampine_3 ? ARKODE_BOGACKI_SHAMPINE_4_2_3
                     : method == zonneveld_4      ? ARKODE_ZONNEVELD_5_3_4
                                                  : ARKODE_DORMAND_PRINCE_7_4_5;
  return std::make_unique<Arkode>(problem, vectors, table, tolerance);
}

}  // namespace

const char* name_of(SundialsMethod method) {
  constexpr const char* names[] = {"BDF", "Adams", "Bogacki-Shampine", "Zonneveld", "Dormand-Prince"};
  return names[static_cast<int>(method)];
}

Peaks sundials_peaks(SundialsProblem& problem, SundialsMethod method, double relative_tolerance) {
  Vectors vectors{relative_tolerance};
  const auto integrator = integrator_for(problem, vectors, method, relative_tolerance);
  const double end = problem.motion.duration(), interval = problem.motion.time_step();
  const realtype *y = NV_DATA_S(vectors.y), *between = NV_DATA_S(vectors.between);
  std::vector<int> crossed(static_cast<std::size_t>(problem.margin_count()));
  FivePeaks peaks;
  double t = 0.0;
  peaks.add(t, problem.sample(t, y));
  while (t < end * (1.0 - 1e-12)) {
    const double start = t;
    const int outcome = integrator->step(end, t);
    // A step longer than the interval of the samples may hide a peak.
    const double parts = std::ceil((t - start) / interval - 1e-6);
    for (double part = 1.0; part < parts; part += 1.0) {
      const double inside = start + (t - start) * part / parts;
      integrator->interpolate(inside, vectors.between);
      peaks.add(inside, problem.sample(inside, between));
    }
    peaks.add(t, problem.sample(t, y));
    if (outcome != Integrator::margin_crossed) continue;
    integrator->find_crossings(crossed.data());
    problem.change_regimes(t, y, crossed.data());
    peaks.restart(t, problem.sample(t, y));
    integrator->restart(t);
  }
  return peaks.values();
}

}  // namespace moat::performance
