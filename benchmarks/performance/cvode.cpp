#include "performance/cvode.hpp"

#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <array>

#include "performance/sundials_model_problem.hpp"
#include "performance/sundials_problem.hpp"

namespace moat::performance {
namespace {

template <class Problem>
class Cvode {
 public:
  Cvode(Problem& problem, SundialsVectors& vectors, const CvodeSetting& setting)
      : vectors_{&vectors},
        memory_{CVodeCreate(setting.method == Multistep::bdf ? CV_BDF : CV_ADAMS, vectors.context())} {
    checked(CVodeInit(memory_, Problem::rate, 0.0, vectors.y), "CVodeInit");
    checked(CVodeSetUserData(memory_, &problem), "CVodeSetUserData");
    vectors.set_tolerances(setting.relative_tolerance);
    checked(CVodeSVtolerances(memory_, setting.relative_tolerance, vectors.tolerances), "CVodeSVtolerances");
    if (setting.method == Multistep::bdf) {
      checked(CVodeSetLinearSolver(memory_, vectors.solver, vectors.matrix), "CVodeSetLinearSolver");
      checked(CVodeSetJacFn(memory_, Problem::jacobian), "CVodeSetJacFn");
    } else {
      fixed_point_ = SUNNonlinSol_FixedPoint(vectors.y, 0, vectors.context());
      checked(CVodeSetNonlinearSolver(memory_, fixed_point_), "CVodeSetNonlinearSolver");
    }
    checked(CVodeSetMaxStep(memory_, longest_step(*problem.motion, setting.kinks)), "CVodeSetMaxStep");
    checked(CVodeSetMaxNumSteps(memory_, -1), "CVodeSetMaxNumSteps");
    checked(CVodeRootInit(memory_, Problem::sides, Problem::margins), "CVodeRootInit");
    std::array<int, Problem::sides> falling{};
    falling.fill(-1);
    checked(CVodeSetRootDirection(memory_, falling.data()), "CVodeSetRootDirection");
    checked(CVodeSetNoInactiveRootWarn(memory_), "CVodeSetNoInactiveRootWarn");
  }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;
  ~Cvode() {
    CVodeFree(&memory_);
    if (fixed_point_ != nullptr) SUNNonlinSolFree(fixed_point_);
  }

  int step(double last, double& t) {
    if (last != stop_) checked(CVodeSetStopTime(memory_, stop_ = last), "CVodeSetStopTime");
    const int what = checked(CVode(memory_, last, vectors_->y, &t, CV_ONE_STEP), "CVode");
    if (what == CV_TSTOP_RETURN) stop_ = -1.0;
    return what;
  }
  void find_crossings(int* found) { checked(CVodeGetRootInfo(memory_, found), "CVodeGetRootInfo"); }
  void restart(double t) {
    checked(CVodeReInit(memory_, t, vectors_->y), "CVodeReInit");
    stop_ = -1.0;
  }
  void interpolate(double t) { checked(CVodeGetDky(memory_, t, 0, vectors_->between), "CVodeGetDky"); }

 private:
  SundialsVectors* vectors_;
  void* memory_;
  SUNNonlinearSolver fixed_point_ = nullptr;
  double stop_ = -1.0;
};

template <class Problem>
Peaks peaks_of(Problem problem, const CvodeSetting& setting) {
  SundialsVectors vectors;
  Cvode<Problem> integrator{problem, vectors, setting};
  follow(problem, integrator, vectors, setting.kinks);
  return problem.peaks.values();
}

}  // namespace

Peaks cvode_peaks(const GroundMotion& motion, const CvodeSetting& setting) {
  return peaks_of(SundialsProblem{motion}, setting);
}

Peaks cvode_peaks(const Model& model, const GroundMotion& motion, const CvodeSetting& setting) {
  return peaks_of(SundialsModelProblem{model, motion}, setting);
}

}  // namespace moat::performance
