#include "study/floor_spectra_of_records.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "base/text/text_file.hpp"
#include "report/charts/chart_columns.hpp"

namespace moat {
namespace {

// The parts of a place of "floor_sa": "roof, corner 2, x, 5 %, 0.3 s", on a line "roof, 5 %, 0.3 s".
struct SpectrumPlace {
  explicit SpectrumPlace(std::string where) {
    period = scan_number(last_of(where)).value;
    title = "Floor spectrum, " + where;
    damping = scan_number(last_of(where)).value / 100.0;
    if (where.ends_with(", x") || where.ends_with(", y")) direction = last_of(where);
    if (where.substr(std::min(where.rfind(", "), where.size())).starts_with(", corner ")) place = last_of(where);
    floor = where;
  }

  std::string title, floor, place = "centre", direction = "x";
  double damping = 0.0, period = 0.0;  // share of critical, s

 private:
  // Takes it off the text.
  static std::string last_of(std::string& where) {
    const std::size_t comma = where.rfind(", ");
    if (comma == std::string::npos) return std::exchange(where, "");
    std::string last = where.substr(comma + 2);
    where.resize(comma);
    return last;
  }
};

}  // namespace

std::vector<Chart> floor_spectra_over_records(const std::vector<RecordStatistics>& list) {
  const bool has_envelope = std::ranges::any_of(list, &RecordStatistics::envelope);
  std::vector<Chart> charts;
  for (const RecordStatistics& each : list) {
    if (each.quantity != "floor_sa" || each.envelope != has_envelope) continue;
    const SpectrumPlace at{each.where};
    if (charts.empty() || charts.back().title != at.title)
      charts.push_back({.title = at.title,
                        .x_label = "period of an oscillator [s]",
                        .y_label = axis_label("pseudo-acceleration", each.unit),
                        .series = {{.name = "largest", .colour = 4},
                                   {.name = "mean", .colour = 1},
                                   {.name = "84 %", .style = Series::Style::dashed, .colour = 1}},
                        .logarithmic_x = true,
                        .y_from_zero = true,
                        .second_unit = second_scale(each.unit)});
    const double values[] = {each.statistics.largest, each.statistics.mean, each.statistics.fractile_84};
    for (std::size_t i = 0; i < std::size(values); ++i) {
      if (!std::isfinite(values[i])) continue;
      charts.back().series[i].x.push_back(at.period);
      charts.back().series[i].y.push_back(values[i]);
    }
  }
  for (Chart& chart : charts) std::erase_if(chart.series, [](const Series& each) { return each.x.empty(); });
  std::erase_if(charts, [](const Chart& chart) { return chart.series.empty(); });
  return charts;
}

Table floor_spectra_table(const std::vector<RecordStatistics>& list) {
  Table table{{{"floor", "", "1", {}},
               {"place", "", "1", {}},
               {"direction", "", "1", {}},
               {"group", "", "1", {}},
               {"damping", "", "1", {}},
               {"period", "", "s", {}},
               {"mean", "", "m/s^2", {}},
               {"fractile_84", "", "m/s^2", {}},
               {"largest", "", "m/s^2", {}},
               {"design_value", "", "m/s^2", {}}}};
  for (const RecordStatistics& each : list) {
    if (each.quantity != "floor_sa") continue;
    const SpectrumPlace at{each.where};
    const std::string texts[] = {at.floor, at.place, at.direction, each.envelope ? "envelope" : each.group};
    const double numbers[] = {
        at.damping, at.period, each.statistics.mean, each.statistics.fractile_84, each.statistics.largest, each.design};
    for (std::size_t i = 0; i < std::size(texts); ++i) {
      table.columns[i].labels.push_back(texts[i]);
      table.columns[i].values.push_back(Statistics::unknown);
    }
    for (std::size_t i = 0; i < std::size(numbers); ++i)
      table.columns[std::size(texts) + i].values.push_back(numbers[i]);
  }
  return table;
}

}  // namespace moat
