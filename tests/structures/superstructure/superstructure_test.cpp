#include "structures/superstructure/superstructure.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analyses/case/input_warnings.hpp"
#include "message_of.hpp"
#include "output/files/building_rows.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "output/recorders/storey_shears.hpp"
#include "output/vtk/model_scene.hpp"
#include "peak_in.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;
using testing::peak;

constexpr int storeys = 3;

GroundMotion shaking() {
  std::vector<double> samples;
  for (int i = 0; i < 600; ++i)
    samples.push_back(3.0 * std::sin(0.07 * i) * std::exp(-1e-5 * i * i) + std::cos(0.31 * i));
  return {"shaking", 0.01, samples};
}

GroundMotion shaking_in_plan() {
  std::vector<double> along_y;
  for (int i = 0; i < 600; ++i) along_y.push_back(2.0 * std::cos(0.05 * i) * std::exp(-1e-5 * i * i));
  const GroundMotion x = shaking();
  return x.with_component_y(along_y, x, {"y", 0.01, along_y});
}

Eigen::MatrixXd chain_stiffness() {
  Eigen::MatrixXd k{storeys, storeys};
  k << 2.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 1.0;
  return 1e9 * k;
}

LeadRubberBearing bearing() {
  return {.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};
}

std::vector<SuperstructureFloor> floors_on_line() {
  std::vector<SuperstructureFloor> floors;
  for (int i = 1; i <= storeys; ++i) floors.push_back({.height = 3.5 * i * m, .mass = 500 * tonne});
  return floors;
}

Superstructure matrices_on_line() {
  return {.stiffness = in_units(chain_stiffness(), {.force = N, .length = m}),
          .freedoms = per_floor(Freedoms::x),
          .floors = floors_on_line(),
          .damping = RayleighDamping{.ratio = 0.05},
          .base = SuperstructureBase{.mass = 550 * tonne},
          .isolation = bearing()};
}

// The modes of the same building, normalised by the mass in kg.
Superstructure modes_on_line() {
  Superstructure building = matrices_on_line();
  const Eigen::MatrixXd mass = 500e3 * Eigen::MatrixXd::Identity(storeys, storeys);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver{chain_stiffness(), mass};
  building.stiffness.reset();
  building.modes = StructureModes{.eigenvalues = {solver.eigenvalues().data(), solver.eigenvalues().data() + storeys},
                                  .shapes = solver.eigenvectors()};
  return building;
}

// A base shear is the force of these bearings at every instant.
void expect_sum_of_bearings(const CaseResult& result, const std::string& shear, const std::string& force,
                            const std::vector<std::string>& bearings) {
  const std::vector<double>& values = result.histories.values(shear, "base");
  for (std::size_t i = 0; i < values.size(); ++i) {
    double sum = 0.0;
    for (const std::string& bearing : bearings) sum += result.histories.values(force, bearing)[i];
    EXPECT_NEAR(values[i], sum, 1e-6 * peak(result, shear, "base")) << i;
  }
}

CaseResult run(const Model& model, const GroundMotion& motion, const TransientOptions& options) {
  CaseRun run{model, motion, {.transient = options, .error_bars = ErrorBarMode::never}};
  run.run();
  return run.result();
}

const std::vector<std::pair<std::string, std::string>>& peaks_on_line() {
  static const std::vector<std::pair<std::string, std::string>> list{{"displacement", "base"},
                                                                     {"displacement", "floor 3"},
                                                                     {"absolute_acceleration", "base"},
                                                                     {"absolute_acceleration", "floor 1"},
                                                                     {"absolute_acceleration", "floor 3"},
                                                                     {"drift", "storey 1"},
                                                                     {"drift", "storey 3"},
                                                                     {"storey_shear", "storey 2"},
                                                                     {"total_base_shear", "base"},
                                                                     {"isolator_deformation", "bearings"}};
  return list;
}

void expect_equal(const CaseResult& a, const CaseResult& b, double tolerance) {
  for (const auto& [quantity, where] : peaks_on_line()) {
    const double expected = peak(b, quantity, where);
    EXPECT_NEAR(peak(a, quantity, where), expected, tolerance * expected) << quantity << " at " << where;
  }
}

std::vector<TransientOptions> all_integrators() {
  return {{.step = 2 * ms},
          {.integrator = HilberHughesTaylor{}, .step = 2 * ms},
          {.integrator = GeneralizedAlpha{.spectral_radius = 0.8}, .step = 2 * ms},
          {.integrator = ExactBetweenEvents{}}};
}

TEST(Superstructure, AShearBuildingGivenByItsMatrixHasItsPeaks) {
  for (const TransientOptions& options : all_integrators()) {
    Model given, shear;
    add(given, matrices_on_line());
    add(shear, ShearBuilding{.storeys = storeys,
                             .floor_mass = 500 * tonne,
                             .storey_stiffness = 1 * GN / m,
                             .damping = RayleighDamping{.ratio = 0.05},
                             .base_mass = 550 * tonne,
                             .isolation = bearing()});
    expect_equal(run(given, shaking(), options), run(shear, shaking(), options), 1e-10);
  }
}

TEST(Superstructure, AllModesAreTheMatrices) {
  for (const TransientOptions& options : all_integrators()) {
    TransientOptions strict = options;
    strict.force_tolerance = 1e-12;
    Model matrices, modes;
    add(matrices, matrices_on_line());
    add(modes, modes_on_line());
    const CaseResult by_matrices = run(matrices, shaking(), strict);
    expect_equal(run(modes, shaking(), strict), by_matrices, 1e-9);
  }
}

