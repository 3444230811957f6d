#include "analyses/questions/fragility.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/text/number_format.hpp"

namespace moat {
namespace {

/// One result of all cases that are done and have a finite one, ascending.
std::vector<double> finite_results(const StudyResult& study, std::string_view quantity) {
  std::vector<double> values;
  const std::vector<Column>& columns = study.table().columns;
  for (std::size_t i = study.axes().size(); i < columns.size(); ++i)
    if (columns[i].quantity == quantity && columns[i].where.empty())
      std::ranges::copy_if(columns[i].values, std::back_inserter(values),
                           [](double value) { return std::isfinite(value); });
  std::ranges::sort(values);
  return values;
}

std::vector<KnownInterval> known_intervals(const std::vector<double>& gaps, const std::vector<double>& beyond) {
  const auto records = static_cast<double>(gaps.size() + beyond.size());
  Check{"GapDemand", ""}.that(records >= 2.0 && !gaps.empty(), "records with a smallest gap", records, "1", ">= 2",
                              gaps.empty() && records > 0.0
                                  ? "All records need more than the largest gap: give a larger GapSearch::largest."
                                  : "A distribution needs several records with the result smallest_gap.");
  std::vector<KnownInterval> intervals;
  for (const double gap : gaps) intervals.push_back({gap, gap, 1.0});
  for (const double gap : beyond) intervals.push_back({.above = gap});
  return intervals;
}

std::string in_cm(double gap) { return to_significant(100.0 * gap, 4); }

}  // namespace

StudyEvent exceeds(std::string quantity, std::string where, double threshold) {
  return [quantity = std::move(quantity), where = std::move(where), threshold](const CaseOutcome& outcome) {
    return value_of(outcome.results, quantity, where) > threshold;
  };
}

StudyEvent exceeds(std::string quantity, std::string where, double threshold, std::string unit) {
  StudyEvent event = exceeds(quantity, where, threshold);
  return [event = std::move(event), quantity = std::move(quantity), where = std::move(where),
          unit = std::move(unit)](const CaseOutcome& outcome) {
    for (const NamedNumber& each : outcome.results)
      if (each.quantity == quantity && each.where == where && each.unit != unit)
        throw InputError{"exceeds: " + quantity + " of " + where + " is in " + each.unit + ", the threshold in " +
                         unit + ". Give a threshold of its dimension, or a number where it has none."};
    return event(outcome);
  };
}

StudyEvent pounds() { return exceeds("impacts", "", 0.0); }

std::vector<EventCount> event_counts(const StudyResult& study, std::string_view axis, const StudyEvent& event) {
  const std::size_t index = study.cases().index_of(axis);
  std::map<double, EventCount> counts;
  for (std::size_t number = 0; number < study.cases().count(); ++number) {
    const CaseOutcome outcome = study.outcome(number);
    const double level = study.axes()[index].values[study.cases().position(index, number)];
    EventCount& count = counts[level];
    count.level = level;
    if (outcome.state == CaseState::done) {
      ++count.trials;
      if (event(outcome)) ++count.events;
    } else if (outcome.state != CaseState::open) {
      ++count.without_solution;
    }
  }
  std::vector<EventCount> list;
  for (const auto& [level, count] : counts) list.push_back(count);
  return list;
}

std::vector<KnownInterval> event_limits(const StudyResult& study, std::string_view axis, const StudyEvent& event,
                                        Trend trend) {
  const std::size_t index = study.cases().index_of(axis);
  std::map<std::vector<std::size_t>, std::map<double, bool>> answers;  // by the other axes, by the level
  for (std::size_t number = 0; number < study.cases().count(); ++number) {
    const CaseOutcome outcome = study.outcome(number);
    if (outcome.state != CaseState::done) continue;
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < study.axes().size(); ++i)
      if (i != index) others.push_back(study.cases().position(i, number));
    const double level = study.axes()[index].values[study.cases().position(index, number)];
    Check{"StudyAxis", axis}.not_negative("a level", level, study.axes()[index].unit);
    answers[others][level] = event(outcome);
  }
  std::vector<KnownInterval> limits;
  for (const auto& [others, levels] : answers) {
    KnownInterval limit;
    if (trend == Trend::grows) {
      for (const auto& [level, happened] : levels) {
        if (happened) {
          limit.up_to = level;
          break;
        }
        limit.above = level;
      }
    } else {
      for (auto each = levels.rbegin(); each != levels.rend(); ++each) {
        if (each->second) {
          limit.above = each->first;
          break;
        }
        limit.up_to = each->first;
      }
    }
    limits.push_back(limit);
  }
  return limits;
}

LognormalFit fit_fragility(const StudyResult& study, std::string_view axis, const StudyEvent& event, Trend trend,
                           double confidence) {
  return LognormalFit{event_limits(study, axis, event, trend), confidence, "limits on axis " + std::string{axis}};
}

GapDemand::GapDemand(const StudyResult& study, double confidence)
    : gaps_{finite_results(study, "smallest_gap")},
      beyond_{finite_results(study, "smallest_gap_above")},
      without_solution_{study.count(CaseState::failed) + study.count(CaseState::not_converged)},
      fit_{known_intervals(gaps_, beyond_), confidence, "smallest gaps"} {}

std::string GapDemand::description() const {
  std::string text = std::to_string(gaps_.size()) + " records with a smallest gap from " + in_cm(gaps_.front()) +
                     " to " + in_cm(gaps_.back()) + " cm, ";
  if (!beyond_.empty())
    text += std::to_string(beyond_.size()) + " that need more than " + in_cm(beyond_.front()) + " cm, ";
  return text + std::to_string(without_solution_) + " without solution.";
}

Length GapDemand::gap(double probability_of_pounding) const {
  return Length{fit_.quantile(1.0 - probability_of_pounding)};
}

Bounds GapDemand::gap_bounds(double probability_of_pounding) const {
  return fit_.quantile_bounds(1.0 - probability_of_pounding);
}

Length GapDemand::empirical_gap(double share_that_pounds) const {
  Check{"GapDemand", ""}.that(share_that_pounds >= 0.0 && share_that_pounds < 1.0, "share_that_pounds",
                              share_that_pounds, "1", ">= 0 and < 1");
  const auto may_pound =
      std::min(static_cast<std::size_t>(share_that_pounds * static_cast<double>(records()) + 1e-9), records() - 1);
  const std::size_t open = records() - 1 - may_pound;
  return Length{open < gaps_.size() ? gaps_[open] : std::numeric_limits<double>::infinity()};
}

double GapDemand::probability(Length gap) const { return 1.0 - fit_.probability(gap.si()); }

Bounds GapDemand::probability_bounds(Length gap) const {
  const Bounds open = fit_.probability_bounds(gap.si());
  return {1.0 - open.high, 1.0 - open.low};
}

}  // namespace moat
