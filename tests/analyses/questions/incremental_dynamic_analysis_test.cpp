// Incremental dynamic analysis.

#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis_testing.hpp"

namespace moat {
namespace {

TEST(HuntAndFill, HuntsWithGrowingStepsAndHalvesTheWidestDistance) {
  const IdaCurve curve = hunt_and_fill([](double level) { return level * level; }, {.first_level = 1.0,
                                                                                    .first_step = 1.0,
                                                                                    .step_increment = 1.0,
                                                                                    .response_limit = 40.0,
                                                                                    .largest_level = 100.0,
                                                                                    .fill = 2});
  // Hunt: 1, 2, 4, 7 (49 > 40). Fill: 5.5 in 4 ... 7, then 3 in 2 ... 4.
  EXPECT_EQ(curve.levels, (std::vector{1.0, 2.0, 3.0, 4.0, 5.5, 7.0}));
  for (std::size_t i = 0; i < curve.levels.size(); ++i)
    EXPECT_EQ(curve.responses[i], curve.levels[i] * curve.levels[i]);
  EXPECT_TRUE(curve.without_solution.empty());
}

TEST(HuntAndFill, BracketsTheCapacityEverCloser) {
  const auto structure = [](double level) { return level < 0.537 ? level : 100.0; };
  HuntAndFill options{.first_level = 0.1,
                      .first_step = 0.1,
                      .step_increment = 0.05,
                      .response_limit = 10.0,
                      .largest_level = 5.0,
                      .fill = 60};
  const KnownInterval capacity = capacities({hunt_and_fill(structure, options)}, 10.0).at(0);
  EXPECT_LT(capacity.above, 0.537);
  EXPECT_GE(capacity.up_to, 0.537);
  EXPECT_LT(capacity.up_to - capacity.above, 0.02);
}

TEST(HuntAndFill, EndsWhereASolutionIsMissing) {
  const auto structure = [](double level) {
    if (level > 0.55 || std::abs(level - 0.15) < 1e-9) throw ConvergenceError{"stuck", 0.0, 0.0, 0.0, ""};
    return level;
  };
  const IdaCurve curve = hunt_and_fill(structure, {.first_level = 0.1,
                                                   .first_step = 0.1,
                                                   .step_increment = 0.0,
                                                   .response_limit = 10.0,
                                                   .largest_level = 5.0,
                                                   .fill = 8});
  EXPECT_LT(curve.levels.back(), 0.56);
  ASSERT_GE(curve.without_solution.size(), 2u);
  EXPECT_NEAR(curve.without_solution.front(), 0.15, 1e-9);
  EXPECT_NEAR(*std::ranges::find_if(curve.without_solution, [](double x) { return x > 0.2; }), 0.575, 0.03);
  EXPECT_TRUE(std::isinf(capacities({curve}, 10.0).at(0).up_to)) << "not converged is not collapsed";
}

TEST(HuntAndFill, EndsAtTheLargestLevel) {
  const IdaCurve curve = hunt_and_fill([](double) { return 0.0; }, {.first_level = 1.0,
                                                                    .first_step = 3.0,
                                                                    .step_increment = 0.0,
                                                                    .response_limit = 1.0,
                                                                    .largest_level = 6.0,
                                                                    .fill = 0});
  EXPECT_EQ(curve.levels, (std::vector{1.0, 4.0, 6.0}));
  EXPECT_THROW((void)hunt_and_fill([](double) { return 0.0; }, {.response_limit = 0.0}), InputError);
}

TEST(IdaCurves, OfHuntsSurviveTheirStudy) {
  const std::vector<double> strengths{1.0, 2.0};
  const auto hunt = [&](std::size_t record) {
    return hunt_and_fill(
        [&](double level) {
          if (record == 1 && level > 3.0) throw ConvergenceError{"stuck", 0.0, 0.0, 0.0, ""};
          return level / strengths[record];
        },
        {.first_level = 0.5, .first_step = 0.5, .response_limit = 1.5, .largest_level = 9.0, .fill = 3});
  };
  const StudyResult study = run_study({StudyAxis::of_names("record", {"north", "south"})},
                                      [&](const StudyCase& each) { return record_of(hunt(each.position("record"))); });
  const std::vector<IdaCurve> curves = ida_curves(study);
  ASSERT_EQ(curves.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(curves[i].record, i == 0 ? "north" : "south");
    EXPECT_EQ(curves[i].levels, hunt(i).levels);
    EXPECT_EQ(curves[i].responses, hunt(i).responses);
    EXPECT_EQ(curves[i].without_solution, hunt(i).without_solution);
    EXPECT_EQ(curves[i].response_limit, 1.5);
  }
}

TEST(IdaCurves, OfFixedLevelsLeaveOutCasesWithoutSolution) {
  const StudyResult study = run_study(
      {{.name = "Sa", .unit = "g", .values = {0.2, 0.1, 0.3}}, StudyAxis::of_names("record", {"north", "south"})},
      [](const StudyCase& each) {
        if (each.position("record") == 1 && each.position("Sa") == 2)
          throw ConvergenceError{"stuck", 0.0, 0.0, 0.0, ""};
        return StudyRecord{{"drift", "", "m", each.value("Sa") * (1.0 + each.value("record"))}};
      },
      {.keep_failures = true});
  const std::vector<IdaCurve> curves = ida_curves(study, "Sa", "drift", "");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].levels, (std::vector{0.1, 0.2, 0.3}));
  EXPECT_EQ(curves[1].levels, (std::vector{0.1, 0.2}));
  EXPECT_EQ(curves[1].responses, (std::vector{0.2, 0.4}));
  EXPECT_EQ(curves[1].without_solution, (std::vector{0.3}));
  const std::vector<IdaFractiles> fractiles = ida_fractiles(curves);
  EXPECT_EQ(fractiles.back().records, 1u);
  EXPECT_EQ(fractiles.back().without_solution, 1u);
}

