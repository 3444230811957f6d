#include "analyses/questions/answer_charts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/text/number_format.hpp"

namespace moat {
namespace {

/// Adds a curve with the band of its confidence.
void add_curve(Chart& chart, Series curve, const std::vector<Bounds>& bounds, double confidence) {
  Series band{.name = to_significant(100.0 * confidence, 3) + " % confidence",
              .x = curve.x,
              .y = {},
              .style = Series::Style::band,
              .colour = 0};
  for (const Bounds& each : bounds) band.y.push_back(each.high);
  for (std::size_t i = bounds.size(); i-- > 0;) {
    band.x.push_back(curve.x[i]);
    band.y.push_back(bounds[i].low);
  }
  chart.series = {std::move(band), std::move(curve)};
}

/// Adds a curve with its band over levels at equal distances.
void add_curve(Chart& chart, double last, const std::string& name, double confidence,
               const std::function<double(double)>& value, const std::function<Bounds(double)>& band) {
  constexpr int points = 100;
  Series curve{.name = name, .x = {}, .y = {}, .colour = 0};
  std::vector<Bounds> bounds;
  for (int i = 1; i <= points; ++i) {
    const double x = last * i / points;
    curve.x.push_back(x);
    curve.y.push_back(value(x));
    bounds.push_back(band(x));
  }
  add_curve(chart, std::move(curve), bounds, confidence);
}

/// The confidence of bands without a fit of the caller.
constexpr double confidence = 0.95;

/// Charts reach to the level that this share of the records does not exceed, and to all data.
constexpr double share_shown = 0.99;

}  // namespace

Chart fragility_chart(const LognormalFit& fit, const std::vector<EventCount>& counts, const std::string& title,
                      const std::string& level_label) {
  Chart chart{.title = title, .x_label = level_label, .y_label = "probability", .series = {}, .y_from_zero = true};
  Series counted{.name = "share of the records", .x = {}, .y = {}, .style = Series::Style::markers, .colour = 6};
  double last = fit.quantile(share_shown);
  for (const EventCount& count : counts) {
    if (count.trials == 0) continue;
    counted.x.push_back(count.level);
    counted.y.push_back(static_cast<double>(count.events) / count.trials);
    last = std::max(last, count.level);
  }
  const std::string name =
      "median " + to_significant(fit.median(), 3) + ", dispersion " + to_significant(fit.dispersion(), 3);
  add_curve(
      chart, last, name, fit.confidence(), [&](double x) { return fit.probability(x); },
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
  constexpr double cm = 0.01;
  double largest = std::max(demand.gap(1.0 - share_shown).si(), demand.gaps().back());
  if (!demand.beyond().empty()) largest = std::max(largest, demand.beyond().back());
  add_curve(
      chart, largest / cm, "lognormal", demand.fit().confidence(),
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

namespace {

bool has_result(const StudyResult& study, std::string_view quantity) {
  const std::vector<Column>& columns = study.table().columns;
  return std::any_of(columns.begin() + static_cast<std::ptrdiff_t>(study.axes().size()), columns.end(),
                     [&](const Column& column) { return column.quantity == quantity; });
}

void add(StudyAnswers& answers, const std::string& title, const std::function<Chart()>& chart) {
  try {
    answers.pictures.push_back({title, svg_text({chart()}, 1000, 420)});
  } catch (const InputError& error) {
    answers.sentences.push_back(title + ": there is no picture. " + error.what());
  }
}

void add_smallest_gaps(StudyAnswers& answers, const StudyResult& study) {
  add(answers, "Probability of pounding", [&] {
    const GapDemand demand{study};
    answers.sentences.push_back(demand.description());
    return pounding_chart(demand, "Probability of pounding");
  });
}

/// Whether the study has one axis of several numbers, this one, and others of names: cases at one number are a sample.
bool is_over_samples(const StudyResult& study, const StudyAxis& axis) {
  return axis.labels.empty() && axis.values.size() > 1 && study.axes().size() > 1 &&
         std::ranges::count_if(study.axes(), [](const StudyAxis& each) { return each.labels.empty(); }) == 1;
}

/// Whether all cases are one sample.
bool is_one_sample(const StudyResult& study) {
  return std::ranges::none_of(study.axes(), [](const StudyAxis& axis) { return axis.labels.empty(); });
}

Chart pounding_share_chart(const StudyResult& study, const StudyAxis& axis, const std::string& title) {
  Chart chart{.title = title,
              .x_label = axis.name + (axis.unit.empty() ? "" : " [" + axis.unit + "]"),
              .y_label = "share of cases with impacts",
              .series = {},
              .y_from_zero = true};
  Series share{.name = "share of cases", .x = {}, .y = {}, .colour = 0};
  std::vector<Bounds> bounds;
  for (const EventCount& count : event_counts(study, axis.name, pounds())) {
    if (count.trials == 0) continue;
    share.x.push_back(count.level);
    share.y.push_back(static_cast<double>(count.events) / count.trials);
    bounds.push_back(binomial_bounds(count.events, count.trials, confidence));
  }
  add_curve(chart, std::move(share), bounds, confidence);
  return chart;
}

void add_hunts(StudyAnswers& answers, const StudyResult& study) {
  const std::vector<IdaCurve> curves = ida_curves(study);
  add(answers, "Incremental dynamic analysis",
      [&] { return ida_chart(curves, "Incremental dynamic analysis", "level", "response"); });
  double limit = 0.0;
  for (const IdaCurve& curve : curves) limit = std::max(limit, curve.response_limit);
  add(answers, "Fragility", [&] {
    return fragility_chart(LognormalFit{capacities(curves, limit), confidence, "capacities"}, {}, "Fragility",
                           "level at which the response exceeds the limit of the hunt");
  });
}

}  // namespace

StudyAnswers answers_of(const StudyResult& study) {
  StudyAnswers answers;
  if (is_one_sample(study) && has_result(study, "smallest_gap")) add_smallest_gaps(answers, study);
  for (const StudyAxis& axis : study.axes())
    if (is_over_samples(study, axis) && has_result(study, "impacts")) {
      const std::string title = "Share of cases with impacts over " + axis.name;
      add(answers, title, [&] { return pounding_share_chart(study, axis, title); });
    }
  if (is_one_sample(study) && has_result(study, "ida_level")) add_hunts(answers, study);
  return answers;
}

}  // namespace moat
