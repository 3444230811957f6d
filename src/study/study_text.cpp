#include "study/study_text.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/check.hpp"
#include "base/number_format.hpp"

namespace moat {
namespace {

constexpr std::size_t shown_cases = 5;

std::string axis_lines(const StudyCases& cases) {
  std::string text = "axes\n";
  for (const StudyAxis& axis : cases.axes()) {
    const auto name_of_value = [&](std::size_t i) {
      return axis.labels.empty() ? to_text(axis.values[i]) + (axis.unit.empty() ? "" : " " + axis.unit)
                                 : axis.labels[i];
    };
    text += "  " + axis.name + ": " + std::to_string(axis.values.size()) + " values, " + name_of_value(0);
    if (axis.values.size() > 1) text += " ... " + name_of_value(axis.values.size() - 1);
    text += "\n";
  }
  return text;
}

std::string slowest_lines(const StudyResult& result) {
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; number < result.outcomes().size(); ++number)
    if (result.outcomes()[number].state != CaseState::open) numbers.push_back(number);
  std::ranges::stable_sort(numbers, [&](std::size_t a, std::size_t b) {
    return result.outcomes()[a].seconds > result.outcomes()[b].seconds;
  });
  if (numbers.empty()) return "";
  numbers.resize(std::min(numbers.size(), shown_cases));
  std::string text = "slowest cases\n";
  for (const std::size_t number : numbers)
    text += "  " + std::to_string(number) + ": " + to_significant(result.outcomes()[number].seconds, 3) + " s, " +
            StudyCase{result.cases(), number}.description() + "\n";
  return text;
}

}  // namespace

std::string description_of(const StoredStudy& study) {
  const StudyResult& result = study.result;
  std::string text;
  for (const auto& [key, value] : study.properties)
    if (key == "title" && !value.empty()) text += value + "\n";
  text += axis_lines(result.cases());
  const std::size_t all = result.cases().count();
  text += "cases: " + std::to_string(all) + ", of these";
  for (const CaseState state : {CaseState::done, CaseState::failed, CaseState::not_converged, CaseState::open})
    text += std::string{state == CaseState::done ? " " : ", "} + std::to_string(result.count(state)) + " " +
            std::string{name_of(state)};
  double seconds = 0.0;
  for (const CaseOutcome& outcome : result.outcomes()) seconds += outcome.seconds;
  text += "\ntime of all cases: " + to_significant(seconds, 4) + " s\n";
  if (const std::string failures = failure_message(result); !failures.empty()) text += failures + "\n";
  text += slowest_lines(result) + "runs\n";
  for (const StudySession& session : study.sessions)
    text += "  " + session.date + "  moat " + session.moat_version + " " + session.git_commit.substr(0, 12) + ", " +
            session.engine + ": " + session.command_line + "\n";
  return text;
}

}  // namespace moat
