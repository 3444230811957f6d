#include "performance/arkode.hpp"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

namespace moat::performance {
namespace {

constexpr std::array<int, SundialsProblem::sides> falling{-1, -1, -1, -1};

class Explicit {
 public:
  Explicit(SundialsProblem& problem, SundialsVectors& vectors, const ArkodeSetting& setting)
      : vectors_{&vectors}, memory_{ERKStepCreate(SundialsProblem::rate, 0.0, vectors.y, vectors.context())} {
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
      checked(ERKStepSetMaxStep(memory_, problem.longest_step(setting.kinks)), "ERKStepSetMaxStep");
    checked(ERKStepSetMaxNumSteps(memory_, -1), "ERKStepSetMaxNumSteps");
    checked(ERKStepRootInit(memory_, SundialsProblem::sides, SundialsProblem::margins), "ERKStepRootInit");
    std::array<int, SundialsProblem::sides> directions = falling;
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

class Implicit {
 public:
  Implicit(SundialsProblem& problem, SundialsVectors& vectors, const ArkodeSetting& setting)
      : vectors_{&vectors}, memory_{ARKStepCreate(nullptr, SundialsProblem::rate, 0.0, vectors.y, vectors.context())} {
    checked(ARKStepSetUserData(memory_, &problem), "ARKStepSetUserData");
    vectors.set_tolerances(setting.relative_tolerance);
    checked(ARKStepSVtolerances(memory_, setting.relative_tolerance, vectors.tolerances), "ARKStepSVtolerances");
    checked(ARKStepSetTableNum(memory_, ARKODE_SDIRK_5_3_4, ARKODE_ERK_NONE), "ARKStepSetTableNum");
    checked(ARKStepSetLinearSolver(memory_, vectors.solver, vectors.matrix), "ARKStepSetLinearSolver");
    checked(ARKStepSetJacFn(memory_, SundialsProblem::jacobian), "ARKStepSetJacFn");
    checked(ARKStepSetMaxStep(memory_, problem.longest_step(setting.kinks)), "ARKStepSetMaxStep");
    checked(ARKStepSetMaxNumSteps(memory_, -1), "ARKStepSetMaxNumSteps");
    checked(ARKStepRootInit(memory_, SundialsProblem::sides, SundialsProblem::margins), "ARKStepRootInit");
    std::array<int, SundialsProblem::sides> directions = falling;
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

}  // namespace

Peaks arkode_peaks(const GroundMotion& motion, const ArkodeSetting& setting) {
  SundialsProblem problem;
  problem.motion = &motion;
  SundialsVectors vectors;
  if (setting.method == RungeKuttaMethod::sdirk_4) {
    Implicit integrator{problem, vectors, setting};
    follow(problem, integrator, vectors, setting.kinks);
  } else {
    Explicit integrator{problem, vectors, setting};
    follow(problem, integrator, vectors, setting.kinks);
  }
  return problem.peaks.values();
}

}  // namespace moat::performance
