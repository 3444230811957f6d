#include "analyses/questions/study.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "analyses/case/available_memory.hpp"
#include "analyses/case/case_warnings.hpp"
#include "analyses/case/error_bars.hpp"
#include "base/check.hpp"
#include "base/error.hpp"
#include "motions/motion_files.hpp"
#include "output/peaks/drift_ratios.hpp"
#include "output/recorders/energy_columns.hpp"
#include "output/recorders/energy_ledger.hpp"
#include "output/recorders/isolator_forces.hpp"

namespace moat {
namespace {

std::size_t threads_of(const StudyOptions& options) {
  Check{"StudyOptions", ""}.that(options.threads >= 0, "threads", options.threads, "1", ">= 0",
                                 "0 takes one thread per core.");
  if (options.threads > 0) return static_cast<std::size_t>(options.threads);
  if (options.ranks != nullptr) return 1;
  return std::max(1u, std::thread::hardware_concurrency());
}

// The cases of the part that are not computed yet.
std::vector<std::size_t> open_numbers(const StudyResult& result, const StudyOptions& options) {
  const std::size_t count = result.cases().count();
  std::size_t first = 0, last = count;
  if (options.part) {
    std::tie(first, last) = *options.part;
    Check{"StudyOptions", ""}.that(first < last && last <= count,
                                   "part = " + std::to_string(first) + ":" + std::to_string(last) + " is not allowed.",
                                   "The cases are 0:" + std::to_string(count) + "; the last is not included.");
  }
  std::vector<std::size_t> numbers;
  for (std::size_t number = first; number < last; ++number)
    if (result.state(number) == CaseState::open) numbers.push_back(number);
  return numbers;
}

/// Counts the cases for StudyOptions::progress.
class Progress {
 public:
  Progress(const StudyResult& result, std::size_t open) {
    for (std::size_t number = 0; number < result.cases().count(); ++number)
      if (result.state(number) != CaseState::open) add(result.outcome(number));
    now_.all = now_.done + open;
  }
  const StudyProgress& finished(const CaseOutcome& outcome) {
    add(outcome);
    ++now_.computed;
    now_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return now_;
  }

 private:
  void add(const CaseOutcome& outcome) {
    ++now_.done;
    if (outcome.state != CaseState::done) ++now_.failed;
    for (const NamedNumber& result : outcome.results)
      if (result.quantity == "impacts" && result.where.empty() && !std::isnan(result.value))
        now_.impacts += result.value;
  }

