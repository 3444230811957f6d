// The element of a corner and an edge: geometry, effective mass, tangents, refusals.
#include "elements/contact/corner_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analyses/case/input_warnings.hpp"
#include "materials/impact/hertz.hpp"
#include "message_of.hpp"
#include "moved_model.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

struct Slabs {
  explicit Slabs(double friction = 0.4) {
    a = add(model, Diaphragm{.name = "a", .mass = 8 * kg, .rotary_inertia = 20 * kg * m * m});
    b = add(
        model,
        Diaphragm{.name = "b", .mass = 5 * kg, .rotary_inertia = 30 * kg * m * m, .centre_of_mass = {9 * m, 1 * m}});
    gap.friction = {friction, 300 * N / m};
  }
  // The corner of a at (2, 1) and an edge of b at x + 0.5 y = const, its direction turned by an angle.
  CornerGap<Hertz> gap{.name = "gap",
                       .corner = PlanPoint{ground, {2 * m, 1 * m}},
                       .edge_of = ground,
                       .edge_begin = PlanPosition{3 * m, -2 * m},
                       .edge_end = PlanPosition{2.5 * m, 3 * m},
                       .law = {.stiffness = 1000 * N / m_3_2}};
  void add_gap() {
    gap.corner = PlanPoint{a, {2 * m, 1 * m}};
    gap.edge_of = b.x;
    add(model, gap);
  }
  Model model;
  DiaphragmId a, b;
};

TEST(CornerGap, ClearanceAndMotionAreThoseAlongNormalAndTangent) {
  Slabs slabs;
  slabs.add_gap();
  const PlanVector begin{3.0, -2.0}, end{2.5, 3.0}, at{2.0, 1.0};
  const PlanVector t = (end - begin) / length(end - begin), n = -turned_left(t);
  const double clearance = dot(begin - at, n);
  EXPECT_GT(clearance, 0.0);
  EXPECT_NEAR(slabs.model.blocks()[0]->info(0).offset, clearance, 1e-15);
  // Move both bodies.
  const Vector u{{0.1, -0.05, 0.02, 0.03, 0.04, -0.01}};
  AnalysisState state{slabs.model};
  testing::move_to(state, u);
  const double ra = std::sqrt(20.0 / 8.0), rb = std::sqrt(30.0 / 5.0);
  const PlanVector faced = at + clearance * n, arm_a = at, arm_b = faced - PlanVector{9.0, 1.0};
  const PlanVector moved_a = PlanVector{u[0], u[1]} + u[2] / ra * turned_left(arm_a),
                   moved_b = PlanVector{u[3], u[4]} + u[5] / rb * turned_left(arm_b);
  EXPECT_NEAR(state.elements(0).results()[0].deformation, dot(moved_a - moved_b, n) - clearance, 1e-14);
}

TEST(CornerGap, EffectiveMassIsThatOfTheImpulse) {
  Slabs slabs;
  const CornerGap<Hertz> gap{.name = "gap",
                             .corner = PlanPoint{slabs.a, {2 * m, 1 * m}},
                             .edge_of = slabs.b.x,
                             .edge_begin = PlanPosition{3 * m, -2 * m},
                             .edge_end = PlanPosition{3 * m, 3 * m},
                             .law = {.stiffness = 1e9 * N / m_3_2}};
  const CornerGeometry geometry =
      check_corner(slabs.model, {gap.name, gap.place, gap.corner, gap.edge_of, gap.edge_begin, gap.edge_end,
                                 gap.friction, gap.share, gap.effective_mass, gap.corner_name, gap.edge_name});
  // n = +x: 1/m_n = 1/m_a + y_a^2/J_a + 1/m_b + y_b^2/J_b with the arms' y components 1 and 0.
  EXPECT_NEAR(geometry.motion.normal_mass, 1.0 / (1.0 / 8.0 + 1.0 / 20.0 + 1.0 / 5.0), 1e-12);
  EXPECT_NEAR(geometry.motion.tangential_mass, 1.0 / (1.0 / 8.0 + 4.0 / 20.0 + 1.0 / 5.0 + 36.0 / 30.0), 1e-12);
  EXPECT_NEAR(geometry.motion.edge_begin, -3.0, 1e-15);
  EXPECT_NEAR(geometry.motion.edge_end, 2.0, 1e-15);
}