TEST(Superstructure, OnTheGroundModesAndMatricesAgreeToo) {
  for (const bool modal : {false, true}) {
    Superstructure fixed = modal ? modes_on_line() : matrices_on_line();
    fixed.base.reset();
    fixed.isolation.reset();
    Model given, shear;
    add(given, fixed);
    add(shear, ShearBuilding{.storeys = storeys,
                             .floor_mass = 500 * tonne,
                             .storey_stiffness = 1 * GN / m,
                             .damping = RayleighDamping{.ratio = 0.05}});
    const CaseResult a = run(given, shaking(), {.step = 2 * ms}), b = run(shear, shaking(), {.step = 2 * ms});
    for (const auto& [quantity, where] : {std::pair{"absolute_acceleration", "floor 1"},
                                          {"displacement", "floor 3"},
                                          {"drift", "storey 1"},
                                          {"storey_shear", "storey 1"},
                                          {"total_base_shear", "base"}})
      EXPECT_NEAR(peak(a, quantity, where), peak(b, quantity, where), 1e-9 * peak(b, quantity, where)) << quantity;
  }
}

TEST(Superstructure, GapsActOnFloorsThatFollowModes) {
  const auto with_gaps = [](Superstructure building) {
    Model model;
    const SuperstructureParts parts = add(model, building);
    add(model, Gap{.name = "roof wall",
                   .left = parts.floor(3),
                   .right = ground,
                   .clearance = 2 * cm,
                   .law = Kelvin{.stiffness = 200 * MN / m, .restitution = 0.6}});
    add(model, Gap{.name = "column wall",
                   .left = ground,
                   .right = MemberPoint{parts.floor(1), parts.floor(2), 0.4},
                   .clearance = 3 * cm,
                   .law = LinearElastic{.stiffness = 100 * MN / m}});
    const TransientOptions strict{.step = 0.5 * ms, .force_tolerance = 1e-12};
    return run(model, shaking(), strict);
  };
  const CaseResult modes = with_gaps(modes_on_line()), matrices = with_gaps(matrices_on_line());
  ASSERT_GT(matrices.impacts.size(), 4U);
  EXPECT_EQ(modes.impacts.size(), matrices.impacts.size());
  expect_equal(modes, matrices, 1e-7);
  for (const char* gap : {"roof wall", "column wall"})
    EXPECT_NEAR(peak(modes, "impact_force", gap), peak(matrices, "impact_force", gap),
                1e-7 * peak(matrices, "impact_force", gap));
}

TEST(Superstructure, TheMassThatModesLeaveOutRidesOnTheBase) {
  Superstructure few = modes_on_line();
  few.modes->keep = 1;
  Model model;
  const SuperstructureParts parts = add(model, few);
  // The whole mass moves with the base where the coordinate does not.
  EXPECT_NEAR(model.mass_matrix().at(0, 0), 550e3 + storeys * 500e3, 1e-6);
  ASSERT_EQ(parts.notes.size(), 1U);
  const double share = 1.0 - parts.modes.at(0).x;
  EXPECT_NE(parts.notes[0].find("The modes leave out " + to_text(100.0 * share) + " %"), std::string::npos)
      << parts.notes[0];
}

TEST(Superstructure, ParticipatingMassesOfAllModesAddUpToTheWhole) {
  Model model;
  const SuperstructureParts parts = add(model, matrices_on_line());
  double sum = 0.0;
  for (const ParticipatingMass& mode : parts.modes) sum += mode.x;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  // Of a chain of three equal storeys: w = 2 sqrt(k/m) sin(pi/14).
  EXPECT_NEAR(parts.periods().at(0), std::numbers::pi / (std::sqrt(1e9 / 500e3) * std::sin(std::numbers::pi / 14.0)),
              1e-12);
}

// Stiffness, masses and outlines in plan, floors with centres of mass that do not lie above each other.
struct PlanCase {
  Eigen::MatrixXd stiffness{9, 9};
  std::vector<SuperstructureFloor> floors;
  PlanOutline outline = rectangle(24 * m, 15 * m);

  PlanCase() {
    Eigen::MatrixXd root{9, 9};
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j) root(i, j) = std::sin(1.0 + 3.0 * i + 7.0 * j) * (j % 3 == 2 ? 8.0 : 1.0);
    stiffness = 1e8 * (root.transpose() * root);
    for (int i = 0; i < 3; ++i)
      for (int d = 0; d < 3; ++d) stiffness(3 * i + d, 3 * i + d) += d == 2 ? 6e10 : 1e9;
    for (int i = 0; i < 3; ++i)
      floors.push_back({.height = (4.0 + 3.5 * i) * m,
                        .mass = (820 - 150 * i) * tonne,
                        .centre_of_mass = {0.6 * i * m, -0.4 * i * m},
                        .outline = outline});
  }

  [[nodiscard]] Superstructure building() const {
    return {.stiffness = in_units(stiffness, {.force = N, .length = m}),
            .floors = floors,
            .damping = ModalDamping{0.05},
            .base = SuperstructureBase{.mass = 900 * tonne, .outline = outline},
            .bearings =
                grid(3, 3,
                     BiaxialBilinear{
                         .yield_force = 120 * kN, .yield_displacement = 8 * mm, .post_yield_stiffness = 1.5 * MN / m})};
  }
};

