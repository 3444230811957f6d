#include "structures/shear_building.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "materials/spring_laws.hpp"
#include "message_of.hpp"
#include "moved_model.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

LeadRubberBearing bearing() {
  return {.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};
}

ShearBuilding isolated(int storeys) {
  return {.storeys = storeys,
          .floor_mass = 500 * tonne,
          .storey_stiffness = 1 * GN / m,
          .damping = RayleighDamping{.ratio = 0.05},
          .base_mass = 550 * tonne,
          .isolation = bearing()};
}

ShearBuilding fixed(int storeys) {
  return {.storeys = storeys,
          .floor_mass = 500 * tonne,
          .storey_stiffness = 1 * GN / m,
          .damping = RayleighDamping{.ratio = 0.05}};
}

// Of the forces of the whole model around rest; the last row is the force on the ground.
testing::Derivatives matrices_of(const Model& model) {
  AnalysisState state{model};
  const Vector zero = Vector::Zero(model.degrees_of_freedom());
  return testing::derivatives_at(state, zero, zero, 1e-3, 1e-3);
}

std::vector<std::string> element_names(const Model& model) {
  std::vector<std::string> names;
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) names.push_back(block->info(e).name);
  std::sort(names.begin(), names.end());
  return names;
}

bool has_element(const Model& model, const std::string& name) {
  return std::ranges::count(element_names(model), name) == 1;
}

TEST(ShearBuilding, IsolatedStiffnessAndMassAreThoseOfAChainOnBearings) {
  Model model;
  add(model, isolated(3));
  const testing::Derivatives made = matrices_of(model);
  const double k = 1e9, bearings = 1.93e8;
  const Eigen::Matrix4d expected{
      {k + bearings, -k, 0.0, 0.0}, {-k, 2.0 * k, -k, 0.0}, {0.0, -k, 2.0 * k, -k}, {0.0, 0.0, -k, k}};
  EXPECT_LT((made.stiffness.topRows(4) - expected).norm(), 1e-9 * k);
  EXPECT_EQ(model.mass_matrix().diagonal(), (Vector{{550e3, 500e3, 500e3, 500e3}}));
}

TEST(ShearBuilding, DampingHasItsRatioInTheFirstTwoModesOfTheSuperstructure) {
  for (const int storeys : {2, 5, 12}) {
    Model model;
    add(model, isolated(storeys));
    const testing::Derivatives made = matrices_of(model);
    // Held at the base: without the first row and column.
    const Eigen::MatrixXd stiffness = made.stiffness.block(1, 1, storeys, storeys);
    const Eigen::MatrixXd damping = made.damping.block(1, 1, storeys, storeys);
    const Eigen::MatrixXd mass = model.mass_matrix().diagonal().tail(storeys).asDiagonal();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes{stiffness, mass};
    for (int i = 0; i < storeys; ++i) {
      const Eigen::VectorXd shape = modes.eigenvectors().col(i);  // mass-normalised
      const double ratio = shape.dot(damping * shape) / (2.0 * std::sqrt(modes.eigenvalues()[i]));
      if (i < 2)
        EXPECT_NEAR(ratio, 0.05, 1e-9) << storeys << " storeys, mode " << i + 1;
      else
        EXPECT_GT(ratio, 0.05) << storeys << " storeys, mode " << i + 1;
    }
    // Rayleigh damping leaves the modes uncoupled.
    const Eigen::MatrixXd modal = modes.eigenvectors().transpose() * damping * modes.eigenvectors();
    EXPECT_LT((modal - Eigen::MatrixXd{modal.diagonal().asDiagonal()}).norm(), 1e-9 * modal.norm());
  }
}

TEST(ShearBuilding, DampingActsWithinTheBuilding) {
  Model model;
  add(model, isolated(5));
  const testing::Derivatives made = matrices_of(model);
  const Eigen::MatrixXd damping = made.damping.topRows(6);
  // Moving as a rigid body it feels none, and its dampers together never push the building as a whole: the mass part
  // reacts on the base, nothing on the ground.
  EXPECT_LT((damping * Eigen::VectorXd::Ones(6)).norm(), 1e-9 * damping.norm());
  EXPECT_LT((Eigen::RowVectorXd::Ones(6) * damping).norm(), 1e-9 * damping.norm());
  EXPECT_EQ(made.damping.row(6).norm(), 0.0);
  // Every floor is tied to the base.
  for (int floor = 2; floor <= 5; ++floor) EXPECT_LT(damping(0, floor), 0.0) << floor;
}