  StudyProgress now_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// All results of a study are in memory, also those that its file had. A case with 50 results needs less, as a test
// holds.
void require_memory(const StudyCases& cases) {
  constexpr double bytes_per_case = 1e3;
  const double needed = bytes_per_case * static_cast<double>(cases.count()), available = available_memory();
  Check{"Study", ""}.that(needed <= available,
                          std::to_string(cases.count()) + " cases need about " + memory_text(needed) + ", and " +
                              memory_text(available) + " of memory are available.",
                          "Give the axes fewer values, or make several studies of them.");
}

StudyResult compute_outcomes(const StudyCases& cases, const ComputeCase& compute, const StudyOptions& options) {
  std::vector<ComputeCase> workers(threads_of(options),
                                   [&](const StudyCase& each) { return outcome_of(each, compute); });
  if (options.ranks != nullptr) {
    if (options.ranks->rank() > 0) return compute_for_first_rank(*options.ranks, cases, compute);
    for (int rank = 1; rank < options.ranks->count(); ++rank) workers.push_back(computed_on(*options.ranks, rank));
  }
  require_memory(cases);
  StudyResult result = options.store != nullptr ? options.store->result() : StudyResult{cases};
  const std::vector<std::size_t> numbers = open_numbers(result, options);
  Progress progress{result, numbers.size()};
  const auto finished = [&](std::size_t number, CaseOutcome&& outcome) {
    if (options.store != nullptr) options.store->write(number, outcome);
    const StudyProgress& now = progress.finished(outcome);
    result.set(number, std::move(outcome));
    if (options.progress) options.progress(now);
  };
  compute_cases(cases, numbers, workers, finished, options.stop);
  if (options.ranks != nullptr) end_work(*options.ranks, result);
  return result;
}

StudyResult compute_study(const StudyCases& cases, const ComputeCase& compute, const StudyOptions& options) {
  StudyResult result = compute_outcomes(cases, compute, options);
  if (!open_numbers(result, options).empty()) throw StudyStopped{std::move(result)};
  if (!options.keep_failures && !failures_of(result).empty()) throw StudyError{std::move(result)};
  return result;
}

void add_energies(CaseOutcome& outcome, const EnergyBalance& energy) {
  for (const EnergyColumn& column : energy_columns(energy.in_plan, energy.weights_change))
    outcome.results.push_back({"energy_" + std::string{column.name}, "", "J", energy.*column.value});
  outcome.energy_error = energy.error_share();
}

void add_floor_spectra(StudyRecord& record, const std::vector<FloorSpectrum>& spectra) {
  for (const FloorSpectrum& floor : spectra)
    for (std::size_t i = 0; i < floor.spectrum.period.size(); ++i) {
      const std::string where = floor.where() + ", " + to_text(floor.spectrum.period[i]) + " s";
      record.push_back({"floor_sa", where, "m/s^2", floor.spectrum.pseudo_acceleration[i]});
      if (!floor.spectrum.absolute_acceleration.empty())
        record.push_back({"floor_sa_absolute", where, "m/s^2", floor.spectrum.absolute_acceleration[i]});
    }
}

CaseOutcome outcome_of_model(const Model& model, const GroundMotion& motion, const StudyOptions& options) {
  std::optional<EnergyLedger> energy;
  if (options.energies) energy.emplace();
  std::optional<FloorSpectra> floors;
  if (options.floor_spectra) floors.emplace(*options.floor_spectra);
  // The total base shear has the forces of dampers and impacts, too.
  IsolatorForces isolators{model};
  PeaksAndImpacts main = compute_peaks(model, motion, options.transient,
                                       {energy ? &*energy : nullptr, floors ? &*floors : nullptr, &isolators});
  double unsettled = std::numeric_limits<double>::quiet_NaN();
  // Peaks of a fall depend on where it is stopped.
  if (options.error_bars && !main.collapsed) {
    try {
      const PeaksAndImpacts companion =
          compute_peaks(model, motion, companion_options(options.transient, main.solver.longest_step));
      const double least_share = least_share_of_errors(model, options.transient);
      const ScalesOfUnits scales = scales_of_run(main.peaks, model, motion, options.transient);
      unsettled = estimate_errors(main.peaks, main.touches, companion, least_share, scales).unsettled ? 1.0 : 0.0;
      estimate_clearance_errors(main, companion, least_share);
    } catch (const Error&) {
      // The case itself is computed; its errors stay unknown.
    }
  }
  std::ranges::move(drift_ratios(model, main.peaks), std::back_inserter(main.peaks));
  CaseOutcome outcome{.state = CaseState::done, .files = files_of(motion), .steps = main.solver.accepted_steps};
  StudyRecord& record = outcome.results;
  for (const Peak& peak : main.peaks) {
    record.push_back({peak.quantity, peak.where, peak.unit, peak.magnitude()});
    if (options.error_bars) record.push_back({peak.quantity + "_error", peak.where, peak.unit, peak.error});
  }
  for (const Peak& peak : isolators.peaks()) record.push_back({peak.quantity, peak.where, peak.unit, peak.magnitude()});
  for (const GapClearance& gap : main.clearances) {
    record.push_back({"clearance_left", gap.where, "m", gap.left});
    if (options.error_bars) record.push_back({"clearance_left_error", gap.where, "m", gap.error});
  }
  record.push_back({"impacts", "", "1", static_cast<double>(main.touches.size())});
  const bool collapsed = main.collapsed || !collapse_warnings(main.peaks).empty();
  record.push_back({"collapsed", "", "1", collapsed ? 1.0 : 0.0});
  if (options.error_bars) record.push_back({"unsettled", "", "1", unsettled});
  if (energy) add_energies(outcome, energy->at_end());
  if (floors) add_floor_spectra(record, floors->spectra());
  return outcome;
}

}  // namespace

StudyAxis record_axis(std::string name, const std::vector<GroundMotion>& motions) {
  std::vector<std::string> names;
  for (const GroundMotion& motion : motions) names.push_back(motion.name());
  StudyAxis axis = StudyAxis::of_names(std::move(name), std::move(names));
  for (const GroundMotion& motion : motions) axis.hashes.push_back(hash_of(motion));
  return axis;
}

StudyAxis record_axis(std::string name, const std::vector<PlanMotion>& pairs) {
  std::vector<std::string> names;
  for (const PlanMotion& pair : pairs) names.push_back(pair.first.name() + " + " + pair.second.name());
  StudyAxis axis = StudyAxis::of_names(std::move(name), std::move(names));
  for (const PlanMotion& pair : pairs) axis.hashes.push_back(hash_of(pair.resolved()));
  return axis;
}

ContactChange contact_change(const StudyCase& each) {
  ContactChange change;
  for (const auto& [name, value] : std::initializer_list<std::pair<std::string_view, double&>>{
           {"contact_stiffness_factor", change.stiffness_factor},
           {"restitution_change", change.restitution_change},
           {"clearance_factor", change.clearance_factor},
           {"soil_factor", change.soil_factor}})
    if (std::ranges::find(each.cases().axes(), name, &StudyAxis::name) != each.cases().axes().end())
      value = each.value(name);
  return change;
}

StudyResult run_study(const StudyCases& cases, const std::function<StudyRecord(const StudyCase&)>& compute,
                      const StudyOptions& options) {
  const auto outcome = [&](const StudyCase& each) {
    return CaseOutcome{.state = CaseState::done, .results = compute(each)};
  };
  return compute_study(cases, outcome, options);
}

StudyResult run_study(const StudyCases& cases, const std::function<StudyModel(const StudyCase&)>& make,
                      const StudyOptions& options) {
  const auto outcome = [&](const StudyCase& each) {
    StudyModel study = make(each);
    return outcome_of_model(study.model, study.motion, options);
  };
  return compute_study(cases, outcome, options);
}

StudyRecord peaks_of(const Model& model, const GroundMotion& motion, const TransientOptions& options, bool error_bars) {
  return outcome_of_model(model, motion, {.transient = options, .error_bars = error_bars}).results;
}

}  // namespace moat
