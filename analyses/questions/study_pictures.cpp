#include "analyses/questions/study_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include "analyses/questions/answer_charts.hpp"
#include "base/error.hpp"
#include "base/text/number_format.hpp"

namespace moat {
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
  constexpr double confidence = 0.95;
  Chart chart{.title = title,
              .x_label = axis.name + (axis.unit.empty() ? "" : " [" + axis.unit + "]"),
              .y_label = "share of cases with impacts",
              .series = {},
              .y_from_zero = true};
  Series band{.name = to_significant(100.0 * confidence, 3) + " % confidence",
              .x = {},
              .y = {},
              .style = Series::Style::band,
              .colour = 0};
  Series share{.name = "share of cases", .x = {}, .y = {}, .colour = 0};
  std::vector<double> low;
  for (const EventCount& count : event_counts(study, axis.name, pounds())) {
    if (count.trials == 0) continue;
    const Bounds bounds = binomial_bounds(count.events, count.trials, confidence);
    for (Series* series : {&band, &share}) series->x.push_back(count.level);
    share.y.push_back(static_cast<double>(count.events) / count.trials);
    band.y.push_back(bounds.high);
    low.push_back(bounds.low);
  }
  for (std::size_t i = low.size(); i-- > 0;) {
    band.x.push_back(share.x[i]);
    band.y.push_back(low[i]);
  }
  chart.series = {std::move(band), std::move(share)};
  return chart;
}

void add_hunts(StudyAnswers& answers, const StudyResult& study) {
  const std::vector<IdaCurve> curves = ida_curves(study);
  add(answers, "Incremental dynamic analysis",
      [&] { return ida_chart(curves, "Incremental dynamic analysis", "level", "response"); });
  double limit = 0.0;
  for (const IdaCurve& curve : curves) limit = std::max(limit, curve.response_limit);
  add(answers, "Fragility", [&] {
    return fragility_chart(LognormalFit{capacities(curves, limit), 0.95, "capacities"}, {}, "Fragility",
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
