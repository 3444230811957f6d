// One model under one motion, with everything that is reported about it.
#pragma once

#include <string>

#include "analyses/transient.hpp"
#include "output/case_result.hpp"
#include "output/energy_ledger.hpp"
#include "output/history_recorder.hpp"
#include "output/impact_recorder.hpp"
#include "output/peak_recorder.hpp"

namespace moat {

struct CaseOptions {
  std::string title{};
  TransientOptions transient{};
  /// >= 0 s. Interval of the histories; 0: that of the motion.
  Time history_interval{};
  /// > 0. Integration error, as a fraction of the largest input or kinetic energy, above which a warning names the worst element.
  double warn_above_energy_error = 1e-3;
};

/// A time history with peaks, impacts, histories, periods and solver statistics.
///
///     CaseRun run{model, motion, {.title = "..."}};
///     run.run();                                  // may throw ConvergenceError ...
///     const CaseResult result = run.result();     // ... and this still tells all up to then
class CaseRun {
 public:
  /// The model must outlive the run. Throws InputError for an option outside its range.
  CaseRun(Model& model, const GroundMotion& motion, CaseOptions options = {});
  CaseRun(const CaseRun&) = delete;
  CaseRun& operator=(const CaseRun&) = delete;

  /// Calls the observer too; it must outlive the run.
  void attach(StepObserver& observer) { transient_.attach(observer); }
  void run() { transient_.run(); }

  [[nodiscard]] const Transient& transient() const { return transient_; }
  [[nodiscard]] CaseResult result() const;

 private:
  CaseOptions options_;
  std::vector<NamedPeriod> periods_;
  Transient transient_;
  EnergyLedger energy_;
  PeakRecorder peaks_;
  ImpactRecorder impacts_;
  HistoryRecorder histories_;
};

/// Runs one case and returns its result.
CaseResult run_case(Model& model, const GroundMotion& motion, CaseOptions options = {});

}  // namespace moat
