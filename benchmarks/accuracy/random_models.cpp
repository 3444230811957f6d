#include "random_models.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <thread>

#include "base/error.hpp"
#include "random_trial.hpp"

namespace moat {
namespace {

/// What a reference may have left of error, relative, for its model to be compared.
constexpr double settled_reference = 1e-5;
/// What a run should not miss without a warning.
constexpr double large_error = 5e-3;

std::vector<TrialSetting> settings() {
  return {{"default", {}, testing::LocateYield::as_drawn},
          {"tight", {.tolerance = 1e-7, .steps_per_contact = 512}, testing::LocateYield::as_drawn},
          {"exact", {.integrator = Integrator::exact_between_events}, testing::LocateYield::always}};
}

std::vector<TrialModel> run_all(const RandomModelsOptions& options, const std::vector<TrialSetting>& list) {
  std::vector<TrialModel> models(static_cast<std::size_t>(options.models));
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < models.size(); i = next++) models[i] = run_trials(options.seed + i, list);
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < options.threads; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return models;
}

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

/// The value below which a share of the sorted values lies.
double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return NAN;
  const double place = std::ceil(share * static_cast<double>(sorted.size())) - 1.0;
  return sorted[static_cast<std::size_t>(std::max(place, 0.0))];
}

using Value = std::function<double(const TrialModel&, const Trial&)>;

std::vector<double> sorted_values(const std::vector<const TrialModel*>& models, std::size_t setting,
                                  const Value& value) {
  std::vector<double> values;
  for (const TrialModel* model : models)
    if (const Trial& trial = model->trials[setting]; trial.refused.empty()) values.push_back(value(*model, trial));
  std::sort(values.begin(), values.end());
  return values;
}

double worst_error(const Trial& trial, bool counting_only) {
  const TrialPeak* worst = trial.worst(counting_only);
  return worst == nullptr ? 0.0 : worst->error();
}

std::string table_of(const std::vector<const TrialModel*>& models, const std::vector<TrialSetting>& list) {
  std::string table =
      "| settings | models | median, % | 90th, % | 99th, % | largest, % | all peaks: median, 90th, largest, % | other "
      "count of impacts | above 0.5 % | of these warned | median steps "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t s = 0; s < list.size(); ++s) {
    const auto errors =
        sorted_values(models, s, [](const TrialModel&, const Trial& t) { return worst_error(t, true); });
    const auto any = sorted_values(models, s, [](const TrialModel&, const Trial& t) { return worst_error(t, false); });
    const auto steps =
        sorted_values(models, s, [](const TrialModel&, const Trial& t) { return static_cast<double>(t.steps); });
    int other = 0, large = 0, warned = 0;
    for (const TrialModel* model : models) {
      const Trial& trial = model->trials[s];
      if (!trial.refused.empty()) continue;
      other += static_cast<int>(trial.impacts != model->reference.result.touches.size());
      if (worst_error(trial, true) <= large_error) continue;
      ++large;
      warned += static_cast<int>(trial.warned);
    }
    const auto percent = [](double error) { return text("%.4f", 100.0 * error); };
    table += "| " + list[s].name + " | " + std::to_string(errors.size()) + " | " + percent(quantile(errors, 0.5)) +
             " | " + percent(quantile(errors, 0.9)) + " | " + percent(quantile(errors, 0.99)) + " | " +
             percent(quantile(errors, 1.0)) + " | " + percent(quantile(any, 0.5)) + ", " + percent(quantile(any, 0.9)) +
             ", " + percent(quantile(any, 1.0)) + " | " + std::to_string(other) + " | " + std::to_string(large) +
             " | " + std::to_string(warned) + " | " + text("%.0f", quantile(steps, 0.5)) + " |\n";
  }
  return table;
}

/// What the models were, and how good the reference is.
std::string facts_of(const std::vector<TrialModel>& models, const std::vector<const TrialModel*>& compared,
                     std::size_t exact) {
  int refused = 0, other_touches = 0, pounding = 0;
  std::vector<double> touches, changes;
  double reference_seconds = 0.0;
  for (const TrialModel& model : models) {
    refused += static_cast<int>(!model.trials[exact].refused.empty());
    other_touches += static_cast<int>(!model.reference.same_touches);
    pounding += static_cast<int>(!model.reference.result.touches.empty());
    touches.push_back(static_cast<double>(model.reference.result.touches.size()));
    changes.push_back(model.reference.largest_change);
    reference_seconds += model.reference_cpu_seconds;
  }
  std::sort(touches.begin(), touches.end());
  std::sort(changes.begin(), changes.end());
  return std::to_string(models.size()) + " models, " + std::to_string(pounding) + " of them pound, median " +
         text("%.0f", quantile(touches, 0.5)) + " and at most " + text("%.0f", quantile(touches, 1.0)) +
         " impacts. With steps twice as long the reference's peaks change by " + text("%.1e", quantile(changes, 0.5)) +
         " (median), " + text("%.1e", quantile(changes, 0.99)) + " (99th percentile), " +
         text("%.1e", quantile(changes, 1.0)) + " (largest), and its impacts in " + std::to_string(other_touches) +
         " models; " + std::to_string(models.size() - compared.size()) + " models whose reference did not settle to " +
         text("%.0e", settled_reference) + " are left out of the comparison. Exact steps refused " +
         std::to_string(refused) + ".\n\nThe reference took " + text("%.0f", reference_seconds) + " s of CPU time.\n";
}

void write_csv(const std::string& path, const std::vector<TrialModel>& models, const std::vector<TrialSetting>& list) {
  std::ofstream file{path};
  file << "seed,setting,worst_error,worst_peak,worst_error_any_peak,worst_any_peak,impacts,reference_impacts,"
          "reference_change,reference_settled,steps,warned,cpu_s,refused\n";
  for (const TrialModel& model : models)
    for (std::size_t s = 0; s < list.size(); ++s) {
      const Trial& trial = model.trials[s];
      const TrialPeak *worst = trial.worst(true), *any = trial.worst(false);
      file << model.seed << ',' << list[s].name << ',' << (worst ? worst->error() : 0.0) << ','
           << (worst ? worst->name : "") << ',' << (any ? any->error() : 0.0) << ',' << (any ? any->name : "") << ','
           << trial.impacts << ',' << model.reference.result.touches.size() << ',' << model.reference.largest_change
           << ',' << (model.reference.settled(settled_reference) ? "yes" : "no") << ',' << trial.steps << ','
           << (trial.warned ? "yes" : "no") << ',' << trial.cpu_seconds << ",\"" << trial.refused << "\"\n";
    }
  if (!file.flush()) throw FileError{path + ": cannot be written."};
}

}  // namespace

std::string run_random_models(const RandomModelsOptions& options) {
  const std::vector<TrialSetting> list = settings();
  const std::vector<TrialModel> models = run_all(options, list);
  if (!options.csv.empty()) write_csv(options.csv, models, list);
  std::vector<const TrialModel*> compared;
  for (const TrialModel& model : models)
    if (model.reference.settled(settled_reference)) compared.push_back(&model);
  return facts_of(models, compared, list.size() - 1) + "\n" + table_of(compared, list);
}

}  // namespace moat
