// Bodies in generalised coordinates, and masses that couple degrees of freedom.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "analyses/modes/periods.hpp"
#include "analyses/time_history/transient.hpp"
#include "base/error.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/spring.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "small_models.hpp"
#include "solvers/modes.hpp"

namespace moat {
namespace {

using namespace units;

// A spring whose stiffness may be negative, N/m.
struct Signed {
  double stiffness = 0.0;

  using State = NoState;
  static constexpr bool linear_within_regimes = true;
  Response evaluate(const State&, double d, double, State&) const { return {stiffness * d, stiffness, 0.0}; }
  double stored_energy(const State&, double d) const { return 0.5 * stiffness * d * d; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return stiffness; }
};

// Springs between all nodes, and from each to the ground, that have this stiffness together.
void add_stiffness(Model& model, const std::vector<NodeId>& nodes, const Eigen::MatrixXd& stiffness) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const std::string name = "spring " + std::to_string(i);
    add(model, Spring<Signed>{.name = name, .lower = ground, .upper = nodes[i], .law = {stiffness.row(row).sum()}});
    for (std::size_t j = 0; j < i; ++j)
      add(model, Spring<Signed>{.name = name + " " + std::to_string(j),
                                .lower = nodes[j],
                                .upper = nodes[i],
                                .law = {-stiffness(row, static_cast<Eigen::Index>(j))}});
  }
}

GroundMotion shaking() {
  std::vector<double> samples;
  for (int i = 0; i <= 200; ++i) samples.push_back(3.0 * std::sin(0.3 * i) * std::sin(0.031 * i));
  return {"shaking", 0.01, std::move(samples)};
}

// Two masses coupled by m12 on springs to the ground: with M^-1/2-scaled modes the free vibration is a sum of cosines.
struct CoupledPair {
  Model model;
  NodeId a = add(model, Node{.name = "a", .mass = 3 * tonne, .initial_displacement = 2 * cm});
  NodeId b = add(model, Node{.name = "b", .mass = 2 * tonne});
  Eigen::Matrix2d mass{{3e3 + 400.0, 1.5e3}, {1.5e3, 2e3 + 900.0}}, stiffness{{9e5, 0.0}, {0.0, 4e5}};

  CoupledPair() {
    add(model, ShearSpring{.name = "spring a", .lower = ground, .upper = a, .stiffness = 900 * kN / m});
    add(model, ShearSpring{.name = "spring b", .lower = ground, .upper = b, .stiffness = 400 * kN / m});
    model.add_mass({a, b}, Eigen::Matrix2d{{400.0, 1.5e3}, {1.5e3, 900.0}});
  }
  [[nodiscard]] Eigen::Vector2d exact(double time) const {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> modes{stiffness, mass};
    const Eigen::Matrix2d shapes = modes.eigenvectors();
    const Eigen::Vector2d start = shapes.transpose() * mass * Eigen::Vector2d{0.02, 0.0};
    return shapes * start.cwiseProduct((modes.eigenvalues().cwiseSqrt() * time).array().cos().matrix());
  }
};

TEST(CoupledMasses, VibrateAsInClosedForm) {
  const GroundMotion still = testing::still_ground(1 * s);
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{ExactBetweenEvents{}}}) {
    const CoupledPair pair;
    Transient analysis{pair.model, still, {.integrator = integrator, .tolerance = 1e-7}};
    while (!analysis.finished()) {
      analysis.advance();
      const Eigen::Vector2d exact = pair.exact(analysis.state().time());
      EXPECT_NEAR(analysis.state().displacement(pair.a), exact[0], 1e-8);
      EXPECT_NEAR(analysis.state().displacement(pair.b), exact[1], 1e-8);
    }
  }
}

