// Neighbours in plan: which corners and columns meet which edges, impulses, refusals.
#include "structures/neighbours/plan_neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "ended_case.hpp"
#include "free_slabs.hpp"
#include "materials/impact/exact_hertz_damp.hpp"
#include "message_of.hpp"
#include "peak_in.hpp"
#include "small_models.hpp"
#include "structures/plan_building.hpp"

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

TEST(PlanNeighbours, EqualFacesCountOnce) {
  Model model;
  const DiaphragmId a = add_slab(model, "a", rectangle(10 * m, 8 * m), 0.6 * m / s),
                    b = add_slab(model, "b", rectangle(10 * m, 8 * m, {10.1 * m, 0 * m}));
  add(model, PlanNeighbours{.first = a, .second = b, .law = law(), .friction = 0.3});
  EXPECT_EQ(contacts_of(model),
            (std::set<std::string>{"neighbours a corner 2 b edge 4", "neighbours a corner 3 b edge 4"}));
  const auto [result, state] = run_to_end(model, still_ground(1 * s, 5 * ms), {.error_bars = ErrorBarMode::never});
  EXPECT_EQ(result.impacts.size(), 2U);
  // Equal masses: v' = v (1 -+ e)/2.
  EXPECT_NEAR(state.velocity(a.x), 0.3 * (1.0 - restitution), 6e-4);
  EXPECT_NEAR(state.velocity(b.x), 0.3 * (1.0 + restitution), 6e-4);
  EXPECT_NEAR(state.velocity(a.r), 0.0, 1e-12);
}

TEST(PlanNeighbours, CornersOfTheShorterFaceCount) {
  for (const bool short_first : {true, false}) {
    Model model;
    const DiaphragmId a = add_slab(model, "a", rectangle(10 * m, (short_first ? 4 : 8) * m)),
                      b = add_slab(model, "b", rectangle(10 * m, (short_first ? 8 : 4) * m, {10.1 * m, 0 * m}));
    add(model, PlanNeighbours{.first = a, .second = b, .law = law(), .reach = 0.5 * m});
    EXPECT_EQ(contacts_of(model),
              short_first
                  ? (std::set<std::string>{"neighbours a corner 2 b edge 4", "neighbours a corner 3 b edge 4"})
                  : (std::set<std::string>{"neighbours b corner 1 a edge 2", "neighbours b corner 4 a edge 2"}));
  }
}

TEST(PlanNeighbours, BodiesAtAnAngleExchangeTheImpulseOfTheirEffectiveMass) {
  // A diamond hits a rectangle with its corner, away from the centres: momentum, moment of momentum and restitution.
  Model model;
  const double side = 8.0 * std::sqrt(2.0);
  const DiaphragmId a = add_slab(model, "a", turned(rectangle(side * m, side * m), pi / 4), 0.6 * m / s, 0.1 * m / s),
                    b = add_slab(model, "b", rectangle(10 * m, 12 * m, {13.05 * m, -2 * m}));
  add(model, PlanNeighbours{.first = a, .second = b, .law = law()});
  const auto [result, state] =
      run_to_end(model, still_ground(1 * s, 5 * ms),
                 {.transient = {.tolerance = 1e-8, .steps_per_contact = 512}, .error_bars = ErrorBarMode::never});
  ASSERT_EQ(result.impacts.size(), 1U);
  const double mass = 8e5, inertia_b = mass * (100.0 + 144.0) / 12.0, arm_b = 2.0;
  const double normal_mass = 1.0 / (2.0 / mass + arm_b * arm_b / inertia_b);
  const double impulse = normal_mass * (1.0 + restitution) * 0.6;
  EXPECT_NEAR(state.velocity(a.x), 0.6 - impulse / mass, 1e-5);
  EXPECT_NEAR(state.velocity(b.x), impulse / mass, 1e-5);
  EXPECT_NEAR(state.angular_velocity(a), 0.0, 1e-9);
  EXPECT_NEAR(state.angular_velocity(b), -impulse * arm_b / inertia_b, 1e-6);
  EXPECT_NEAR(result.impacts[0].rebound_ratio, restitution, 1e-4);
}

