// Pictures of answers.

#include "analyses/questions/answer_charts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analyses/questions/incremental_dynamic_analysis.hpp"
#include "analyses/questions/study.hpp"

namespace moat {
namespace {

// The first series is the band: forth above, back below, around the second.
void expect_band_around_curve(const Chart& chart) {
  ASSERT_GE(chart.series.size(), 2u);
  const Series &band = chart.series[0], &curve = chart.series[1];
  EXPECT_EQ(band.style, Series::Style::band);
  const std::size_t n = curve.x.size();
  ASSERT_EQ(band.x.size(), 2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(band.x[i], curve.x[i]);
    EXPECT_EQ(band.x[2 * n - 1 - i], curve.x[i]);
    EXPECT_GE(band.y[i], curve.y[i] - 1e-9);
    EXPECT_LE(band.y[2 * n - 1 - i], curve.y[i] + 1e-9);
  }
  EXPECT_NO_THROW((void)svg_text({chart}));
}

TEST(FragilityChart, HasCurveBandAndShares) {
  const LognormalFit fit{{{0.2, 0.2}, {0.3, 0.3}, {0.5, 0.5}, {0.4, 0.4}}};
  const Chart chart = fragility_chart(
      fit, {{.level = 0.3, .trials = 4, .events = 1}, {.level = 0.4, .without_solution = 2}}, "Fragility", "Sa [g]");
  expect_band_around_curve(chart);
  EXPECT_TRUE(std::ranges::is_sorted(chart.series[1].y));
  ASSERT_EQ(chart.series.size(), 3u);
  EXPECT_EQ(chart.series[2].y, (std::vector{0.25})) << "no share without a trial";
}

TEST(PoundingChart, SaysHowManyRecordsNeedMore) {
  const StudyResult study =
      run_study({{.name = "record", .unit = "", .values = {1.0, 2.0, 3.0, 4.0}}}, [](const StudyCase& each) {
        if (each.number() == 3)
          return StudyRecord{{"smallest_gap", "", "m", INFINITY}, {"smallest_gap_above", "", "m", 0.35}};
        return StudyRecord{{"smallest_gap", "", "m", 0.1 * each.value("record")}};
      });
  const Chart chart = pounding_chart(GapDemand{study}, "Pounding");
  expect_band_around_curve(chart);
  EXPECT_EQ(chart.series[2].y, (std::vector{0.75, 0.5, 0.25})) << "shares of all four";
  EXPECT_EQ(chart.series[2].name, "share of 4 records, 1 need more than 35 cm");
}

TEST(IdaChart, HasAllCurvesAndThreeFractiles) {
  const std::vector<IdaCurve> curves{{.record = "a", .levels = {1.0, 2.0}, .responses = {0.01, 0.03}},
                                     {.record = "b", .levels = {1.0, 2.0}, .responses = {0.02, 0.05}}};
  const Chart chart = ida_chart(curves, "IDA", "Sa [g]", "drift [cm]", 0.01);
  ASSERT_EQ(chart.series.size(), 5u);
  EXPECT_NEAR(chart.series[3].y[1], 4.0, 1e-12) << "the median, in cm";
  EXPECT_NO_THROW((void)svg_text({chart}));
}

// Answers that the results of a study give by themselves.
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
