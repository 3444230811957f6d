#include "output/charts/chart_description.hpp"

#include <algorithm>

#include "base/text/number_format.hpp"

namespace moat {
namespace {

constexpr int digits = 5;

std::string extent_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return "from " + to_significant(*low, digits) + " to " + to_significant(*high, digits);
}

}  // namespace

std::string titles_of(const std::vector<ChartPanel>& panels) {
  std::string titles;
  for (const ChartPanel& panel : panels) {
    if (panel.chart->title.empty()) continue;
    titles += (titles.empty() ? "" : "; ") + panel.chart->title;
  }
  return titles;
}

std::string description_of(const std::vector<ChartPanel>& panels) {
  std::string text;
  for (const ChartPanel& panel : panels) {
    const Chart& chart = *panel.chart;
    if (!text.empty()) text += ' ';
    if (!chart.title.empty()) text += chart.title + ": ";
    text += chart.y_label + " over " + chart.x_label;
    std::string separator = "; ";
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
      if (panel.curves[i].y.empty()) continue;
      text +=
          separator + (chart.series[i].name.empty() ? "" : chart.series[i].name + " ") + extent_of(panel.curves[i].y);
      separator = ", ";
    }
    text += '.';
  }
  return text;
}

}  // namespace moat