TEST(PlanNeighbours, OverlapIsRefused) {
  const auto refusal = [](Length x, Length y, PlanPosition centre) {
    Model model;
    const DiaphragmId a = add_slab(model, "a", rectangle(10 * m, 8 * m)),
                      b = add_slab(model, "b", rectangle(x, y, centre));
    return message_of([&] { add(model, PlanNeighbours{.first = a, .second = b, .law = law()}); });
  };
  const std::string message =
      "PlanNeighbours \"neighbours\": overlap at rest: the outlines of \"a\" and \"b\" cross each other. Move one of "
      "them away, until they touch at most.";
  EXPECT_EQ(refusal(10 * m, 8 * m, {9 * m, 0 * m}), message);
  EXPECT_EQ(refusal(10 * m, 8 * m, {}), message) << "the same place";
  EXPECT_EQ(refusal(10 * m, 6 * m, {0 * m, 1 * m}), message) << "inside, along three edges";
  EXPECT_EQ(refusal(2 * m, 20 * m, {}), message) << "a cross";
  EXPECT_EQ(refusal(10 * m, 8 * m, {10 * m - 1e-6 * m, 0 * m}), message);
  EXPECT_EQ(refusal(10 * m, 8 * m, {10 * m, 0 * m}), "nothing was thrown") << "wall to wall";
  EXPECT_EQ(refusal(10 * m, 8 * m, {10 * m, 8 * m}), "nothing was thrown") << "corner to corner";
}

// Wall to wall the same corners meet the same edges as a little apart, turned as well.
TEST(PlanNeighbours, WallToWallMeetAsIfApart) {
  for (const double degrees : {0.0, 17.0, 45.0, 133.0}) {
    SCOPED_TRACE(degrees);
    const auto contacts = [&](Length gap, Length x, Length y) {
      Model model;
      const PlanOutline first = rectangle(10 * m, 8 * m), second = rectangle(x, y, {5 * m + 0.5 * x + gap, 0.5 * m});
      add(model, PlanNeighbours{.first = add_slab(model, "a", turned(first, degrees * deg)),
                                .second = add_slab(model, "b", turned(second, degrees * deg)),
                                .law = law()});
      for (const auto& block : model.blocks())
        for (std::size_t e = 0; block->kind().contacts && e < block->size(); ++e)
          EXPECT_EQ(block->info(e).offset == 0.0, gap == 0 * m);
      return contacts_of(model);
    };
    EXPECT_EQ(contacts(0 * m, 10 * m, 8 * m), contacts(1 * mm, 10 * m, 8 * m));
    EXPECT_EQ(contacts(0 * m, 6 * m, 12 * m), contacts(1 * mm, 6 * m, 12 * m));
  }
}