TEST(ShearBuilding, NamesItsParts) {
  Model model;
  const Building nodes = add(model, isolated(2));
  EXPECT_EQ(model.node_name(nodes.base), "base");
  ASSERT_EQ(nodes.floors.size(), 2u);
  EXPECT_EQ(model.node_name(nodes.floors[0]), "floor 1");
  for (const int number : {1, 2}) EXPECT_EQ(model.node_name(nodes.floor(number)), "floor " + std::to_string(number));
  EXPECT_EQ(model.node_name(nodes.top()), "floor 2");
  EXPECT_EQ(model.body(nodes.top()).height, 7.0);
  EXPECT_EQ(element_names(model),
            (std::vector<std::string>{"bearings", "floor 1 damping", "floor 2 damping", "storey 1", "storey 1 damping",
                                      "storey 2", "storey 2 damping"}));
  ASSERT_EQ(model.buildings().size(), 1u);
  EXPECT_EQ(model.buildings()[0].base_name(), "base");
  EXPECT_EQ(model.buildings()[0].nodes(), (std::vector<NodeId>{nodes.base, nodes.floors[0], nodes.floors[1]}));
}

TEST(ShearBuilding, TwoInAModelDifferByTheirName) {
  Model model;
  ShearBuilding north = isolated(1), south = isolated(1);
  north.name = "north";
  south.name = "south";
  south.x = 20 * m;
  add(model, north);
  const Building nodes = add(model, south);
  EXPECT_EQ(model.node_name(nodes.base), "south base");
  EXPECT_EQ(model.node_name(nodes.top()), "south floor 1");
  EXPECT_EQ(model.body(nodes.top()).x, 20.0);
  EXPECT_EQ(element_names(model),
            (std::vector<std::string>{"north bearings", "north storey 1", "north storey 1 damping", "south bearings",
                                      "south storey 1", "south storey 1 damping"}));
  EXPECT_EQ(model.buildings()[1].base_name(), "south base");
  EXPECT_EQ(message_of([&] { add(model, north); }),
            "ShearBuilding \"north\": the model has a node \"north floor 1\" already. Give every building its own "
            ".name.");
}

TEST(ShearBuilding, FixedBaseStandsOnTheGround) {
  Model model;
  const Building nodes = add(model, fixed(3));
  EXPECT_EQ(nodes.base, ground);
  EXPECT_EQ(model.degrees_of_freedom(), 3);
  EXPECT_EQ(model.buildings()[0].nodes(), nodes.floors);
  const testing::Derivatives made = matrices_of(model);
  const double k = 1e9;
  const Eigen::Matrix3d expected{{2.0 * k, -k, 0.0}, {-k, 2.0 * k, -k}, {0.0, -k, k}};
  EXPECT_LT((made.stiffness.topRows(3) - expected).norm(), 1e-9 * k);
  // The dashpots of the mass part stand on the ground, which is the base here.
  const RayleighFactors factors =
      rayleigh_factors_of_chain(0.05, std::vector<Mass>(3, 500 * tonne), std::vector<Stiffness>(3, 1 * GN / m));
  const Eigen::Matrix3d damping =
      factors.stiffness_factor * expected + factors.mass_factor * 500e3 * Eigen::Matrix3d::Identity();
  EXPECT_LT((made.damping.topRows(3) - damping).norm(), 1e-9 * damping.norm());
}

template <class Change>
std::string refusal(Change change) {
  ShearBuilding building = isolated(2);
  building.name = "house";
  change(building);
  return message_of([&] {
    Model model;
    add(model, building);
  });
}

