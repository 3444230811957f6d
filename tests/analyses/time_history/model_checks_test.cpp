// Models that an analysis refuses: bodies that nothing holds, and gaps that contradict each other.
#include "analyses/time_history/model_checks.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "analysis_testing.hpp"
#include "message_of.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;
using testing::still_ground;

constexpr const char* nothing = "nothing was thrown";
const Hertz hertz{.stiffness = 1e9 * N / m_3_2};

std::string refusal(const Model& model) {
  return message_of([&] { const Transient analysis{model, still_ground(0.1 * s)}; });
}

NodeId add_node(Model& model, const std::string& name, Mass mass = 100 * tonne) {
  return add(model, Node{.name = name, .mass = mass});
}

void add_spring(Model& model, NodeId lower, NodeId upper, Stiffness stiffness = 1 * MN / m) {
  const std::string name = std::string{model.node_name(lower)} + " to " + std::string{model.node_name(upper)};
  add(model, ShearSpring{.name = name, .lower = lower, .upper = upper, .stiffness = stiffness});
}

TEST(HeldBodies, AForgottenStoreyIsRefused) {
  Model model;
  const NodeId base = add_node(model, "base"), floor_1 = add_node(model, "floor 1"),
               floor_2 = add_node(model, "floor 2"), floor_3 = add_node(model, "floor 3");
  add_spring(model, ground, base);
  add_spring(model, base, floor_1);
  add_spring(model, floor_2, floor_3);
  const std::string message =
      "Model: floor 2 and floor 3 are held by nothing: no path of elements to the ground. Add the missing spring, "
      "storey "
      "or isolator; a gap holds nothing. Give .free = true where a body shall float.";
  EXPECT_EQ(refusal(model), message);
  EXPECT_EQ(message_of([&] { run_case(model, still_ground(0.1 * s)); }), message);
  EXPECT_EQ(message_of([&] { peaks_of(model, still_ground(0.1 * s)); }), message);
  add_spring(model, floor_1, floor_2);
  EXPECT_EQ(refusal(model), nothing);
}

TEST(HeldBodies, ALonelyNodeIsRefusedAndMayBeDeclaredFree) {
  const auto with = [](const Node& tank) {
    Model model;
    const NodeId body = add_node(model, "body");
    add_spring(model, ground, body);
    const NodeId other = add(model, tank);
    add(model, Gap{.name = "gap", .left = body, .right = other, .clearance = 1 * cm, .law = hertz});
    return refusal(model);
  };
  EXPECT_NE(with({.name = "tank", .mass = 10 * tonne}).find("tank is held by nothing"), std::string::npos)
      << "a gap holds nothing";
  EXPECT_EQ(with({.name = "tank", .mass = 10 * tonne, .free = true}), nothing);
  EXPECT_EQ(with({.name = "tank", .mass = 10 * tonne, .initial_velocity = 1 * m / s}), nothing);
}

TEST(HeldBodies, ManyBodiesAreCounted) {
  Model model;
  NodeId below = add_node(model, "floor 1");
  for (int i = 2; i <= 9; ++i) {
    const NodeId above = add_node(model, "floor " + std::to_string(i));
    add_spring(model, below, above);
    below = above;
  }
  EXPECT_EQ(refusal(model).find("Model: floor 1, floor 2, floor 3 and 6 more are held by nothing"), 0U);
}

// Stiffness does not count: every element but a gap holds, also one without tangent at rest.
TEST(HeldBodies, AnyElementHolds) {
  const auto held_by = [](const std::function<void(Model&, NodeId)>& hold) {
    Model model;
    hold(model, add_node(model, "body"));
    return refusal(model);
  };
  const auto by = [&](const auto& law) {
    return held_by([&](Model& model, NodeId body) {
      add(model, Spring<std::decay_t<decltype(law)>>{.name = "spring", .lower = ground, .upper = body, .law = law});
    });
  };
  EXPECT_EQ(by(Viscous{.damping = 1 * kN * s / m}), nothing);
  EXPECT_EQ(by(MaxwellDamper::typical()), nothing);
  EXPECT_EQ(by(NonlinearViscous::typical()), nothing);
  EXPECT_EQ(by(StiffeningSpring::typical()), nothing);
  EXPECT_EQ(by(HyperbolicBackfill::typical()), nothing);
  EXPECT_EQ(
      held_by([](Model& model, NodeId body) {
        add(model,
            LeadRubberBearing{
                .upper = body, .yield_force = 1 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 0 * N / m});
      }),
      nothing);
}

TEST(HeldBodies, LargeRatiosAreNoFault) {
  for (const double ratio : {1e-10, 1e10}) {
    Model model;
    const NodeId low = add_node(model, "low"), high = add_node(model, "high", ratio * 100 * tonne);
    add_spring(model, ground, low);
    add_spring(model, low, high, ratio * MN / m);
    EXPECT_EQ(refusal(model), nothing) << ratio;
  }
}

