#include "analyses/case/case_run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "analyses/case/available_memory.hpp"
#include "analyses/case/case_assumptions.hpp"
#include "analyses/case/case_warnings.hpp"
#include "analyses/case/input_warnings.hpp"
#include "analyses/modes/periods.hpp"
#include "analyses/modes/torsion.hpp"
#include "base/check.hpp"
#include "base/error.hpp"
#include "model/building.hpp"
#include "output/files/building_parts.hpp"
#include "output/peaks/drift_ratios.hpp"
#include "output/vtk/model_scene.hpp"

namespace moat {
namespace {

CaseOptions checked(CaseOptions options, const Model& model) {
  const Check check{"CaseOptions", options.title};
  // memory_bounds_test.cpp guards it.
  constexpr double bytes_per_degree_of_freedom = 7.5e3;
  const double needed = bytes_per_degree_of_freedom * model.degrees_of_freedom(), available = available_memory();
  check.that(needed <= available,
             "a run of " + std::to_string(model.degrees_of_freedom()) +
                 " degrees of freedom with its results needs about " + memory_text(needed) + ", and " +
                 memory_text(available) + " of memory are available.",
             "Take a machine with more memory, or a model with fewer nodes.");
  check.not_negative("history_interval", options.history_interval);
  check.positive("warn_above_energy_error", options.warn_above_energy_error, "1");
  return options;
}

double history_interval(const CaseOptions& options, const GroundMotion& motion) {
  return options.history_interval.si() > 0.0 ? options.history_interval.si() : motion.time_step();
}

// Whether every multiple of the histories' interval is the end of a step.
bool rows_at_steps(double interval, double step) {
  const double ratio = interval / step;
  return std::abs(ratio - std::round(ratio)) < 1e-9 * ratio;
}

std::string_view name_of(ErrorBarMode mode) {
  switch (mode) {
    case ErrorBarMode::always:
      return "always";
    case ErrorBarMode::never:
      return "never";
    default:
      return "automatic";
  }
}

std::string_view name_of(ContactSensitivityMode mode) {
  switch (mode) {
    case ContactSensitivityMode::always:
      return "always";
    case ContactSensitivityMode::automatic:
      return "automatic";
    default:
      return "never";
  }
}

AnalysisFacts facts_of(const CaseOptions& options) {
  // An option that is missing here does not compile.
  const auto& [title, transient, history_interval, warn_above_energy_error, error_bars, contact_sensitivity] = options;
  AnalysisFacts facts = facts_of(transient);
  facts.error_bars = name_of(error_bars);
  facts.contact_sensitivity = name_of(contact_sensitivity);
  facts.options.push_back({"history_interval", history_interval.si(), "s"});
  facts.options.push_back({"warn_above_energy_error", warn_above_energy_error, "1"});
  return facts;
}

MotionFacts facts_of(const GroundMotion& motion) {
  return {.name = motion.name(),
          .peak_acceleration = motion.peak_acceleration().si(),
          .peak_velocity = motion.peak_velocity().si(),
          .time_step = motion.time_step(),
          .duration = motion.duration(),
          .notes = motion.notes(),
          .components = motion.components()};
}

CaseResult with_model(CaseResult result, const Model& model) {
  result.model = facts_of(model);
  if (model.degrees_of_freedom() <= most_drawn_nodes) result.scene = scene_of(model);
  result.buildings = parts_of_buildings(model);
  return result;
}

}  // namespace

CaseRun::CaseRun(const Model& model, const GroundMotion& motion, CaseOptions options)
    : options_{checked(std::move(options), model)},
      periods_{characteristic_periods(model)},
      transient_{model, motion, options_.transient},
      peaks_{std::make_unique<PeakRecorder>(model)},
      clearances_{model},
      histories_{std::make_unique<HistoryRecorder>(
          model, history_interval(options_, motion), &energy_,
          !rows_at_steps(history_interval(options_, motion), longest_step(options_.transient, motion.time_step())))} {
  histories_->share_samples_of(*peaks_);
}

void CaseRun::attach(StepObserver& observer) {
  transient_.attach(observer);
  if (const auto* checks = dynamic_cast<const BearingCheckRecorder*>(&observer)) bearing_checks_.push_back(checks);
  if (const auto* spectra = dynamic_cast<const FloorSpectra*>(&observer)) floor_spectra_.push_back(spectra);
  const auto* recorder = dynamic_cast<const QuantityRecorder*>(&observer);
  if (recorder == nullptr) return;
  offered_.add(*recorder);
  histories_->add(offered_);
}

void CaseRun::run() {
  const double interval = histories_->interval(), available = available_memory();
  constexpr double least_for_histories = 64e6;
  if (const double needed = histories_->fit(transient_.end_time(), std::max(0.5 * available, least_for_histories));
      needed > 0.0)
    thinned_histories_ = "Histories have a row every " + to_text(histories_->interval()) + " s instead of every " +
                         to_text(interval) + " s, which would take " + memory_text(needed) + " of the " +
                         memory_text(available) +
                         " of memory that are available. Peaks, impacts and energies are those "
                         "of all steps. An earlier end or more memory keeps all rows.";
  histories_->reserve(transient_.end_time());
  // After the observers of the script: a quantity that one of them offers is up to date when it is sampled.
  for (StepObserver* own :
       std::initializer_list<StepObserver*>{&energy_, peaks_.get(), &impacts_, &clearances_, histories_.get()})
    transient_.attach(*own);
  if (!offered_.list().empty()) transient_.attach(offered_peaks_);
  if (floor_spectra_.empty()) attach(own_floor_spectra_);
  if (saved_) {
    archive(*saved_);
    saved_->require_end();
    saved_.reset();
  }
  transient_.run(stop_);
  stopped_ = !transient_.finished();
  if (stopped_) return;
  if (!companion_done_) run_companion();
  companion_done_ = true;
  contact_sensitivity_ =
      contact_sensitivity(transient_.model(), transient_.motion(), options_.transient, options_.contact_sensitivity,
                          main_run(), changed_contacts_observer_, stop_, &contact_runs_);
}

void CaseRun::archive(StateArchive& archive) {
  archive(thinned_histories_, transient_, companion_done_, error_bars_, errors_of_peaks_, errors_of_clearances_,
          about_companion_, companion_failure_, companion_run_, contact_runs_);
}

PeaksAndImpacts CaseRun::main_run() const {
  return {peaks_->peaks(), impacts_.impacts(), transient_.statistics(), clearances_.clearances(),
          transient_.collapsed()};
}

void CaseRun::run_companion() {
  const SolverStatistics& spent = transient_.statistics();
  const auto solves = static_cast<double>(std::max(spent.newton_iterations, spent.accepted_steps));
  if (options_.error_bars == ErrorBarMode::never) {
    about_companion_ = "No error bars: they were not wanted (CaseOptions::error_bars).";
  } else if (transient_.collapsed()) {
    about_companion_ = "No error bars: the model collapsed, and peaks of a fall depend on where it is stopped.";
  } else if (options_.error_bars == ErrorBarMode::automatic && !companion_is_cheap(transient_.model(), solves)) {
    about_companion_ =
        "No error bars by default for a run of this size (steps times elements). --check (in code "
        "CaseOptions::error_bars = ErrorBarMode::always) makes the second run that they need.";
  } else {
    const TransientOptions finer = companion_options(options_.transient, spent.longest_step);
    about_companion_ = companion_description(finer);
    try {
      compare_with(
          compute_peaks(transient_.model(), transient_.motion(), finer, {companion_observer_}, stop_, &companion_run_));
    } catch (const Error& error) {
      companion_failure_ = error.what();
      about_companion_ = "No error bars: the second run failed.";
    }
  }
}

// Keeps the errors alone: the peaks of a large model take much memory.
void CaseRun::compare_with(const PeaksAndImpacts& companion) {
  PeaksAndImpacts main = main_run();
  const double least_share = least_share_of_errors(transient_.model(), options_.transient);
  error_bars_ = estimate_errors(main.peaks, main.touches, companion, least_share,
                                scales_of_run(main.peaks, transient_.model(), transient_.motion(), options_.transient));
  estimate_clearance_errors(main, companion, least_share);
  for (const Peak& peak : main.peaks) errors_of_peaks_.push_back(peak.error);
  for (const GapClearance& clearance : main.clearances) errors_of_clearances_.push_back(clearance.error);
}

CaseResult CaseRun::result() const {
  return with_model(result_with(histories_->table(), peaks_->peaks()), transient_.model());
}

CaseResult take_result(std::optional<CaseRun>& run) {
  const Model& model = run->transient_.model();
  Table histories = run->histories_->take_table();
  std::vector<Peak> peaks = run->peaks_->peaks();
  // Nothing is recorded any more, and the rest of the result takes memory.
  run->histories_.reset();
  run->peaks_.reset();
  CaseResult result = run->result_with(std::move(histories), std::move(peaks));
  run.reset();
  return with_model(std::move(result), model);
}

CaseResult CaseRun::result_with(Table histories, std::vector<Peak> peaks) const {
  const GroundMotion& motion = transient_.motion();
  CaseResult result{.title = options_.title,
                    .provenance = provenance_of_library(),
                    .analysis = facts_of(options_),
                    .motion = facts_of(motion),
                    .buildings = {},
                    .periods = periods_,
                    .peaks = std::move(peaks),
                    .clearances = clearances_.clearances(),
                    .impacts = impacts_.impacts(),
                    .histories = std::move(histories),
                    .offered = offered_.list(),
                    .energy = energy_.at_end(),
                    .solver = transient_.statistics(),
                    .error_bars = {},
                    .warnings = transient_.warnings(),
                    .assumptions = transient_.assumptions()};
  if (!thinned_histories_.empty()) result.warnings.push_back(thinned_histories_);
  for (const auto& warnings : {motion_warnings(motion), model_warnings(transient_.model()),
                               collapse_warnings(result.peaks), period_warnings(transient_.model()),
                               strain_warnings(result.peaks), wall_warnings(transient_.model(), result.peaks),
                               plan_warnings(transient_.state(), result.peaks, result.impacts),
                               energy_warnings(result.energy, options_.warn_above_energy_error, options_.transient)})
    result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
  const std::vector<std::string>& notes = transient_.model().notes();
  result.assumptions.insert(result.assumptions.end(), notes.begin(), notes.end());
  for (const BearingCheckRecorder* checks : bearing_checks_)
    std::ranges::move(checks->rows(), std::back_inserter(result.bearing_checks));
  for (const FloorSpectra* each : floor_spectra_)
    std::ranges::move(each->spectra(), std::back_inserter(result.floor_spectra));
  result.torsion = torsion_of(transient_.model(), result.peaks);
  add_errors(result);
  double first_rocking = std::numeric_limits<double>::infinity();
  for (const WeightOnBearings& weight : transient_.state().weights())
    first_rocking = std::min(first_rocking, weight.first_rocking());
  for (Peak& peak : result.peaks)
    if (peak.time >= first_rocking) peak.side += peak.side.empty() ? "rocked" : ", rocked";
  // Behind the errors: the companion does not know the peaks that recorders offered.
  std::vector<Peak> ratios = drift_ratios(transient_.model(), result.peaks), of_recorders = offered_peaks_.peaks();
  result.peaks.reserve(result.peaks.size() + ratios.size() + of_recorders.size());
  for (std::vector<Peak>* more : {&ratios, &of_recorders}) std::ranges::move(*more, std::back_inserter(result.peaks));
  for (std::string& warning : offered_peaks_.warnings()) result.warnings.push_back(std::move(warning));
  std::ranges::move(assumptions_of(transient_.model()), std::back_inserter(result.assumptions));
  return result;
}

void CaseRun::add_errors(CaseResult& result) const {
  result.error_bars = error_bars_;
  for (std::size_t i = 0; i < errors_of_peaks_.size(); ++i) result.peaks[i].error = errors_of_peaks_[i];
  for (std::size_t i = 0; i < errors_of_clearances_.size(); ++i) result.clearances[i].error = errors_of_clearances_[i];
  result.error_bars.companion = about_companion_;
  result.contact_sensitivity = contact_sensitivity_;
  result.contact_sensitivity.unsettled = result.error_bars.unsettled;
  for (std::size_t i = 0; i < result.contact_sensitivity.peaks.size(); ++i)
    result.contact_sensitivity.peaks[i].error = result.peaks[i].error;
  if (result.error_bars.unsettled)
    result.warnings.push_back(unsettled_warning(result.error_bars, result.impacts.size(), options_.transient));
  if (!companion_failure_.empty())
    result.warnings.push_back("There are no error bars, because the second run with finer steps failed: " +
                              companion_failure_);
}

CaseResult run_case(const Model& model, const GroundMotion& motion, CaseOptions options) {
  std::optional<CaseRun> run;
  run.emplace(model, motion, std::move(options)).run();
  return take_result(run);
}

}  // namespace moat
