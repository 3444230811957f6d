// Modes in plan.
#include "moat.hpp"

#include <gtest/gtest.h>

#include <string>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;

// 1.5e6 kg, 20 x 12 m, on four springs of 1.6 MN/m at (+-10, +-6) m; the mass is off by e along x.
Model slab(double e) {
  Model model;
  const DiaphragmId id = add(
      model, Diaphragm{.name = "slab", .mass = 1.5e6 * kg, .size = {20 * m, 12 * m}, .centre_of_mass = {e * m, {}}});
  int number = 0;
  for (const double x : {-10.0, 10.0})
    for (const double y : {-6.0, 6.0})
      for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}})
        add(model, PlanSpring<Linear>{.name = "spring " + std::to_string(++number),
                                      .lower = PlanPoint{ground, {x * m, y * m}},
                                      .upper = PlanPoint{id, {x * m, y * m}},
                                      .direction = direction,
                                      .law = {.stiffness = 1.6 * MN / m}});
  return model;
}

TEST(PlanModes, PeriodsOfAnEccentricSlabAreExact) {
  struct Case {
    double e, slow, fast;
  };
  for (const Case& each :
       {Case{0.0, 3.041834, 1.756204}, Case{0.5, 3.046019, 1.753791}, Case{1.0, 3.058473, 1.746650}}) {
    Model model = slab(each.e);
    const std::vector<PlanMode> modes = plan_modes(model, StiffnessStage::initial, 3);
    ASSERT_EQ(modes.size(), 3U);
    EXPECT_NEAR(modes[0].period, each.slow, 1e-6);
    EXPECT_NEAR(modes[1].period, 3.041834, 1e-6);  // along x
    EXPECT_NEAR(modes[2].period, each.fast, 1e-6);
    double x = 0.0, y = 0.0;
    for (const PlanMode& mode : modes) {
      x += mode.participation_x;
      y += mode.participation_y;
      EXPECT_NEAR(mode.along_x + mode.along_y + mode.rotation, 1.0, 1e-12);
    }
    EXPECT_NEAR(x, 1.0, 1e-12);
    EXPECT_NEAR(y, 1.0, 1e-12);
    EXPECT_EQ(modes[2].character(), "torsion");
    if (each.e > 0.0) {
      EXPECT_EQ(modes[0].character(), "y");
      EXPECT_GT(modes[2].participation_y, 0.0);
    }
  }
}

// A mass that moves along x alone has no part in motion along y.
TEST(PlanModes, ParticipationIsThatOfTheMassInItsDirection) {
  Model model = slab(0.0);
  const NodeId cart = add(model, Node{.name = "cart", .mass = 0.5e6 * kg, .direction = PlanVector{1.0, 0.0}});
  add(model, ShearSpring{.name = "buffer", .lower = ground, .upper = cart, .stiffness = 50 * MN / m});
  double x = 0.0, y = 0.0;
  for (const PlanMode& mode : plan_modes(model, StiffnessStage::initial, 4)) {
    x += mode.participation_x;
    y += mode.participation_y;
  }
  EXPECT_NEAR(x, 1.0, 1e-12);
  EXPECT_NEAR(y, 1.0, 1e-12);
}

TEST(PlanModes, BadInputIsRefused) {
  Model line;
  add(line, Node{.name = "node", .mass = 1 * kg});
  EXPECT_EQ(testing::message_of([&] { (void)plan_modes(line, StiffnessStage::initial, 1); }),
            "plan_modes: the model moves on a line. Its periods are those of characteristic_periods().");
}

}  // namespace
}  // namespace moat