TEST(ShearBuilding, RefusesBadParameters) {
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.storeys = 0; }),
            "ShearBuilding \"house\": storeys = 0 is not allowed; it must be >= 1. Give a number in this range.");
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.floor_mass = -1 * kg; }),
            "ShearBuilding \"house\": floor_mass = -1 kg is not allowed; it must be > 0 kg and finite. Check its sign "
            "and its unit.");
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.storey_stiffness = 0 * N / m; }),
            "ShearBuilding \"house\": storey_stiffness = 0 N/m is not allowed; it must be > 0 N/m and finite. Check "
            "its sign and its unit.");
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.storey_height = 0 * m; }),
            "ShearBuilding \"house\": storey_height = 0 m is not allowed; it must be > 0 m and finite. Check its sign "
            "and its unit.");
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.half_width = 0 * m; }),
            "ShearBuilding \"house\": half_width = 0 m is not allowed; it must be > 0 m and finite. Check its sign and "
            "its unit.");
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.base_mass = {}; }),
            "ShearBuilding \"house\": base_mass = 0 kg is not allowed; it must be > 0 kg and finite. "
            "An isolated building needs the mass of its base floor.");
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.isolation.reset(); }),
            "ShearBuilding \"house\": base_mass = 550000 kg is not allowed; it must be left out without isolation: the "
            "ground is the base. Give .isolation, or leave out .base_mass.");
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.damping.ratio = 5.0; }),
            "RayleighDamping: ratio = 5 is not allowed; it must be >= 0 and < 1. 5 % of critical is 0.05.");
}

TEST(ShearBuilding, RefusesABearingThatIsTiedElsewhere) {
  // The building sets both ends; given ends would be ignored.
  Model model;
  const NodeId other = add(model, Node{.name = "other", .mass = 1 * tonne});
  ShearBuilding building = isolated(1);
  LeadRubberBearing tied = bearing();
  tied.upper = other;
  building.isolation = tied;
  EXPECT_EQ(message_of([&] { add(model, building); }),
            "ShearBuilding: isolation.upper is given. Leave it out: the bearings carry the base.");
  tied = bearing();
  tied.lower = other;
  building.isolation = tied;
  EXPECT_EQ(message_of([&] { add(model, building); }),
            "ShearBuilding: isolation.lower is given. Leave it out: the bearings stand on the ground.");
}

// Deformation to force, without history.
struct HardeningPad {
  struct State {};
  Stiffness stiffness;

  void check(const Check& check) const { check.positive("stiffness", stiffness); }
  Response evaluate(const State&, double d, double, State&) const {
    return {.force = stiffness.si() * d * (1.0 + d * d), .stiffness = stiffness.si() * (1.0 + 3.0 * d * d)};
  }
  double stored_energy(const State&, double d) const { return stiffness.si() * d * d * (0.5 + 0.25 * d * d); }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return stiffness.si(); }
};

TEST(ShearBuilding, StandsOnAnyLaw) {
  Model model;
  ShearBuilding building = isolated(1);
  building.isolation = HardeningPad{.stiffness = 5 * MN / m};
  const Building added = add(model, building);
  const auto isolators = isolators_of(model, model.buildings());
  ASSERT_EQ(isolators[0].size(), 1u);
  const ElementInfo& info = model.blocks()[isolators[0][0].block]->info(isolators[0][0].element);
  EXPECT_EQ(info.name, "bearings");
  EXPECT_EQ(info.second, added.base);
  EXPECT_EQ(info.force_quantity, "isolator_force");
  const testing::Derivatives made = matrices_of(model);
  EXPECT_NEAR(made.stiffness(2, 0), -5e6, 10.0) << "the part that reaches the ground";
}

TEST(ShearBuilding, NamesIsolatorsAsTheyAreNamed) {
  Model model;
  ShearBuilding building = isolated(1);
  building.name = "tower";
  building.isolation = Isolator{.name = "pads", .law = HardeningPad{.stiffness = 5 * MN / m}};
  add(model, building);
  EXPECT_TRUE(has_element(model, "tower pads"));
  EXPECT_EQ(refusal([](ShearBuilding& b) { b.isolation = HardeningPad{.stiffness = -1 * N / m}; }),
            "Isolator \"house bearings\": stiffness = -1 N/m is not allowed; it must be > 0 N/m and finite. Check its "
            "sign and its unit.");
}

TEST(ShearBuilding, TakesAValueForEveryStorey) {
  Model model;
  ShearBuilding building = fixed(3);
  building.floor_mass = {500 * tonne, 400 * tonne, 250 * tonne};
  building.storey_stiffness = {1 * GN / m, 0.8 * GN / m, 0.5 * GN / m};
  building.storey_height = {5 * m, 4 * m, 3 * m};
  const Building added = add(model, building);
  EXPECT_EQ(model.body(added.top()).height, 12.0);
  const testing::Derivatives made = matrices_of(model);
  EXPECT_EQ(model.mass_matrix().diagonal(), (Vector{{500e3, 400e3, 250e3}}));
  const Eigen::Matrix3d expected{{1.8e9, -0.8e9, 0.0}, {-0.8e9, 1.3e9, -0.5e9}, {0.0, -0.5e9, 0.5e9}};
  EXPECT_LT((made.stiffness.topRows(3) - expected).norm(), 1.0);
}

