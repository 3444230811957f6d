#include "analyses/questions/answer_charts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/text/number_format.hpp"

namespace moat {
namespace {

constexpr int points = 80;

/// A curve with its band over levels at equal distances.
template <class Value, class Band>
void add_curve(Chart& chart, double first, double last, const std::string& name, double confidence, Value value,
               Band band) {
  Series curve{.name = name, .x = {}, .y = {}, .colour = 0};
  Series area{.name = to_significant(100.0 * confidence, 3) + " % confidence",
              .x = {},
              .y = {},
              .style = Series::Style::band,
              .colour = 0};
  std::vector<double> low;
  for (int i = 0; i <= points; ++i) {
    const double x = first + (last - first) * i / points;
    const Bounds bounds = band(x);
    curve.x.push_back(x);
    curve.y.push_back(value(x));
    area.x.push_back(x);
    area.y.push_back(bounds.high);
    low.push_back(bounds.low);
  }
  for (std::size_t i = low.size(); i-- > 0;) {
    area.x.push_back(curve.x[i]);
    area.y.push_back(low[i]);
  }
  chart.series.push_back(std::move(area));
  chart.series.push_back(std::move(curve));
}

}  // namespace

Chart fragility_chart(const LognormalFit& fit, const std::vector<EventCount>& counts, const std::string& title,
                      const std::string& level_label) {
  Chart chart{.title = title, .x_label = level_label, .y_label = "probability", .series = {}, .y_from_zero = true};
  Series counted{.name = "share of the records", .x = {}, .y = {}, .style = Series::Style::markers, .colour = 6};
  double last = fit.quantile(0.99);
  for (const EventCount& count : counts) {
    if (count.trials == 0) continue;
    counted.x.push_back(count.level);
    counted.y.push_back(static_cast<double>(count.events) / count.trials);
    last = std::max(last, count.level);
  }
  constexpr double first_share = 0.01;
  const std::string name =
      "median " + to_significant(fit.median(), 3) + ", dispersion " + to_significant(fit.dispersion(), 3);
  add_curve(
      chart, first_share * last, last, name, fit.confidence(), [&](double x) { return fit.probability(x); },
      [&](double x) { return fit.probability_bounds(x); });
  if (!counted.x.empty()) chart.series.push_back(std::move(counted));
  return chart;
}

Chart ida_chart(const std::vector<IdaCurve>& curves, const std::string& title, const std::string& level_label,
                const std::string& response_label, double per_unit) {
  Chart chart{.title = title, .x_label = level_label, .y_label = response_label, .series = {}};
  for (const IdaCurve& curve : curves) {
    Series series{.name = "", .x = {}, .y = {}, .colour = 4};
    for (std::size_t i = 0; i < curve.levels.size(); ++i) {
      if (!std::isfinite(curve.responses[i])) continue;
      series.x.push_back(curve.levels[i]);
      series.y.push_back(curve.responses[i] / per_unit);
    }
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  Series low{.name = "16 %", .x = {}, .y = {}, .style = Series::Style::dashed, .colour = 1};
  Series median{.name = "median of " + std::to_string(curves.size()) + " records", .x = {}, .y = {}, .colour = 1};
  Series high{.name = "84 %", .x = {}, .y = {}, .style = Series::Style::dashed, .colour = 1};
  // Fractiles of few curves jump where a curve ends.
  for (const IdaFractiles& each : ida_fractiles(curves)) {
    if (2 * each.records < curves.size()) continue;
    for (const auto& [series, value] : {std::pair{&low, each.low}, {&median, each.median}, {&high, each.high}}) {
      if (!std::isfinite(value)) continue;
      series->x.push_back(each.level);
      series->y.push_back(value / per_unit);
    }
  }
  for (Series* series : {&low, &median, &high})
    if (!series->x.empty()) chart.series.push_back(std::move(*series));
  return chart;
}

Chart pounding_chart(const GapDemand& demand, const std::string& title) {
  Chart chart{
      .title = title, .x_label = "gap [cm]", .y_label = "probability of pounding", .series = {}, .y_from_zero = true};
  constexpr double cm = 0.01, share_at_the_end = 0.02, margin = 1.05;
  double largest = std::max(demand.gap(share_at_the_end).si(), demand.gaps().back());
  if (!demand.beyond().empty()) largest = std::max(largest, demand.beyond().back());
  const double last = margin * largest / cm;
  add_curve(
      chart, 0.01 * last, last, "lognormal", demand.fit().confidence(),
      [&](double x) { return demand.probability(Length{cm * x}); },
      [&](double x) { return demand.probability_bounds(Length{cm * x}); });
  std::string name = "share of " + std::to_string(demand.records()) + " records";
  if (!demand.beyond().empty())
    name += ", " + std::to_string(demand.beyond().size()) + " need more than " +
            to_significant(demand.beyond().front() / cm, 4) + " cm";
  Series counted{.name = name, .x = {}, .y = {}, .style = Series::Style::markers, .colour = 6};
  const std::vector<double>& gaps = demand.gaps();
  const double known_up_to =
      demand.beyond().empty() ? std::numeric_limits<double>::infinity() : demand.beyond().front();
  for (std::size_t i = 0; i < gaps.size() && gaps[i] <= known_up_to; ++i) {
    counted.x.push_back(gaps[i] / cm);
    counted.y.push_back(static_cast<double>(demand.records() - 1 - i) / static_cast<double>(demand.records()));
  }
  chart.series.push_back(std::move(counted));
  return chart;
}

}  // namespace moat
