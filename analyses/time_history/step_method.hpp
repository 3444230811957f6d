// The interface of methods that compute a trial state from the committed state.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/ground_vector.hpp"
#include "model/analysis_state.hpp"
#include "output/files/case_result.hpp"
#include "solvers/newton.hpp"

namespace moat {

/// A step from the committed state.
struct StepTask {
  double length = 0.0;                          ///< h > 0 s
  double end_time = 0.0;                        ///< s
  GroundVector ground_acceleration{};           ///< m/s^2, at the end
  GroundVector ground_jerk{};                   ///< m/s^3, mean of the step; used by schemes that correct the velocity
  GroundVector ground_acceleration_at_start{};  ///< m/s^2
  double start_time = 0.0;                      ///< s
};

/// The part of TransientOptions and of the motion that steps need.
struct StepSettings {
  static constexpr int most_halvings = 40;  ///< Upper bound of `max_halvings`.

  double fixed_step = 0.0;                ///< s; 0: adaptive
  double longest_step = 0.0;              ///< s, of adaptive steps
  double sample_interval = 0.0;           ///< s, of the motion
  double peak_ground_acceleration = 0.0;  ///< m/s^2
  double tolerance = 3e-5;                ///< > 0, of the error of one adaptive step over its scale
  int steps_per_contact = 32;             ///< > 0; adaptive steps divide the shortest contact into these
  int max_halvings = 24;                  ///< of longest_step, for the shortest adaptive step
  NewtonOptions newton{};                 ///< of methods that solve equations
  int max_cuts = 12;                      ///< of a step that does not converge
  double location_tolerance = 1e-12;      ///< m
};

/// A method of integration. An analysis (Transient) has one or several, in order of preference. The first that applies
/// takes the step: propose(), solve(), and judge(), from propose() again where judge() returns false. The analysis then
/// looks for events in the step, which may call solve() with shorter parts of it, and commits it. It calls accepted()
/// and restart() of all methods. A method does not depend on observers, files or the location of events.
class StepMethod {
 public:
  virtual ~StepMethod() = default;

  /// Whether it can take the next step. The last method of an analysis always can.
  [[nodiscard]] virtual bool applies() const { return true; }
  /// Returns the length of the step to try next from the committed state, s.
  virtual double propose() = 0;
  /// Solves a step into the trial state: the motion with accelerations and jerks, and all forces with
  /// their rates. After propose() the whole step comes first, then shorter parts of it. False if it did not converge.
  virtual bool solve(const StepTask& task) = 0;
  /// Judges the trial state of the last solve(). False: it must be tried again with propose(), which is then shorter.
  [[nodiscard]] virtual bool judge(const StepTask&) { return true; }
  /// The step was committed.
  virtual void accepted(const StepTask&) {}
  /// Accelerations of the committed state may have jumped: at the start, after changes of regime, and where the ground
  /// stops. `touched`: a gap closed.
  virtual void restart([[maybe_unused]] bool touched) {}

  /// Returns how the work of its steps is formed.
  [[nodiscard]] virtual WorkRule work_rule() const { return WorkRule::mean_force; }
  /// Returns how it steps, for the assumptions of a report; without a full stop. Where it does not always apply the
  /// next method's description follows.
  [[nodiscard]] virtual std::string description() const = 0;
  /// Returns sentences about settings that can make the results inaccurate, with advice.
  [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
  /// Adds its iterations and factorisations so far.
  virtual void add_costs(SolverStatistics&) const {}
  /// Returns where and how far forces are out of balance, after a solve() that did not converge.
  [[nodiscard]] virtual NewtonReport imbalance() const { return {}; }

  /// Writes all that one step leaves for the next, or reads it back into a method of the same model and settings.
  virtual void archive(StateArchive& archive) = 0;
};

/// The methods of an analysis.
struct StepMethods {
  std::vector<std::unique_ptr<StepMethod>> by_preference;  ///< at least one
  std::string reason{};                                    ///< a sentence: why they were chosen; may be empty
};

}  // namespace moat