TEST(Superstructure, UnitsAndOrderOfTheRowsDoNotMatter) {
  const PlanCase plan;
  const auto result_of = [&](const Superstructure& building) {
    Model model;
    add(model, building);
    return run(model, shaking_in_plan(), {.step = 2 * ms});
  };
  const CaseResult reference = result_of(plan.building());
  const auto expect_same = [&](const CaseResult& result, const char* which) {
    for (const auto& [quantity, where] : {std::pair{"displacement", "base"},
                                          {"displacement", "floor 3"},
                                          {"rotation", "floor 2"},
                                          {"storey_torque", "storey 1"}})
      EXPECT_NEAR(peak(result, quantity, where), peak(reference, quantity, where),
                  1e-10 * peak(reference, quantity, where))
          << which << ": " << quantity << " at " << where;
  };
  // kN and cm.
  Superstructure other = plan.building();
  Eigen::MatrixXd values = plan.stiffness;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) values(i, j) *= 1e-3 * std::pow(100.0, (i % 3 == 2) + (j % 3 == 2) - 1);
  other.stiffness = in_units(values, {.force = kN, .length = cm});
  expect_same(result_of(other), "kN and cm");
  // The highest floor first, and a list.
  Superstructure listed = plan.building(), top_down = plan.building();
  Eigen::MatrixXd turned{9, 9}, mixed{9, 9};
  std::vector<Freedom> rows;
  std::vector<int> from_top, from_list;
  for (int i = 0; i < 9; ++i) {
    from_top.push_back(3 * (2 - i / 3) + i % 3);
    from_list.push_back((4 * i) % 9);
    rows.push_back({1 + from_list.back() / 3, static_cast<FloorDirection>(from_list.back() % 3)});
  }
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 9; ++j) {
      turned(static_cast<int>(i), static_cast<int>(j)) = plan.stiffness(from_top[i], from_top[j]);
      mixed(static_cast<int>(i), static_cast<int>(j)) = plan.stiffness(from_list[i], from_list[j]);
    }
  top_down.stiffness = in_units(turned, {.force = N, .length = m});
  top_down.freedoms = per_floor(Freedoms::x_y_rotation, FloorOrder::top_down);
  expect_same(result_of(top_down), "from the top down");
  listed.stiffness = in_units(mixed, {.force = N, .length = m});
  listed.freedoms = rows;
  expect_same(result_of(listed), "a list");
  MatrixInUnits named = in_units(mixed, {.force = N, .length = m});
  for (const Freedom& row : rows) named.names.push_back(row.name());
  Superstructure by_names = plan.building();
  by_names.stiffness = named;
  expect_same(result_of(by_names), "names in the file");
}

TEST(Superstructure, StoreyForcesAndDampingBalanceTheInertiaOfTheFloors) {
  // sum(K v + C v') over floors j >= i is minus the inertia of these floors, at every instant.
  const PlanCase plan;
  Superstructure undamped = plan.building();
  undamped.damping = std::monostate{};
  Model model;
  const SuperstructureParts parts = add(model, undamped);
  Transient transient{model, shaking_in_plan(), {.step = 2 * ms, .end = 2 * s}};
  const Building& building = model.buildings().front();
  double largest = 0.0, worst = 0.0;
  while (!transient.finished()) {
    transient.advance();
    const AnalysisState& state = transient.state();
    const GroundVector ground_acceleration = shaking_in_plan().components_at(state.time());
    for (const StoreyResult& result : building.storey_results) {
      if (result.place != "storey 2") continue;
      double of_result = 0.0, inertia = 0.0;
      for (const MotionShare& share : result.displacements) of_result += share.weight * state.displacement(share.node);
      for (int floor = 2; floor <= 3; ++floor) {
        const PlacedDiaphragm& its = model.diaphragm(parts.floor(floor));
        const double x = its.mass * (state.acceleration(its.id.x) + ground_acceleration.x),
                     y = its.mass * (state.acceleration(its.id.y) + ground_acceleration.y);
        const double arm = its.height - 4.0;
        if (result.quantity == "storey_shear_x") inertia += x;
        if (result.quantity == "storey_shear_y") inertia += y;
        if (result.quantity == "overturning_moment_x") inertia += arm * x;
        if (result.quantity == "overturning_moment_y") inertia += arm * y;
        if (result.quantity == "storey_torque")
          inertia += its.centre_of_mass.x * y - its.centre_of_mass.y * x +
                     its.mass * its.gyration * state.acceleration(its.id.r);
      }
      largest = std::max(largest, std::abs(of_result));
      worst = std::max(worst, std::abs(of_result + inertia));
    }
  }
  EXPECT_GT(largest, 1e6);
  EXPECT_LT(worst, 1e-7 * largest);
}

