// Suites of records with bounds, eccentricities and directions.
#include "analyses/questions/suite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "message_of.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

GroundMotion record(const std::string& name, double size) {
  std::vector<double> samples;
  for (int i = 0; i < 100; ++i) samples.push_back(size * std::sin(0.2 * i));
  return {name, 0.02, samples};
}

// A case returns its own factors as motion of a body: the model is a body that moves freely with its initial velocity.
Model free_body(Speed speed) {
  Model model;
  add(model, Node{.name = "body", .mass = 1 * tonne, .initial_velocity = speed, .free = true});
  return model;
}

const PropertyBounds bounds{.lower = {.strength = 0.8, .stiffness = 0.9}, .upper = {.strength = 1.3, .stiffness = 1.2}};

TEST(Suite, CombinesRecordsBoundsEccentricitiesAndDirections) {
  const std::vector<PlanMotion> pairs{{record("a", 1.0), record("b", 0.5)}, {record("c", 2.0), record("d", 0.25)}};
  const Suite suite{pairs, {.bounds = bounds, .eccentricity = 0.05, .directions = {0 * deg, 90 * deg}}};
  const StudyCases cases = suite.cases();
  EXPECT_EQ(cases.count(), 2U * 3U * 5U * 2U);
  std::vector<SuiteCase> seen;
  for (std::size_t i = 0; i < cases.count(); ++i) {
    const StudyModel made = suite.model(StudyCase{cases, i}, [&](const SuiteCase& each) {
      seen.push_back(each);
      return free_body(0 * m / s);
    });
    // Turned by 90 degrees the first component acts along y.
    const bool first_record = i < 30, turned = i % 2 == 1;
    const double first = first_record ? 1.0 : 2.0, second = first_record ? 0.5 : 0.25, now = std::sin(0.2 * 7);
    EXPECT_NEAR(made.motion.samples()[7], (turned ? -second : first) * now, 1e-12) << i;
    EXPECT_NEAR(made.motion.samples_y()[7], (turned ? first : second) * now, 1e-12) << i;
  }
  EXPECT_EQ(seen[0].factors.strength, 0.8) << "lower";
  EXPECT_EQ(seen[10].factors.strength, 1.0) << "nominal";
  EXPECT_EQ(seen[20].factors.stiffness, 1.2) << "upper";
  EXPECT_EQ(seen[0].eccentricity, PlanVector{});
  EXPECT_EQ(seen[2].eccentricity, (PlanVector{0.05, 0.0}));
  EXPECT_EQ(seen[8].eccentricity, (PlanVector{0.0, -0.05}));
}

TEST(Suite, GivesTheStatisticsOfItsRecords) {
  const Suite suite{std::vector{record("a", 0.0), record("b", 0.0)}, {.bounds = bounds}};
  const StudyResult result =
      run_suite(suite, [](const SuiteCase& each) { return free_body(each.factors.strength * m / s); });
  const std::vector<RecordStatistics> list = statistics_over(result);
  const auto found = std::ranges::find_if(
      list, [](const RecordStatistics& each) { return each.envelope && each.quantity == "displacement"; });
  ASSERT_NE(found, list.end());
  EXPECT_NEAR(found->statistics.mean, 1.3 * 99 * 0.02, 1e-9) << "the way of the upper bound";
  EXPECT_EQ(found->group, "bounds = upper");
}

TEST(SuiteRecords, HashTheirSamplesOnce) {
  const std::vector motions{record("a", 1.0), record("b", 2.0)};
  const SuiteRecords records{motions};
  EXPECT_EQ(&records.axis(), &records.axis());
  EXPECT_EQ(records.axis().name, "record");
  EXPECT_EQ(records.axis().labels, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(records.axis().hashes, record_axis("record", motions).hashes);
  EXPECT_NE(records.axis().hashes[0], records.axis().hashes[1]);
  EXPECT_EQ(Suite(records, {}).cases().axes()[0].hashes, records.axis().hashes);
}

// Two cases with lower bounds are left out: the largest collapsed, and another did not converge. All cases with upper
// bounds collapsed.
TEST(Suite, NamesTheCasesWithTheLargestDeformation) {
  StudyAxis axis = StudyAxis::of_names("record", {"a", "b", "c", "d"});
  const StudyAxis of_bounds = StudyAxis::of_names("bounds", {"lower", "nominal", "upper"});
  const auto suite_of = [](const StudyCases& cases) {
    std::vector<CaseOutcome> outcomes;
    for (std::size_t i = 0; i < cases.count(); ++i) {
      const StudyCase each{cases, i};
      const double record = each.value("record");
      const std::size_t bound = cases.axes().size() > 1 ? each.position("bounds") : 0;
      CaseOutcome& outcome = outcomes.emplace_back();
      if (bound == 0 && record == 2.0) continue;
      outcome.state = CaseState::done;
      const bool collapsed = bound == 2 || (bound == 0 && record == 3.0);
      outcome.results = {{"isolator_deformation", "bearing 1", "m", bound == 1 ? 0.4 - 0.1 * record : 0.1 * record},
                         {"isolator_deformation", "bearing 2", "m", 0.01},
                         {"collapsed", "", "1", collapsed ? 1.0 : 0.0}};
    }
    return StudyResult{cases, outcomes};
  };
  const StudyCases cases{axis, of_bounds};  // three for every record
  EXPECT_EQ(cases_with_largest_deformation(suite_of(cases)), (std::vector<std::size_t>{3, 1}));
  EXPECT_EQ(cases_with_largest_deformation(suite_of({axis})), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(cases_with_largest_deformation(StudyResult{cases, std::vector<CaseOutcome>(cases.count())}).empty());
}

TEST(Suite, RefusesWhatHasNoMeaning) {
  const std::vector motions{record("a", 1.0)};
  EXPECT_EQ(message_of([&] { Suite(motions, {.directions = {0 * deg}}); }),
            "Suite: directions are given of motions on a line. Give pairs of components.");
  EXPECT_EQ(message_of([&] { Suite(motions, {.eccentricity = 5.0}); }),
            "Suite: eccentricity = 5 is not allowed; it must be >= 0 and < 0.5. 5 % is 0.05.");
  EXPECT_EQ(message_of([&] { Suite(std::vector<GroundMotion>{}, {}); }),
            "Suite: there are no records. Give at least one.");
  EXPECT_NE(message_of([&] {
              Suite(motions, {.bounds = PropertyBounds{.lower = {.strength = 2.0}, .upper = {}}});
            }).find("lower.strength"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              Suite(std::vector{record("a", 1.0), record("a", 2.0)}, {});
            }).find("\"a\""),
            std::string::npos);
}

}  // namespace
}  // namespace moat
