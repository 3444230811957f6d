// Answers that the results of a study give by themselves.

#include "analyses/questions/study_pictures.hpp"

#include <gtest/gtest.h>

#include "analyses/questions/incremental_dynamic_analysis.hpp"
#include "analyses/questions/study.hpp"

namespace moat {
namespace {

const StudyAxis records = StudyAxis::of_names("record", {"a", "b", "c", "d"});

std::vector<std::string> titles_of(const StudyAnswers& answers) {
  std::vector<std::string> titles;
  for (const StudyPicture& picture : answers.pictures) titles.push_back(picture.title);
  return titles;
}

TEST(StudyAnswers, OfSmallestGapsAreTheProbabilityOfPounding) {
  const auto gap = [](const StudyCase& each) {
    return StudyRecord{{"smallest_gap", "", "m", 0.1 * (1.0 + static_cast<double>(each.position("record")))}};
  };
  const StudyAnswers answers = answers_of(run_study({records}, gap));
  EXPECT_EQ(titles_of(answers), std::vector<std::string>{"Probability of pounding"});
  EXPECT_NE(answers.pictures[0].svg.find("95 % confidence"), std::string::npos);
  EXPECT_EQ(answers.sentences.at(0), "4 records with a smallest gap from 10 to 40 cm, 0 without solution.");
  // Cases of several buildings are not one sample.
  EXPECT_TRUE(
      answers_of(run_study({records, {.name = "mass", .unit = "t", .values = {1.0, 2.0}}}, gap)).pictures.empty());
}

TEST(StudyAnswers, WithoutAFitSayWhy) {
  const StudyAnswers answers = answers_of(run_study({records}, [](const StudyCase&) {
    return StudyRecord{{"smallest_gap", "", "m", 0.1}};
  }));
  EXPECT_TRUE(answers.pictures.empty());
  ASSERT_FALSE(answers.sentences.empty());
  EXPECT_NE(answers.sentences.back().find("the dispersion would be zero"), std::string::npos);
}

TEST(StudyAnswers, OfAGapAndRecordsAreTheShareThatPounds) {
  const StudyCases cases{{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 30.0}}, records};
  const StudyAnswers answers = answers_of(run_study(cases, [](const StudyCase& each) {
    return StudyRecord{{"impacts", "", "1", each.value("record") >= each.value("gap") / 10.0 ? 2.0 : 0.0}};
  }));
  EXPECT_EQ(titles_of(answers), std::vector<std::string>{"Share of cases with impacts over gap"});
  EXPECT_NE(answers.pictures[0].svg.find("gap [cm]"), std::string::npos);
}

TEST(StudyAnswers, OfHuntsAreTheirCurvesAndFragility) {
  const StudyAnswers answers = answers_of(run_study({records}, [](const StudyCase& each) {
    return record_of(hunt_and_fill([&](double level) { return level * (1.0 + 0.3 * each.value("record")); },
                                   {.first_level = 0.1, .first_step = 0.1, .response_limit = 1.0}));
  }));
  EXPECT_EQ(titles_of(answers), (std::vector<std::string>{"Incremental dynamic analysis", "Fragility"}));
}

}  // namespace
}  // namespace moat