// The whole tangent, sticking and sliding, is the derivative of the forces.
TEST(CornerGap, TangentIsTheDerivativeOfTheForces) {
  for (const double friction : {0.0, 0.05, 1.0}) {
    Slabs slabs{friction};
    slabs.add_gap();
    AnalysisState state{slabs.model};
    // Touch, then move along the edge.
    const Vector touch{{0.8, 0.1, 0.02, -0.2, 0.0, 0.03}}, still = Vector::Zero(6);
    for (const std::size_t changes : {1u, 0u}) {
      testing::move_to(state, touch, still, changes == 1u ? 0.1 : 0.0);
      state.evaluate_rates();
      ASSERT_EQ(testing::commit_with_regimes(state).size(), changes);
    }
    const Vector slid = touch + Vector{{0.02, 0.1, 0.01, 0.0, -0.05, 0.0}};
    const Vector forces = testing::forces_at(state, slid, still, 0.1);
    EXPECT_GT(state.elements(0).results()[0].force, 0.0);
    const double limit = friction * state.elements(0).results()[0].force,
                 friction_force = std::abs(state.elements(0).contact(0).friction_force);
    EXPECT_LE(friction_force, limit * (1.0 + 1e-12));
    if (friction == 0.05) {
      EXPECT_NEAR(friction_force, limit, 1e-9 * limit);
    }
    if (friction == 1.0) {
      EXPECT_LT(friction_force, 0.999 * limit);
    }
    const Eigen::MatrixXd tangent = testing::tangent_of(state, 0.0, 0.0, 1.0);
    const Eigen::MatrixXd slope = testing::derivatives_at(state, slid, still, 1e-7, 1.0, 0.1).stiffness.topRows(6);
    EXPECT_LT((slope - tangent).cwiseAbs().maxCoeff(), 1e-3) << friction;
    // Action and reaction: no net force.
    EXPECT_NEAR(forces[0] + forces[3], 0.0, 1e-10);
    EXPECT_NEAR(forces[1] + forces[4], 0.0, 1e-10);
  }
}

// The spring that follows the normal law: 0.85 x 1.5 k sqrt(d), of the share of the law.
TEST(CornerGap, TangentialStiffnessFollowsTheNormalLaw) {
  Slabs slabs;
  slabs.gap.friction = {1.0, 0.85};
  slabs.gap.share = 0.5;
  slabs.add_gap();
  AnalysisState state{slabs.model};
  const Vector touch{{0.8, 0.1, 0.02, -0.2, 0.0, 0.03}}, still = Vector::Zero(6);
  for (const std::size_t changes : {1u, 0u}) {
    testing::move_to(state, touch, still, changes == 1u ? 0.1 : 0.0);
    state.evaluate_rates();
    ASSERT_EQ(testing::commit_with_regimes(state).size(), changes);
  }
  const double d = state.elements(0).results()[0].deformation, spring = 0.85 * 1.5 * 0.5 * 1000.0 * std::sqrt(d);
  // Along the edge alone, so that d stays: the friction grows by the spring times the way.
  const PlanVector t = PlanVector{-0.5, 5.0} / length(PlanVector{-0.5, 5.0});
  const Vector along = touch + 1e-4 * Vector{{t.x, t.y, 0.0, 0.0, 0.0, 0.0}};
  testing::forces_at(state, along, still, 0.1);
  EXPECT_NEAR(state.elements(0).contact(0).friction_force / (spring * 1e-4), 1.0, 1e-6);
  EXPECT_EQ(slabs.model.blocks()[0]->info(0).law_as_given()->parameters.back().name, "share");
  const auto& parameters = slabs.model.blocks()[0]->info(0).law_as_given()->parameters;
  EXPECT_EQ(parameters[parameters.size() - 2], (Parameter{"tangential_stiffness_ratio", 0.85, "1"}));
}

// The stiffness of friction that the law gives does not depend on the form in which its restitution was given.
TEST(CornerGap, FrictionFollowsALawWhoseRestitutionMayFall) {
  const auto stiffness = [](const Restitution& restitution) {
    const BilinearImpact law{.stiffness = 1e10 * units::N / units::m_3_2,
                             .restitution = restitution,
                             .expected_indentation = 10 * units::mm};
    return CornerLaw<BilinearImpact>{.law = law, .effective_mass = 1e5, .share = 1.0, .gives_grip = true}
        .acting_friction()
        .tangential_stiffness;
  };
  EXPECT_NEAR(stiffness(MeasuredRestitution{{{1 * units::m / units::s, 0.65}}}) / stiffness(0.65), 1.0, 1e-12);
}