TEST(Superstructure, ModesInPlanAreTheMatrices) {
  const PlanCase plan;
  Superstructure by_modes = plan.building();
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(9, 9);
  for (int i = 0; i < 9; ++i) {
    const SuperstructureFloor& floor = plan.floors[static_cast<std::size_t>(i / 3)];
    mass(i, i) = floor.mass.si() * (i % 3 == 2 ? plan.outline.gyration_squared() : 1.0);
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver{plan.stiffness, mass};
  by_modes.stiffness.reset();
  // Any norm: the masses of the modes count.
  Eigen::MatrixXd shapes = solver.eigenvectors();
  for (int i = 0; i < 9; ++i) shapes.col(i) *= 1.0 + 3.0 * i;
  by_modes.modes = StructureModes{.eigenvalues = {solver.eigenvalues().data(), solver.eigenvalues().data() + 9},
                                  .shapes = shapes,
                                  .norm = ShapeNorm::any};
  const auto result_of = [&](const Superstructure& building) {
    Model model;
    const SuperstructureParts parts = add(model, building);
    add(model, PlanMoat{.around = parts.base, .clearance = 1 * cm, .law = LinearElastic{.stiffness = 200 * MN / m}});
    add(model, PlanMoat{.name = "collar",
                        .around = parts.floor(2),
                        .clearance = 2 * cm,
                        .law = LinearElastic{.stiffness = 100 * MN / m}});
    return run(model, shaking_in_plan(), {.step = 0.5 * ms, .end = 3 * s, .force_tolerance = 1e-12});
  };
  const CaseResult matrices = result_of(plan.building()), modes = result_of(by_modes);
  ASSERT_GT(matrices.impacts.size(), 3U);
  EXPECT_EQ(matrices.impacts.size(), modes.impacts.size());
  for (const auto& [quantity, where] : {std::pair{"displacement", "floor 3"},
                                        {"rotation", "base"},
                                        {"absolute_acceleration", "floor 1"},
                                        {"storey_shear_x", "storey 1"},
                                        {"storey_torque", "storey 2"},
                                        {"overturning_moment_y", "storey 1"},
                                        {"total_base_shear_x", "base"},
                                        {"total_base_torque", "base"},
                                        {"impact_force", "collar"},
                                        {"corner_drift", "floor 2"}})
    EXPECT_NEAR(peak(modes, quantity, where), peak(matrices, quantity, where), 1e-7 * peak(matrices, quantity, where))
        << quantity << " at " << where;
}

TEST(Superstructure, ATurnedBuildingUnderATurnedMotionIsTheSame) {
  const PlanCase plan;
  const Angle angle = 37 * deg;
  const double c = std::cos(angle.si()), sine = std::sin(angle.si());
  Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(9, 9);
  for (int i = 0; i < 9; i += 3) turn.block<2, 2>(i, i) = Eigen::Matrix2d{{c, -sine}, {sine, c}};
  Superstructure other = plan.building();
  const Eigen::MatrixXd stiffness = turn * plan.stiffness * turn.transpose();
  other.stiffness = in_units(0.5 * (stiffness + stiffness.transpose()), {.force = N, .length = m});
  for (SuperstructureFloor& floor : other.floors) {
    floor.centre_of_mass = turned(floor.centre_of_mass, angle);
    floor.outline = turned(floor.outline, angle);
  }
  other.base->outline = turned(plan.outline, angle);
  std::vector<PlanBearings::Placed> bearings;
  for (const PlanBearings::Placed& each : plan.building().bearings.placed(Check{"test", ""}, plan.outline)) {
    bearings.push_back(each);
    bearings.back().at = turned(each.at, angle);
  }
  other.bearings = bearings;
  std::vector<double> x, y;
  const GroundMotion motion = shaking_in_plan();
  for (std::size_t i = 0; i < motion.samples().size(); ++i) {
    x.push_back(c * motion.samples()[i] - sine * motion.samples_y()[i]);
    y.push_back(sine * motion.samples()[i] + c * motion.samples_y()[i]);
  }
  const GroundMotion turned_motion = GroundMotion{"x", 0.01, x}.with_component_y(y, {"x", 0.01, x}, {"y", 0.01, y});
  Model plain, rotated;
  add(plain, plan.building());
  add(rotated, other);
  const TransientOptions strict{.step = 2 * ms, .force_tolerance = 1e-12};
  const CaseResult a = run(rotated, turned_motion, strict), b = run(plain, motion, strict);
  for (const auto& [quantity, where] : {std::pair{"displacement", "base"},
                                        {"displacement", "floor 3"},
                                        {"rotation", "floor 3"},
                                        {"absolute_acceleration", "floor 2"},
                                        {"storey_torque", "storey 1"},
                                        {"corner_drift", "floor 1"}})
    EXPECT_NEAR(peak(a, quantity, where), peak(b, quantity, where), 1e-9 * peak(b, quantity, where)) << quantity;
}

TEST(Superstructure, TwoHalvesOnOneBaseAreTheWhole) {
  const PlanCase plan;
  Superstructure half = plan.building(), other = plan.building();
  half.name = "west";
  other.name = "east";
  for (Superstructure* each : {&half, &other}) {
    each->stiffness->values *= 0.5;
    for (SuperstructureFloor& floor : each->floors) floor.mass = 0.5 * floor.mass.value();
  }
  Model both, whole;
  const SuperstructureParts west = add(both, half);
  other.base.reset();
  other.bearings = {};
  other.on = {west.base};
  const SuperstructureParts east = add(both, other);
  add(whole, plan.building());
  const TransientOptions strict{.step = 2 * ms, .force_tolerance = 1e-12};
  const CaseResult a = run(both, shaking_in_plan(), strict), b = run(whole, shaking_in_plan(), strict);
  for (const char* quantity : {"total_base_shear_x", "total_base_torque"})
    EXPECT_NEAR(peak(a, quantity, "west base"), peak(b, quantity, "base"), 1e-10 * peak(b, quantity, "base"));
  for (const std::string tower : {"west ", "east "}) {
    EXPECT_NEAR(peak(a, "displacement", tower + "floor 3"), peak(b, "displacement", "floor 3"), 1e-11);
    EXPECT_NEAR(2.0 * peak(a, "storey_shear_x", tower + "storey 1"), peak(b, "storey_shear_x", "storey 1"),
                1e-10 * peak(b, "storey_shear_x", "storey 1"));
  }
  EXPECT_EQ(east.base, west.base);
}

// On a base with a tower, pendulums swing with 2 pi sqrt(R/g) once they know the weight of both.
TEST(Superstructure, BearingsCarryTowersThatAreAddedLater) {
  const auto first = [](Mass carried, bool has_tower) {
    Model model;
    Superstructure podium = matrices_on_line();
    podium.isolation = FrictionPendulum{.radius = 2.25 * m, .friction = 0.05};
    podium.base->carried = carried;
    const SuperstructureParts parts = add(model, podium);
    Superstructure tower = matrices_on_line();
    tower.name = "tower";
    tower.base.reset();
    tower.isolation.reset();
    tower.on = {parts.base};
    if (has_tower) add(model, tower);
    for (const auto& block : model.blocks())
      for (std::size_t e = 0; e < block->size(); ++e)
        for (const Parameter& parameter : block->law(e).parameters)
          if (parameter.name == "weight") return std::pair{parameter.value, model_warnings(model)};
    return std::pair{0.0, model_warnings(model)};
  };
  EXPECT_NEAR(first(1500 * tonne, true).first, 3550e3 * standard_gravity, 1.0);
  EXPECT_TRUE(first(1500 * tonne, true).second.empty());
  EXPECT_TRUE(first(0 * tonne, false).second.empty());
  EXPECT_EQ(
      first(0 * tonne, true).second,
      (std::vector<std::string>{"The isolators of the building are made for a weight of " +
                                to_text(2050 * standard_gravity) + " kN, and " + to_text(3550 * standard_gravity) +
                                " kN stand on them. Give their .weight; under a base that carries buildings "
                                "added later, SuperstructureBase::carried."}));
}

TEST(Superstructure, SlabsThatMoveApartStrainIt) {
  // A floor on two columns, each on a slab of its own, by springs and by the matrix of all.
  const double k = 4e7;
  Model springs, matrix;
  std::vector<NodeId> slabs;
  for (Model* model : {&springs, &matrix}) {
    slabs.clear();
    for (int i = 1; i <= 2; ++i) {
      const std::string number = std::to_string(i);
      slabs.push_back(add(*model, Node{.name = "slab " + number, .mass = 100.0 * i * tonne}));
      add(*model, LeadRubberBearing{.name = "bearings " + number,
                                    .upper = slabs.back(),
                                    .yield_force = 100.0 * i * kN,
                                    .yield_displacement = 1 * cm,
                                    .post_yield_stiffness = 1.0 / i * MN / m});
    }
  }
  const NodeId floor = add(springs, Node{.name = "floor 1", .mass = 200 * tonne});
  for (int i = 0; i < 2; ++i)
    add(springs, ShearSpring{.name = "column " + std::to_string(i),
                             .lower = slabs[static_cast<std::size_t>(i)],
                             .upper = floor,
                             .stiffness = k * N / m});
  const Eigen::Matrix3d whole{{k, 0.0, -k}, {0.0, k, -k}, {-k, -k, 2.0 * k}};
  Superstructure building{.stiffness = in_units(whole, {.force = N, .length = m}),
                          .freedoms = {{0, FloorDirection::x, 1}, {0, FloorDirection::x, 2}, {1, FloorDirection::x}},
                          .floors = {{.height = 4 * m, .mass = 200 * tonne}}};
  for (const NodeId slab : slabs) building.on.push_back({.x = slab});
  EXPECT_TRUE(add(matrix, building).notes.empty());
  const CaseResult a = run(matrix, shaking(), {.step = 2 * ms}), b = run(springs, shaking(), {.step = 2 * ms});
  for (const char* place : {"slab 1", "slab 2", "floor 1"})
    EXPECT_NEAR(peak(a, "displacement", place), peak(b, "displacement", place), 1e-10 * peak(b, "displacement", place));
  EXPECT_GT(std::abs(peak(b, "displacement", "slab 1") - peak(b, "displacement", "slab 2")), 1e-3);

  // Both slabs are in the results of the building.
  ASSERT_EQ(a.buildings.size(), 1U);
  EXPECT_EQ(a.buildings[0].isolators, (std::vector<std::string>{"bearings 1", "bearings 2"}));
  const std::string largest =
      peak(a, "isolator_deformation", "bearings 1") > peak(a, "isolator_deformation", "bearings 2") ? "bearings 1"
                                                                                                    : "bearings 2";
  EXPECT_TRUE(building_table(a).rows.front().cells.front().where.starts_with(largest));
  expect_sum_of_bearings(a, "total_base_shear", "isolator_force", {"bearings 1", "bearings 2"});
  const auto period = [&](const std::string& name) {
    const auto found = std::ranges::find(a.periods, name, &NamedPeriod::name);
    return found == a.periods.end() ? std::nan("") : found->value;
  };
  EXPECT_NEAR(period("isolation, rigid building"), 2.0 * pi * std::sqrt(500e3 / 1.5e6), 1e-9);
  EXPECT_NEAR(period("fixed base"), 2.0 * pi * std::sqrt(200e3 / (2.0 * k)), 1e-9);
}

// A floor on four columns, two on each of two slabs in plan.
TEST(Superstructure, BaseShearInPlanIsTheSumOverSlabs) {
  const double k = 4e7, column_x = 6.0, column_y = 4.0;
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(9, 9);
  Superstructure building{.floors = {{.height = 4 * m, .mass = 200 * tonne, .outline = rectangle(14 * m, 10 * m)}}};
  std::vector<Freedom> freedoms;
  for (int i = 0; i < 9; ++i)
    freedoms.push_back({i < 6 ? 0 : 1, static_cast<FloorDirection>(i % 3), i < 6 ? i / 3 + 1 : 1});
  building.freedoms = freedoms;
  Model model;
  std::vector<std::string> bearings;
  std::vector<PlanVector> places;
  for (int slab = 0; slab < 2; ++slab) {
    const double x = (slab == 0 ? -1.0 : 1.0) * column_x;
    const DiaphragmId id = add(model, Diaphragm{.name = "slab " + std::to_string(slab + 1),
                                                .mass = 100.0 * (slab + 1) * tonne,
                                                .rotary_inertia = 1e6 * kg * m * m,
                                                .centre_of_mass = {x * m, 0 * m}});
    building.on.push_back(id);
    for (const double y : {-column_y, column_y}) {
      Eigen::MatrixXd drift = Eigen::MatrixXd::Zero(2, 9);
      drift.middleCols<3>(3 * slab) << -1.0, 0.0, y, 0.0, -1.0, 0.0;
      drift.rightCols<3>() << 1.0, 0.0, -y, 0.0, 1.0, x;
      whole += k * drift.transpose() * drift;
      bearings.push_back("bearing " + std::to_string(bearings.size() + 1));
      places.push_back({x, y});
      add(model, PlanBearing<BiaxialBilinear>{.name = bearings.back(),
                                              .under = id,
                                              .at = {x * m, y * m},
                                              .law = {.yield_force = 40.0 * (slab + 1) * kN,
                                                      .yield_displacement = 1 * cm,
                                                      .post_yield_stiffness = 1 * MN / m}});
    }
  }
  building.stiffness = in_units(whole, {.force = N, .length = m});
  EXPECT_TRUE(add(model, building).notes.empty());
  const CaseResult result = run(model, shaking_in_plan(), {.step = 2 * ms});
  EXPECT_EQ(result.buildings.at(0).isolators, bearings);
  expect_sum_of_bearings(result, "total_base_shear_x", "isolator_force_x", bearings);
  expect_sum_of_bearings(result, "total_base_shear_y", "isolator_force_y", bearings);
  const std::vector<double>& torque = result.histories.values("total_base_torque", "base");
  for (std::size_t i = 0; i < torque.size(); ++i) {
    double sum = 0.0;
    for (std::size_t b = 0; b < bearings.size(); ++b)
      sum += cross(places[b], {result.histories.values("isolator_force_x", bearings[b])[i],
                               result.histories.values("isolator_force_y", bearings[b])[i]});
    EXPECT_NEAR(torque[i], sum, 1e-6 * peak(result, "total_base_torque", "base"));
  }
}

// Slabs under several superstructures: the first building with them counts all that stands on it.
TEST(Superstructure, SlabsBelongToOneBuildingEach) {
  Model model;
  std::vector<DiaphragmId> slabs;
  for (const char* name : {"slab 1", "slab 2", "slab 3"})
    slabs.push_back({.x = add(model, Node{.name = name, .mass = 100 * tonne})});
  const auto on = [&](const char* name, const std::vector<DiaphragmId>& carrying) {
    const Eigen::Matrix3d whole{{1e7, 0.0, -1e7}, {0.0, 1e7, -1e7}, {-1e7, -1e7, 2e7}};
    return add(model, Superstructure{
                          .name = name,
                          .stiffness = in_units(whole, {.force = N, .length = m}),
                          .freedoms = {{0, FloorDirection::x, 1}, {0, FloorDirection::x, 2}, {1, FloorDirection::x}},
                          .floors = {{.height = 4 * m, .mass = 200 * tonne}},
                          .on = carrying});
  };
  EXPECT_TRUE(on("first", {slabs[0], slabs[1]}).notes.empty());
  EXPECT_TRUE(on("second", {slabs[1], slabs[0]}).notes.empty());
  EXPECT_EQ(carried_nodes(model, model.buildings()[0]).size(), 4U);
  const std::vector<std::string> notes = on("third", {slabs[2], slabs[0]}).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0],
            "\"slab 1\" belongs to another building than the first slab, whose base shear counts the inertia of all "
            "floors alone.");
}

