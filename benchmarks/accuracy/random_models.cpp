#include "random_models.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <thread>

#include "base/check.hpp"
#include "base/error.hpp"
#include "error_distribution.hpp"
#include "random_trial.hpp"

namespace moat {
namespace {

/// Largest relative change of the reference's peaks with half the steps for which a model is compared.
constexpr double settled_reference = 1e-5;

std::vector<TrialSetting> trial_settings(double tolerance) {
  const TransientOptions newmark{.tolerance = tolerance},
      exact{.integrator = ExactBetweenEvents{}, .tolerance = tolerance};
  const bool by_default = tolerance == TransientOptions{}.tolerance;
  const std::string given = "tolerance " + to_text(tolerance);
  const std::string newmark_name = by_default ? "default" : given,
                    exact_name = by_default ? "exact" : "exact, " + given;
  return {{newmark_name, newmark}, {"tight", {.tolerance = 1e-7, .steps_per_contact = 512}}, {exact_name, exact}};
}

bool usable(const TrialModel& model) { return model.failed.empty() && model.reference.settled(settled_reference); }

std::vector<TrialModel> run_all(const RandomModelsOptions& options, const std::vector<TrialSetting>& settings) {
  std::vector<TrialModel> models(static_cast<std::size_t>(options.models));
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < models.size(); i = next++) models[i] = run_trials(options.seed + i, settings);
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < options.threads; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return models;
}

std::string scientific(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0e", value);
  return text;
}

/// "; name: seed, seed", or nothing where no model is meant.
template <class Meant>
std::string seeds_of(const std::string& name, const std::vector<TrialModel>& models, const Meant& meant) {
  std::string seeds;
  for (const TrialModel& model : models)
    if (meant(model)) seeds += (seeds.empty() ? "" : ", ") + std::to_string(model.seed);
  return seeds.empty() ? "" : name + ": seeds " + seeds + ". ";
}

/// The models, and the accuracy of the reference.
std::string facts_of(const std::vector<TrialModel>& models, const std::vector<TrialSetting>& settings) {
  std::vector<double> touches, changes;
  for (const TrialModel& model : models) {
    if (!model.failed.empty()) continue;
    touches.push_back(static_cast<double>(model.reference.result.touches.size()));
    changes.push_back(model.reference.largest_change);
  }
  std::sort(touches.begin(), touches.end());
  std::sort(changes.begin(), changes.end());
  const auto pounding = touches.end() - std::upper_bound(touches.begin(), touches.end(), 0.0);
  const auto impacts = [&](double share) { return std::to_string(static_cast<long>(quantile(touches, share))); };
  std::string text = std::to_string(models.size()) + " models from seed " +
                     (models.empty() ? "" : std::to_string(models.front().seed)) + "; " + std::to_string(pounding) +
                     " pound, with " + impacts(0.5) + " impacts in the median, " + impacts(0.9) +
                     " in the 90th percentile and at most " + impacts(1.0) +
                     ". With half the length of steps the worst peak of the reference changes by " +
                     scientific(quantile(changes, 0.5)) + " (median), " + scientific(quantile(changes, 0.99)) +
                     " (99th percentile), " + scientific(quantile(changes, 1.0)) + " (largest). " +
                     std::to_string(std::count_if(models.begin(), models.end(), usable)) +
                     " models are compared, those whose reference settles to " + scientific(settled_reference) +
                     " with the same impacts. ";
  text += seeds_of("Not settled", models, [](const TrialModel& m) { return m.failed.empty() && !usable(m); });
  text += seeds_of("Reference stopped", models, [](const TrialModel& m) { return !m.failed.empty(); });
  for (std::size_t s = 0; s < settings.size(); ++s)
    text += seeds_of("Refused with " + settings[s].name + " settings", models,
                     [&](const TrialModel& m) { return m.failed.empty() && !m.trials[s].refused.empty(); });
  text.back() = '\n';
  return text;
}

/// For a cell: text in quotation marks.
std::string quoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  return '"' + text + '"';
}

void write_csv(const std::string& path, const std::vector<TrialModel>& models,
               const std::vector<TrialSetting>& settings) {
  std::ofstream file{path};
  file << "seed,setting,worst_error,worst_peak,worst_error_of_all,worst_of_all,impacts,reference_impacts,"
          "reference_change,compared,steps,warned,cpu_s,message\n";
  for (const TrialModel& model : models) {
    const testing::CheckedReference& reference = model.reference;
    if (!model.failed.empty()) file << model.seed << ",reference,,,,,,,,no,,,," << quoted(model.failed) << '\n';
    for (std::size_t s = 0; s < model.trials.size(); ++s) {
      const Trial& trial = model.trials[s];
      file << model.seed << ',' << settings[s].name << ',';
      for (const PeaksToCompare peaks : {PeaksToCompare::counting, PeaksToCompare::all})
        if (const TrialPeak* worst = trial.worst(peaks); worst != nullptr)
          file << worst->error() << ',' << quoted(worst->name) << ',';
        else
          file << ",,";
      file << trial.impacts << ',' << reference.result.touches.size() << ',' << reference.largest_change << ','
           << (usable(model) ? "yes" : "no") << ',' << trial.steps << ',' << (trial.warned ? "yes" : "no") << ','
           << trial.cpu_seconds << ',' << quoted(trial.refused) << '\n';
    }
  }
  if (!file.flush()) throw FileError{path + ": cannot be written."};
}

}  // namespace

std::string run_random_models(const RandomModelsOptions& options) {
  const std::vector<TrialSetting> settings = trial_settings(options.tolerance);
  const std::vector<TrialModel> models = run_all(options, settings);
  if (!options.csv.empty()) write_csv(options.csv, models, settings);
  std::vector<const TrialModel*> compared;
  for (const TrialModel& model : models)
    if (usable(model)) compared.push_back(&model);
  std::vector<ErrorDistribution> distributions;
  for (std::size_t s = 0; s < settings.size(); ++s) distributions.push_back(error_distribution(compared, s));
  return facts_of(models, settings) + "\n" + table_of(settings, distributions);
}

}  // namespace moat
