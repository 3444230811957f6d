// Buildings in plan: the same parts as by hand, the line model where it is symmetric, refusals.
#include "moat.hpp"
#include "moved_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "message_of.hpp"
#include "peak_in.hpp"
#include "unlocated_bilinear.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;
using testing::peak_in;

LeadRubberBearing bearing(double share) {
  return {.yield_force = share * 1.2 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = share * 9 * MN / m};
}

PlanBuilding tower(int storeys) {
  return {.outline = rectangle(20 * m, 12 * m),
          .storeys = storeys,
          .floor_mass = 500 * tonne,
          .columns = grid(3, 2, {.stiffness = 100 * MN / m}),
          .damping = {0.05},
          .base_mass = 550 * tonne,
          .bearings = grid(2, 2, bearing(0.25))};
}

TEST(PlanBuilding, SymmetricBuildingInAMoatEqualsTheShearBuilding) {
  const GroundMotion motion = near_fault_pulse({.quiet_after = 4 * s}).scaled_to_pga(0.45 * g);
  for (const int storeys : {1, 3}) {
    Model line, plan;
    const Building on_line = add(line, ShearBuilding{.storeys = storeys,
                                                     .floor_mass = 500 * tonne,
                                                     .storey_stiffness = 600 * MN / m,
                                                     .damping = {0.05},
                                                     .base_mass = 550 * tonne,
                                                     .isolation = testing::UnlocatedBilinear{1.2e6, 0.01, 9e6}});
    const PlanBuildingParts in_plan = add(plan, tower(storeys));
    const HertzDamp law{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65};
    add(line, Moat{.around = on_line.base, .clearance = 20 * cm, .law = law});
    add(plan,
        PlanMoat{.around = in_plan.base, .clearance = 20 * cm, .law = law, .friction = 0.3, .share = Share::per_face});
    const CaseOptions options{.transient = {.step = 1 * ms}, .error_bars = ErrorBarMode::never};
    const CaseResult a = run_case(line, motion, options), b = run_case(plan, motion, options);
    EXPECT_GT(a.impacts.size(), 0U);
    EXPECT_EQ(b.impacts.size(), 2 * a.impacts.size());
    for (const char* where : {"base", "floor 1"}) {
      for (const std::string quantity : {"displacement", "velocity", "absolute_acceleration"})
        EXPECT_NEAR(peak_in(b, quantity + "_x", where).value / peak_in(a, quantity, where).value, 1.0, 1e-10)
            << quantity;
      EXPECT_NEAR(peak_in(b, "displacement_y", where).value, 0.0, 1e-12);
      EXPECT_NEAR(peak_in(b, "rotation", where).value, 0.0, 1e-12);
    }
    EXPECT_NEAR(peak_in(b, "total_base_shear_x", "base").value / peak_in(a, "total_base_shear", "base").value, 1.0,
                1e-10);
    EXPECT_NEAR(peak_in(b, "drift_x", "floor 1").value / peak_in(a, "drift", "storey 1").value, 1.0, 1e-9);
    EXPECT_NEAR(b.energy.viscous / a.energy.viscous, 1.0, 1e-9);
  }
}

TEST(PlanBuilding, TakesBearingsInBraces) {
  const LeadRubberBearing law = bearing(0.25);
  const PlanBuilding building{.outline = rectangle(20 * m, 12 * m),
                              .storeys = 1,
                              .floor_mass = 700 * tonne,
                              .columns = grid(2, 2, {.stiffness = 100 * MN / m}),
                              .base_mass = 800 * tonne,
                              .bearings = {{{-10 * m, 0 * m}, law}, {PlanPosition{10 * m, 6 * m}, in_plan(law)}}};
  const auto bearings = building.bearings.placed(Check{"test", ""}, {});
  ASSERT_EQ(bearings.size(), 2u);
  EXPECT_EQ(bearings[0].at.si(), (PlanVector{-10.0, 0.0}));
  EXPECT_EQ(bearings[1].at.si(), (PlanVector{10.0, 6.0}));
  const PlanBearings single = {{{3 * m, 0 * m}, law}};
  EXPECT_EQ(single.placed(Check{"test", ""}, {}).size(), 1u);
  EXPECT_TRUE(single);
  EXPECT_FALSE(PlanBearings{});
  Model model;
  const PlanBuildingParts parts = add(model, building);
  EXPECT_TRUE(parts.base.specified());
}

