#include "output/recorders/channels.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace moat