TEST(CornerGap, JamsWhereFrictionPressesTheCornerIn) {
  // J = m: 1/m_n = 1 + 1, |m_nt| = 3 x 1, so that friction from 2/3 on jams.
  for (const double friction : {0.66, 0.67}) {
    Model model;
    const DiaphragmId body = add(model, Diaphragm{.name = "body", .mass = 1 * kg, .rotary_inertia = 1 * kg * m * m});
    add(model, CornerGap<Hertz>{.name = "gap",
                                .corner = PlanPoint{body, {3 * m, 1 * m}},
                                .edge_of = ground,
                                .edge_begin = PlanPosition{3.1 * m, -2 * m},
                                .edge_end = PlanPosition{3.1 * m, 2 * m},
                                .law = {.stiffness = 1000 * N / m_3_2},
                                .friction = friction});
    const std::vector<std::string> warnings = model_warnings(model);
    if (friction < 2.0 / 3.0) {
      EXPECT_TRUE(warnings.empty());
    } else {
      ASSERT_EQ(warnings.size(), 1U);
      EXPECT_EQ(warnings[0],
                "\"gap\" can jam: while its corner slides, friction presses it into the edge at least as hard as the "
                "contact pushes it back, 1/m_n <= mu |m_nt|. Give less friction, or check the rotary inertia and the "
                "place of the corner.");
    }
  }
}

TEST(CornerGap, BadInputIsRefused) {
  const auto message = [](auto change) {
    return message_of([&] {
      Slabs slabs;
      change(slabs);
      slabs.add_gap();
    });
  };
  EXPECT_EQ(message([](Slabs&) {}), "nothing was thrown");
  EXPECT_EQ(message([](Slabs& slabs) {
              std::swap(slabs.gap.edge_begin, slabs.gap.edge_end);
            }).find("CornerGap \"gap\": clearance = -"),
            0U);
  EXPECT_NE(message([](Slabs& slabs) { std::swap(slabs.gap.edge_begin, slabs.gap.edge_end); })
                .find("Overlap at rest: the corner must be on the left of the way from edge_begin to edge_end, or on "
                      "it."),
            std::string::npos);
  EXPECT_EQ(
      message([](Slabs& slabs) { slabs.gap.edge_end = slabs.gap.edge_begin; }),
      "CornerGap \"gap\": edge_end - edge_begin = 0 is not allowed; it must be a vector of finite length > 0. Give "
      "the direction along which the element acts, for example {1, 0}.");
  EXPECT_EQ(
      message([](Slabs& slabs) { slabs.gap.friction = -0.1; }),
      "CornerGap \"gap\": friction = -0.1 is not allowed; it must be from 0 to 1. Concrete on concrete has 0.4 to "
      "0.6, steel 0.2 to 0.3.");
  EXPECT_EQ(message([](Slabs& slabs) {
              slabs.gap.friction = {0.4, -1 * N / m};
            }),
            "CornerGap \"gap\": tangential_stiffness = -1 N/m is not allowed; it must be > 0 N/m and finite. Give the "
            "stiffness before sliding, or leave it out for 0.85 times that of the normal law.");
  for (const double ratio : {-0.5, 1.5})
    EXPECT_EQ(message([&](Slabs& slabs) {
                slabs.gap.friction = {0.4, ratio};
              }),
              "CornerGap \"gap\": tangential_stiffness = " + to_text(ratio) +
                  " is not allowed; it must be > 0 and <= 1. A number is the ratio to the tangent of the normal law, "
                  "0.85 for example; a constant has a unit, N/m.");
  EXPECT_NE(message([](Slabs& slabs) { slabs.gap.share = 1.5; }).find("share = 1.5"), std::string::npos);
}

TEST(CornerGap, PointsOfColumnsAreChecked) {
  const auto message = [](auto change) {
    return message_of([&] {
      Slabs slabs;
      const DiaphragmId above =
          add(slabs.model, Diaphragm{.name = "above", .mass = 1 * kg, .rotary_inertia = 1 * kg * m * m});
      PlanPoint corner{slabs.a, {2 * m, 1 * m}, above, 0.5};
      change(slabs, corner);
      slabs.gap.edge_of = slabs.b.x;
      slabs.gap.corner = corner;
      add(slabs.model, slabs.gap);
    });
  };
  EXPECT_EQ(message([](Slabs&, PlanPoint&) {}), "nothing was thrown");
  EXPECT_EQ(message([](Slabs&, PlanPoint& corner) { corner.share = 1.0; }),
            "CornerGap \"gap\": corner.share = 1 is not allowed; it must be >= 0 and < 1. It is the way from .of to "
            ".other; take the other body itself for 1.");
  EXPECT_EQ(message([](Slabs&, PlanPoint& corner) { corner.other = {}; }),
            "CornerGap \"gap\": corner.share is given without .other. Give the body at the other end of the column.");
  EXPECT_EQ(
      message([](Slabs& slabs, PlanPoint& corner) { corner.other = slabs.a.y; }),
      "CornerGap \"gap\": corner.of and corner.other are the same body. Leave .other out for a point of one body.");
  EXPECT_EQ(
      message([](Slabs& slabs, PlanPoint& corner) { corner.other = slabs.b; }),
      "CornerGap \"gap\": corner and edge_of are points of the same body. An element joins points of two bodies.");
}

}  // namespace
}  // namespace moat
