// Gaps whose ends are points between floors.

#include <gtest/gtest.h>

#include "message_of.hpp"
#include "moat.hpp"
#include "moved_model.hpp"
#include "small_models.hpp"

namespace moat {
namespace {

using namespace units;

struct Neighbours {
  Model model;
  NodeId low = add(model, Node{.name = "low", .mass = 2 * kg});
  NodeId high = add(model, Node{.name = "high", .mass = 3 * kg});
  NodeId other = add(model, Node{.name = "other", .mass = 5 * kg, .initial_displacement = -30 * mm});
};

const LinearElastic law{.stiffness = 1000 * N / m};

TEST(GapPoints, ForceIsSharedByTheFloorsOfTheColumn) {
  Neighbours n;
  add(n.model, Gap{.name = "mid-column",
                   .left = MemberPoint{n.low, n.high, 0.25},
                   .right = n.other,
                   .clearance = 10 * mm,
                   .law = law});
  AnalysisState state{n.model};
  // The neighbour starts 20 mm inside the column.
  ASSERT_EQ(testing::commit_with_regimes(state).size(), 1u);
  const Vector force = state.internal_forces();
  EXPECT_NEAR(force[0], 0.75 * 20.0, 1e-12);
  EXPECT_NEAR(force[1], 0.25 * 20.0, 1e-12);
  EXPECT_NEAR(force[2], -20.0, 1e-12);
  EXPECT_EQ(force[3], 0.0);
}

TEST(GapPoints, EffectiveMassIsThatOfAnImpulseAtThePoint) {
  Neighbours n;
  const Check check{"Gap", "test"};
  EXPECT_NEAR(effective_mass(n.model, check, n.low, ground), 2.0, 1e-15);
  EXPECT_NEAR(effective_mass(n.model, check, n.low, n.high), 6.0 / 5.0, 1e-15);
  // A unit impulse at the quarter point moves it by (3/4)^2 / 2 + (1/4)^2 / 3.
  EXPECT_NEAR(effective_mass(n.model, check, MemberPoint(n.low, n.high, 0.25), ground),
              1.0 / (0.5625 / 2.0 + 0.0625 / 3.0), 1e-12);
}

TEST(GapPoints, ANodeOnBothSidesLeavesTheRestitutionAsAsked) {
  Model model;
  const NodeId low = add(model, Node{.name = "low", .mass = 2 * tonne, .initial_velocity = 1 * m / s});
  const NodeId high = add(model, Node{.name = "high", .mass = 3 * tonne, .free = true});
  add(model, Gap<ExactKelvin>{.name = "gap",
                              .left = MemberPoint{low, high, 0.5},
                              .right = high,
                              .clearance = 1 * cm,
                              .law = {.stiffness = 1e8 * N / m, .restitution = 0.5}});
  const CaseResult result = run_case(model, testing::still_ground(0.1 * s, 1 * ms));
  ASSERT_EQ(result.impacts.size(), 1u);
  EXPECT_NEAR(result.impacts[0].rebound_ratio, 0.5, 1e-3);  // default steps in contact
  EXPECT_NEAR(result.impacts[0].restitution, 0.5, 1e-7);
}

TEST(GapPoints, MayBeginAtTheSameNode) {
  Neighbours n;
  add(n.model, Gap{.name = "gap",
                   .left = MemberPoint{n.low, n.high, 0.25},
                   .right = MemberPoint{n.low, n.other, 0.25},
                   .clearance = 1 * mm,
                   .law = law});
  AnalysisState state{n.model};
  testing::commit_with_regimes(state);  // 0.25 (u_high - u_other) is 7.5 mm
  const Eigen::Vector3d weights{0.0, 0.25, -0.25};
  const Eigen::MatrixXd expected = 1000.0 * weights * weights.transpose();
  EXPECT_LT((testing::tangent_of(state, 0.0, 0.0, 1.0) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(GapPoints, RefuseTwoEndsAtTheSamePoint) {
  Neighbours n;
  const auto message = [&](const MemberPoint& left, const MemberPoint& right) {
    return testing::message_of(
        [&] { add(n.model, Gap{.name = "g", .left = left, .right = right, .clearance = 1 * cm, .law = law}); });
  };
  const std::string same_point =
      "Gap \"g\": left and right are the same point, so that the gap never changes. Give two points that move towards "
      "each other.";
  EXPECT_EQ(message(MemberPoint{n.low, n.high, 0.3}, MemberPoint{n.low, n.high, 0.3}), same_point);
  EXPECT_EQ(message(MemberPoint{n.low, n.high, 0.3}, MemberPoint{n.high, n.low, 0.7}), same_point);
  EXPECT_EQ(message(MemberPoint{ground, n.low, 0.5}, MemberPoint{n.low, ground, 0.5}), same_point);
}

TEST(GapPoints, SayWhatIsWrong) {
  Neighbours n;
  EXPECT_EQ(testing::message_of([&] {
              add(n.model, Gap{.name = "g",
                               .left = MemberPoint{n.low, n.high, 1.0},
                               .right = n.other,
                               .clearance = 1 * cm,
                               .law = law});
            }),
            "Gap \"g\": left.share = 1 is not allowed; it must be >= 0 and < 1. It is the way from the first node to "
            "the second; take the second node itself for 1.");
  EXPECT_THROW(
      add(n.model,
          Gap{.name = "g", .left = MemberPoint{n.low, n.low, 0.5}, .right = n.other, .clearance = 1 * cm, .law = law}),
      InputError);
  EXPECT_THROW(add(n.model, Gap{.name = "g",
                                .left = MemberPoint{n.low, NodeId{}, 0.5},
                                .right = n.other,
                                .clearance = 1 * cm,
                                .law = law}),
               InputError);
}

}  // namespace
}  // namespace moat
