#include "moat.hpp"
#include "moved_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const HertzDamp law{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65};

TEST(Moat, IsTwoGapsThatShareAPlace) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  add(model, Moat<HertzDamp>{.around = base, .clearance = 10 * cm, .law = law});
  ASSERT_EQ(model.blocks().size(), 1u);
  const ElementBlock& gaps = *model.blocks().front();
  ASSERT_EQ(gaps.size(), 2u);
  EXPECT_TRUE(gaps.kind().contacts);
  EXPECT_EQ(gaps.info(0).name, "moat left");
  EXPECT_EQ(gaps.info(1).name, "moat right");
  for (const std::size_t e : {0u, 1u}) {
    EXPECT_EQ(gaps.info(e).place, "moat");
    EXPECT_EQ(gaps.info(e).offset, 0.1);
  }
}

TEST(Moat, OneSideClosesWhereTheOtherOpens) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  add(model, Moat<HertzDamp>{.around = base, .clearance = 10 * cm, .law = law});
  AnalysisState state{model};
  for (const double displacement : {0.12, -0.12}) {
    testing::move_to(state, Vector{{displacement}});
    EXPECT_DOUBLE_EQ(state.elements(0).results()[0].deformation, -displacement - 0.1);
    EXPECT_DOUBLE_EQ(state.elements(0).results()[1].deformation, displacement - 0.1);
  }
}

TEST(Moat, MayHaveOneSideOnly) {
  for (const Sides side : {Sides::left, Sides::right}) {
    Model model;
    const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
    add(model, Moat<HertzDamp>{.around = base, .clearance = 10 * cm, .law = law, .sides = side});
    ASSERT_EQ(model.blocks().front()->size(), 1u);
    EXPECT_EQ(model.blocks().front()->info(0).name, "moat") << "there is no other side to distinguish it from";
    EXPECT_EQ(model.blocks().front()->info(0).first == ground, side == Sides::right);
    Model with_wall;
    add(with_wall, Moat<HertzDamp>{.name = "quay",
                                   .around = add(with_wall, Node{.name = "base", .mass = 550 * tonne}),
                                   .clearance = 10 * cm,
                                   .law = law,
                                   .sides = side,
                                   .wall = FlexibleWall{.mass = 20 * tonne, .stiffness = 2 * GN / m}});
    EXPECT_EQ(with_wall.bodies()[1].name, "quay wall");
  }
}

TEST(Moat, FlexibleWallsAreNodesOnSprings) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne, .half_width = 5 * m});
  add(model,
      Moat<HertzDamp>{.around = base,
                      .clearance = 10 * cm,
                      .law = law,
                      .wall = FlexibleWall{.mass = 20 * tonne, .stiffness = 2 * GN / m, .damping = 3e5 * kg / s}});
  ASSERT_EQ(model.degrees_of_freedom(), 3);
  EXPECT_EQ(model.bodies()[1].name, "moat left wall");
  EXPECT_EQ(model.bodies()[2].name, "moat right wall");
  // The face of the wall is the clearance away from the edge of the floor.
  EXPECT_NEAR(model.bodies()[2].x - model.bodies()[2].half_width, 5.1, 1e-12);
  EXPECT_NEAR(model.bodies()[1].x + model.bodies()[1].half_width, -5.1, 1e-12);
  AnalysisState state{model};
  const Vector force = testing::forces_at(state, Vector{{0.0, 0.0, 0.01}}, Vector{{0.0, 0.0, 0.1}});
  EXPECT_NEAR(force[2], 2e7 + 3e4, 1e-3);
  EXPECT_EQ(force[1], 0.0);
  // The gap opens as the wall gives way.
  for (std::size_t b = 0; b < model.blocks().size(); ++b)
    for (std::size_t e = 0; e < model.blocks()[b]->size(); ++e)
      if (model.blocks()[b]->info(e).name == "moat right") {
        EXPECT_NEAR(state.elements(b).results()[e].deformation, -0.11, 1e-15);
      }
}