TEST(Superstructure, ItsStoreysAreDrawnWithTheirShears) {
  Superstructure held = matrices_on_line();
  held.damping = std::monostate{};
  Model matrices, modes;
  add(matrices, held);
  Superstructure modal = modes_on_line();
  modal.damping = std::monostate{};
  add(modes, modal);
  for (const Model* model : {&matrices, &modes}) {
    const Scene scene = scene_of(*model);
    ASSERT_EQ(scene.storeys.size(), 3U);
    EXPECT_EQ(std::ranges::count(scene.cells, CellKind::storey, &SceneCell::kind), 3);
    Transient analysis{*model, shaking(), {.step = 2 * ms, .end = 2 * s}};
    analysis.run();
    const AnalysisState& state = analysis.state();
    StoreyShears shears{*model, scene.storeys};
    const auto found = shears.evaluate(state);
    for (std::size_t i = 0; i < 3; ++i) {
      const double drift = state.displacement(scene.storeys[i].second) - state.displacement(scene.storeys[i].first);
      EXPECT_NEAR(found[i], 1e9 * drift, 1e-6 * std::abs(1e9 * drift));
    }
  }
}

// ---------------------------------------------------------------------------------------------------------- refusals

std::string refusal(const Superstructure& building) {
  return message_of([&] {
    Model model;
    add(model, building);
  });
}

