#include "design/sheet_inputs.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "analyses/questions/effective_properties.hpp"
#include "materials/isolation/bouc_wen.hpp"
#include "message_of.hpp"
#include "sheet_building.hpp"

namespace moat::testing {
namespace {

using namespace units;

const Check check{"Sheet", ""};

void expect_loop(const SheetIsolation& isolation, double strength, double stiffness, double yield) {
  const IsolationLoop loop = isolation.under(30 * MN, check);
  EXPECT_NEAR(loop.characteristic_strength.si(), strength, 1e-9 * strength);
  EXPECT_NEAR(loop.post_yield_stiffness.si(), stiffness, 1e-9 * stiffness);
  EXPECT_DOUBLE_EQ(loop.yield_displacement.si(), yield);
}

TEST(SheetIsolation, ComesFromLaws) {
  const Bilinear law{.yield_force = 2 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 20 * MN / m};
  expect_loop(law, 1.8e6, 20e6, 0.01);
  expect_loop(
      LeadRubberBearing{.yield_force = 2 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 20 * MN / m},
      1.8e6, 20e6, 0.01);
  expect_loop(BoucWen{.yield_force = 2 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 20 * MN / m}, 1.8e6,
              20e6, 0.01);
  const double stiffness = 30e6 / standard_gravity * std::pow(2.0 * pi / 3.0, 2);
  expect_loop(BearingDesign{.strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 1 * cm}, 1.8e6,
              stiffness, 0.01);
  expect_loop(
      FrictionPendulum{.radius = 3 * m, .friction = VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 50 * s / m}},
      1.8e6, 10e6, 1e-3);
  expect_loop(FrictionPendulum{.radius = 3 * m, .friction = 0.05, .weight = 24 * MN}, 1.2e6, 8e6, 1e-3);
}

// A polygon of the loop itself, by another function.
TEST(IsolationLoop, HasTheEffectivePropertiesOfItsLoop) {
  const IsolationLoop loop{1.8 * MN, 13 * MN / m, 1 * cm};
  const double d = 0.4, far = loop.force(d * m).si(), turn = 2.0 * loop.yield_force().si();
  const EffectiveProperties effective =
      effective_properties(std::vector{d, d - 0.02, -d, -d + 0.02}, std::vector{far, far - turn, -far, -far + turn});
  EXPECT_NEAR(loop.stiffness(d * m).si(), effective.stiffness, 1e-9 * effective.stiffness);
  EXPECT_NEAR(loop.damping_ratio(d * m), effective.damping_ratio, 1e-12);
  // Elastic before yield.
  EXPECT_DOUBLE_EQ(loop.force(5 * mm).si(), 0.5 * loop.yield_force().si());
  EXPECT_DOUBLE_EQ(loop.stiffness(5 * mm).si(), loop.yield_force().si() / 0.01);
  EXPECT_EQ(loop.damping_ratio(1 * cm), 0.0);
}

TEST(SheetBuilding, RefusesBadInput) {
  const auto refused = [](const std::function<void(SheetBuilding&)>& change) {
    SheetBuilding building = sheet_building();
    change(building);
    return message_of([&] { building.check(Check{"Asce7Sheet", building.name}); });
  };
  EXPECT_EQ(
      refused([](SheetBuilding& each) { each.floors[2].height = 0 * m; }),
      "Asce7Sheet \"Hospital\": height of floor 3 = 0 m is not allowed; it must be > 0 m and finite. The forces of "
      "floors need it; it counts from the base.");
  for (const auto& [change, message] : std::vector<std::pair<std::function<void(SheetBuilding&)>, std::string>>{
           {[](SheetBuilding& each) { each.weight = 0 * N; }, "weight = 0 N"},
           {[](SheetBuilding& each) { each.floors.clear(); }, "floors are missing. Give weight and height"},
           {[](SheetBuilding& each) { each.floors[0].weight = Force{}; }, "weight of floor 1 = 0 N"},
           {[](SheetBuilding& each) { each.floors[4].weight = 11 * MN; },
            "weight of all floors = 3.1e+07 N is not allowed; it must be <= weight = 3e+07 N, with the base level"},
           {[](SheetBuilding& each) { each.bounds.lower.strength = 1.2; }, "lower.strength = 1.2"},
           {[](SheetBuilding& each) { each.bounds.upper.stiffness = 0.9; }, "upper.stiffness = 0.9"},
           {[](SheetBuilding& each) { each.shorter_side = 0 * m; }, "shorter_side = 0 m"},
           {[](SheetBuilding& each) { each.longer_side = 19 * m; }, "longer_side = 19 m"},
           {[](SheetBuilding& each) { each.bearings.clear(); }, "bearings are missing. Give the places"},
           {[](SheetBuilding& each) { each.eccentricity = -1 * m; }, "eccentricity = -1 m"},
           {[](SheetBuilding& each) { each.corner_distance = -1 * m; }, "corner_distance = -1 m"},
           {[](SheetBuilding& each) { each.fixed_base_period = 0 * s; }, "fixed_base_period = 0 s"},
           {[](SheetBuilding& each) { each.clearance = -1 * m; }, "clearance = -1 m"}})
    EXPECT_NE(refused(change).find(message), std::string::npos) << refused(change);
}

TEST(SheetIsolation, RefusesABadLoop) {
  const auto refused = [](const SheetIsolation& isolation) {
    return message_of([&] { static_cast<void>(isolation.under(30 * MN, check)); });
  };
  EXPECT_NE(refused(IsolationLoop{0 * N, 1 * MN / m, 1 * cm}).find("isolation.characteristic_strength = 0 N"),
            std::string::npos);
  EXPECT_NE(refused(IsolationLoop{1 * N, 0 * N / m, 1 * cm}).find("isolation.post_yield_stiffness = 0 N/m"),
            std::string::npos);
  EXPECT_NE(refused(IsolationLoop{1 * N, 1 * N / m, 0 * cm}).find("isolation.yield_displacement = 0 m"),
            std::string::npos);
  EXPECT_NE(refused(FrictionPendulum{.radius = 0 * m, .friction = 0.05}).find("radius = 0 m"), std::string::npos);
  EXPECT_NE(refused(BearingDesign{.strength_ratio = 0.06, .isolation_period = 0 * s, .yield_displacement = 1 * cm})
                .find("isolation_period"),
            std::string::npos);
}

}  // namespace
}  // namespace moat::testing