TEST(CoupledMasses, CountInEnergiesAndModes) {
  const CoupledPair pair;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> exact{pair.stiffness, pair.mass};
  SparseMatrix mass = pair.model.zero_matrix();
  pair.model.mass_matrix().add_to(1.0, mass);
  const std::vector<Mode> modes = slowest_modes(pair.model.linear_stiffness(StiffnessStage::initial), mass, 2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(modes[static_cast<std::size_t>(i)].angular_frequency, std::sqrt(exact.eigenvalues()[i]), 1e-10);
    const Vector& shape = modes[static_cast<std::size_t>(i)].shape;
    EXPECT_NEAR(shape.dot(mass * shape), 1.0, 1e-12);
  }
  Transient analysis{pair.model, shaking()};
  analysis.run();
  const Vector velocity = analysis.state().motion().velocity.head(2);
  EXPECT_NEAR(analysis.state().kinetic_energy(), 0.5 * velocity.dot(pair.mass * velocity), 1e-9);
}

// The base shear of a building is minus the inertia of its nodes: without damping the sum of their springs' forces.
TEST(CoupledMasses, CountInTheBaseShear) {
  CoupledPair pair;
  add(pair.model, Building{.base = pair.a, .floors = {pair.b}});
  PeakRecorder peaks{pair.model};
  Transient analysis{pair.model, shaking()};
  analysis.attach(peaks);
  double largest = 9e5 * 0.02;  // at the start
  while (!analysis.finished()) {
    analysis.advance();
    const Vector u = analysis.state().motion().displacement.head(2);
    largest = std::max(largest, std::abs((pair.stiffness * u).sum()));
  }
  const std::vector<Peak> list = peaks.peaks();
  const auto shear = std::ranges::find(list, "total_base_shear", &Peak::quantity);
  ASSERT_NE(shear, list.end());
  EXPECT_NEAR(shear->magnitude(), largest, 1e-4 * largest);
  EXPECT_EQ(std::ranges::find(list, "sum_of_floor_inertia_maxima", &Peak::quantity), list.end());
}

TEST(CoupledMasses, AreRefusedWhereTheMatrixIsNotPositiveDefinite) {
  CoupledPair pair;
  EXPECT_THROW(pair.model.add_mass({pair.a, pair.b}, Eigen::Matrix2d{{0.0, 5e3}, {5e3, 0.0}}), InputError);
  EXPECT_THROW(pair.model.add_mass({pair.a, pair.a}, Eigen::Matrix2d::Identity()), InputError);
  EXPECT_THROW(pair.model.add_mass({pair.a, ground}, Eigen::Matrix2d::Identity()), InputError);
  EXPECT_THROW(pair.model.add_mass({pair.a, pair.b}, Eigen::Matrix2d{{1.0, 0.5}, {0.4, 1.0}}), InputError);
  EXPECT_EQ(pair.model.mass_matrix().diagonal()[0], 3400.0);
}