template <class Change>
std::string refusal_of(const Change& change) {
  Superstructure building = matrices_on_line();
  change(building);
  return refusal(building);
}

void expect_words(const std::string& message, const std::string& words) {
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

TEST(Superstructure, BadMatricesAreRefusedWithTheNumber) {
  expect_words(refusal_of([](Superstructure& b) { b.stiffness->values(0, 1) *= 1.1; }),
               "stiffness is not symmetric: entry (floor 1 x, floor 2 x) = -1.1e+09, transposed -1e+09");
  expect_words(refusal_of([](Superstructure& b) { b.stiffness->values(2, 2) = 1e21; }),
               "stiffness of floor 3 x is 5e+11 times the median");
  expect_words(refusal_of([](Superstructure& b) { b.stiffness->values(1, 1) = -1.0; }),
               "stiffness of floor 2 x is -1.");
  expect_words(refusal_of([](Superstructure& b) { b.stiffness->values(0, 0) = 1e9 / 3.0; }),
               "stiffness is indefinite: eigenvalue -");
  expect_words(refusal_of([](Superstructure& b) { b.stiffness->values(0, 0) = 1e9; }), "nothing holds them");
  expect_words(refusal_of([](Superstructure& b) { b.freedoms = per_floor(Freedoms::x_y_rotation); }),
               "rotary_inertia = 0 kg m^2 is not allowed");
  expect_words(refusal_of([](Superstructure& b) { b.floors.pop_back(); }),
               "floors has 2 entries, the matrix has floor 3 x.");
  expect_words(refusal_of([](Superstructure& b) { b.floors[2].height = 7 * m; }), "heights must rise: floor 3 at 7 m");
  expect_words(refusal_of([](Superstructure& b) { b.isolation.reset(); }), "base is given without bearings");
  expect_words(refusal_of([](Superstructure& b) { b.base.reset(); }), "bearings are given without base");
  expect_words(refusal_of([](Superstructure& b) { b.damping = ModalDamping{5.0}; }), "5 % is 0.05");
  expect_words(refusal_of([](Superstructure& b) {
                 b.modes = StructureModes{.shapes = Eigen::MatrixXd{3, 3}};
               }),
               "2 of them are given");
  expect_words(refusal_of([](Superstructure& b) {
                 b.freedoms = {{1, FloorDirection::x}, {2, FloorDirection::x}};
               }),
               "freedoms lists 2 entries; stiffness has 3 rows");
  expect_words(refusal_of([](Superstructure& b) {
                 b.freedoms = {{1, FloorDirection::x}, {2, FloorDirection::x}, {2, FloorDirection::x}};
               }),
               "the freedom floor 2 x is given twice");
}

TEST(Superstructure, RowsOfTheBaseAreCheckedByRigidMotion) {
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(4, 4);
  whole.bottomRightCorner(3, 3) = chain_stiffness();
  whole(0, 0) = 1e9;
  whole(0, 1) = whole(1, 0) = -1e9;
  Superstructure building = matrices_on_line();
  building.stiffness = in_units(whole, {.force = N, .length = m});
  building.freedoms = per_floor(Freedoms::x).with_base();
  EXPECT_EQ(refusal(building), "nothing was thrown");
  whole(0, 0) = 1.1e9;
  building.stiffness = in_units(whole, {.force = N, .length = m});
  expect_words(refusal(building), "rigid motion of base and floors strains row base x");
}

// A program that prints K with the base prints M so too, or M of the floors alone.
TEST(Superstructure, MassesMayHaveRowsOfTheBase) {
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(4, 4), mass = 500e3 * Eigen::MatrixXd::Identity(4, 4);
  stiffness.bottomRightCorner(3, 3) = chain_stiffness();
  stiffness(0, 0) = 1e9;
  stiffness(0, 1) = stiffness(1, 0) = -1e9;
  Superstructure building = matrices_on_line();
  building.stiffness = in_units(stiffness, {.force = N, .length = m});
  building.freedoms = per_floor(Freedoms::x).with_base();
  const auto first_period = [](const Superstructure& given) {
    Model model;
    return add(model, given).periods().at(0);
  };
  const double expected = first_period(matrices_on_line());
  building.mass = in_units(mass, {.force = N, .length = m});
  EXPECT_NEAR(first_period(building), expected, 1e-12);
  building.mass = in_units(mass.bottomRightCorner(3, 3), {.force = N, .length = m});
  EXPECT_NEAR(first_period(building), expected, 1e-12);
  mass(0, 1) = mass(1, 0) = 1e3;
  building.mass = in_units(mass, {.force = N, .length = m});
  expect_words(refusal(building), "mass couples base x with floors.");
}

// In a building without coupling of its directions, entries of round-off are no forces.
TEST(Superstructure, RoundOffBesideTheBaseIsNoStrain) {
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(6, 6);
  for (int d = 0; d < 3; ++d) {
    const double k = d == 2 ? 6e10 : 1e9;
    whole(d, d) = whole(3 + d, 3 + d) = k;
    whole(d, 3 + d) = whole(3 + d, d) = -k;
  }
  whole(0, 1) = whole(1, 0) = 3e-8;
  whole(4, 0) = whole(0, 4) = -7e-8;
  const PlanCase plan;
  Superstructure building = plan.building();
  building.stiffness = in_units(whole, {.force = N, .length = m});
  building.freedoms = per_floor(Freedoms::x_y_rotation).with_base();
  building.floors = {plan.floors[0]};
  Model model;
  EXPECT_TRUE(add(model, building).notes.empty());
}

TEST(Superstructure, ADampingAgainstTheGroundIsRefused) {
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(4, 4);
  stiffness.bottomRightCorner(3, 3) = chain_stiffness();
  stiffness(0, 0) = 1e9;
  stiffness(0, 1) = stiffness(1, 0) = -1e9;
  Superstructure building = matrices_on_line();
  building.stiffness = in_units(stiffness, {.force = N, .length = m});
  building.freedoms = per_floor(Freedoms::x).with_base();
  building.damping = in_units(1e-3 * stiffness, {.force = N, .length = m});
  EXPECT_EQ(refusal(building), "nothing was thrown");
  building.damping = in_units(1e-3 * stiffness + 2e5 * Eigen::MatrixXd::Identity(4, 4), {.force = N, .length = m});
  expect_words(refusal(building), "alphaM of OpenSees damps motion against the ground");
}

TEST(Superstructure, DampersAlongOneDirectionAreADamping) {
  const PlanCase plan;
  Superstructure building = plan.building();
  Eigen::MatrixXd damping = Eigen::MatrixXd::Zero(9, 9);
  damping(0, 0) = 1e6;
  building.damping = in_units(damping, {.force = N, .length = m});
  EXPECT_EQ(refusal(building), "nothing was thrown");
  damping(0, 0) = -1e6;
  building.damping = in_units(damping, {.force = N, .length = m});
  expect_words(refusal(building), "damping of floor 1 x is -1e+06.");
}

TEST(Superstructure, RatiosOfAllModesHoldForThoseThatAreKept) {
  Superstructure building = modes_on_line();
  building.damping = ModalDamping{0.05, 0.03, 0.02};
  building.modes->keep = 2;
  EXPECT_EQ(refusal(building), "nothing was thrown");
  building.damping = ModalDamping{0.05, 0.03, 0.02, 0.01};
  expect_words(refusal(building), "damping has 4 ratios for 2 modes.");
}

TEST(Superstructure, OneModeInPlanIsABuilding) {
  const PlanCase plan;
  Superstructure building = plan.building();
  building.stiffness.reset();
  // All floors move by 1 along x.
  Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(9, 1);
  double mass = 0.0;
  for (int i = 0; i < 9; i += 3) {
    shape(i, 0) = 1.0;
    mass += plan.floors[static_cast<std::size_t>(i / 3)].mass.si();
  }
  building.modes = StructureModes{.periods = {0.5 * s}, .shapes = shape / std::sqrt(mass)};
  for (const bool fixed : {false, true}) {
    if (fixed) {
      building.base.reset();
      building.bearings = {};
    }
    Model model;
    const SuperstructureParts parts = add(model, building);
    EXPECT_NEAR(parts.periods().at(0), 0.5, 1e-12);
    EXPECT_NEAR(parts.modes.at(0).x, 1.0, 1e-12);
  }
}

TEST(Superstructure, RatiosOfOneModeThatIsLeft) {
  Superstructure building = modes_on_line();
  building.damping = ModalDamping{0.05, 0.03};
  Model model;
  const std::vector<std::string> notes = add(model, building).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "Mode 3 has the damping ratio of mode 2.");
}