class HeldInPlan : public ::testing::Test {
 protected:
  DiaphragmId add_slab(const std::string& name, PlanPosition centre = {}) {
    return add(model, Diaphragm{.name = name, .mass = 100 * tonne, .size = {20 * m, 10 * m}, .centre_of_mass = centre});
  }
  void add_bearing(const std::string& name, DiaphragmId under, PlanPosition at) {
    add(model, PlanBearing<BiaxialBilinear>{
                   .name = name,
                   .under = under,
                   .at = at,
                   .law = {.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * MN / m}});
  }
  void add_column(const std::string& name, NodeId lower, DiaphragmId upper, PlanPosition at, PlanVector direction,
                  Stiffness stiffness = 1 * MN / m) {
    add(model, PlanSpring<Linear>{.name = name,
                                  .lower = PlanPoint{lower, at},
                                  .upper = PlanPoint{upper, at},
                                  .direction = direction,
                                  .law = {.stiffness = stiffness}});
  }

  Model model;
};

TEST_F(HeldInPlan, BearingsAtOnePointDoNotResistTurning) {
  for (const PlanPosition at : {PlanPosition{}, PlanPosition{3 * m, 1 * m}, PlanPosition{5e5 * m, 4e6 * m}}) {
    SCOPED_TRACE(at.x.si());
    model = {};
    const DiaphragmId base = add_slab("base", {at.x + 2 * m, at.y});
    add_bearing("one", base, at);
    add_bearing("two", base, at);
    const std::string message = refusal(model);
    EXPECT_EQ(message.find("Model: the bearings of base do not resist rotation: all stand at one point, ("), 0U)
        << message;
    EXPECT_NE(message.find(") m. Give bearings at two places at least. Give .free = true where a body shall float."),
              std::string::npos)
        << message;
    add_bearing("three", base, {at.x, at.y + 1 * cm});
    EXPECT_EQ(refusal(model), nothing);
  }
}

TEST_F(HeldInPlan, OneDirectionIsNotEnough) {
  const DiaphragmId base = add_slab("base");
  add_column("one", ground, base, {0 * m, -5 * m}, {1.0, 0.0});
  add_column("two", ground, base, {0 * m, 5 * m}, {1.0, 0.0});
  EXPECT_EQ(refusal(model).find("Model: base can move in plan"), 0U);
  add_column("three", ground, base, {0 * m, 5 * m}, {0.6, 0.8});
  EXPECT_EQ(refusal(model), nothing);
}

TEST_F(HeldInPlan, ASlabOnNothingIsRefusedAndMayBeDeclaredFree) {
  add_slab("base");
  EXPECT_EQ(refusal(model).find("Model: base is held by nothing: no path of elements to the ground."), 0U);
  model = {};
  add(model, Diaphragm{.name = "puck", .mass = 1 * tonne, .size = {1 * m, 1 * m}, .free = true});
  EXPECT_EQ(refusal(model), nothing);
  model = {};
  add(model, Diaphragm{.name = "puck", .mass = 1 * tonne, .size = {1 * m, 1 * m}, .initial_velocity_y = 1 * m / s});
  EXPECT_EQ(refusal(model), nothing);
}

// Floors that turn on the one below, though the base is held.
TEST_F(HeldInPlan, AnUpperFloorMustBeHeldToo) {
  const DiaphragmId base = add_slab("base"), floor = add_slab("floor");
  add_bearing("one", base, {5 * m, 0 * m});
  add_bearing("two", base, {-5 * m, 0 * m});
  add_column("x", base, floor, {3 * m, 2 * m}, {1.0, 0.0});
  add_column("y", base, floor, {3 * m, 2 * m}, {0.0, 1.0});
  EXPECT_EQ(refusal(model).find("Model: base and floor can move in plan"), 0U);
  add(model, RotationDamper{.name = "turning", .lower = base, .upper = floor, .damping = Quantity<1, 4, -1>{1.0}});
  EXPECT_EQ(refusal(model), nothing);
}

// Two floors, each held in one direction, that hold each other.
TEST_F(HeldInPlan, BodiesMayHoldEachOther) {
  const DiaphragmId a = add_slab("a"), b = add_slab("b");
  add_column("a x", ground, a, {0 * m, 2 * m}, {1.0, 0.0});
  add_column("b y", ground, b, {2 * m, 0 * m}, {0.0, 1.0});
  add_column("b turning", ground, b, {-2 * m, 0 * m}, {0.0, 1.0});
  for (const double x : {-1.0, 1.0}) {
    add_column("joint x " + std::to_string(x), a, b, {x * m, x * m}, {1.0, 0.0}, 1e10 * N / m);
    add_column("joint y " + std::to_string(x), a, b, {x * m, x * m}, {0.0, 1.0}, 1e10 * N / m);
  }
  EXPECT_EQ(refusal(model), nothing);
}

