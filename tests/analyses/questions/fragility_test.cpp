// Fragilities of studies.

#include "message_of.hpp"
#include "moat.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moat {
namespace {

const std::vector<double> capacities{0.42, 0.55, 0.31, 0.77, 0.48, 0.61, 0.35, 0.52};

StudyAxis records() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < capacities.size(); ++i) names.push_back("record " + std::to_string(i));
  return StudyAxis::of_names("record", names);
}

// A structure whose drift is the level over its capacity; some cases do not converge.
StudyResult study_of(const std::vector<double>& levels, const std::function<bool(const StudyCase&)>& stuck = {}) {
  return run_study(
      {{.name = "Sa", .unit = "g", .values = levels}, records()},
      [&](const StudyCase& each) {
        if (stuck && stuck(each)) throw ConvergenceError{"stuck", 0.0, 0.0, 0.0, ""};
        return StudyRecord{{"drift", "storey 1", "m", each.value("Sa") / capacities[each.position("record")]}};
      },
      {.keep_failures = true});
}

const StudyEvent collapse = exceeds("drift", "storey 1", 1.0);

TEST(Fragility, CountsTheEventAtEveryLevel) {
  const std::vector<EventCount> counts = event_counts(study_of({0.6, 0.4}), "Sa", collapse);
  ASSERT_EQ(counts.size(), 2u);
  EXPECT_EQ(counts[0].level, 0.4);
  EXPECT_EQ(counts[0].events, 2);
  EXPECT_EQ(counts[1].events, 6);
  EXPECT_EQ(counts[1].trials, 8);
}

TEST(Fragility, FindsTheLimitOfEveryRecord) {
  const std::vector<KnownInterval> limits = event_limits(study_of({0.3, 0.4, 0.5, 0.6}), "Sa", collapse, Trend::grows);
  ASSERT_EQ(limits.size(), capacities.size());
  for (std::size_t i = 0; i < limits.size(); ++i) {
    EXPECT_LT(limits[i].above, capacities[i]);
    EXPECT_GE(limits[i].up_to, capacities[i]);
    EXPECT_TRUE(std::isinf(limits[i].up_to) || limits[i].up_to - limits[i].above < 0.1001);
  }
}

// A sweep of clearances may begin wall to wall.
TEST(Fragility, ALevelMayBeZero) {
  const StudyEvent stands = [](const CaseOutcome& outcome) { return !collapse(outcome); };
  for (const KnownInterval& limit : event_limits(study_of({0.0, 0.9}), "Sa", stands, Trend::shrinks)) {
    EXPECT_EQ(limit.above, 0.0);
    EXPECT_EQ(limit.up_to, 0.9);
  }
  EXPECT_THROW((void)event_limits(study_of({-0.1, 0.9}), "Sa", stands, Trend::shrinks), InputError);
}

TEST(Fragility, ACaseWithoutSolutionIsNeitherPassNorFailure) {
  const auto stuck = [](const StudyCase& each) { return each.position("record") == 4 && each.position("Sa") == 2; };
  const StudyResult study = study_of({0.3, 0.4, 0.5, 0.6}, stuck);
  const std::vector<EventCount> counts = event_counts(study, "Sa", collapse);
  EXPECT_EQ(counts[2].trials, 7);
  EXPECT_EQ(counts[2].events, 3);
  EXPECT_EQ(counts[2].without_solution, 1);
  const KnownInterval limit = event_limits(study, "Sa", collapse, Trend::grows)[4];
  EXPECT_EQ(limit.above, 0.4) << "capacity 0.48: known between 0.4 and 0.6";
  EXPECT_EQ(limit.up_to, 0.6);
  const auto all_stuck = [](const StudyCase& each) { return each.position("record") == 4; };
  EXPECT_EQ(event_limits(study_of({0.3, 0.6}, all_stuck), "Sa", collapse, Trend::grows).size(), 7u);
}

TEST(Fragility, TakesTheFirstLimitWhereTheEventComesAndGoes) {
  const StudyResult study =
      run_study({{.name = "level", .unit = "", .values = {1.0, 2.0, 3.0, 4.0}}}, [](const StudyCase& each) {
        const bool event = each.position("level") == 1 || each.position("level") == 3;
        return StudyRecord{{"x", "", "1", event ? 1.0 : 0.0}};
      });
  const KnownInterval first = event_limits(study, "level", exceeds("x", "", 0.5), Trend::grows).at(0);
  EXPECT_EQ(first.above, 1.0);
  EXPECT_EQ(first.up_to, 2.0);
  const KnownInterval last = event_limits(study, "level", exceeds("x", "", 0.5), Trend::shrinks).at(0);
  EXPECT_EQ(last.above, 4.0);
  EXPECT_TRUE(std::isinf(last.up_to));
}

TEST(Fragility, ApproachesThatOfTheCapacitiesAsLevelsGetCloser) {
  std::vector<KnownInterval> exact;
  for (const double each : capacities) exact.push_back({each, each});
  const LognormalFit limit{exact}, fit = fit_fragility(study_of(linearly_spaced(0.3, 0.8, 501)), "Sa", collapse);
  EXPECT_NEAR(fit.median(), limit.median(), 1e-3);
  EXPECT_NEAR(fit.dispersion(), limit.dispersion(), 1e-3);
}

TEST(Fragility, RefusesUnknownResults) {
  EXPECT_THROW((void)event_counts(study_of({0.3}), "Sa", exceeds("drift", "storey 9", 1.0)), InputError);
  // A threshold of another dimension than the result.
  EXPECT_EQ(
      testing::message_of(
          [] { (void)event_counts(study_of({0.3}), "Sa", exceeds("drift", "storey 1", 1 * units::kN)); }),
      "exceeds: drift of storey 1 is in m, the threshold in N. Give a threshold of its dimension, or a number where "
      "it has none.");
  EXPECT_NO_THROW((void)event_counts(study_of({0.3}), "Sa", exceeds("drift", "storey 1", 1 * units::m)));
  EXPECT_THROW((void)event_counts(study_of({0.3}), "PGA", collapse), InputError);
}

}  // namespace
}  // namespace moat