// Shapes of any size are the same building after Loewdin's orthonormalisation.
TEST(Superstructure, OrthonormalisedShapesDoNotDependOnTheirSize) {
  const auto periods = [](double factor) {
    Superstructure building = modes_on_line();
    building.modes->shapes(0, 1) *= 1.01;
    building.modes->shapes.col(0) *= factor;
    building.modes->norm = ShapeNorm::any;
    building.modes->orthonormalise = true;
    Model model;
    return add(model, building).modes;
  };
  const auto one = periods(1.0), other = periods(7.0);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_NEAR(one[i].period, other[i].period, 1e-12);
    EXPECT_NEAR(one[i].x, other[i].x, 1e-10);
  }
}

TEST(Superstructure, OtherBasesAndFreedomsAreRefused) {
  Model model;
  const SuperstructureParts modal = add(model, modes_on_line());
  Superstructure on_top = matrices_on_line();
  on_top.name = "top";
  on_top.base.reset();
  on_top.isolation.reset();
  on_top.on = {modal.floor(1)};
  expect_words(message_of([&] { add(model, on_top); }), "it stands on a floor that is given by modes");
  EXPECT_THROW(model.add_mass({modal.floor(1)}, Eigen::MatrixXd::Identity(1, 1)), InputError);
  Superstructure two = matrices_on_line();
  two.stiffness = in_units(1e9 * Eigen::Matrix2d::Identity(), {.force = N, .length = m});
  two.freedoms = {{1, FloorDirection::x}, {1, FloorDirection::y}};
  expect_words(refusal(two), "freedoms have y without rotation");
}

