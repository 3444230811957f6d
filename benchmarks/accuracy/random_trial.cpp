#include "random_trial.hpp"

#include <cmath>
#include <map>

#include "analyses/case/case_run.hpp"
#include "base/error.hpp"
#include "measuring/measure.hpp"
#include "random_model.hpp"

namespace moat {

using performance::seconds;

double TrialPeak::error() const { return reference == 0.0 ? std::abs(value) : std::abs(value - reference) / reference; }

const TrialPeak* Trial::worst(PeaksToCompare of) const {
  const TrialPeak* worst = nullptr;
  for (const TrialPeak& peak : peaks) {
    if (of == PeaksToCompare::counting && !peak.counts) continue;
    if (worst == nullptr || peak.error() > worst->error()) worst = &peak;
  }
  return worst;
}

Trial run_trial(const testing::PlainModel& plain, const testing::CheckedReference& checked,
                const TrialSetting& setting) {
  const testing::ReferenceResult& reference = checked.result;
  Trial trial;
  const double started = seconds();
  try {
    Model model = testing::moat_model(plain);
    TransientOptions options = setting.options;
    options.end = plain.end * units::s;
    const CaseResult result =
        run_case(model, testing::moat_motion(plain.motion), {.transient = options, .error_bars = ErrorBarMode::always});
    trial.impacts = result.impacts.size();
    trial.steps = result.solver.accepted_steps;
    trial.warned = !result.warnings.empty();
    std::map<std::string, const Peak*> found;
    for (const Peak& peak : result.peaks) found[peak.quantity + " " + peak.where] = &peak;
    const std::vector<bool> counts = testing::counting_peaks(reference.peaks);
    for (std::size_t i = 0; i < reference.peaks.size(); ++i) {
      const testing::ReferencePeak& peak = reference.peaks[i];
      const std::string name = peak.quantity + " " + peak.where;
      const Peak& of_moat = *found.at(name);
      trial.peaks.push_back(
          {name, of_moat.magnitude(), peak.value, checked.peak_changes[i] * peak.value, counts[i], of_moat.error});
    }
  } catch (const Error& error) {
    trial.refused = error.what();
  }
  trial.cpu_seconds = seconds() - started;
  return trial;
}

TrialModel run_trials(std::uint64_t seed, const std::vector<TrialSetting>& settings) {
  TrialModel model;
  model.seed = seed;
  testing::PlainModel plain;
  try {
    plain = testing::random_model(seed);
    model.reference = testing::checked_reference(plain);
  } catch (const std::runtime_error& error) {
    model.failed = error.what();
    return model;
  }
  for (const TrialSetting& setting : settings) model.trials.push_back(run_trial(plain, model.reference, setting));
  return model;
}

}  // namespace moat