// An impulse at a point of a column acts on both floors with its arms there: nine weights with the floor that hits it.
TEST(PlanNeighbours, ColumnMovesWithTheFloorsAboveAndBelow) {
  for (const bool on_ground : {false, true}) {
    SCOPED_TRACE(on_ground);
    Model model;
    const DiaphragmId ram = add(model, Diaphragm{.name = "ram",
                                                 .mass = 800 * tonne,
                                                 .outline = rectangle(10 * m, 8 * m),
                                                 .initial_velocity_x = 0.6 * m / s,
                                                 .height = 3 * m}),
                      lower = add(model, Diaphragm{.name = "lower",
                                                   .mass = 500 * tonne,
                                                   .rotary_inertia = 6e6 * kg * m * m,
                                                   .centre_of_mass = {8 * m, 1 * m},
                                                   .outline = rectangle(6 * m, 10 * m, {8.05 * m, 1 * m}),
                                                   .free = true,
                                                   .height = 1 * m}),
                      upper = add(model, Diaphragm{.name = "upper",
                                                   .mass = 300 * tonne,
                                                   .rotary_inertia = 4e6 * kg * m * m,
                                                   .centre_of_mass = {8.5 * m, 2 * m},
                                                   .outline = rectangle(6 * m, 10 * m, {8.05 * m, 1 * m}),
                                                   .free = true,
                                                   .height = 6 * m});
    const double share = on_ground ? 0.5 : 0.4;  // of the upper floor at 3 m
    BuildingLevels tower =
        on_ground ? Building{.name = "tower", .floors = {upper}} : Building{.name = "tower", .floors = {lower, upper}};
    const std::vector<PlanPosition> columns{{5.05 * m, 1.5 * m}};
    tower.columns = {columns, columns};
    const NeighbourGaps gaps = add(model, PlanNeighbours{.first = ram, .second = tower, .law = law()});
    const std::string storey = on_ground ? "tower storey 1" : "tower storey 2";
    ASSERT_EQ(gaps.names, (std::vector<std::string>{"neighbours " + storey + " column 1 ram edge 2"}));
    for (const auto& block : model.blocks())
      for (const ElementInfo& info : block->infos()) {
        ASSERT_NE(info.member_ends(), nullptr);
        EXPECT_EQ(info.member_ends()->first, MemberPoint{ram.x});
        EXPECT_NEAR(info.member_ends()->second.share, on_ground ? 1.0 - share : share, 1e-12);
        EXPECT_NEAR(info.member_ends()->height, 3.0, 1e-12);
        EXPECT_NEAR(info.offset, 0.05, 1e-12);
      }
    const auto [result, state] =
        run_to_end(model, still_ground(1 * s, 5 * ms),
                   {.transient = {.tolerance = 1e-8, .steps_per_contact = 512}, .error_bars = ErrorBarMode::never});
    ASSERT_EQ(result.impacts.size(), 1U);
    EXPECT_NEAR(result.impacts[0].rebound_ratio, restitution, 1e-4);
    const double of_lower = on_ground ? 0.0 : 1.0 - share, ram_inertia = 8e5 * (100.0 + 64.0) / 12.0;
    const double ram_arm = 1.5, lower_arm = 0.5, upper_arm = -0.5;  // m, along y
    const double mobility = 1.0 / 8e5 + ram_arm * ram_arm / ram_inertia +
                            of_lower * of_lower * (1.0 / 5e5 + lower_arm * lower_arm / 6e6) +
                            share * share * (1.0 / 3e5 + upper_arm * upper_arm / 4e6);
    const double impulse = (1.0 + restitution) * 0.6 / mobility;
    EXPECT_NEAR(state.velocity(ram.x), 0.6 - impulse / 8e5, 1e-5);
    EXPECT_NEAR(state.angular_velocity(ram), ram_arm * impulse / ram_inertia, 1e-6);
    EXPECT_NEAR(state.velocity(lower.x), of_lower * impulse / 5e5, 1e-5);
    EXPECT_NEAR(state.angular_velocity(lower), -lower_arm * of_lower * impulse / 6e6, 1e-6);
    EXPECT_NEAR(state.velocity(upper.x), share * impulse / 3e5, 1e-5);
    EXPECT_NEAR(state.angular_velocity(upper), -upper_arm * share * impulse / 4e6, 1e-6);
    EXPECT_NEAR(state.velocity(upper.y), 0.0, 1e-12);
  }
}

// Floors at 3 and 6 m beside floors at 4 and 8 m; `side` is -1 for the mirror image about the x axis.
struct TwoBuildings {
  Model model;
  PlanBuildingParts a, b;