TEST(PlanBuilding, FloorsHaveOutlinesOffsetsAndInertiaOfTheirOwn) {
  // A podium with a setback tower, whose floors are those of diaphragms by hand.
  PlanBuilding building = tower(2);
  building.outline = {rectangle(20 * m, 12 * m), rectangle(10 * m, 6 * m, {3 * m, 2 * m})};
  building.base_outline = rectangle(30 * m, 14 * m);
  building.mass_offset = {{1 * m, 0.5 * m}, {-0.5 * m, 0 * m}};
  building.base_mass_offset = {0 * m, 1 * m};
  building.rotary_inertia = {RotaryInertia{}, 500 * tonne * 9 * m * m};
  Model model;
  const PlanBuildingParts parts = add(model, building);
  const PlacedDiaphragm &base = model.diaphragm(parts.base), &podium = model.diaphragm(parts.floor(1)),
                        &top = model.diaphragm(parts.floor(2));
  EXPECT_EQ(base.centre_of_mass, (PlanVector{0.0, 1.0}));
  EXPECT_NEAR(base.gyration, std::sqrt((30.0 * 30.0 + 14.0 * 14.0) / 12.0), 1e-12);
  EXPECT_EQ(podium.centre_of_mass, (PlanVector{1.0, 0.5}));
  EXPECT_NEAR(podium.gyration, std::sqrt(544.0 / 12.0), 1e-12);
  EXPECT_NEAR(top.centre_of_mass.x, 2.5, 1e-12);
  EXPECT_NEAR(top.centre_of_mass.y, 2.0, 1e-12);
  EXPECT_NEAR(top.gyration, 3.0, 1e-12);
  EXPECT_EQ(top.outline.size(), 4u);

  const PlanBuilding moved = with_eccentricity(building, 0.05, 0.0);
  EXPECT_DOUBLE_EQ(moved.mass_offset.of(1).x.si(), 2.0);
  EXPECT_DOUBLE_EQ(moved.mass_offset.of(2).x.si(), 0.0);
  EXPECT_DOUBLE_EQ(moved.base_mass_offset.x.si(), 1.5);
}

TEST(PlanBuilding, StoreyAsAWholeEqualsItsColumns) {
  // Eccentric columns: their sums at their centre of rigidity, with the torsional stiffness about it.
  const std::vector<ColumnLine> lines{{{-10 * m, -6 * m}, {.stiffness_x = 80 * MN / m, .stiffness_y = 50 * MN / m}},
                                      {{10 * m, -6 * m}, {.stiffness_x = 80 * MN / m, .stiffness_y = 150 * MN / m}},
                                      {{10 * m, 6 * m}, {.stiffness_x = 200 * MN / m, .stiffness_y = 150 * MN / m}}};
  double kx = 0.0, ky = 0.0, x = 0.0, y = 0.0, rotation = 0.0;
  for (const ColumnLine& line : lines) {
    kx += line.column.along_x().si();
    ky += line.column.along_y().si();
    x += line.column.along_y().si() * line.at.x.si();
    y += line.column.along_x().si() * line.at.y.si();
  }
  x /= ky;
  y /= kx;
  for (const ColumnLine& line : lines)
    rotation += line.column.along_y().si() * std::pow(line.at.x.si() - x, 2) +
                line.column.along_x().si() * std::pow(line.at.y.si() - y, 2);
  PlanBuilding by_lines = tower(2), whole = tower(2);
  by_lines.columns = lines;
  whole.columns = StoreyStiffness{kx * N / m, ky * N / m, rotation * J, {x * m, y * m}};
  const GroundMotion first = near_fault_pulse({.quiet_after = 3 * s}).scaled_to_pga(0.3 * g);
  const CaseOptions options{.transient = {.step = 2.5 * ms}, .error_bars = ErrorBarMode::never};
  std::array<CaseResult, 2> results;
  for (int i = 0; i < 2; ++i) {
    Model model;
    add(model, i == 0 ? by_lines : whole);
    results[static_cast<std::size_t>(i)] = run_case(model, PlanMotion{first, first.scaled_by(0.5), 30 * deg}, options);
  }
  for (const char* quantity : {"displacement_x", "displacement_y", "rotation", "corner_drift", "absolute_acceleration"})
    EXPECT_NEAR(peak_in(results[1], quantity, "floor 2").value / peak_in(results[0], quantity, "floor 2").value, 1.0,
                1e-8)
        << quantity;
  EXPECT_NE(peak_in(results[0], "rotation", "floor 2").value, 0.0);
}