// Four storeys in nodes, and in four generalised coordinates q with u = T q: with fixed steps of average acceleration
// both are the same equations.
TEST(GeneralisedBodies, MoveAsTheNodesThatTheyStandFor) {
  const Eigen::Vector4d masses{40e3, 30e3, 30e3, 20e3};
  Eigen::Matrix4d stiffness{
      {8e7, -4e7, 0.0, 0.0}, {-4e7, 7e7, -3e7, 0.0}, {0.0, -3e7, 5e7, -2e7}, {0.0, 0.0, -2e7, 2e7}};
  const Eigen::Matrix4d shapes{
      {0.3, 0.8, -0.5, 0.1}, {0.6, 0.7, 0.6, -0.4}, {0.8, -0.2, 0.4, 0.7}, {1.0, -0.9, -0.6, -0.2}};

  Model nodes;
  std::vector<NodeId> floors;
  for (int i = 0; i < 4; ++i)
    floors.push_back(add(nodes, Node{.name = "floor " + std::to_string(i), .mass = masses[i] * kg}));
  add_stiffness(nodes, floors, stiffness);

  Model modes;
  Eigen::Matrix4d mass = shapes.transpose() * masses.asDiagonal() * shapes;
  mass = (0.5 * (mass + mass.transpose())).eval();
  const Eigen::Vector4d influence = shapes.inverse() * Eigen::Vector4d::Ones();
  GeneralisedBody body{.name = "building", .coordinates = {}, .mass = mass};
  for (int i = 0; i < 4; ++i)
    body.coordinates.push_back({.name = "q" + std::to_string(i + 1), .ground_influence = {influence[i], 0.0, 0.0}});
  const std::vector<NodeId> coordinates = add(modes, body);
  add_stiffness(modes, coordinates, shapes.transpose() * stiffness * shapes);
  EXPECT_EQ(modes.node_name(coordinates[2]), "building:q3");
  EXPECT_EQ(modes.bodies().size(), 1U);
  EXPECT_EQ(modes.body_of(coordinates[1]).size(), 4U);

  const TransientOptions fixed{.step = 2 * ms, .force_tolerance = 1e-12};
  Transient of_nodes{nodes, shaking(), fixed}, of_modes{modes, shaking(), fixed};
  of_nodes.run();
  of_modes.run();
  const Eigen::Vector4d u = of_nodes.state().motion().displacement.head(4),
                        q = of_modes.state().motion().displacement.head(4);
  EXPECT_LT((shapes * q - u).cwiseAbs().maxCoeff(), 1e-10 * u.cwiseAbs().maxCoeff());
  EXPECT_NEAR(of_modes.state().kinetic_energy(), of_nodes.state().kinetic_energy(),
              1e-9 * of_nodes.state().kinetic_energy());
  const std::vector<NamedPeriod> exact = characteristic_periods(nodes), found = characteristic_periods(modes);
  ASSERT_EQ(found.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(found[i].value, exact[i].value, 1e-9 * exact[i].value);
}

// A mass on a spring moves up and down under a vertical motion as another one moves along the same horizontal motion.
TEST(GeneralisedBodies, FollowTheVerticalGround) {
  const GroundMotion along = shaking();
  const GroundMotion up =
      GroundMotion{"still", 0.01, std::vector<double>(along.samples().size(), 0.0)}.with_component_z(
          {along.samples().begin(), along.samples().end()});
  const auto end_of = [](GroundVector influence, const GroundMotion& motion) {
    Model model;
    const std::vector<NodeId> nodes =
        add(model, GeneralisedBody{.name = "mass",
                                   .coordinates = {{.name = "up", .ground_influence = influence}},
                                   .mass = Eigen::MatrixXd::Constant(1, 1, 2e3)});
    add(model, Spring<Signed>{.name = "spring", .lower = ground, .upper = nodes[0], .law = {5e5}});
    Transient analysis{model, motion, {.step = 1 * ms}};
    analysis.run();
    return analysis.state().displacement(nodes[0]);
  };
  const double vertical = end_of({0.0, 0.0, 1.0}, up);
  EXPECT_NE(vertical, 0.0);
  EXPECT_DOUBLE_EQ(vertical, end_of({1.0, 0.0, 0.0}, along));
  EXPECT_THROW(end_of({1.0, 0.0, 0.0}, up), InputError) << "the ground lifts nothing";
  EXPECT_THROW(static_cast<void>(along.with_component_z({1.0, 2.0})), InputError);
}

TEST(GeneralisedBodies, RefuseBadMassesAndNames) {
  Model model;
  const auto body = [](std::vector<GeneralisedCoordinate> coordinates, const Eigen::MatrixXd& mass) {
    return GeneralisedBody{.name = "body", .coordinates = std::move(coordinates), .mass = mass};
  };
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(1, 1), two = Eigen::MatrixXd::Identity(2, 2);
  EXPECT_THROW(add(model, body({}, one)), InputError);
  EXPECT_THROW(add(model, body({{.name = "q"}}, two)), InputError);
  EXPECT_THROW(add(model, body({{.name = "q"}}, -one)), InputError);
  EXPECT_THROW(add(model, body({{.name = "q"}, {.name = "q"}}, two)), InputError);
  EXPECT_THROW(add(model, body({{.name = "q"}, {.name = "p"}}, Eigen::Matrix2d{{1.0, 0.2}, {0.1, 1.0}})), InputError);
  EXPECT_EQ(model.degrees_of_freedom(), 0);
  add(model, body({{.name = "q"}}, one));
  EXPECT_THROW(add(model, Node{.name = "body:q", .mass = 1 * kg}), InputError);
}

}  // namespace
}  // namespace moat