/// A storey that keeps 0.8 MN/m after 0.4 MN, of which its weight takes 1.6 MN/m: under a pull of 2 m/s^2 it falls, and
/// under 0.3 m/s^2 it does not yield. The sturdy one has no weight. `end`: 60 s until it is far down, 6 s until it
/// leans.
StudyResult study_of_falling_storeys(Time end) {
  using namespace units;
  return run_study(
      {{.name = "pull", .unit = "m/s^2", .values = {0.3, 2.0}}, StudyAxis::of_names("storey", {"a", "b", "sturdy"})},
      [](const StudyCase& each) {
        StudyModel one{Model{}, testing::constant_acceleration(each.value("pull"), 60 * s)};
        const NodeId floor = add(one.model, Node{.name = "floor", .mass = 500 * tonne});
        add(one.model, Storey<YieldingStorey>{
                           .name = "storey",
                           .lower = ground,
                           .upper = floor,
                           .law = {.stiffness = 40 * MN / m, .yield_force = 0.4 * MN, .hardening_ratio = 0.02}});
        if (each.position("storey") < 2)
          add(one.model,
              Spring<PDelta>{
                  .name = "weight", .lower = ground, .upper = floor, .law = {.weight = 4.9 * MN, .height = 3 * m}});
        return one;
      },
      {.transient = {.end = end}});
}

TEST(IdaCurves, OfFixedLevelsAreInfiniteWhereTheModelCollapsed) {
  using namespace units;
  for (const Time end : {60 * s, 6 * s})
    for (const char* quantity : {"drift", "absolute_acceleration"}) {
      const StudyResult study = study_of_falling_storeys(end);
      const std::string where = std::string{quantity} == "drift" ? "storey" : "floor";
      EXPECT_EQ(study.values("collapsed", ""), (std::vector{0.0, 0.0, 0.0, 1.0, 1.0, 0.0}));
      EXPECT_GT(study.values("drift", "storey")[3], 3.0);
      const std::vector<IdaCurve> curves = ida_curves(study, "pull", quantity, where);
      ASSERT_EQ(curves.size(), 3u);
      for (const IdaCurve& curve : curves) {
        EXPECT_TRUE(std::isfinite(curve.responses[0]));
        EXPECT_EQ(std::isinf(curve.responses[1]), curve.record != "sturdy") << curve.record;
      }
      const std::vector<IdaFractiles> fractiles = ida_fractiles(curves);
      EXPECT_TRUE(std::isfinite(fractiles[0].high));
      EXPECT_TRUE(std::isinf(fractiles[1].median)) << "2 of 3 fell";
      EXPECT_EQ(fractiles[1].records, 3u);
      for (const KnownInterval& capacity : {capacities(curves, 1e6)[0], capacities(curves, 1e6)[1]}) {
        EXPECT_EQ(capacity.above, 0.3);
        EXPECT_EQ(capacity.up_to, 2.0);
      }
      const Chart chart = ida_chart(curves, "IDA", "pull", quantity);
      EXPECT_EQ(chart.series[0].x, (std::vector{0.3})) << "it ends where the storey fell";
      EXPECT_NO_THROW((void)svg_text({chart}));
    }
}