TEST(Moat, FlexibleWallsTakeAnyLaw) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  FlexibleWall wall{.mass = 20 * tonne, .damping = 3e5 * kg / s, .law = YieldingStorey::typical()};
  add(model, Moat<HertzDamp>{.around = base, .clearance = 10 * cm, .law = law, .wall = wall});
  AnalysisState state{model};
  const Vector force = testing::forces_at(state, Vector{{0.0, 0.0, 0.001}}, Vector{{0.0, 0.0, 0.1}});
  EXPECT_NEAR(force[2], 1e6 + 3e4, 1e-3);

  wall.stiffness = 2 * GN / m;
  EXPECT_EQ(message_of([&] {
              wall.check(Check{"FlexibleWall", "moat"});
            }),
            "FlexibleWall \"moat\": stiffness = 2e+09 N/m is not allowed; it must be left out where law is given. Give "
            "one of both.");
}

TEST(Moat, RefusesBadInput) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  const auto refusal = [&](auto change) {
    Moat<HertzDamp> moat{.around = base, .clearance = 10 * cm, .law = law};
    change(moat);
    return message_of([&] { add(model, moat); });
  };
  EXPECT_EQ(refusal([](auto& moat) { moat.name = ""; }),
            "Moat: a moat has no name. Give .name, or leave it out: \"moat\".");
  EXPECT_EQ(refusal([](auto& moat) { moat.around = NodeId{}; }),
            "Moat \"moat\": around is not given. Set it to a node of this model or to `ground`.");
  EXPECT_EQ(refusal([](auto& moat) { moat.clearance = -10 * cm; }),
            "Gap \"moat left\": clearance = -0.1 m is not allowed; it must be >= 0 m and finite. "
            "Give the free distance at rest, 0 m for wall to wall; a preload is an initial_displacement.");
  EXPECT_EQ(refusal([](auto& moat) { moat.around = ground; }),
            "Gap \"moat left\": left and right are the same node, \"ground\". An element joins two different nodes.");
  EXPECT_TRUE(model.blocks().empty());
  EXPECT_EQ(refusal([](auto& moat) { moat.wall = FlexibleWall{.mass = 20 * tonne, .stiffness = -2 * GN / m}; }),
            "FlexibleWall \"moat left wall\": stiffness = -2e+09 N/m is not allowed; it must be > 0 N/m and finite. "
            "Check its sign and its unit.");
}

TEST(FlexibleWall, HasTheStiffnessAndMassOfItsGeometry) {
  using namespace units;
  WallGeometry geometry{.height = 2 * m, .thickness = 0.3 * m, .width = 10 * m, .youngs_modulus = 25e9 * N / (m * m)};
  const FlexibleWall clamped = FlexibleWall::from_geometry(geometry);
  EXPECT_NEAR(clamped.stiffness.si(), 210.937e6, 1e3);
  EXPECT_NEAR(clamped.mass.si(), 3394.29, 0.01);
  EXPECT_EQ(clamped.yield_force.si(), 0.0);
  // The static shape has the frequency of Rayleigh's quotient, 1.5 % above that of the cantilever.
  EXPECT_NEAR(std::sqrt(clamped.stiffness.si() / clamped.mass.si()), 249.29, 0.01);
  geometry.base_rotation = 200 * MN * m;
  geometry.yield_moment = 1.2 * MN * m;
  const FlexibleWall turning = FlexibleWall::from_geometry(geometry);
  EXPECT_NEAR(turning.stiffness.si(), 40.4192e6, 1e2);
  EXPECT_NEAR(turning.mass.si(), 2400.0 * 10 * 0.3 * 2 / 3.0, 1e-6);
  EXPECT_NEAR(turning.yield_force.si(), 0.6e6, 1e-6);
}

}  // namespace
}  // namespace moat