TEST_F(HeldInPlan, LargeRatiosAndTallBuildingsAreNoFault) {
  const DiaphragmId base = add_slab("base");
  add_column("x", ground, base, {9 * m, 5 * m}, {1.0, 0.0}, 1 * N / m);
  add_column("y", ground, base, {9 * m, 5 * m}, {0.0, 1.0}, 1 * N / m);
  add_column("turning", ground, base, {9.01 * m, 5 * m}, {0.0, 1.0}, 1e-3 * N / m);
  DiaphragmId below = base;
  for (int i = 1; i <= 300; ++i) {
    const DiaphragmId floor = add_slab("floor " + std::to_string(i));
    for (const double x : {-8.0, 8.0})
      for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}})
        add_column(std::to_string(i) + " " + std::to_string(x) + " " + std::to_string(direction.x), below, floor,
                   {x * m, x * m}, direction, 1e10 * N / m);
    below = floor;
  }
  EXPECT_EQ(message_of([&] { check_held(AnalysisState{model}); }), nothing);
}

// Gaps between two towers, beside each other or by their x.
std::string refusal_of_gaps(Length x, bool as_buildings, int floor_of_second, Length half_width = 5 * m) {
  Model model;
  const auto tower = [&](const std::string& name, Length at, Length half) {
    if (as_buildings)
      return add(model, ShearBuilding{.name = name,
                                      .storeys = 2,
                                      .floor_mass = 1 * tonne,
                                      .storey_stiffness = 1 * MN / m,
                                      .half_width = half,
                                      .x = at});
    Building floors;
    for (const char* floor : {" floor 1", " floor 2"}) {
      floors.floors.push_back(add(model, Node{.name = name + floor, .mass = 1 * tonne, .x = at, .half_width = half}));
      add_spring(model, ground, floors.floors.back());
    }
    return floors;
  };
  const Building a = tower("a", 0 * m, 5 * m), b = tower("b", x, half_width);
  add(model, Gap{.name = "one", .left = a.floor(1), .right = b.floor(1), .clearance = 1 * cm, .law = hertz});
  add(model, Gap{.name = "two",
                 .left = b.floor(floor_of_second),
                 .right = a.floor(floor_of_second),
                 .clearance = 1 * cm,
                 .law = hertz});
  return refusal(model);
}

TEST(GapDirections, OfTwoBuildingsMustAgree) {
  const std::string message =
      "Gap \"two\": it has \"b floor 2\" on the left of \"a floor 2\", but gap \"one\" has \"a floor 1\" on the left "
      "of "
      "\"b floor 1\". Exchange .left and .right of one of them. A body inside another one needs its .x and a smaller "
      ".half_width.";
  EXPECT_EQ(refusal_of_gaps(0 * m, true, 2), message);
  EXPECT_EQ(refusal_of_gaps(10.01 * m, true, 2), message);
  EXPECT_EQ(refusal_of_gaps(-10.01 * m, true, 2), message);
}

TEST(GapDirections, OfTwoNodesMustAgree) {
  EXPECT_EQ(refusal_of_gaps(0 * m, false, 1).find("Gap \"two\": it has \"b floor 1\" on the left of \"a floor 1\""),
            0U);
  EXPECT_EQ(refusal_of_gaps(0 * m, false, 2), nothing) << "other nodes, and the model knows no building";
}

TEST(GapDirections, ABuildingMayStandInACourtyard) {
  for (const bool as_buildings : {false, true})
    for (const int floor : {1, 2}) EXPECT_EQ(refusal_of_gaps(1 * m, as_buildings, floor, 2 * m), nothing);
  EXPECT_EQ(refusal_of_gaps(4 * m, true, 1, 2 * m).find("Gap \"two\""), 0U) << "it stands out of the courtyard";
}

TEST(MotionInPlan, IsRefusedByAModelOnALine) {
  Model line;
  add(line, Node{.name = "node", .mass = 1 * kg});
  const GroundMotion first = near_fault_pulse();
  EXPECT_NE(testing::message_of([&] {
              const Transient analysis{line, PlanMotion{first, first}};
            })
                .find("the motion has two components, and the model moves on a line. Give one component, or make the "
                      "model of diaphragms."),
            std::string::npos);
}

// Such a bearing would stay lifted for ever.
TEST(AxialForces, AreRefusedWhereNoBuildingGivesThem) {
  Model model;
  const NodeId base = add_node(model, "base");
  add_spring(model, ground, base);
  add(model, Isolator<FlatSlider>{.name = "slider",
                                  .upper = base,
                                  .law = {.friction = 0.1, .yield_displacement = 1 * mm},
                                  .weight = 1 * MN,
                                  .weight_changes = true});
  EXPECT_EQ(refusal(model),
            "Transient \"still ground\": the law of the element \"slider\" takes an axial force, and none acts on it: "
            "it would stay "
            "lifted. Give .axial_forces to its building, or a law under a constant weight.");
}

}  // namespace
}  // namespace moat
