// A study as text.

#include "study/study_text.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

StoredStudy study() {
  const StudyCases cases{{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 30.0, 40.0}}};
  std::vector<CaseOutcome> outcomes(4);
  outcomes[0] = {.state = CaseState::done, .results = {{"x", "", "1", 1.0}}, .seconds = 0.5};
  outcomes[1] = {.state = CaseState::not_converged, .reason = "stuck", .seconds = 3.0};
  outcomes[2] = {.state = CaseState::failed, .reason = "wrong", .seconds = 0.1};
  StoredSession first, second;
  first.date = "2026-01-01T00:00:00Z";
  first.command_line = "moat run a.cpp";
  first.cases = 2;
  second = first;
  first.ending = "stopped by SIGINT";
  second.version = 1;
  second.cases = 1;
  return {.title = "A study",
          .versions = {{{"option --pga", "0.2g"}}, {{"option --pga", "0.4g"}}},
          .current_version = 1,
          .sessions = {first, second},
          .session_of_case = {0, 0, 1, 0},
          .result = StudyResult{cases, outcomes}};
}

TEST(StudyText, CountsEveryState) {
  const std::string text = description_of(study());
  for (const char* line :
       {"A study\n", "  gap: 4 values, 10 cm ... 40 cm\n",
        "cases: 4, of these 1 done, 1 failed, 1 not converged, 1 open\n",
        "2 of 4 cases failed, 1 of them did not converge.\n  case 1, gap = 20 cm: stuck\n  case 2, gap = 30 cm: "
        "wrong\n",
        "slowest cases\n  case 1, gap = 20 cm: 3 s\n  case 0, gap = 10 cm: 0.5 s\n  case 2, gap = 30 cm: 0.1 s\n",
        ", 2 cases, stopped by SIGINT: moat run a.cpp\n", ", 1 cases, running, or killed: moat run a.cpp\n",
        "  changes were accepted before this run:\n  option --pga: 0.2g -> 0.4g\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

TEST(StudyText, ListsTheResponsesOfAFewCases) {
  const auto lines = [](std::size_t cases) {
    std::vector<CaseOutcome> outcomes(cases, CaseOutcome{.state = CaseState::failed, .reason = "wrong"});
    outcomes[0] = {.state = CaseState::done,
                   .results = {{"impacts", "", "1", 12.0},
                               {"displacement", "floor 1", "m", 0.25},
                               {"displacement", "base", "m", 0.5},
                               {"displacement_error", "base", "m", 0.1}}};
    return case_lines(StudyResult{
        {{.name = "gap", .unit = "cm", .values = linearly_spaced(10.0, 20.0, static_cast<int>(cases))}}, outcomes});
  };
  EXPECT_EQ(lines(2), "  gap [cm]  impacts  displacement [cm]\n  10        12       50.00\n  20        -        -\n");
  EXPECT_EQ(lines(25), "");
}

}  // namespace
}  // namespace moat