TEST(ShearBuilding, RefusesListsThatDoNotFit) {
  EXPECT_EQ(
      refusal([](ShearBuilding& b) {
        b.floor_mass = {1 * tonne, 2 * tonne, 3 * tonne};
      }),
      "ShearBuilding \"house\": floor_mass has 3 values for 2 storeys. Give one value for all storeys, or one for "
      "each from the lowest up.");
  EXPECT_EQ(refusal([](ShearBuilding& b) {
              b.storey_stiffness = {1 * MN / m, -2 * MN / m};
            }),
            "ShearBuilding \"house\": storey_stiffness of storey 2 = -2e+06 N/m is not allowed; it must be > 0 N/m and "
            "finite. Check its sign and its unit.");
}

TEST(ShearBuilding, GivesItsWeightToPendulums) {
  for (const int count : {1, 20}) {
    Model model;
    ShearBuilding building = isolated(5);
    building.isolation = Isolator<FrictionPendulum>{.law = {.radius = 3 * m, .friction = 0.05}, .count = count};
    const Building added = add(model, building);
    const SparseMatrix stiffness = model.linear_stiffness(StiffnessStage::post_yield);
    const double weight = 3050e3 * standard_gravity;
    const int base = added.base.index;
    EXPECT_NEAR(stiffness.coeff(base, base) - 1e9, weight / 3.0, 1e-9 * weight);
  }
}

TEST(ShearBuilding, PutsIsolatorsAndDampersSideBySide) {
  Model model;
  ShearBuilding building = isolated(1);
  building.isolation = Isolation{bearing(), NonlinearViscous{.reference_force = 1 * MN, .exponent = 0.3},
                                 NonlinearViscous{.reference_force = 2 * MN, .exponent = 1.0}};
  add(model, building);
  for (const char* name : {"bearings", "dampers", "dampers 2"}) EXPECT_TRUE(has_element(model, name)) << name;
}

TEST(ShearBuilding, LeansUnderTheWeightAbove) {
  const auto stiffness_of = [](bool p_delta) {
    Model model;
    ShearBuilding building = isolated(2);
    building.isolation.reset();
    building.base_mass = Mass{};
    building.p_delta = p_delta;
    add(model, building);
    const SparseMatrix stiffness = model.linear_stiffness(StiffnessStage::initial);
    return stiffness.coeff(1, 1);
  };
  EXPECT_NEAR(stiffness_of(false) - stiffness_of(true), 500e3 * standard_gravity / 3.5, 1.0);
}

TEST(ShearBuilding, HasStoreysThatYield) {
  ShearBuilding building = isolated(2);
  building.storey = YieldingStorey{.stiffness = 1 * GN / m, .yield_force = 6 * MN};
  Model refused, model;
  EXPECT_EQ(
      message_of([&] { add(refused, building); }),
      "ShearBuilding: storey_stiffness and storey are given. Give one of them: storey_stiffness for linear storeys, "
      "storey for others.");
  building.storey_stiffness = Stiffness{};
  add(model, building);
  EXPECT_TRUE(has_element(model, "storey 2"));
  EXPECT_TRUE(has_element(model, "storey 2 damping"));
  building.storey.reset();
  Model none;
  EXPECT_NE(message_of([&] { add(none, building); }), "nothing was thrown");
}

TEST(Isolator, AsksForTheWeightThatAPendulumNeeds) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  Isolator<FrictionPendulum> pendulum{.upper = base, .law = {.radius = 3 * m, .friction = 0.05}};
  EXPECT_EQ(message_of([&] { add(model, pendulum); }),
            "Isolator \"bearings\": weight = 0 N is not allowed; it must be > 0 N and finite. Give the weight that it "
            "carries; a ShearBuilding knows its own.");
  pendulum.law.weight = 5 * MN;
  add(model, pendulum);
  EXPECT_TRUE(has_element(model, "bearings"));
}

}  // namespace
}  // namespace moat