TEST(IdaFractiles, AreInfiniteWhereMoreThanTheirShareCollapsed) {
  // At level 2 the share of the collapsed grows with the number of curves that end there.
  for (int fallen = 0; fallen <= 100; ++fallen) {
    std::vector<IdaCurve> curves;
    for (int i = 0; i <= 100; ++i)
      curves.push_back({.record = "r", .levels = {1.0, 2.0}, .responses = {1.0, i < fallen ? INFINITY : 2.0}});
    const IdaFractiles at = ida_fractiles(curves).back();
    EXPECT_EQ(at.records, 101u);
    EXPECT_EQ(std::isinf(at.low), fallen > 84) << fallen;
    EXPECT_EQ(std::isinf(at.median), fallen > 50) << fallen;
    EXPECT_EQ(std::isinf(at.high), fallen > 16) << fallen;
  }
}

TEST(IdaFractiles, StayInfiniteAboveACollapse) {
  // Level 3 belongs to the second curve alone; the first stands again at 4, and the third ends.
  const std::vector<IdaCurve> curves{{.record = "a", .levels = {1.0, 2.0, 4.0}, .responses = {1.0, INFINITY, 5.0}},
                                     {.record = "b", .levels = {1.0, 3.0}, .responses = {1.0, 3.0}},
                                     {.record = "c", .levels = {1.0, 2.0}, .responses = {1.0, INFINITY}}};
  const std::vector<IdaFractiles> fractiles = ida_fractiles(curves);
  ASSERT_EQ(fractiles.size(), 4u);
  EXPECT_EQ(fractiles[2].records, 3u);
  EXPECT_TRUE(std::isinf(fractiles[2].median));
  EXPECT_EQ(fractiles[3].records, 2u) << "the second has no response there";
  EXPECT_TRUE(std::isinf(fractiles[3].high));
}

TEST(IdaFractiles, AreThoseOfTheResponses) {
  std::vector<IdaCurve> curves;
  for (int i = 0; i <= 100; ++i)
    curves.push_back({.record = "r", .levels = {1.0, 3.0}, .responses = {i / 100.0, 2.0 + i / 100.0}});
  curves.push_back({.record = "between", .levels = {2.0}, .responses = {1.5}});
  const std::vector<IdaFractiles> fractiles = ida_fractiles(curves);
  ASSERT_EQ(fractiles.size(), 3u);
  EXPECT_NEAR(fractiles[0].low, 0.16, 1e-12);
  EXPECT_NEAR(fractiles[0].median, 0.5, 1e-12);
  EXPECT_NEAR(fractiles[0].high, 0.84, 1e-12);
  EXPECT_EQ(fractiles[1].level, 2.0);
  EXPECT_EQ(fractiles[1].records, 102u) << "interpolated between 1 and 3";
  EXPECT_NEAR(fractiles[1].median, 1.5, 0.01);
}

TEST(IdaFractiles, CountRecordsThatExceededTheirLimitBelow) {
  std::vector<IdaCurve> curves(4, {.record = "r", .levels = {1.0, 2.0}, .responses = {1.0, 2.0}});
  curves[0].response_limit = 1.5;                                                        // ended above it
  curves[1] = {.record = "r", .levels = {1.0, 2.0, 4.0}, .responses = {1.0, 2.0, 3.0}};  // goes on
  curves[2].levels = curves[2].responses = {1.0, 2.0, 4.0};                              // goes on
  curves[3].without_solution = {3.0};                                                    // ended without a solution
  const std::vector<IdaFractiles> fractiles = ida_fractiles(curves);
  ASSERT_EQ(fractiles.back().level, 4.0);
  EXPECT_EQ(fractiles.back().records, 3u);
  EXPECT_EQ(fractiles.back().median, 4.0) << "of 3, 4 and infinity";
  EXPECT_TRUE(std::isinf(fractiles.back().high));
}

}  // namespace
}  // namespace moat
