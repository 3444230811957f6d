#include "study/study_text.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "base/text/utf8_text.hpp"
#include "output/files/engineering_unit.hpp"
#include "study/responses.hpp"

namespace moat {
namespace {

constexpr std::size_t shown_cases = 5, shown_sessions = 10;

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

/// "cases: 40, of these 38 done, 1 failed, 1 not converged, 0 open"
std::string state_line(const StudyResult& result) {
  std::string text = "cases: " + std::to_string(result.cases().count()) + ", of these";
  for (const CaseState state : {CaseState::done, CaseState::failed, CaseState::not_converged, CaseState::open})
    text += std::string{state == CaseState::done ? " " : ", "} + std::to_string(result.count(state)) + " " +
            std::string{name_of(state)};
  return text + "\n";
}

std::string slowest_lines(const StudyResult& result) {
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; number < result.cases().count(); ++number)
    if (result.state(number) != CaseState::open) numbers.push_back(number);
  if (numbers.empty()) return "";
  const std::size_t shown = std::min(numbers.size(), shown_cases);
  std::ranges::partial_sort(numbers, numbers.begin() + static_cast<std::ptrdiff_t>(shown), {}, [&](std::size_t number) {
    return std::pair{-result.seconds(number), number};
  });
  std::string text = "slowest cases\n";
  for (std::size_t i = 0; i < shown; ++i)
    text += "  case " + std::to_string(numbers[i]) + ", " + StudyCase{result.cases(), numbers[i]}.description() + ": " +
            to_significant(result.seconds(numbers[i]), 3) + " s\n";
  return text;
}

std::string session_lines(const StoredStudy& study) {
  std::string text = "runs\n";
  const std::vector<StoredSession>& sessions = study.sessions;
  const std::size_t first = sessions.size() > shown_sessions ? sessions.size() - shown_sessions : 0;
  if (first > 0) text += "  ... " + std::to_string(first) + " earlier ones\n";
  for (std::size_t i = first; i < sessions.size(); ++i) {
    const StoredSession& session = sessions[i];
    text += "  " + session.date + "  moat " + session.moat_version + " " + session.git_commit.substr(0, 12) + ", " +
            session.engine + ", " + std::to_string(session.cases) + " cases, " +
            (session.ending.empty() ? "running, or killed" : session.ending) + ": " + session.command_line + "\n";
    if (i > 0 && session.version != sessions[i - 1].version)
      text += "  changes were accepted before this run:" +
              differences(study.versions[sessions[i - 1].version], study.versions[session.version]) + "\n";
  }
  return text;
}

}  // namespace

std::string case_lines(const StudyResult& study) {
  constexpr std::size_t most_cases = 24, most_responses = 6;
  std::vector<StudyResponse> responses = responses_of(study);
  if (responses.empty() || study.cases().count() > most_cases) return "";
  responses.resize(std::min(responses.size(), most_responses));
  std::vector<std::vector<std::string>> lines(study.cases().count() + 1);
  for (const StudyAxis& axis : study.axes()) {
    lines.front().push_back(axis.name + (axis.unit.empty() ? "" : " [" + axis.unit + "]"));
    for (std::size_t i = 1; i < lines.size(); ++i) lines[i].push_back(StudyCase{study.cases(), i - 1}.label(axis.name));
  }
  for (const StudyResponse& response : responses) {
    lines.front().push_back(response.label);
    double largest = 0.0;
    bool counts = response.label.find('[') == std::string::npos;
    for (const double value : response.values) {
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
      counts = counts && (!std::isfinite(value) || value == std::round(value));
    }
    for (std::size_t i = 1; i < lines.size(); ++i)
      lines[i].push_back(with_decimals(response.values[i - 1], counts ? 0 : decimals_for(largest)));
  }
  return in_columns(lines);
}

std::string description_of(const StoredStudy& study) {
  const StudyResult& result = study.result;
  std::string text = study.title.empty() ? "" : study.title + "\n";
  text += axis_lines(result.cases()) + state_line(result);
  double seconds = 0.0;
  for (std::size_t number = 0; number < result.cases().count(); ++number) seconds += result.seconds(number);
  text += "time of all cases: " + to_significant(seconds, 4) + " s\n";
  if (const std::string failures = failure_message(result); !failures.empty()) text += failures + "\n";
  return text + slowest_lines(result) + session_lines(study);
}

}  // namespace moat
