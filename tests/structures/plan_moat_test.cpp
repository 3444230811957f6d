// Moats in plan: which corners meet which walls, flexible walls, refusals.
#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "ended_case.hpp"
#include "free_slabs.hpp"
#include "message_of.hpp"
#include "small_models.hpp"

namespace moat {
namespace {

using namespace units;
using testing::add_slab;
using testing::contacts_of;
using testing::law;
using testing::message_of;
using testing::restitution;
using testing::run_to_end;
using testing::still_ground;

TEST(PlanMoat, CornersMeetTheWallsOfTheirSides) {
  Model model;
  const DiaphragmId base = add_slab(model, "base", rectangle(20 * m, 12 * m));
  add(model, PlanMoat{.around = base, .clearance = 25 * cm, .law = law()});
  EXPECT_EQ(contacts_of(model),
            (std::set<std::string>{"moat wall 1 corner 1", "moat wall 1 corner 2", "moat wall 2 corner 2",
                                   "moat wall 2 corner 3", "moat wall 3 corner 3", "moat wall 3 corner 4",
                                   "moat wall 4 corner 4", "moat wall 4 corner 1"}));
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; block->kind().contacts && e < block->size(); ++e)
      EXPECT_NEAR(block->info(e).offset, 0.25, 1e-12);
}

TEST(PlanMoat, CornersDoNotMeetWallsBehindTheirBody) {
  // 0.5 m deep: the wall behind is within reach, but other corners are nearer to it.
  Model model;
  const DiaphragmId base = add_slab(model, "base", rectangle(20 * m, 0.5 * m));
  add(model, PlanMoat{.around = base, .clearance = 25 * cm, .law = law()});
  EXPECT_EQ(contacts_of(model).size(), 8U);
  EXPECT_FALSE(contacts_of(model).contains("moat wall 1 corner 3"));
  // A base turned inside straight walls: each wall has the one corner that can hit it.
  Model turned_base;
  const double half = 5.0 * std::sqrt(2.0);
  const DiaphragmId diamond = add_slab(turned_base, "base", turned(rectangle(10 * m, 10 * m), pi / 4));
  add(turned_base,
      PlanMoat{.around = diamond, .walls = rectangle(2.1 * half * m, 2.1 * half * m), .law = law(), .reach = 20 * m});
  EXPECT_EQ(contacts_of(turned_base).size(), 4U);
}

TEST(PlanMoat, FaceLawAtManyPointsIsTheLawOnALine) {
  for (const int points : {0, 3, 5}) {
    Model plan, line;
    const DiaphragmId base = add_slab(plan, "base", rectangle(20 * m, 12 * m), 0.5 * m / s);
    add(plan, PlanMoat{.around = base,
                       .clearance = 1 * cm,
                       .law = law(),
                       .friction = 0.5,
                       .share = Share::per_face,
                       .points_per_face = points});
    const NodeId body = add(line, Node{.name = "base", .mass = 800 * tonne, .initial_velocity = 0.5 * m / s});
    add(line, Moat{.around = body, .clearance = 1 * cm, .law = law()});
    const CaseOptions options{.transient = {.step = 1 * ms}, .error_bars = ErrorBarMode::never};
    const auto [in_plan, state] = run_to_end(plan, still_ground(1 * s, 5 * ms), options);
    const auto [on_line, state_on_line] = run_to_end(line, still_ground(1 * s, 5 * ms), options);
    const auto at_once = static_cast<std::size_t>(std::max(points, 2));
    ASSERT_EQ(in_plan.impacts.size(), at_once * on_line.impacts.size());
    EXPECT_NEAR(state.velocity(base.x) / state_on_line.velocity(body), 1.0, 1e-9) << points;
    // Restitution is the same for any stiffness, the duration is not.
    for (std::size_t i = 0; i < in_plan.impacts.size(); ++i)
      EXPECT_NEAR(in_plan.impacts[i].duration, on_line.impacts[i / at_once].duration, 1e-7) << points;
    EXPECT_NEAR(state.velocity(base.r), 0.0, 1e-12);
  }
}

TEST(PlanMoat, FlexibleWallsAreThoseOfTheLine) {
  const FlexibleWall wall{.mass = 200 * tonne, .stiffness = 300 * MN / m, .damping = 2 * MN * s / m};
  Model plan, line;
  const double angle = 0.4;
  const DiaphragmId base = add_slab(plan, "base", turned(rectangle(20 * m, 12 * m), angle),
                                    0.5 * std::cos(angle) * m / s, 0.5 * std::sin(angle) * m / s);
  add(plan, PlanMoat{.around = base, .clearance = 1 * cm, .law = law(), .share = Share::per_face, .wall = wall});
  const NodeId body = add(line, Node{.name = "base", .mass = 800 * tonne, .initial_velocity = 0.5 * m / s});
  add(line, Moat{.around = body, .clearance = 1 * cm, .law = law(), .wall = wall});
  const CaseOptions options{.transient = {.step = 0.5 * ms, .force_tolerance = 1e-12},
                            .error_bars = ErrorBarMode::never};
  const auto [in_plan, state] = run_to_end(plan, still_ground(1 * s, 5 * ms), options);
  const auto [on_line, state_on_line] = run_to_end(line, still_ground(1 * s, 5 * ms), options);
  EXPECT_EQ(in_plan.impacts.size(), 2 * on_line.impacts.size());
  const double along = std::cos(angle) * state.velocity(base.x) + std::sin(angle) * state.velocity(base.y);
  EXPECT_NEAR(along, state_on_line.velocity(body), 1e-9);
  const auto wall_peak = [](const CaseResult& result) {
    double largest = 0.0;
    for (const Peak& peak : result.peaks)
      if (peak.quantity == "wall_force") largest = std::max(largest, peak.magnitude());
    return largest;
  };
  EXPECT_NEAR(wall_peak(in_plan) / wall_peak(on_line), 1.0, 1e-9);
}

TEST(PlanMoat, WallCornerThatPointsInwardsHitsTheBase) {
  // A pier in the wall on the right: its two corners face the right edge of the base.
  Model model;
  const DiaphragmId base = add_slab(model, "base", rectangle(10 * m, 10 * m), 0.5 * m / s);
  PlanOutline walls;
  for (const PlanVector& p : {PlanVector{-6, -6}, {6, -6}, {6, -1}, {5.1, -1}, {5.1, 1}, {6, 1}, {6, 6}, {-6, 6}})
    walls.corners.push_back({p.x * m, p.y * m});
  add(model, PlanMoat{.around = base, .walls = walls, .law = law()});
  const auto [result, state] = run_to_end(model, still_ground(1 * s, 5 * ms), {.error_bars = ErrorBarMode::never});
  ASSERT_EQ(result.impacts.size(), 2U);
  EXPECT_EQ(result.impacts[0].corner, "moat corner 4");
  EXPECT_EQ(result.impacts[0].edge, "base edge 2");
  EXPECT_NEAR(state.velocity(base.x), -restitution * 0.5, 1e-3);
  EXPECT_NEAR(state.velocity(base.r), 0.0, 1e-9);
}

TEST(PlanMoat, BadInputIsRefused) {
  const auto message = [](auto change) {
    return message_of([&] {
      Model model;
      const DiaphragmId base = add_slab(model, "base", rectangle(20 * m, 12 * m));
      PlanMoat<ExactHertzDamp> moat{.around = base, .clearance = 25 * cm, .law = law()};
      change(moat);
      add(model, moat);
    });
  };
  using Moat = PlanMoat<ExactHertzDamp>;
  const auto walls = [](Length x, Length y) { return rectangle(x, y); };
  EXPECT_EQ(message([](Moat&) {}), "nothing was thrown");
  EXPECT_EQ(message([](Moat& moat) { moat.clearance = 1.2 * m; }),
            "PlanMoat \"moat\": clearance = 1.2 m is not allowed; it must be at most the reach, 1 m. No corner would "
            "meet a wall: give a longer .reach.");
  EXPECT_EQ(message([](Moat& moat) { moat.clearance = {}; }),
            "PlanMoat \"moat\": clearance is not given. Give the free distance at rest, or .walls.");
  EXPECT_EQ(message([](Moat& moat) { moat.clearance = -1 * cm; }),
            "PlanMoat \"moat\": clearance = -0.01 m is not allowed; it must be >= 0 m and finite. Give the free "
            "distance at rest, 0 m for wall to wall.");
  EXPECT_EQ(message([&](Moat& moat) {
              moat.clearance = {};
              moat.walls = walls(19.99 * m, 13 * m);
            }),
            "PlanMoat \"moat\": overlap at rest: corner 1 of \"base\", at (-10, -6) m, is not inside the walls. Give "
            "walls around the outline, or along it for wall to wall.");
  EXPECT_NE(message([&](Moat& moat) {
              moat.clearance = {};
              moat.walls = walls(18 * m, 13 * m);
            }).find("overlap at rest: corner 1 of \"base\""),
            std::string::npos);
  EXPECT_NE(message([&](Moat& moat) {
              moat.clearance = {};
              moat.walls = walls(30 * m, 30 * m);
            }).find("no corner of \"base\" is within reach of a wall. Give a longer .reach (now 1 m)"),
            std::string::npos);
  EXPECT_NE(message([&](Moat& moat) { moat.walls = walls(21 * m, 13 * m); }).find("both .clearance and .walls"),
            std::string::npos);
  EXPECT_EQ(
      message([](Moat& moat) { moat.friction = 1.2; }),
      "CornerGap \"moat wall 1 corner 1\": friction = 1.2 is not allowed; it must be from 0 to 1. Concrete on concrete "
      "has 0.4 to 0.6, steel 0.2 to 0.3.");
  EXPECT_NE(message([](Moat& moat) { moat.points_per_face = 2; }).find("points_per_face = 2"), std::string::npos);

  // A face with a recess has more than two corners in reach of its wall.
  EXPECT_EQ(
      message_of([&] {
        Model model;
        PlanOutline recessed;
        for (const PlanVector& p : {PlanVector{0, 0}, {10, 0}, {10, 4}, {9.8, 4}, {9.8, 8}, {10, 8}, {10, 12}, {0, 12}})
          recessed.corners.push_back({p.x * m, p.y * m});
        add(model, PlanMoat{.around = add_slab(model, "base", recessed),
                            .walls = rectangle(10.2 * m, 12.2 * m, {5 * m, 6 * m}),
                            .law = law(),
                            .share = Share::per_face});
      }),
      "PlanMoat \"moat\": 4 corners of \"base\" face wall 2, which has its law per face. Give .points_per_face, or "
      ".share = Share::per_corner.");
}

TEST(PlanMoat, WallToWallMeetsAsIfApart) {
  const auto contacts = [](Length clearance, Angle angle) {
    Model model;
    add(model, PlanMoat{.around = add_slab(model, "base", turned(rectangle(20 * m, 12 * m, {7 * m, 3 * m}), angle)),
                        .clearance = clearance,
                        .law = law()});
    return contacts_of(model);
  };
  for (const double degrees : {0.0, 17.0, 45.0, 133.0})
    EXPECT_EQ(contacts(0 * m, degrees * deg), contacts(1 * mm, degrees * deg)) << degrees;
}

}  // namespace
}  // namespace moat
