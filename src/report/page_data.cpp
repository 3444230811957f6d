#include "report/page_data.hpp"

#include <cmath>
#include <span>

#include <nlohmann/json.hpp>

#include "base/text/number_format.hpp"
#include "output/charts/chart_panel.hpp"
#include "report/charts/chart_columns.hpp"
#include "report/charts/result_charts.hpp"

namespace moat::html {
namespace {

std::string text_of(const std::string& name) {
  return nlohmann::json(name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string array_of(std::span<const double> values, double factor, std::size_t stride) {
  constexpr int digits = 5;
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); i += stride) {
    if (i > 0) text += ',';
    const double value = factor * values[i];
    text += std::isfinite(value) ? to_significant(value, digits) : "null";
  }
  return text + "]";
}

std::string json_of(const Chart& chart) {
  std::string series;
  for (std::size_t i = 0; i < chart.series.size(); ++i)
    series += std::string{i > 0 ? "," : ""} + "{\"name\":" + text_of(chart.series[i].name) + ",\"colour\":\"" +
              std::string{paint_of(chart, i).colour} + "\",\"values\":" + array_of(chart.series[i].y, 1.0, 1) + "}";
  std::string second;
  if (chart.second_unit)
    second = ",\"second\":{\"symbol\":" + text_of(chart.second_unit->symbol) +
             ",\"factor\":" + to_significant(chart.second_unit->per_first, 12) + "}";
  return "{\"title\":" + text_of(chart.title) + ",\"label\":" + text_of(chart.y_label) + second + ",\"series\":[" +
         series + "]}";
}

template <class Items, class Json>
std::string list_of(const Items& items, const Json& json) {
  std::string text = "[";
  for (const auto& each : items) text += (text.size() > 1 ? "," : "") + json(each);
  return text + "]";
}

}  // namespace

std::string page_data(const CaseResult& result) {
  const std::size_t rows = result.histories.rows();
  if (rows < 2) return "";
  const std::vector<double>& times = result.histories.values("time");
  const std::size_t stride = (rows - 1) / most_rows_of_charts + 1;
  // A model without drawing needs no motions.
  const std::vector<NodeMotion> motions =
      result.scene.cells.empty() ? std::vector<NodeMotion>{} : motions_of_nodes(result);
  return "{\"start\":" + to_significant(times.front(), 12) +
         ",\"interval\":" + to_significant(static_cast<double>(stride) * (times[1] - times[0]), 12) +
         ",\"rows\":" + std::to_string((rows - 1) / stride + 1) + ",\"motions\":" +
         list_of(motions,
                 [&](const NodeMotion& motion) {
                   return motion.column == nullptr ? std::string{"null"}
                                                   : array_of(motion.column->values, motion.factor, stride);
                 }) +
         ",\"charts\":" + list_of(history_charts(result, stride), json_of) + ",\"impacts\":" +
         list_of(result.impacts,
                 [](const Impact& impact) {
                   return "{\"where\":" + text_of(impact.where) + ",\"start\":" + to_significant(impact.start, 9) +
                          ",\"end\":" + to_significant(impact.start + impact.duration, 9) + "}";
                 }) +
         "}";
}

}  // namespace moat::html
