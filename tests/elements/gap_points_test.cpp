// Gaps whose ends are points between floors.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "elements/gap.hpp"
#include "elements/shear_spring.hpp"
#include "materials/linear_elastic.hpp"
#include "message_of.hpp"

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
  n.model.prepare();
  std::vector<RegimeChange> changes;
  n.model.change_regimes(changes);  // the neighbour starts 20 mm inside the column
  ASSERT_EQ(changes.size(), 1u);
  Vector force;
  n.model.internal_forces(force);
  EXPECT_NEAR(force[0], 0.75 * 20.0, 1e-12);
  EXPECT_NEAR(force[1], 0.25 * 20.0, 1e-12);
  EXPECT_NEAR(force[2], -20.0, 1e-12);
  EXPECT_EQ(force[3], 0.0);
}

TEST(GapPoints, TangentIsTheDerivativeOfTheForces) {
  Neighbours n;
  add(n.model, Gap{.name = "mid-column",
                   .left = MemberPoint{n.low, n.high, 0.25},
                   .right = MemberPoint{n.other, ground, 0.5},
                   .clearance = 1 * mm,
                   .law = law});
  n.model.prepare();
  std::vector<RegimeChange> changes;
  n.model.change_regimes(changes);
  SparseMatrix tangent = n.model.pattern();
  n.model.assemble_tangent(0.0, 0.0, 1.0, tangent);
  const Eigen::Vector3d weights{0.75, 0.25, -0.5};
  const Eigen::MatrixXd expected = 1000.0 * weights * weights.transpose();
  EXPECT_LT((Eigen::MatrixXd{tangent.view()} - expected).cwiseAbs().maxCoeff(), 1e-12);
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
  EXPECT_THROW(add(n.model, Gap{.name = "g",
                                .left = MemberPoint{n.low, n.low, 0.5},
                                .right = n.other,
                                .clearance = 1 * cm,
                                .law = law}),
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
