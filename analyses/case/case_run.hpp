// One model under one motion, with everything that is reported about it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analyses/case/contact_sensitivity.hpp"
#include "analyses/case/error_bars.hpp"
#include "analyses/time_history/transient.hpp"
#include "output/files/case_result.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "output/recorders/bearing_check_recorder.hpp"
#include "output/recorders/clearance_recorder.hpp"
#include "output/recorders/energy_ledger.hpp"
#include "output/recorders/floor_spectra.hpp"
#include "output/recorders/history_recorder.hpp"
#include "output/recorders/impact_recorder.hpp"
#include "output/recorders/offered_quantities.hpp"

namespace moat {

/// When a run is followed by a companion with finer steps, from which its peaks get their errors.
enum class ErrorBarMode {
  automatic,  ///< where steps times elements are few (companion_is_cheap)
  always,
  never,
};

/// Options of one case.
struct CaseOptions {
  std::string title{};           ///< Reports show it.
  TransientOptions transient{};  ///< Options of the analysis: step, tolerance, end.
  /// >= 0 s. Interval of the histories, which have rows exactly at its multiples; 0: that of the motion's samples. Rows
  /// that would take more than half of the memory that is available are thinned, with a warning.
  Time history_interval{};
  /// > 0. Integration error, and residual of the equations, as a fraction of the largest input or kinetic energy, above
  /// which there is a warning.
  double warn_above_energy_error = 1e-3;
  ErrorBarMode error_bars = ErrorBarMode::automatic;  ///< When the second run is made.
  /// When runs with changed contacts are made. A script makes them where they are cheap; in code they are asked for.
  ContactSensitivityMode contact_sensitivity = ContactSensitivityMode::never;
};

/// A time history with peaks, clearances and their errors, impacts, histories, periods and solver statistics.
///
///     CaseRun run{model, motion, {.title = "..."}};
///     run.run();                                  // may throw ConvergenceError ...
///     const CaseResult result = run.result();     // ... and this still has all up to then
///
/// If the companion (analyses/case/error_bars.hpp) fails, the result has no error bars and a warning with the reason.
class CaseRun {
 public:
  /// The model must outlive the run. Throws InputError for an option outside its range, and for a model that needs more
  /// memory than is available.
  CaseRun(const Model& model, const GroundMotion& motion, CaseOptions options = {});
  CaseRun(const CaseRun&) = delete;
  CaseRun& operator=(const CaseRun&) = delete;

  /// Before run(): calls the observer too; it must outlive the run. Quantities of a QuantityRecorder appear in
  /// histories, peaks and report, and the checks of a BearingCheckRecorder and the spectra of FloorSpectra in the
  /// result. Throws InputError for a quantity that is there already.
  void attach(StepObserver& observer);
  /// Calls the observer for the steps of the companion, if there is one; it must outlive the run.
  void attach_to_companion(StepObserver& observer) { companion_observer_ = &observer; }
  /// Calls the observer for the steps of the runs with changed contacts, if there are any; it must outlive the run.
  void attach_to_changed_contacts(StepObserver& observer) { changed_contacts_observer_ = &observer; }
  /// stop: asked before every step of run(), also of the other runs; true ends it there, with all results up to then.
  void stop_when(std::function<bool()> stop) { stop_ = std::move(stop); }
  /// Whether the main run ended before its end because it was asked to.
  [[nodiscard]] bool stopped() const { return stopped_; }
  /// The main run, then the companion and the runs with changed contacts. Throws as Transient::run does in the main
  /// run.
  void run();

  /// Within `stop` of stop_when(): writes all from which a new run of the same model, motion, options and observers
  /// goes on, bit for bit. Runs behind the main run are a part of it. Throws InputError for an observer or an element
  /// that has no archive().
  void archive(StateArchive& archive);
  /// Before run(): it goes on from the state that archive() wrote in the same program. run() throws InputError where
  /// that does not fit.
  void go_on_from(StateArchive saved) { saved_ = std::move(saved); }
  /// Returns the histories up to now, to read.
  [[nodiscard]] const Table& histories() const { return histories_->table(); }

  [[nodiscard]] const Transient& transient() const { return transient_; }  ///< The analysis behind the case.
  /// All that was recorded up to now.
  [[nodiscard]] CaseResult result() const;
  friend CaseResult take_result(std::optional<CaseRun>& run);

 private:
  void run_companion();
  void compare_with(const PeaksAndImpacts& companion);
  [[nodiscard]] PeaksAndImpacts main_run() const;
  [[nodiscard]] CaseResult result_with(Table histories, std::vector<Peak> peaks) const;
  void add_errors(CaseResult& result) const;

  CaseOptions options_;
  std::vector<NamedPeriod> periods_;
  Transient transient_;
  EnergyLedger energy_;
  std::unique_ptr<PeakRecorder> peaks_;
  ImpactRecorder impacts_;
  ClearanceRecorder clearances_;
  std::unique_ptr<HistoryRecorder> histories_;
  std::vector<const BearingCheckRecorder*> bearing_checks_;
  FloorSpectra own_floor_spectra_;  // where the script attached none
  std::vector<const FloorSpectra*> floor_spectra_;
  OfferedQuantities offered_;
  OfferedPeaks offered_peaks_{offered_};
  std::function<bool()> stop_;
  bool stopped_ = false;
  StepObserver* companion_observer_ = nullptr;
  ErrorBars error_bars_;
  std::vector<double> errors_of_peaks_, errors_of_clearances_;  // in their order
  std::string about_companion_ = "No error bars: the run did not reach its end.";
  std::string companion_failure_, thinned_histories_;
  bool companion_done_ = false;
  RunUnderWay companion_run_;
  ContactRuns contact_runs_;
  std::optional<StateArchive> saved_;  // to go on from
  StepObserver* changed_contacts_observer_ = nullptr;
  ContactSensitivity contact_sensitivity_{.reason = "The run did not reach its end."};
};

/// Returns the result without a copy of the histories. It ends the run before it adds the facts of the model, which
/// need the memory of the run.
CaseResult take_result(std::optional<CaseRun>& run);

/// Runs one case and returns its result.
CaseResult run_case(const Model& model, const GroundMotion& motion, CaseOptions options = {});

}  // namespace moat
