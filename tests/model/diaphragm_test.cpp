// Diaphragms among the nodes of a model: inertia, kinematics, refusals.
#include "moat.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

TEST(Diaphragm, ScaledRotationHasTheMassAsInertia) {
  Model model;
  const DiaphragmId slab = add(model, Diaphragm{.name = "slab",
                                                .mass = 1.5e6 * kg,
                                                .size = {20 * m, 12 * m},
                                                .initial_displacement = {1 * cm, 2 * cm},
                                                .initial_rotation = 0.01,
                                                .initial_angular_velocity = 0.2 / s});
  const AnalysisState state{model};
  EXPECT_NEAR(model.diaphragm(slab).gyration, 6.733003292, 1e-9);
  for (const NodeId node : slab.degrees_of_freedom()) EXPECT_EQ(model.mass(node), 1.5e6);
  EXPECT_DOUBLE_EQ(state.displacement(slab.y), 0.02);
  EXPECT_DOUBLE_EQ(state.rotation(slab), 0.01);
  EXPECT_DOUBLE_EQ(state.angular_velocity(slab), 0.2);
  EXPECT_TRUE(model.is_plan());
  // The ground moves x by its first component, y by its second, and turns nothing.
  const GroundColumns influence = model.ground_influence();
  EXPECT_EQ(influence.times({3.0, 5.0}, slab.x.index), 3.0);
  EXPECT_EQ(influence.times({3.0, 5.0}, slab.y.index), 5.0);
  EXPECT_EQ(influence.times({3.0, 5.0}, slab.r.index), 0.0);
}

TEST(Diaphragm, RotaryInertiaIsGivenOrThatOfSizeOrOutline) {
  const auto gyration = [](Diaphragm diaphragm) {
    Model model;
    return model.diaphragm(add(model, diaphragm)).gyration;
  };
  const double expected = std::sqrt(544.0 / 12.0);
  EXPECT_NEAR(gyration({.name = "a", .mass = 7 * kg, .size = {20 * m, 12 * m}}), expected, 1e-12);
  EXPECT_NEAR(gyration({.name = "a", .mass = 7 * kg, .outline = rectangle(20 * m, 12 * m)}), expected, 1e-12);
  EXPECT_NEAR(gyration({.name = "a", .mass = 7 * kg, .rotary_inertia = 63 * kg * m * m}), 3.0, 1e-12);
}

TEST(Diaphragm, ForcesAtPointsHaveTheirMoments) {
  Model model;
  const DiaphragmId slab = add(model, Diaphragm{.name = "slab",
                                                .mass = 2 * kg,
                                                .rotary_inertia = 8 * kg * m * m,
                                                .centre_of_mass = {1 * m, 2 * m},
                                                .initial_displacement = {0.3 * m, 0.1 * m},
                                                .initial_rotation = 0.05});
  const PlanVector n{0.6, 0.8};
  add(model, PlanSpring<Linear>{.name = "spring",
                                .lower = PlanPoint{ground, {4 * m, 7 * m}},
                                .upper = PlanPoint{slab, {4 * m, 7 * m}},
                                .direction = {3.0, 4.0},
                                .law = {.stiffness = 10 * N / m}});
  const AnalysisState state{model};
  // Arm (3, 5): u_P = (0.3 - 5 * 0.05, 0.1 + 3 * 0.05).
  const double d = 0.05 * n.x + 0.25 * n.y, force = 10.0 * d, moment = force * (3.0 * n.y - 5.0 * n.x);
  EXPECT_NEAR(state.elements(0).results()[0].deformation, d, 1e-15);
  EXPECT_NEAR(state.internal_forces()[slab.x.index], force * n.x, 1e-14);
  EXPECT_NEAR(state.internal_forces()[slab.y.index], force * n.y, 1e-14);
  EXPECT_NEAR(state.internal_forces()[slab.r.index], moment / 2.0, 1e-14);
}

TEST(Diaphragm, BadInertiaIsRefused) {
  Model model;
  const auto message = [&](Diaphragm diaphragm) { return message_of([&] { add(model, diaphragm); }); };
  EXPECT_EQ(message({.name = "base", .mass = 1 * kg}),
            "Diaphragm \"base\": rotary_inertia = 0 kg m^2 is not allowed; it must be > 0 kg m^2 and finite. Give "
            ".rotary_inertia, or .size or .outline of a uniform floor.");
  EXPECT_EQ(
      message(
          {.name = "base", .mass = 1 * kg, .rotary_inertia = 200 * kg * m * m, .outline = rectangle(20 * m, 12 * m)}),
      "Diaphragm \"base\": rotary_inertia = 200 kg m^2 is not allowed; it must be at most mass times the squared "
      "distance of the farthest corner from the centre of mass, 136 kg m^2. Take it about the centre of mass: "
      "mass * (Lx^2 + Ly^2)/12 for a uniform rectangle.");
  // 2 kg at the corners of the size, a distance of sqrt(100 + 36) m away, would be 272 kg m^2.
  const auto of_size = [&](double inertia) {
    return message({.name = "slab", .mass = 2 * kg, .rotary_inertia = inertia * kg * m * m, .size = {20 * m, 12 * m}});
  };
  EXPECT_NE(of_size(272.1).find("farthest corner from the centre of mass, 272 kg m^2"), std::string::npos);
  EXPECT_EQ(of_size(271.9), "nothing was thrown");
  EXPECT_NE(message({.name = "base", .mass = 0 * kg, .size = {1 * m, 1 * m}}).find("mass = 0 kg is not allowed"),
            std::string::npos);
}

TEST(Diaphragm, LineAndPlanDoNotMix) {
  Model line;
  add(line, Node{.name = "node", .mass = 1 * kg});
  EXPECT_EQ(
      message_of([&] {
        add(line, Diaphragm{.name = "slab", .mass = 1 * kg, .size = {1 * m, 1 * m}});
      }),
      "Diaphragm \"slab\": the model has the node \"node\", which moves on a line. Give that node a .direction, or "
      "make it a Diaphragm: a model moves on a line or in plan.");
  Model plan;
  const DiaphragmId slab = add(plan, Diaphragm{.name = "slab", .mass = 1 * kg, .size = {1 * m, 1 * m}});
  EXPECT_EQ(message_of([&] { add(plan, Node{.name = "node", .mass = 1 * kg}); }),
            "Node \"node\": a node without direction in a model with diaphragms. Give .direction, or a Diaphragm in "
            "place of the node: a model moves on a line or in plan.");
  add(plan, Node{.name = "wall", .mass = 1 * kg, .direction = PlanVector{0.6, -0.8}});
  EXPECT_NE(message_of([&] {
              add(plan, Node{.name = "other", .mass = 1 * kg, .direction = PlanVector{1.0, 1.0}});
            }).find("length of direction = 1.41421 is not allowed"),
            std::string::npos);
  EXPECT_EQ(message_of([&] {
              add(plan, ShearSpring{.name = "storey", .lower = ground, .upper = slab, .stiffness = 1 * N / m});
            }),
            "ShearSpring \"storey\": upper is the diaphragm \"slab\", and this element has no direction in plan. Use a "
            "PlanSpring with the same law, two points and a direction.");
  EXPECT_EQ(message_of([&] {
              add(plan, PlanSpring<Linear>{.name = "spring",
                                           .lower = PlanPoint{slab, {}},
                                           .upper = PlanPoint{slab, {1 * m, {}}},
                                           .law = {.stiffness = 1 * N / m}});
            }),
            "PlanSpring \"spring\": lower and upper are points of the same body. An element joins points of two "
            "bodies.");
}

}  // namespace
}  // namespace moat
