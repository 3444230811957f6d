// Runs behind the main run of a case: peaks and touches alone.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "analyses/time_history/transient.hpp"
#include "base/state_archive.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// A run of compute_peaks() until its end, for checkpoints.
class RunUnderWay {
 public:
  /// Runs an analysis that has all its observers; it goes on from the state that archive() read, if there is one.
  void run(Transient& transient, const std::function<bool()>& stop);
  /// Writes the state of the run, or reads it for run().
  void archive(StateArchive& archive);

 private:
  Transient* transient_ = nullptr;
  std::string state_;  // to go on from
};

/// Peaks, clearances and touches of one run, and its cost.
struct PeaksAndImpacts {
  std::vector<Peak> peaks;                 ///< of every quantity and place
  std::vector<Impact> touches;             ///< one for every impact
  SolverStatistics solver;                 ///< steps, iterations, seconds
  std::vector<GapClearance> clearances{};  ///< of every gap
  bool collapsed = false;                  ///< Transient::collapsed()

  void archive(auto& archive) { archive(peaks, touches, solver, clearances, collapsed); }  ///< StateArchive.
};

/// Runs the model and returns its peaks and touches. The observers that are not null get every step. stop: asked
/// before every step; true ends the run with an Error. under_way: has the run until its end. Throws as Transient does.
PeaksAndImpacts compute_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                              std::initializer_list<StepObserver*> observers = {},
                              const std::function<bool()>& stop = {}, RunUnderWay* under_way = nullptr);

}  // namespace moat
