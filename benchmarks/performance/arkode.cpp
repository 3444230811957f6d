#include "performance/arkode.hpp"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include <array>

#include "performance/sundials_model_problem.hpp"
#include "performance/sundials_problem.hpp"

namespace moat::performance {
namespace {

template <class Problem>
class Explicit {
 public:
  Explicit(Problem& problem, SundialsVectors& vectors, const ArkodeSetting& setting)
      : vectors_{&vectors}, memory_{ERKStepCreate(Problem::rate, 0.0, vectors.y, vectors.context())} {
    checked(ERKStepSetUserData(memory_, &problem), "ERKStepSetUserData");
    vectors.set_tolerances(setting.relative_tolerance);
    checked(ERKStepSVtolerances(memory_, setting.relative_tolerance, vectors.tolerances), "ERKStepSVtolerances");
    const auto table = setting.method == RungeKuttaMethod::bogacki_shampine_3 ? ARKODE_BOGACKI_SHAMPINE_4_2_3
                       : setting.method == RungeKuttaMethod::zonneveld_4      ? ARKODE_ZONNEVELD_5_3_4
                                                                              : ARKODE_DORMAND_PRINCE_7_4_5;
    checked(ERKStepSetTableNum(memory_, table), "ERKStepSetTableNum");
    if (setting.fixed_divisions > 0)
      checked(ERKStepSetFixedStep(memory_, problem.motion->time_step() / setting.fixed_divisions),
              "ERKStepSetFixedStep");
    else
      checked(ERKStepSetMaxStep(memory_, longest_step(*problem.motion, setting.kinks)), "ERKStepSetMaxStep");
    checked(ERKStepSetMaxNumSteps(memory_, -1), "ERKStepSetMaxNumSteps");
    checked(ERKStepRootInit(memory_, Problem::sides, Problem::margins), "ERKStepRootInit");
    std::array<int, Problem::sides> directions{};
    directions.fill(-1);
    checked(ERKStepSetRootDirection(memory_, directions.data()), "ERKStepSetRootDirection");
    checked(ERKStepSetNoInactiveRootWarn(memory_), "ERKStepSetNoInactiveRootWarn");
  }
  Explicit(const Explicit&) = delete;
  Explicit& operator=(const Explicit&) = delete;
  ~Explicit() { ERKStepFree(&memory_); }

  int step(double last, double& t) {
    if (last != stop_) checked(ERKStepSetStopTime(memory_, stop_ = last), "ERKStepSetStopTime");
    const int what = checked(ERKStepEvolve(memory_, last, vectors_->y, &t, ARK_ONE_STEP), "ERKStepEvolve");
    if (what == ARK_TSTOP_RETURN) stop_ = -1.0;
    return what;
  }
  void find_crossings(int* found) { checked(ERKStepGetRootInfo(memory_, found), "ERKStepGetRootInfo"); }
  void restart(double t) {
    checked(ERKStepReset(memory_, t, vectors_->y), "ERKStepReset");
    stop_ = -1.0;
  }
  void interpolate(double t) { checked(ERKStepGetDky(memory_, t, 0, vectors_->between), "ERKStepGetDky"); }

 private:
  SundialsVectors* vectors_;
  void* memory_;
  double stop_ = -1.0;
};

template <class Problem>
class Implicit {
 public:
  Implicit(Problem& problem, SundialsVectors& vectors, const ArkodeSetting& setting)
      : vectors_{&vectors}, memory_{ARKStepCreate(nullptr, Problem::rate, 0.0, vectors.y, vectors.context())} {
    checked(ARKStepSetUserData(memory_, &problem), "ARKStepSetUserData");
    vectors.set_tolerances(setting.relative_tolerance);
    checked(ARKStepSVtolerances(memory_, setting.relative_tolerance, vectors.tolerances), "ARKStepSVtolerances");
    checked(ARKStepSetTableNum(memory_, ARKODE_SDIRK_5_3_4, ARKODE_ERK_NONE), "ARKStepSetTableNum");
    checked(ARKStepSetLinearSolver(memory_, vectors.solver, vectors.matrix), "ARKStepSetLinearSolver");
    checked(ARKStepSetJacFn(memory_, Problem::jacobian), "ARKStepSetJacFn");
    checked(ARKStepSetMaxStep(memory_, longest_step(*problem.motion, setting.kinks)), "ARKStepSetMaxStep");
    checked(ARKStepSetMaxNumSteps(memory_, -1), "ARKStepSetMaxNumSteps");
    checked(ARKStepRootInit(memory_, Problem::sides, Problem::margins), "ARKStepRootInit");
    std::array<int, Problem::sides> directions{};
    directions.fill(-1);
    checked(ARKStepSetRootDirection(memory_, directions.data()), "ARKStepSetRootDirection");
    checked(ARKStepSetNoInactiveRootWarn(memory_), "ARKStepSetNoInactiveRootWarn");
  }
  Implicit(const Implicit&) = delete;
  Implicit& operator=(const Implicit&) = delete;
  ~Implicit() { ARKStepFree(&memory_); }

  int step(double last, double& t) {
    if (last != stop_) checked(ARKStepSetStopTime(memory_, stop_ = last), "ARKStepSetStopTime");
    const int what = checked(ARKStepEvolve(memory_, last, vectors_->y, &t, ARK_ONE_STEP), "ARKStepEvolve");
    if (what == ARK_TSTOP_RETURN) stop_ = -1.0;
    return what;
  }
  void find_crossings(int* found) { checked(ARKStepGetRootInfo(memory_, found), "ARKStepGetRootInfo"); }
  void restart(double t) {
    checked(ARKStepReset(memory_, t, vectors_->y), "ARKStepReset");
    stop_ = -1.0;
  }
  void interpolate(double t) { checked(ARKStepGetDky(memory_, t, 0, vectors_->between), "ARKStepGetDky"); }

 private:
  SundialsVectors* vectors_;
  void* memory_;
  double stop_ = -1.0;
};

template <class Problem>
Peaks peaks_of(Problem problem, const ArkodeSetting& setting) {
  SundialsVectors vectors;
  if (setting.method == RungeKuttaMethod::sdirk_4) {
    Implicit<Problem> integrator{problem, vectors, setting};
    follow(problem, integrator, vectors, setting.kinks);
  } else {
    Explicit<Problem> integrator{problem, vectors, setting};
    follow(problem, integrator, vectors, setting.kinks);
  }
  return problem.peaks.values();
}

}  // namespace

Peaks arkode_peaks(const GroundMotion& motion, const ArkodeSetting& setting) {
  return peaks_of(SundialsProblem{motion}, setting);
}

Peaks arkode_peaks(const Model& model, const GroundMotion& motion, const ArkodeSetting& setting) {
  return peaks_of(SundialsModelProblem{model, motion}, setting);
}

}  // namespace moat::performance