// A damper joins a floor that is given by modes.
TEST(Superstructure, SpringsInPlanJoinFloorsOfModes) {
  const PlanCase plan;
  Superstructure building = plan.building();
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(9, 9);
  for (int i = 0; i < 9; ++i)
    mass(i, i) =
        plan.floors[static_cast<std::size_t>(i / 3)].mass.si() * (i % 3 == 2 ? plan.outline.gyration_squared() : 1.0);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver{plan.stiffness, mass};
  Superstructure modal = building;
  modal.stiffness.reset();
  modal.modes = StructureModes{.eigenvalues = {solver.eigenvalues().data(), solver.eigenvalues().data() + 9},
                               .shapes = solver.eigenvectors()};
  const auto result_of = [](const Superstructure& given) {
    Model model;
    const SuperstructureParts parts = add(model, given);
    add(model, PlanSpring<Viscous>{.name = "damper",
                                   .lower = PlanPoint{parts.base, {10 * m, 5 * m}},
                                   .upper = PlanPoint{parts.floor(3), {10 * m, 5 * m}},
                                   .direction = {1.0, 0.0},
                                   .law = {.damping = 5 * MN * s / m}});
    add(model, PlanSpring<Linear>{.name = "rope",
                                  .lower = PlanPoint{ground, {-10 * m, 5 * m}},
                                  .upper = PlanPoint{parts.floor(2), {-10 * m, 5 * m}},
                                  .direction = {0.0, 1.0},
                                  .law = {.stiffness = 5 * MN / m}});
    return run(model, shaking_in_plan(), {.step = 2 * ms, .force_tolerance = 1e-12});
  };
  const CaseResult a = result_of(modal), b = result_of(building);
  for (const auto& [quantity, where] :
       {std::pair{"displacement", "floor 3"}, {"rotation", "base"}, {"force", "damper"}, {"force", "rope"}})
    EXPECT_NEAR(peak(a, quantity, where), peak(b, quantity, where), 1e-8 * peak(b, quantity, where)) << quantity;
}

// Masses between floors count in the base shear: without damping it is the force of the bearings.
TEST(Superstructure, CoupledMassesCountInTheBaseShearInPlan) {
  const PlanCase plan;
  Superstructure building = plan.building();
  building.damping = std::monostate{};
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(9, 9);
  for (int i = 0; i < 9; ++i)
    mass(i, i) =
        plan.floors[static_cast<std::size_t>(i / 3)].mass.si() * (i % 3 == 2 ? plan.outline.gyration_squared() : 1.0);
  mass(0, 3) = mass(3, 0) = 1e5;
  mass(1, 5) = mass(5, 1) = 2e5;
  building.mass = in_units(mass, {.force = N, .length = m});
  Model model;
  add(model, building);
  Transient transient{model, shaking_in_plan(), {.step = 2 * ms, .end = 2 * s}};
  PeakRecorder peaks{model};
  transient.attach(peaks);
  double largest = 0.0;
  while (!transient.finished()) {
    transient.advance();
    double force = 0.0;
    for (std::size_t b = 0; b < model.blocks().size(); ++b)
      for (const PlanVector& each : transient.state().elements(b).results().plan.forces) force += each.x;
    largest = std::max(largest, std::abs(force));
  }
  const std::vector<Peak> list = peaks.peaks();
  const auto shear = std::ranges::find(list, "total_base_shear_x", &Peak::quantity);
  ASSERT_NE(shear, list.end());
  EXPECT_NEAR(shear->magnitude(), largest, 1e-3 * largest);
}

TEST(Superstructure, ShapesThatDoNotFitTheMassesAreRefused) {
  Superstructure building = modes_on_line();
  building.modes->shapes.col(1) += 0.05 * building.modes->shapes.col(0);
  expect_words(refusal(building), "shapes 1 and 2 are not orthogonal with these masses");
  building = modes_on_line();
  building.modes->shapes *= 2.0;
  expect_words(refusal(building), "Give .norm = ShapeNorm::any");
  building = modes_on_line();
  building.modes->shapes.col(1).setZero();
  expect_words(refusal(building), "shape 2 is zero.");
  building = modes_on_line();
  building.modes->eigenvalues.pop_back();
  expect_words(refusal(building), "shapes has 3 rows and 3 columns, eigenvalues 2.");
}

TEST(Superstructure, AWrongUnitOfTheRotaryInertiaIsRefused) {
  Superstructure building = PlanCase{}.building();
  building.floors[1].rotary_inertia = 1e3 * tonne * m * m / 1e3;
  expect_words(refusal(building), "rotary inertia of floor 2 gives a radius of");
}

}  // namespace
}  // namespace moat