  explicit TwoBuildings(double side, std::optional<PlanColumns> columns_of_b = {}, Length gap = 5 * cm) {
    a = add(model, PlanBuilding{.name = "a",
                                .outline = rectangle(12 * m, 10 * m),
                                .storeys = 2,
                                .floor_mass = 300 * tonne,
                                .mass_offset = {0.5 * m, side * 0.8 * m},
                                .columns = grid(3, 3, {.stiffness = 30 * MN / m}),
                                .storey_height = 3 * m});
    b = add(model, PlanBuilding{.name = "b",
                                .outline = rectangle(10 * m, 10 * m, {11 * m + gap, side * 0.9 * m}),
                                .storeys = 2,
                                .floor_mass = 250 * tonne,
                                .mass_offset = {-0.3 * m, -side * 0.5 * m},
                                .columns = columns_of_b.value_or(grid(2, 3, {.stiffness = 90 * MN / m})),
                                .storey_height = 4 * m});
  }
  NeighbourGaps join(Length reach = 1 * m) {
    return add(model,
               PlanNeighbours{.name = "joint", .first = a, .second = b, .law = law(), .friction = 0.3, .reach = reach});
  }
};

TEST(PlanNeighbours, FloorsMeetTheNearestRowOfColumns) {
  const std::set<std::string> expected{
      "joint b storey 1 column 1 a floor 1 edge 2", "joint b storey 1 column 3 a floor 1 edge 2",
      "joint b storey 1 column 5 a floor 1 edge 2", "joint b storey 2 column 1 a floor 2 edge 2",
      "joint b storey 2 column 3 a floor 2 edge 2", "joint b storey 2 column 5 a floor 2 edge 2",
      "joint a storey 2 column 3 b floor 1 edge 4", "joint a storey 2 column 6 b floor 1 edge 4",
      "joint a storey 2 column 9 b floor 1 edge 4"};
  for (const Length reach : {1 * m, 20 * m}) {
    TwoBuildings two{1.0};
    EXPECT_EQ(two.join(reach).names.size(), expected.size());
    EXPECT_EQ(contacts_of(two.model), expected);
  }
  // Without positions of columns the corners of the floor above stand for them.
  TwoBuildings whole{1.0, StoreyStiffness{.x = 1e9 * N / m, .y = 1e9 * N / m, .rotation = 1e11 * N * m}};
  const NeighbourGaps gaps = whole.join();
  EXPECT_EQ(gaps.names, (std::vector<std::string>{
                            "joint b storey 1 corner 1 a floor 1 edge 2", "joint b storey 1 corner 4 a floor 1 edge 2",
                            "joint a storey 2 column 3 b floor 1 edge 4", "joint a storey 2 column 6 b floor 1 edge 4",
                            "joint a storey 2 column 9 b floor 1 edge 4", "joint b storey 2 corner 1 a floor 2 edge 2",
                            "joint b storey 2 corner 4 a floor 2 edge 2"}));
  EXPECT_EQ(gaps.notes, (std::vector<std::string>{
                            "joint: 7 gaps are those of floors against columns, with the law of slabs. A "
                            "column is softer than a slab, and its shear is not checked: give .column_law."}));
}

TEST(PlanNeighbours, MirrorImagesMoveAsMirrorImages) {
  const auto run = [](double side, TwoBuildings& two) {
    two.join();
    std::vector<double> x, y;
    for (int i = 0; i < 200; ++i) {
      x.push_back(6.0 * std::sin(0.09 * i));
      y.push_back(side * 4.0 * std::sin(0.13 * i));
    }
    const GroundMotion along_x{"x", 0.01, x};
    return run_to_end(two.model, along_x.with_component_y(y, along_x, {"y", 0.01, y}),
                      {.transient = {.step = 0.5 * ms}, .error_bars = ErrorBarMode::never});
  };
  TwoBuildings two{1.0, {}, 2 * mm}, image{-1.0, {}, 2 * mm};
  const auto [result, state] = run(1.0, two);
  const auto [of_image, state_of_image] = run(-1.0, image);
  EXPECT_GT(result.impacts.size(), 3U);
  EXPECT_EQ(result.impacts.size(), of_image.impacts.size());
  for (const PlanBuildingParts* parts : {&two.a, &two.b})
    for (const DiaphragmId& floor : parts->floors) {
      EXPECT_NEAR(state.displacement(floor.x), state_of_image.displacement(floor.x), 1e-9);
      EXPECT_NEAR(state.displacement(floor.y), -state_of_image.displacement(floor.y), 1e-9);
      EXPECT_NEAR(state.rotation(floor), -state_of_image.rotation(floor), 1e-9);
      const std::string& name = two.model.diaphragm(floor).name;
      EXPECT_NEAR(testing::peak(result, "absolute_acceleration_x", name) /
                      testing::peak(of_image, "absolute_acceleration_x", name),
                  1.0, 1e-6);
    }
}

