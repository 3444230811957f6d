#include "analyses/questions/fragility.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moat {

StudyEvent exceeds(std::string quantity, std::string where, double threshold) {
  return [quantity = std::move(quantity), where = std::move(where), threshold](const CaseOutcome& outcome) {
    return value_of(outcome.results, quantity, where) > threshold;
  };
}

StudyEvent pounds() { return exceeds("impacts", "", 0.0); }

std::vector<EventCount> event_counts(const StudyResult& study, std::string_view axis, const StudyEvent& event) {
  const std::size_t index = study.cases().index_of(axis);
  std::map<double, EventCount> counts;
  for (std::size_t number = 0; number < study.outcomes().size(); ++number) {
    const CaseOutcome& outcome = study.outcomes()[number];
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
  for (std::size_t number = 0; number < study.outcomes().size(); ++number) {
    const CaseOutcome& outcome = study.outcomes()[number];
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

}  // namespace moat