TEST(PlanBuilding, MassDampingDoesNotActOnRigidMotion) {
  // The base turns and moves; the floor follows rigidly: no dashpot has a force.
  Model model;
  const PlanBuildingParts parts = add(model, [] {
    PlanBuilding building = tower(3);
    building.mass_offset = {1 * m, 0.6 * m};
    return building;
  }());
  const PlanVector origin = model.diaphragm(parts.base).centre_of_mass;
  Vector velocity = Vector::Zero(model.degrees_of_freedom());
  const double turn = 0.02, vx = 0.3, vy = -0.1;
  for (const DiaphragmId& id : parts.diaphragms()) {
    const PlacedDiaphragm& each = model.diaphragm(id);
    const PlanVector arm = each.centre_of_mass - origin;
    velocity[id.x.index] = vx - arm.y * turn;
    velocity[id.y.index] = vy + arm.x * turn;
    velocity[id.r.index] = turn * each.gyration;
  }
  AnalysisState state{model};
  EXPECT_LT(testing::forces_at(state, 0.0 * velocity, velocity).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST(PlanBuilding, FindsFloorsByTheirNumbers) {
  PlanBuilding building = tower(3);
  building.name = "tower";
  Model model;
  const PlanBuildingParts parts = add(model, building);
  for (const int number : {1, 2, 3})
    EXPECT_EQ(model.diaphragm(parts.floor(number)).name, "tower floor " + std::to_string(number));
  for (const int number : {0, 4})
    EXPECT_EQ(testing::message_of([&] { return parts.floor(number); }),
              "PlanBuilding \"tower\": floor = " + std::to_string(number) +
                  " is not allowed; it must be >= 1 and <= 3. Give a number in "
                  "this range.");
  EXPECT_THROW(parts.floors[3], InputError);
  EXPECT_THROW(building.outline.of(1).corners[4], InputError);
}

TEST(PlanBuilding, EccentricityMovesAllCentresOfMass) {
  PlanBuilding building = tower(1);
  building.mass_offset = {0.2 * m, 0.1 * m};
  const auto cases = accidental_eccentricities(building);
  EXPECT_DOUBLE_EQ(cases[0].mass_offset.of(1).x.si(), 1.2);
  EXPECT_DOUBLE_EQ(cases[0].base_mass_offset.x.si(), 1.0);
  EXPECT_DOUBLE_EQ(cases[1].base_mass_offset.x.si(), -1.0);
  EXPECT_DOUBLE_EQ(cases[2].mass_offset.of(1).y.si(), 0.7);
  EXPECT_DOUBLE_EQ(cases[3].base_mass_offset.y.si(), -0.6);
  Model model;
  const PlanBuildingParts parts = add(model, cases[0]);
  EXPECT_NEAR(model.diaphragm(parts.floors[0]).centre_of_mass.x, 1.2, 1e-12);
  // About the centre of mass the rotary inertia stays that of the outline.
  EXPECT_NEAR(model.diaphragm(parts.floors[0]).gyration, std::sqrt(544.0 / 12.0), 1e-12);
}

TEST(PlanBuilding, RayleighDampingMayBeGivenByItsFactors) {
  const auto peak = [](const RayleighDamping& damping) {
    Model model;
    PlanBuilding building = tower(2);
    building.damping = damping;
    add(model, building);
    return run_case(model, near_fault_pulse({}), {.transient = {.step = 5 * ms, .end = 2 * s}}).peaks.front().value;
  };
  Model model;
  PlanBuilding undamped = tower(2);
  undamped.damping = {};
  const PlanBuildingParts parts = add(model, undamped);
  const RayleighFactors factors =
      rayleigh_factors_in_plan(0.05, model, std::vector<DiaphragmId>(parts.floors.begin(), parts.floors.end()));
  EXPECT_NEAR(peak({.a0 = factors.mass_factor / s, .a1 = factors.stiffness_factor * s}), peak({.ratio = 0.05}), 1e-12);
}

// Six bearings of a design have the strength ratio and the period of the whole building, for any number of them.
TEST(PlanBuilding, BearingsShareADesign) {
  Model model;
  PlanBuilding building = tower(2);
  building.bearings =
      grid(3, 2, BearingDesign{.strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 15 * mm});
  add(model, building);
  double mass = 0.0, strength = 0.0, stiffness = 0.0;
  for (const PlacedDiaphragm& floor : model.diaphragms()) mass += floor.mass;
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) {
      if (!block->info(e).isolates) continue;
      const auto parameters = block->law_of_block(e).parameters;
      const double post_yield = block->linear_stiffness(e, StiffnessStage::post_yield);
      stiffness += post_yield;
      strength += parameters[0].value - post_yield * parameters[1].value;
    }
  EXPECT_NEAR(strength / (mass * standard_gravity), 0.06, 1e-12);
  EXPECT_NEAR(2.0 * std::numbers::pi * std::sqrt(mass / stiffness), 3.0, 1e-12);
}

TEST(PlanBuilding, BadInputIsRefused) {
  const auto message = [](auto change) {
    return message_of([&] {
      Model model;
      PlanBuilding building = tower(2);
      change(building);
      add(model, building);
    });
  };
  EXPECT_EQ(message([](PlanBuilding&) {}), "nothing was thrown");
  EXPECT_EQ(
      message([](PlanBuilding& b) {
        b.columns = std::vector<ColumnLine>{{{}, {.stiffness = 1 * MN / m}}};
      }),
      "PlanBuilding: storey 1 does not resist every motion in plan: the smallest eigenvalue of its stiffness is 0 "
      "N/m. Give column lines at two places at least, with stiffness along x and along y, or a StoreyStiffness.");
  EXPECT_EQ(
      message([](PlanBuilding& b) { b.columns = std::vector<PlanColumns>(3, grid(2, 2, StoreyColumn{1 * MN / m})); }),
      "PlanBuilding: columns has 3 values for 2 storeys. Give one value for all storeys, or one for each from "
      "the lowest up.");
  EXPECT_NE(message([](PlanBuilding& b) { b.base_mass = {}; }).find("needs the mass of its base floor"),
            std::string::npos);
  EXPECT_NE(message([](PlanBuilding& b) { b.bearings = {}; }).find("base_mass"), std::string::npos);
  EXPECT_NE(message([](PlanBuilding& b) {
              PlanOutline clockwise = rectangle(2 * m, 1 * m);
              std::ranges::reverse(clockwise.corners);
              b.outline = clockwise;
            }).find("outline is clockwise"),
            std::string::npos);
  EXPECT_EQ(
      message([](PlanBuilding& b) { b.mass_offset = std::vector<PlanPosition>(3); }),
      "PlanBuilding: mass_offset has 3 values for 2 storeys. Give one value for all storeys, or one for each from "
      "the lowest up.");
  EXPECT_EQ(message([](PlanBuilding& b) {
              b.rotary_inertia = {1 * tonne * m * m, -1 * kg * m * m};
            }),
            "PlanBuilding: rotary_inertia of floor 2 = -1 kg m^2 is not allowed; it must be >= 0 kg m^2 and finite. "
            "Check its sign and its unit.");
  EXPECT_NE(message([](PlanBuilding& b) {
              b.outline = {rectangle(2 * m, 1 * m), PlanOutline{}};
            }).find("outline of floor 2"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