TEST(PlanNeighbours, EqualLevelsMeetWithTheirCornersAndFarOnesAreNamed) {
  Model model;
  const auto floor = [&](const std::string& name, Length x, Length height) {
    return add(model, Diaphragm{.name = name,
                                .mass = 100 * tonne,
                                .centre_of_mass = {x, {}},
                                .outline = rectangle(10 * m, 8 * m, {x, {}}),
                                .height = height});
  };
  const DiaphragmId podium = floor("podium", 0 * m, 4 * m), tower = floor("tower", -5 * m, 8 * m),
                    lower = floor("lower", 10.1 * m, 4.2 * m), upper = floor("upper", 10.1 * m, 8 * m);
  const NeighbourGaps gaps = add(model, PlanNeighbours{.name = "joint",
                                                       .first = Building{.name = "a", .floors = {podium, tower}},
                                                       .second = Building{.name = "b", .floors = {lower, upper}},
                                                       .law = law(),
                                                       .column_law = law()});
  EXPECT_EQ(gaps.names,
            (std::vector<std::string>{"joint podium corner 2 lower edge 4", "joint podium corner 3 lower edge 4"}));
  EXPECT_EQ(gaps.notes,
            (std::vector<std::string>{
                "tower and upper at 8.00 m have no corner or column within reach of an edge of the other."}));
}

TEST(PlanNeighbours, BadInputIsRefused) {
  EXPECT_EQ(
      message_of([] {
        TwoBuildings{1.0, {}, -10 * cm}.join();
      }),
      "PlanNeighbours \"joint\": overlap at rest: column 1 of \"b storey 1\", at (5.9, -4.1) m, is inside \"a floor "
      "1\". Move one of the buildings away, until they touch at most.");
  EXPECT_EQ(message_of([] {
              TwoBuildings{1.0, {}, 2 * m}.join();
            }),
            "PlanNeighbours \"joint\": no corner of \"a\" and \"b\" is within reach of the other. Give a longer .reach "
            "(now 1 m).");
  Model model;
  const DiaphragmId a = add_slab(model, "a", rectangle(10 * m, 8 * m)),
                    bare = add(model, Diaphragm{.name = "bare", .mass = 1 * tonne, .size = {1 * m, 1 * m}}),
                    low = add(model,
                              Diaphragm{.name = "low", .mass = 1 * tonne, .size = {1 * m, 1 * m}, .height = 1 * m}),
                    high = add(model,
                               Diaphragm{.name = "high", .mass = 1 * tonne, .size = {1 * m, 1 * m}, .height = 9 * m});
  const auto message = [&](const BuildingLevels& second, const std::string& name = "joint") {
    return message_of([&] { add(model, PlanNeighbours{.name = name, .first = a, .second = second, .law = law()}); });
  };
  EXPECT_EQ(message(bare, ""), "PlanNeighbours: neighbours have no name. Give .name, or leave it out: \"neighbours\".");
  EXPECT_EQ(message(bare),
            "PlanNeighbours \"joint\": the diaphragm \"bare\" has no outline. Give Diaphragm::outline: its corners and "
            "edges hit the neighbour.");
  EXPECT_EQ(message(Building{.name = "tank", .base = low, .floors = {high}}),
            "PlanNeighbours \"joint\": no floor of \"a\" or \"tank\" is at the height of a floor or a column of the "
            "other. Check their heights; the ground meets nothing: give a PlanMoat around a base.");
  EXPECT_NE(message(DiaphragmId{}).find("a floor is not given"), std::string::npos);
}

}  // namespace
}  // namespace moat
