#include "elements/matrix/linear_structure.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "message_of.hpp"
#include "moved_model.hpp"
#include "small_models.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

// Three nodes on a base, with signed couplings between all of them.
struct OnBase {
  Model model;
  std::vector<NodeId> nodes;
  NodeId base;
  Eigen::Matrix3d stiffness{{3e6, -1e6, 4e5}, {-1e6, 2e6, -8e5}, {4e5, -8e5, 1e6}};
  Eigen::Matrix3d damping{{3e4, -1e4, 0.0}, {-1e4, 2e4, -5e3}, {0.0, -5e3, 8e3}};
  Eigen::MatrixXd carried{{1.0}, {0.5}, {2.0}};

  OnBase() {
    base = add(model, Node{.name = "base", .mass = 2e3 * kg, .initial_displacement = 2 * cm});
    for (int i = 0; i < 3; ++i)
      nodes.push_back(add(model, Node{.name = "node " + std::to_string(i),
                                      .mass = (1e3 + 200.0 * i) * kg,
                                      .initial_displacement = (1.0 + i) * cm,
                                      .initial_velocity = (0.1 - 0.2 * i) * (m / s)}));
  }
  [[nodiscard]] LinearStructure structure() const {
    return {.name = "frame",
            .nodes = nodes,
            .base = {base},
            .carried = carried,
            .stiffness = stiffness,
            .damping = damping};
  }
};

TEST(LinearStructure, ForcesAndTangentsAreThoseOfItsMatrices) {
  OnBase on_base;
  add(on_base.model, on_base.structure());
  AnalysisState state{on_base.model};
  const Eigen::Vector4d u{0.01, -0.02, 0.03, 0.015}, v{0.4, 0.1, -0.3, 0.2};
  const Eigen::Vector3d own = u.tail(3) - on_base.carried * u[0], rate = v.tail(3) - on_base.carried * v[0],
                        force = on_base.stiffness * own + on_base.damping * rate;
  const Vector found = testing::forces_at(state, u, v);
  EXPECT_LT((found.segment(1, 3) - force).norm(), 1e-9 * force.norm());
  EXPECT_NEAR(found[0], -on_base.carried.col(0).dot(force), 1e-9 * force.norm());
  const testing::Derivatives exact = testing::derivatives_at(state, u, v, 1e-3, 1e-3);
  testing::move_to(state, u, v);
  EXPECT_LT((testing::tangent_of(state, 0.0, 0.0, 1.0) - exact.stiffness.topRows(4)).norm(),
            1e-9 * exact.stiffness.norm());
  EXPECT_LT((testing::tangent_of(state, 0.0, 1.0, 0.0) - exact.damping.topRows(4)).norm(), 1e-9 * exact.damping.norm());
}

TEST(LinearStructure, MotionOfTheBaseStrainsNothing) {
  OnBase on_base;
  add(on_base.model, on_base.structure());
  AnalysisState state{on_base.model};
  const Eigen::Vector4d rigid{0.3, 0.3 * 1.0, 0.3 * 0.5, 0.3 * 2.0};
  EXPECT_EQ(testing::forces_at(state, rigid, rigid).head(4).cwiseAbs().maxCoeff(), 0.0);
}

// Work is stored or dissipated: by quadrature in steps of fourth order, and by mean forces in steps of second order.
TEST(LinearStructure, ItsEnergiesBalance) {
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{HilberHughesTaylor{}}}) {
    OnBase on_base;
    add(on_base.model, on_base.structure());
    add(on_base.model, ShearSpring{.name = "below", .lower = ground, .upper = on_base.base, .stiffness = 2 * MN / m});
    const GroundMotion still = testing::still_ground(1 * s);
    Transient analysis{on_base.model, still, {.integrator = integrator}};
    EnergyLedger ledger;
    analysis.attach(ledger);
    analysis.run();
    const EnergyBalance balance = ledger.at_end();
    EXPECT_GT(balance.viscous, 0.1 * balance.largest_kinetic);
    EXPECT_LT(balance.error_share(), 1e-4);
  }
}

TEST(LinearStructure, ADampedNodeDecaysAsTheClosedForm) {
  Model model;
  const NodeId node = add(model, Node{.name = "node", .mass = 1e3 * kg, .initial_displacement = 5 * cm});
  const double w = 20.0, z = 0.1, wd = w * std::sqrt(1.0 - z * z);
  add(model, LinearStructure{.name = "oscillator",
                             .nodes = {node},
                             .stiffness = Eigen::MatrixXd::Constant(1, 1, 1e3 * w * w),
                             .damping = Eigen::MatrixXd::Constant(1, 1, 2.0 * z * w * 1e3)});
  const GroundMotion still = testing::still_ground(1 * s);
  Transient analysis{model, still, {.integrator = ExactBetweenEvents{}}};
  analysis.run();
  const double t = analysis.state().time();
  const double exact = 0.05 * std::exp(-z * w * t) * (std::cos(wd * t) + z * w / wd * std::sin(wd * t));
  EXPECT_NEAR(analysis.state().displacement(node), exact, 1e-12);
}

TEST(LinearStructure, BadMatricesAndNodesAreRefused) {
  const auto refused = [](const auto& change) {
    return message_of([&] {
      OnBase on_base;
      LinearStructure structure = on_base.structure();
      change(on_base, structure);
      add(on_base.model, structure);
    });
  };
  const auto has = [](const std::string& message, const std::string& words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  has(refused([](OnBase&, LinearStructure& s) { s.stiffness(0, 1) = 7.0; }), "stiffness is not a symmetric matrix");
  has(refused([](OnBase&, LinearStructure& s) { s.damping = Eigen::MatrixXd::Identity(2, 2); }),
      "damping is not a symmetric matrix");
  has(refused([](OnBase&, LinearStructure& s) { s.stiffness(1, 1) = -1.0; }), "diagonal >= 0");
  has(refused([](OnBase&, LinearStructure& s) { s.carried = Eigen::MatrixXd::Ones(2, 1); }), "carried is not a matrix");
  has(refused([](OnBase& o, LinearStructure& s) { s.nodes[1] = o.base; }), "repeated");
  has(refused([](OnBase&, LinearStructure& s) { s.nodes[1] = ground; }), "the ground");
  has(refused([](OnBase&, LinearStructure& s) { s.nodes.clear(); }), "no nodes are given");
  has(refused([](OnBase&, LinearStructure& s) { s.stiffness.setZero(); }), "largest stiffness");
  has(refused([](OnBase& o, LinearStructure& s) { add(o.model, s); }), "an element of this name exists");
}

}  // namespace
}  // namespace moat
