#include <algorithm>
#include <cmath>

#include "output/files/engineering_unit.hpp"
#include "output/files/sensitivity_table.hpp"
#include "report/charts/result_charts.hpp"

namespace moat {
namespace {

// The larger of both distances from the nominal value; a run without results counts as none.
double reach(const TornadoBar& bar, double nominal) {
  return std::fmax(0.0, std::fmax(std::abs(bar.decreased - nominal), std::abs(bar.increased - nominal)));
}

Tornado chart_of(const ContactSensitivity& sensitivity, const ChangedPeak& peak) {
  const EngineeringUnit unit = engineering_unit(peak.unit);
  Tornado chart{.title = "If contact differs: " + name_of(peak),
                .value_label = in_words(peak.quantity) + " [" + with_raised_digits(unit.symbol) + "]",
                .nominal = unit.per_si * std::abs(peak.value),
                .error = unit.per_si * peak.error};
  const std::string* parameter = nullptr;
  for (std::size_t i = 0; i < sensitivity.changes.size(); ++i) {
    const ContactVariation& change = sensitivity.changes[i];
    // The two changes of a parameter stand side by side.
    if (parameter == nullptr || *parameter != change.parameter) chart.bars.emplace_back();
    parameter = &change.parameter;
    TornadoBar& bar = chart.bars.back();
    (change.increases() ? bar.increase : bar.decrease) = label_of(change);
    (change.increases() ? bar.increased : bar.decreased) = unit.per_si * std::abs(peak.changed[i]);
  }
  std::ranges::stable_sort(chart.bars, std::ranges::greater{},
                           [&](const TornadoBar& bar) { return reach(bar, chart.nominal); });
  return chart;
}

}  // namespace

std::vector<Tornado> sensitivity_charts(const ContactSensitivity& sensitivity) {
  std::vector<Tornado> charts;
  if (sensitivity.changes.empty()) return charts;
  for (const ChangedPeak& peak : largest_changed_peaks(sensitivity))
    if (std::isfinite(peak.value)) charts.push_back(chart_of(sensitivity, peak));
  return charts;
}

}  // namespace moat
