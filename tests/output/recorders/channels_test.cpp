#include "output/recorders/channels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "moat.hpp"
#include "recorders_testing.hpp"

namespace moat {
namespace {

using testing_output::find;
using testing_output::HandMovedBuilding;

TEST(Channels, NameEveryQuantityWithPlaceAndUnit) {
  const HandMovedBuilding building;
  const Channels channels{building.model};
  struct Expected {
    const char *quantity, *where, *place, *unit;
  };
  const Expected expected[] = {{"displacement", "base", "base", "m"},
                               {"velocity", "base", "base", "m/s"},
                               {"absolute_acceleration", "base", "base", "m/s^2"},
                               {"displacement", "floor 1", "floor 1", "m"},
                               {"velocity", "floor 1", "floor 1", "m/s"},
                               {"absolute_acceleration", "floor 1", "floor 1", "m/s^2"},
                               {"drift", "storey 1", "storey 1", "m"},
                               {"storey_shear", "storey 1", "storey 1", "N"},
                               {"isolator_deformation", "bearings", "bearings", "m"},
                               {"isolator_force", "bearings", "bearings", "N"},
                               {"indentation", "moat left", "moat", "m"},
                               {"impact_force", "moat left", "moat", "N"},
                               {"indentation", "moat right", "moat", "m"},
                               {"impact_force", "moat right", "moat", "N"},
                               {"total_base_shear", "base", "base", "N"}};
  ASSERT_EQ(channels.list().size(), std::size(expected));
  for (const Expected& wanted : expected) {
    const int at = find(channels, wanted.quantity, wanted.where);
    ASSERT_GE(at, 0) << wanted.quantity << " " << wanted.where;
    const Channel& channel = channels.list()[static_cast<std::size_t>(at)];
    EXPECT_EQ(channel.place, wanted.place);
    EXPECT_EQ(channel.unit, wanted.unit);
  }
  EXPECT_EQ(find(channels, "displacement", "storey 1"), -1);
  EXPECT_EQ(find(channels, "force", "damper"), -1);
}

TEST(Channels, SampleTheCommittedState) {
  HandMovedBuilding building;
  const Channels channels{building.model};
  std::vector<double> values, rates;
  // Base 12 cm to the right: 2 cm into the right wall, bearing yielded.
  channels.sample(building.move(1.0, 0.12, 0.15, 4.0, -2.0, 0.5), values, rates);
  // Later trial states have no effect.
  building.state->trial().displacement.setConstant(9.0);
  const auto value = [&](const char* quantity, const char* where) {
    return values.at(static_cast<std::size_t>(find(channels, quantity, where)));
  };
  EXPECT_EQ(values.size(), channels.list().size());
  EXPECT_DOUBLE_EQ(value("displacement", "base"), 0.12);
  EXPECT_DOUBLE_EQ(value("velocity", "floor 1"), 0.015);
  EXPECT_DOUBLE_EQ(value("absolute_acceleration", "base"), 4.5);
  EXPECT_DOUBLE_EQ(value("absolute_acceleration", "floor 1"), -1.5);
  EXPECT_NEAR(value("drift", "storey 1"), 0.03, 1e-15);
  EXPECT_NEAR(value("storey_shear", "storey 1"), 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(value("isolator_deformation", "bearings"), 0.12);
  EXPECT_NEAR(value("isolator_force", "bearings"), 10.0 + 5.0 * 0.02, 1e-12);
  EXPECT_NEAR(value("indentation", "moat right"), 0.02, 1e-15);
  // The left gap is open: not indented.
  EXPECT_EQ(value("indentation", "moat left"), 0.0);
  EXPECT_DOUBLE_EQ(value("total_base_shear", "base"), -(2.0 * 4.5 + 3.0 * -1.5));
  const auto rate = [&](const char* quantity, const char* where) {
    return rates.at(static_cast<std::size_t>(find(channels, quantity, where)));
  };
  EXPECT_EQ(rates.size(), channels.list().size());
  EXPECT_DOUBLE_EQ(rate("displacement", "base"), value("velocity", "base"));
  EXPECT_DOUBLE_EQ(rate("velocity", "base"), 4.0);
  EXPECT_NEAR(rate("drift", "storey 1"), 0.003, 1e-15);
  EXPECT_NEAR(rate("storey_shear", "storey 1"), 0.3, 1e-12);
  EXPECT_NEAR(rate("isolator_force", "bearings"), 5.0 * 0.012, 1e-12);
  EXPECT_EQ(rate("indentation", "moat left"), 0.0);
  // The floor feels its storey, 100 N/m and 1 N s/m, in rates: 100 * 0.003 + 1 * (-2 - 4).
  EXPECT_NEAR(rate("absolute_acceleration", "floor 1"), -(0.3 - 6.0) / 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(rate("total_base_shear", "base"),
                   -(2.0 * rate("absolute_acceleration", "base") + 3.0 * rate("absolute_acceleration", "floor 1")));
  EXPECT_EQ(Channels::of_node(building.model, building.floor),
            static_cast<std::size_t>(find(channels, "displacement", "floor 1")));
}

// A floor that moves by half with the ground: its resultants and corners are those of its own components.
TEST(Channels, OfAFollowingFloorComeFromItsNodes) {
  using namespace units;
  Model model;
  const PlanOutline outline = rectangle(4 * m, 2 * m);
  const DiaphragmId base = add(model, Diaphragm{.name = "base", .mass = 3 * kg, .outline = outline});
  add(model, Diaphragm{.name = "floor", .mass = 2 * kg, .outline = outline},
      Follower{.shares = {{{base.x, 2.0}}, {{base.y, 2.0}}, {{base.r, 2.0}}},
               .ground_influence = {{0.5, 0.0, 0.0}, {0.0, 0.5, 0.0}, {}}});
  const Channels channels{model};
  AnalysisState state{model};
  const double gyration = std::sqrt((16.0 + 4.0) / 12.0), turn = 0.7;
  state.trial().displacement.head(3) << 0.01, -0.02, 0.03 * gyration;
  state.trial().acceleration.head(3) << 1.0, -3.0, turn * gyration;
  state.evaluate();
  state.evaluate_rates();
  state.commit();
  std::vector<double> values, rates;
  channels.sample({model, state, {4.0, 6.0}}, values, rates);
  const auto value = [&](const char* quantity, const char* where) {
    return values.at(static_cast<std::size_t>(find(channels, quantity, where)));
  };
  EXPECT_DOUBLE_EQ(value("absolute_acceleration_x", "floor"), 2.0 + 0.5 * 4.0);
  EXPECT_DOUBLE_EQ(value("absolute_acceleration", "floor"), std::hypot(2.0 + 0.5 * 4.0, -6.0 + 0.5 * 6.0));
  const PlanVector corner = outline.corner(0);
  EXPECT_DOUBLE_EQ(value("corner_acceleration", "floor corner 1"),
                   std::hypot(4.0 - 2.0 * turn * corner.y, -3.0 + 2.0 * turn * corner.x));
  EXPECT_DOUBLE_EQ(value("corner_displacement", "floor corner 1"),
                   std::hypot(0.02 - 0.06 * corner.y, -0.04 + 0.06 * corner.x));
}

// A ram between two floors strikes both, on a line and in plan.
TEST(Channels, AContactWithAColumnBendsBothItsFloors) {
  using namespace units;
  const HertzDamp law{.stiffness = 1e9 * N / m_3_2, .restitution = 0.5};
  const auto expect_bent = [](const Model& model, const std::string& quantity, const std::string& part) {
    const Channels channels{model};
    const std::vector<std::size_t> bent = channels.bent_by(model, {.block = 0, .element = 0});
    for (const std::string body : {"ram", "lower", "upper"})
      EXPECT_EQ(std::ranges::count(bent, static_cast<std::size_t>(find(channels, quantity, body + part))), 1) << body;
  };
  Model line;
  const NodeId ram = add(line, Node{.name = "ram", .mass = 1 * kg}),
               lower = add(line, Node{.name = "lower", .mass = 1 * kg}),
               upper = add(line, Node{.name = "upper", .mass = 1 * kg});
  add(line, Gap{.name = "gap", .left = ram, .right = MemberPoint{lower, upper, 0.4}, .clearance = 1 * cm, .law = law});
  expect_bent(line, "absolute_acceleration", "");

  Model plan;
  const auto slab = [&](const char* name, Length x) {
    return add(plan, Diaphragm{.name = name,
                               .mass = 1 * kg,
                               .centre_of_mass = {x, 0 * m},
                               .outline = rectangle(2 * m, 2 * m, {x, 0 * m})});
  };
  const DiaphragmId hit = slab("ram", 0 * m), below = slab("lower", 3 * m), above = slab("upper", 3 * m);
  add(plan, CornerGap<HertzDamp>{.name = "gap",
                                 .corner = PlanPoint{below, {2 * m, 0.5 * m}, above, 0.4},
                                 .edge_of = hit,
                                 .edge_begin = PlanPosition{1 * m, 1 * m},
                                 .edge_end = PlanPosition{1 * m, -1 * m},
                                 .law = law});
  expect_bent(plan, "absolute_acceleration_x", "");
  expect_bent(plan, "corner_acceleration", " corner 1");
}

}  // namespace
}  // namespace moat
