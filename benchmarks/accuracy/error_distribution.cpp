#include "error_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace moat {
namespace {

double error_of(const TrialPeak* worst) { return worst == nullptr ? 0.0 : worst->error(); }

std::string text(const char* format, double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::string whole(double value) { return std::to_string(std::lround(value)); }

ErrorBarCheck check_error_bars(const std::vector<const TrialModel*>& models, std::size_t setting) {
  std::vector<double> widths;
  std::size_t peaks = 0, covered = 0;
  for (const TrialModel* model : models)
    for (const TrialPeak& peak : model->trials[setting].peaks) {
      if (!peak.counts || std::isnan(peak.error_bar)) continue;
      const double error = std::abs(peak.value - peak.reference);
      ++peaks;
      // The error of the reference itself does not count against a bar.
      covered += static_cast<std::size_t>(error <= peak.error_bar + peak.reference_change);
      if (error > peak.reference_change) widths.push_back(peak.error_bar / error);
    }
  if (peaks == 0) return {};
  std::sort(widths.begin(), widths.end());
  return {peaks, static_cast<double>(covered) / static_cast<double>(peaks), quantile(widths, 0.5)};
}

}  // namespace

std::string percent(double value) { return text("%.2g %%", 100.0 * value); }

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return NAN;
  const double place = std::ceil(share * static_cast<double>(sorted.size())) - 1.0;
  return sorted[static_cast<std::size_t>(std::max(place, 0.0))];
}

ErrorDistribution error_distribution(const std::vector<const TrialModel*>& models, std::size_t setting) {
  ErrorDistribution found;
  for (const TrialModel* model : models) {
    const Trial& trial = model->trials[setting];
    if (!trial.refused.empty()) {
      ++found.refused;
      continue;
    }
    const double error = error_of(trial.worst(PeaksToCompare::counting));
    found.errors.push_back(error);
    found.all_errors.push_back(error_of(trial.worst(PeaksToCompare::all)));
    found.steps.push_back(static_cast<double>(trial.steps));
    found.other_impacts += static_cast<int>(trial.impacts != model->reference.result.touches.size());
    found.large += static_cast<int>(error > large_error);
    found.large_and_warned += static_cast<int>(error > large_error && trial.warned);
  }
  found.bars = check_error_bars(models, setting);
  for (auto* values : {&found.errors, &found.all_errors, &found.steps}) std::sort(values->begin(), values->end());
  return found;
}

std::string table_of(const std::vector<TrialSetting>& settings, const std::vector<ErrorDistribution>& distributions) {
  std::string head = "| |", line = "|---|";
  for (const TrialSetting& setting : settings) {
    head += " " + setting.name + " |";
    line += "---|";
  }
  std::string table = head + "\n" + line + "\n";
  const auto row = [&](const std::string& label, const std::function<std::string(const ErrorDistribution&)>& value) {
    table += "| " + label + " |";
    for (const ErrorDistribution& each : distributions) table += " " + value(each) + " |";
    table += "\n";
  };
  using D = ErrorDistribution;
  row("models compared", [](const D& d) { return std::to_string(d.errors.size()); });
  row("refused or not finished", [](const D& d) { return std::to_string(d.refused); });
  row("error of the worst peak: median", [](const D& d) { return percent(quantile(d.errors, 0.5)); });
  row("90th percentile", [](const D& d) { return percent(quantile(d.errors, 0.9)); });
  row("99th percentile", [](const D& d) { return percent(quantile(d.errors, 0.99)); });
  row("largest", [](const D& d) { return percent(quantile(d.errors, 1.0)); });
  row("largest, the smallest peaks too", [](const D& d) { return percent(quantile(d.all_errors, 1.0)); });
  row("models with another number of impacts", [](const D& d) { return std::to_string(d.other_impacts); });
  row("models above " + percent(large_error), [](const D& d) { return std::to_string(d.large); });
  row("of these, with a warning", [](const D& d) { return std::to_string(d.large_and_warned); });
  row("peaks with an error bar", [](const D& d) { return std::to_string(d.bars.peaks); });
  row("true error within the bar", [](const D& d) { return text("%.1f %%", 100.0 * d.bars.coverage); });
  row("bar over true error: median", [](const D& d) { return text("%.1f", d.bars.width); });
  row("steps: median", [](const D& d) { return whole(quantile(d.steps, 0.5)); });
  row("90th percentile", [](const D& d) { return whole(quantile(d.steps, 0.9)); });
  return table;
}

}  // namespace moat
