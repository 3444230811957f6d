#include "performance/sundials.hpp"

#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "performance/five_storey_equations.hpp"

namespace moat::performance {
namespace {

constexpr sunindextype state_size = sunindextype{2} * unknowns;

int checked(int flag, const char* call) {
  if (flag < 0) throw Error{std::string{call} + " of SUNDIALS failed with code " + std::to_string(flag) + "."};
  return flag;
}

// The building in its present regimes: y' = f(t, y) with y = (u, v).
struct Problem {
  const GroundMotion& motion;
  FiveStoreys building{};
  Regimes regimes{};

  [[nodiscard]] Values acceleration(double ground, const realtype* y) const {
    return accelerations(building, regimes, Eigen::Map<const Values>{y}, Eigen::Map<const Values>{y + unknowns},
                         ground);
  }
  [[nodiscard]] Peaks sample(double t, const realtype* y) const {
    const double ground = motion.acceleration_at(t);
    const Values absolute = acceleration(ground, y).array() + ground;
    return {y[0], y[floors], absolute[0], absolute[floors], wall_force(building, regimes, y[0], y[unknowns])};
  }
};

int rate(realtype t, N_Vector y, N_Vector ydot, void* data) {
  const Problem& problem = *static_cast<const Problem*>(data);
  const realtype* state = NV_DATA_S(y);
  realtype* rates = NV_DATA_S(ydot);
  std::copy(state + unknowns, state + state_size, rates);
  Eigen::Map<Values>{rates + unknowns} = problem.acceleration(problem.motion.acceleration_at(t), state);
  return 0;
}

int margins(realtype, N_Vector y, realtype* margin, void* data) {
  const Problem& problem = *static_cast<const Problem*>(data);
  const Margins now = margins_of(problem.building, problem.regimes, NV_Ith_S(y, 0), NV_Ith_S(y, unknowns));
  std::copy(now.begin(), now.end(), margin);
  return 0;
}

class Integrator {
 public:
  // Tolerances are relative to 1 cm and 10 cm/s.
  Integrator(Problem& problem, SundialsMethod method, double relative_tolerance) {
    checked(-std::abs(SUNContext_Create(nullptr, &context_)), "SUNContext_Create");
    for (N_Vector* vector : {&y_, &between_, &tolerances_}) *vector = N_VNew_Serial(state_size, context_);
    N_VConst(0.0, y_);
    for (sunindextype i = 0; i < state_size; ++i)
      NV_Ith_S(tolerances_, i) = relative_tolerance * (i < unknowns ? 0.01 : 0.1);
    memory_ = ERKStepCreate(rate, 0.0, y_, context_);
    checked(ERKStepSetUserData(memory_, &problem), "ERKStepSetUserData");
    checked(ERKStepSVtolerances(memory_, relative_tolerance, tolerances_), "ERKStepSVtolerances");
    const auto table = method == SundialsMethod::zonneveld_4 ? ARKODE_ZONNEVELD_5_3_4 : ARKODE_DORMAND_PRINCE_7_4_5;
    checked(ERKStepSetTableNum(memory_, table), "ERKStepSetTableNum");
    checked(ERKStepSetMaxStep(memory_, 20.0 * problem.motion.time_step()), "ERKStepSetMaxStep");
    checked(ERKStepSetMaxNumSteps(memory_, -1), "ERKStepSetMaxNumSteps");
    checked(ERKStepRootInit(memory_, event_count, margins), "ERKStepRootInit");
    std::array<int, event_count> falling{-1, -1, -1};
    checked(ERKStepSetRootDirection(memory_, falling.data()), "ERKStepSetRootDirection");
    checked(ERKStepSetNoInactiveRootWarn(memory_), "ERKStepSetNoInactiveRootWarn");
    checked(ERKStepSetStopTime(memory_, problem.motion.duration()), "ERKStepSetStopTime");
  }
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
  ~Integrator() {
    ERKStepFree(&memory_);
    for (N_Vector vector : {tolerances_, between_, y_}) N_VDestroy(vector);
    SUNContext_Free(&context_);
  }

  // Whether the step ended at an event.
  bool step(double end, double& t) {
    return checked(ERKStepEvolve(memory_, end, y_, &t, ARK_ONE_STEP), "ERKStepEvolve") == ARK_ROOT_RETURN;
  }
  // Returns numbers that are not zero where a margin fell below zero.
  [[nodiscard]] std::array<int, event_count> crossed() {
    std::array<int, event_count> result{};
    checked(ERKStepGetRootInfo(memory_, result.data()), "ERKStepGetRootInfo");
    return result;
  }
  void restart(double t) { checked(ERKStepReset(memory_, t, y_), "ERKStepReset"); }

  [[nodiscard]] const realtype* y() const { return NV_DATA_S(y_); }
  // Inside the last step.
  [[nodiscard]] const realtype* y_at(double t) {
    checked(ERKStepGetDky(memory_, t, 0, between_), "ERKStepGetDky");
    return NV_DATA_S(between_);
  }

 private:
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr, between_ = nullptr, tolerances_ = nullptr;
  void* memory_ = nullptr;
};

}  // namespace

Peaks sundials_peaks(const GroundMotion& motion, SundialsMethod method, double relative_tolerance) {
  Problem problem{motion};
  Integrator integrator{problem, method, relative_tolerance};
  const double end = motion.duration(), interval = motion.time_step();
  const realtype* y = integrator.y();
  FivePeaks peaks;
  double t = 0.0;
  peaks.add(t, problem.sample(t, y));
  while (t < end * (1.0 - 1e-12)) {
    const double start = t;
    const bool event = integrator.step(end, t);
    // A step longer than the interval of the samples may hide a peak.
    const double parts = std::ceil((t - start) / interval - 1e-6);
    for (double part = 1.0; part < parts; part += 1.0) {
      const double inside = start + (t - start) * part / parts;
      peaks.add(inside, problem.sample(inside, integrator.y_at(inside)));
    }
    peaks.add(t, problem.sample(t, y));
    if (!event) continue;
    const auto crossed = integrator.crossed();
    for (const Event each : {bearing_corner, gap_end, force_end})
      if (crossed[each] != 0) problem.regimes = beyond(problem.building, problem.regimes, each, y[0], y[unknowns]);
    peaks.restart(t, problem.sample(t, y));
    integrator.restart(t);
  }
  return peaks.values();
}

}  // namespace moat::performance
