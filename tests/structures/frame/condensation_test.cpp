// Finite-element models condensed to rigid floors: closed forms, dense computations, refusals.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <vector>

#include "base/units.hpp"
#include "base/vector.hpp"
#include "message_of.hpp"
#include "plane_frames.hpp"
#include "structures/frame/finite_elements.hpp"
#include "structures/frame/frame.hpp"

namespace moat {
namespace {

using namespace units;
using testing::frame_of_twelve_storeys;
using testing::message_of;
using Dense = Eigen::MatrixXd;

// From the longest.
std::vector<double> periods(const Dense& stiffness, const Dense& mass) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Dense> modes{stiffness, mass};
  std::vector<double> result;
  for (const double squared : modes.eigenvalues()) result.push_back(2 * pi / std::sqrt(squared));
  return result;
}

void expect_periods(const std::vector<double>& actual, const std::vector<double>& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 0.6e-8) << "mode " << i + 1;
}

// Four columns below a floor, free to bend at their tops.
Frame floor_in_space() {
  Frame frame{.levels = {{.height = 3.5 * m,
                          .mass = 24 * tonne,
                          .rotary_inertia = 150 * tonne * m_2,
                          .centre_of_mass = PlanPosition{3.1 * m, 2.2 * m}}}};
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {1.0, 5.0}}) {
    const int number = static_cast<int>(frame.nodes.size());
    frame.nodes.push_back({.x = x * m, .y = y * m});
    frame.nodes.push_back({.x = x * m, .y = y * m, .z = 3.5 * m});
    frame.members.push_back(
        {.from = number + 1,
         .to = number + 2,
         .section = {.area = 0.02 * m_2, .I_y = 8e-4 * m_4, .I_z = 5e-4 * m_4, .torsion = 1.2e-3 * m_4},
         .material = {.E = 206 * GPa, .poisson = 0.3}});
  }
  return frame;
}

TEST(Condensation, RigidFloorOnFourColumnsHasItsClosedForm) {
  const CondensedStructure floor = floor_in_space().condensed();
  const double E = 206e9, h3 = 3.5 * 3.5 * 3.5, kx = 3 * E * 5e-4 / h3, ky = 3 * E * 8e-4 / h3;
  double x = 0, y = 0, xx = 0, yy = 0;
  for (const auto& [X, Y] : {std::pair{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {1.0, 5.0}}) {
    x += X - 3.1;
    y += Y - 2.2;
    xx += std::pow(X - 3.1, 2);
    yy += std::pow(Y - 2.2, 2);
  }
  Eigen::Matrix3d expected;
  expected << 4 * kx, 0, -kx * y, 0, 4 * ky, ky * x, -kx * y, ky * x, kx * yy + ky * xx + 4 * E / 2.6 * 1.2e-3 / 3.5;
  EXPECT_LT((floor.stiffness - expected).norm(), 1e-12 * expected.norm());
  EXPECT_NEAR(floor.stiffness(2, 2) / 1e3, 613898.66427, 1e-5);
  EXPECT_TRUE(floor.in_plan);
  EXPECT_EQ(floor.levels[0].height, 3.5);
  expect_periods(periods(floor.stiffness, floor.mass), {0.18130703, 0.14355202, 0.09813926});
  EXPECT_NEAR(floor.levels[0].mass, 24e3, 1e-9);
  EXPECT_NEAR(floor.levels[0].rotary_inertia, 150e3, 1e-6);
  EXPECT_NEAR(floor.levels[0].centre_of_mass.x, 3.1, 1e-14);
  EXPECT_NEAR(floor.levels[0].centre_of_mass.y, 2.2, 1e-14);
}

TEST(Condensation, MassesOfNodesMakeTheCentreOfMass) {
  // The same masses at the nodes: m, its centre, and its inertia come from sums over nodes.
  FiniteElements model = floor_in_space().finite_elements();
  model.diaphragms = {{.height = 3.5 * m}};
  Vector masses = Vector::Zero(48);
  const std::array<double, 4> m_i{5e3, 9e3, 2e3, 8e3}, X{0, 6, 6, 1}, Y{0, 0, 4, 5};
  double total = 0, x = 0, y = 0, inertia = 0;
  for (int i = 0; i < 4; ++i) {
    const auto at = static_cast<std::size_t>(i);
    masses[12 * i + 6] = masses[12 * i + 7] = m_i[at];
    masses[12 * i] = 7e3;
    total += m_i[at];
    x += m_i[at] * X[at];
    y += m_i[at] * Y[at];
  }
  for (std::size_t i = 0; i < 4; ++i)
    inertia += m_i[i] * (std::pow(X[i] - x / total, 2) + std::pow(Y[i] - y / total, 2));
  model.mass = SparseMatrix{masses.asDiagonal()};
  const CondensedStructure floor = condensed(model);
  EXPECT_NEAR(floor.levels[0].mass, total, 1e-9);
  EXPECT_NEAR(floor.levels[0].centre_of_mass.x, x / total, 1e-13);
  EXPECT_NEAR(floor.levels[0].centre_of_mass.y, y / total, 1e-13);
  EXPECT_NEAR(floor.levels[0].rotary_inertia, inertia, 1e-8);
  EXPECT_LT((floor.mass - Dense{Eigen::Vector3d{total, total, inertia}.asDiagonal()}).norm(), 1e-10 * inertia);
  ASSERT_EQ(floor.notes.size(), 2U);
  EXPECT_EQ(floor.notes[0], "Feet are clamped to a base that is rigid in plan; it does not move vertically.");
  EXPECT_EQ(floor.notes[1], "Masses on motions that are held belong to the base or to the ground: 28 t along x.");
}

TEST(Condensation, FrameOfTwelveStoreysHasTheMatrixOfAnotherProgram) {
  const CondensedStructure frame = frame_of_twelve_storeys().condensed();
  expect_periods(periods(frame.stiffness, frame.mass),
                 {1.08026131, 0.36226188, 0.20607959, 0.13890291, 0.10216319, 0.07820498});
  // kN/m, with 12 digits.
  const std::array first{1291934.65268, -991576.038165, 343041.423367,  -70254.2561809, 12254.0301751,  -2472.91834571,
                         482.831346852, -32.9681799902, -4.19428319902, 11.7604763566,  -59.0587133178, 216.387069765};
  for (int i = 0; i < 12; ++i)
    EXPECT_NEAR(frame.stiffness(0, i) / 1e3, first[static_cast<std::size_t>(i)], 1e-11 * 1.3e6) << i;
}

// The frame of twelve storeys, whose floors have their masses along z too, in equal parts at the nodes.
FiniteElements with_vertical_masses(Vanishing masses) {
  FiniteElements model = frame_of_twelve_storeys().finite_elements();
  Vector diagonal = Vector::Zero(6 * std::ssize(model.nodes));
  for (int node = 4; node < std::ssize(model.nodes); ++node) diagonal[6 * node + 2] = node < 48 ? 15e3 : 12.5e3;
  model.mass = SparseMatrix{diagonal.asDiagonal()};
  model.masses = masses;
  return model;
}

TEST(Condensation, VerticalMassesAreRefusedDroppedMovedByGuyanOrKept) {
  EXPECT_EQ(message_of([] { return condensed(with_vertical_masses(Vanishing::refuse)); }),
            "FiniteElements: 48 motions of no level have mass (710 t along z), the first is node 5, z. Take "
            ".masses = Vanishing::drop to leave them out, Vanishing::guyan to move them to the floors, or "
            "Vanishing::keep to keep these motions.");

  const CondensedStructure dropped = condensed(with_vertical_masses(Vanishing::drop));
  expect_periods(periods(dropped.stiffness, dropped.mass), {1.08026131, 0.36226188, 0.20607959});
  EXPECT_EQ(dropped.notes.back(),
            "48 motions of no level have mass (710 t along z), the first is node 5, z; they are left out.");
  EXPECT_TRUE(dropped.eigenvalue_errors.empty());

  const CondensedStructure guyan = condensed(with_vertical_masses(Vanishing::guyan));
  const std::vector<double> by_guyan = periods(guyan.stiffness, guyan.mass);
  expect_periods(by_guyan, {1.08039245, 0.36255266, 0.20614480});
  ASSERT_EQ(guyan.eigenvalue_errors.size(), 12U);
  EXPECT_NEAR(guyan.eigenvalue_errors[0], -1.496e-6, 0.6e-9);
  EXPECT_NEAR(guyan.eigenvalue_errors[1], -9.266e-5, 0.6e-8);
  EXPECT_NEAR(guyan.eigenvalue_errors[2], -1.098e-4, 0.6e-7);
  EXPECT_EQ(guyan.notes[guyan.notes.size() - 11], "Guyan: mode 2 has 0.362553 s, which is about 0.00463 % too short.");

  // All motions kept: rotations are condensed, because they have no mass, vertical ones stay.
  const FiniteElements model = with_vertical_masses(Vanishing::guyan);
  Dense kept = Dense::Zero(model.stiffness.rows(), 12 + 48), turns = Dense::Zero(model.stiffness.rows(), 48);
  Dense mass = Dense::Zero(60, 60);
  for (int node = 0; node < 48; ++node) {
    kept(6 * (node + 4), node / 4) = 1.0;
    kept(6 * (node + 4) + 2, 12 + node) = 1.0;
    turns(6 * (node + 4) + 4, node) = 1.0;
    mass(12 + node, 12 + node) = node < 44 ? 15e3 : 12.5e3;
  }
  for (int floor = 0; floor < 12; ++floor) mass(floor, floor) = floor < 11 ? 60e3 : 50e3;
  const Dense k{model.stiffness};
  const Dense coupling = turns.transpose() * k * kept;
  const Dense exact =
      kept.transpose() * k * kept - coupling.transpose() * (turns.transpose() * k * turns).ldlt().solve(coupling);
  const std::vector<double> all = periods(exact, mass);
  expect_periods(all, {1.08039326, 0.36256946, 0.20615611});
  const CondensedStructure by_keeping = condensed(with_vertical_masses(Vanishing::keep));
  EXPECT_LT((by_keeping.stiffness - exact).norm(), 1e-11 * exact.norm());
  EXPECT_EQ(by_keeping.mass, mass);
  expect_periods(periods(by_keeping.stiffness, by_keeping.mass), all);
  EXPECT_EQ(by_keeping.notes.back(),
            "48 motions of no level have mass (710 t along z), the first is node 5, z; they are kept.");
  ASSERT_EQ(by_keeping.kept.size(), 48U);
  EXPECT_EQ(by_keeping.kept[47].name, "node 52, z");
  EXPECT_EQ(by_keeping.kept[47].level, 11U);
  // The last column stands 10.5 m to the right of the middle.
  EXPECT_TRUE(by_keeping.kept[47].rigid.isApprox(Eigen::Matrix<double, 6, 1>{0, 0, 1, 0, -10.5, 0}, 1e-13));
  for (std::size_t mode = 0; mode < 3; ++mode)
    EXPECT_NEAR(std::pow(by_guyan[mode] / all[mode], 2) - 1.0, guyan.eigenvalue_errors[mode],
                0.02 * std::abs(guyan.eigenvalue_errors[mode]));
}

TEST(Condensation, KeptMotionsHaveThePeriodsOfTheFullEigenproblem) {
  // Masses on all motions of the tops, coupled, and no motion is condensed: T' K T and T' M T have all periods.
  FiniteElements model = floor_in_space().finite_elements();
  model.diaphragms[0].mass = {};
  model.diaphragms[0].rotary_inertia = {};
  model.masses = Vanishing::keep;
  Dense mass = Dense::Zero(48, 48), tied = Dense::Zero(48, 15);
  for (int i = 0; i < 4; ++i) {
    const int row = 12 * i + 6;
    const FrameNode& node = model.nodes[static_cast<std::size_t>(2 * i + 1)];
    mass.diagonal().segment<6>(row) << 6e3, 6e3, 4e3 + 500.0 * i, 900, 700 + 50 * i, 100;
    mass(row + 2, row + 3) = mass(row + 3, row + 2) = 300;
    mass(row, row + 4) = mass(row + 4, row) = -200;
    tied.block<2, 2>(row, 0).setIdentity();
    tied(row, 2) = -node.y.si();
    tied(row + 1, 2) = node.x.si();
    tied(row + 5, 2) = 1.0;
    tied.block<3, 3>(row + 2, 3 + 3 * i).setIdentity();
  }
  model.mass = mass.sparseView();
  const std::vector<double> full =
      periods(tied.transpose() * Dense{model.stiffness} * tied, tied.transpose() * mass * tied);
  const CondensedStructure kept = condensed(model);
  ASSERT_EQ(kept.kept.size(), 12U);
  const std::vector<double> actual = periods(kept.stiffness, kept.mass);
  ASSERT_EQ(actual.size(), full.size());
  for (std::size_t mode = 0; mode < full.size(); ++mode) EXPECT_NEAR(actual[mode] / full[mode], 1.0, 1e-11) << mode;
}

TEST(Condensation, TwoStepsEqualOne) {
  // Rotations are condensed by a dense elimination first.
  const FiniteElements model = frame_of_twelve_storeys().finite_elements();
  const Dense k{model.stiffness};
  std::vector<Eigen::Index> kept, turns;
  std::vector<Eigen::Triplet<double>> equations;
  for (int node = 4; node < std::ssize(model.nodes); ++node) {
    turns.push_back(6 * node + 4);
    for (const int motion : {0, 2}) {
      equations.emplace_back(6 * node + motion, std::ssize(kept), 1.0);
      kept.push_back(6 * node + motion);
    }
  }
  FiniteElements second = model;
  second.stiffness = Dense{k(kept, kept) - k(kept, turns) * k(turns, turns).ldlt().solve(k(turns, kept))}.sparseView();
  second.mass = {};
  second.equations.resize(k.rows(), std::ssize(kept));
  second.equations.setFromTriplets(equations.begin(), equations.end());
  const Dense one = condensed(model).stiffness, two = condensed(second).stiffness;
  EXPECT_LT((one - two).norm(), 1e-11 * one.norm());
}

TEST(Condensation, EquationsMayExpressTheFloorAlready) {
  // Three unknowns of the floor about a corner, and three of each top, replace the motions of the nodes.
  const FiniteElements plain = floor_in_space().finite_elements();
  FiniteElements model = plain;
  std::vector<Eigen::Triplet<double>> equations;
  for (int i = 0; i < 4; ++i) {
    const FrameNode& node = plain.nodes[static_cast<std::size_t>(2 * i + 1)];
    const int row = 6 * (2 * i + 1);
    equations.emplace_back(row, 12, 1.0);
    equations.emplace_back(row, 14, -(node.y.si() - 5.0));
    equations.emplace_back(row + 1, 13, 1.0);
    equations.emplace_back(row + 1, 14, node.x.si() + 2.0);
    equations.emplace_back(row + 5, 14, 1.0);
    for (const int motion : {2, 3, 4}) equations.emplace_back(row + motion, 3 * i + motion - 2, 1.0);
  }
  model.equations.resize(48, 15);
  model.equations.setFromTriplets(equations.begin(), equations.end());
  model.stiffness = SparseMatrix{model.equations.transpose() * plain.stiffness * model.equations};
  model.mass = {};
  model.feet = Feet::given;
  const CondensedStructure a = condensed(plain), b = condensed(model);
  EXPECT_LT((a.stiffness - b.stiffness).norm(), 1e-12 * a.stiffness.norm());
  EXPECT_TRUE(a.mass.isApprox(b.mass, 1e-14));
}

TEST(Condensation, LineKeepsOneDirectionOfABuildingInSpace) {
  Frame frame = floor_in_space();
  const Dense in_plan = frame.condensed().stiffness;
  frame.motion = LevelMotion::along_x;
  EXPECT_NEAR(frame.condensed().stiffness(0, 0) / in_plan(0, 0), 1.0, 1e-13);
  EXPECT_EQ(frame.condensed().mass(0, 0), 24e3);
  frame.motion = LevelMotion::along_y;
  EXPECT_NEAR(frame.condensed().stiffness(0, 0) / in_plan(1, 1), 1.0, 1e-13);
}

TEST(Condensation, HeightsCountFromTheLowestNodes) {
  Frame frame = floor_in_space();
  for (FrameNode& node : frame.nodes) node.z -= 3 * m;
  frame.levels[0].height = 0.5 * m;
  EXPECT_DOUBLE_EQ(frame.condensed().levels[0].height, 3.5);
}

TEST(Condensation, TowersOnOneBaseHaveFloorsAtOneHeight) {
  // Two equal columns that stand apart, each with its floor: the nodes of the levels are given.
  Frame frame = floor_in_space();
  frame.levels = {{.tower = "west", .nodes = {2, 8}}, {.tower = "east", .nodes = {4, 6}}};
  const CondensedStructure towers = frame.condensed();
  EXPECT_EQ(towers.levels[1].name, "east floor 1");
  const Dense& k = towers.stiffness;
  EXPECT_EQ(k.rows(), 6);
  EXPECT_EQ(k.topRightCorner(3, 3).norm(), 0.0);
  EXPECT_NEAR(k(0, 0) / floor_in_space().condensed().stiffness(0, 0), 0.5, 1e-13);
}

TEST(Condensation, TallFrameOf30600MotionsHasNoForcesInRigidMotion) {
  // 10 x 10 columns, 50 storeys, with the feet as a level. It is constrained before it is condensed, in seconds.
  constexpr int side = 10, storeys = 50, floor = side * side;
  const MemberSection column = RectangularSection{.b = 0.8 * m, .h = 0.8 * m};
  const MemberSection beam = RectangularSection{.b = 0.4 * m, .h = 0.7 * m};
  const ElasticMaterial concrete{.E = 30 * GPa};
  Frame frame;
  for (int storey = 0; storey <= storeys; ++storey) {
    frame.levels.push_back({.height = storey * 3.5 * m, .mass = 3000 * tonne});
    for (int i = 0; i < floor; ++i) {
      const int node = storey * floor + i + 1;
      frame.nodes.push_back({.x = i % side * 7 * m, .y = i / side * 6 * m, .z = storey * 3.5 * m});
      if (storey == 0) continue;
      frame.members.push_back({.from = node - floor, .to = node, .section = column, .material = concrete});
      if (i % side > 0) frame.members.push_back({.from = node - 1, .to = node, .section = beam, .material = concrete});
      if (i >= side) frame.members.push_back({.from = node - side, .to = node, .section = beam, .material = concrete});
    }
  }
  const CondensedStructure tower = frame.condensed();
  ASSERT_EQ(tower.stiffness.rows(), 3 * (storeys + 1));
  for (int motion = 0; motion < 3; ++motion) {
    Vector rigid = Vector::Zero(tower.stiffness.rows());
    for (int level = 0; level <= storeys; ++level) rigid[3 * level + motion] = 1.0;
    const Vector forces = tower.stiffness * rigid;
    EXPECT_LT(forces.lpNorm<Eigen::Infinity>(), 1e-11 * tower.stiffness.diagonal().maxCoeff()) << motion;
  }
}

TEST(Condensation, BadModelsAreRefused) {
  const auto message = [](auto change) {
    FiniteElements model = frame_of_twelve_storeys().finite_elements();
    change(model);
    return message_of([&] { return condensed(model); });
  };
  using Model = FiniteElements;
  EXPECT_EQ(message([](Model&) {}), "nothing was thrown");
  EXPECT_EQ(message([](Model& m) { m.nodes.clear(); }), "FiniteElements: it has no nodes. Give them in .nodes.");
  EXPECT_EQ(message([](Model& m) { m.diaphragms.clear(); }),
            "FiniteElements: it has no levels. Give the heights of its floors.");
  EXPECT_EQ(message([](Model& m) { m.diaphragms[2].height.reset(); }),
            "FiniteElements: diaphragm floor 3 has neither a height nor nodes.");
  EXPECT_EQ(message([](Model& m) { m.diaphragms[2].height = 11.4 * units::m; }),
            "FiniteElements: diaphragm floor 3 has no nodes within 1 mm of its height of 11.4 m; the nearest node lies "
            "at 11.5 m. Give the height of its nodes, or the nodes themselves.");
  EXPECT_EQ(message([](Model& m) { std::swap(m.diaphragms[3], m.diaphragms[4]); }),
            "FiniteElements: heights must rise: floor 4 at 18.5 m, floor 5 at 15 m. Towers beside each other have "
            "levels of their own: give .tower.");
  EXPECT_EQ(message([](Model& m) { m.diaphragms[2].tower = "west"; }), "nothing was thrown");
  EXPECT_EQ(message([](Model& m) {
              m.diaphragms[2].tower = "west";
              std::swap(m.diaphragms[1], m.diaphragms[2]);
            }),
            "nothing was thrown");
  EXPECT_EQ(message([](Model& m) {
              for (FrameLevel& level : m.diaphragms) level.tower = level.height < 20 * units::m ? "" : "west";
              std::swap(m.diaphragms[4], m.diaphragms[6]);
            }),
            "FiniteElements: heights must rise: west floor 1 at 25.5 m, west floor 2 at 22 m. Towers beside each other "
            "have levels of their own: give .tower.");
  EXPECT_EQ(message([](Model& m) {
              m.diaphragms[11] = {.tower = "west", .nodes = {49, 50}, .mass = 50e3 * kg};
              m.mass.resize(312, 312);
              m.mass.insert(306, 306) = 3e3;
              m.masses = Vanishing::keep;
            }),
            "FiniteElements: node 52, x, has mass, and its node belongs to no level of a tower. Make a level of its "
            "node, or take Vanishing::drop or Vanishing::guyan.");
  EXPECT_EQ(message([](Model& m) {
              m.diaphragms[1] = {.nodes = {9, 10, 13}};
            }),
            "FiniteElements: diaphragm floor 2: its nodes lie between 8 and 11.5 m. Nodes of a rigid floor have one "
            "height, within 1 mm.");
  EXPECT_EQ(message([](Model& m) {
              m.diaphragms[1] = {.nodes = {9, 10}};
              m.diaphragms[2] = {.nodes = {10, 11}};
            }),
            "FiniteElements: node 10 belongs to two diaphragms.");
  EXPECT_EQ(message([](Model& m) {
              m.diaphragms[1] = {.nodes = {9, 99}};
            }),
            "FiniteElements: there is no node 99. Give it in .nodes.");
  EXPECT_EQ(message([](Model& m) { m.nodes[3].name = 3; }),
            "FiniteElements: node 3 is given twice. Give every node a name of its own.");
  EXPECT_EQ(message([](Model& m) { m.nodes[3].x = NAN * units::m; }),
            "FiniteElements: a coordinate of node 4 = nan m is not allowed; it must be a finite number. Look for a "
            "division by zero in the calculation that gave it.");
  EXPECT_EQ(message([](Model& m) { m.diaphragms[0].mass = -1.0 * kg; }),
            "FiniteElements: floor 1 mass = -1 kg is not allowed; it must be >= 0 kg and finite. Check its sign and "
            "its unit.");
  EXPECT_EQ(message([](Model& m) { m.stiffness.conservativeResize(300, 300); }),
            "FiniteElements: stiffness has 300 rows and 300 columns, the model has 312 unknowns.");
  EXPECT_EQ(message([](Model& m) { m.equations.resize(300, 312); }),
            "FiniteElements: equations.rows() = 300 is not allowed; it must be 312, six for each of the nodes. Give a "
            "number in this range.");
  EXPECT_EQ(message([](Model& m) { m.stiffness.coeffRef(24, 24) = NAN; }),
            "FiniteElements: stiffness has an entry that is not finite, at node 5, x.");
  EXPECT_EQ(message([](Model& m) { m.stiffness.coeffRef(28, 28) = -3.0; }),
            "FiniteElements: stiffness of node 5, rotation about y is -3. The order or the unit of the matrix may be "
            "another.");
  EXPECT_EQ(
      message([](Model& m) { m.stiffness.coeffRef(24, 30) *= 1.01; }),
      "FiniteElements: stiffness is not symmetric: entry (node 6, x; node 5, x) = -1.2e+09, transposed -1.212e+09, "
      "0.561 % of the diagonals.");
}

TEST(Condensation, MotionThatNothingHoldsIsNamed) {
  // Hinges at both ends of all members at a node; two members in a line with hinges between them; a loose node.
  Frame hinged = frame_of_twelve_storeys();
  for (FrameMember& member : hinged.members) {
    if (member.from.value().text() == "17") member.releases_from.rz = true;
    if (member.to.value().text() == "17") member.releases_to.rz = true;
  }
  EXPECT_EQ(
      message_of([&] { return hinged.condensed(); }),
      "Frame: node 17, rotation about y, has no stiffness: a pinned end at both members, or a missing restraint.");
  Frame chain = floor_in_space();
  chain.nodes.push_back({.name = "mid", .x = 3 * m, .z = 3.5 * m});
  chain.levels[0].nodes = {2, 4, 6, 8};
  chain.levels[0].height.reset();
  for (const int end : {2, 4})
    chain.members.push_back({.from = end,
                             .to = "mid",
                             .section = chain.members[0].section,
                             .material = chain.members[0].material,
                             .releases_from = {.rz = end == 2},
                             .releases_to = {.rz = end == 2}});
  EXPECT_EQ(message_of([&] { return chain.condensed(); }), "nothing was thrown");
  chain.members.back().releases_from.rz = true;
  EXPECT_EQ(message_of([&] { return chain.condensed(); }),
            "Frame: node mid, z, has no stiffness: a pinned end at both members, or a missing restraint.");
}

TEST(Condensation, EquationsMustFollowTheFloors) {
  const auto message = [](auto change) {
    FiniteElements model = floor_in_space().finite_elements();
    model.equations.resize(48, 48);
    model.equations.setIdentity();
    change(model.equations);
    return message_of([&] { return condensed(model); });
  };
  EXPECT_EQ(message([](SparseMatrix& e) { e.coeffRef(6, 6) = 0.0; }),
            "FiniteElements: node 2, x, does not move with floor 1: the equations of the model hold it, or move it "
            "otherwise.");
  EXPECT_EQ(message([](SparseMatrix& e) { e.coeffRef(6, 8) = 1.0; }),
            "FiniteElements: node 2, x: the floors do not determine the unknowns of its equation.");
  EXPECT_EQ(message([](SparseMatrix& e) { e.coeffRef(2, 6) = 1.0; }),
            "FiniteElements: node 1, z, does not move with the base: the equations of the model hold it, or move it "
            "otherwise.");
}

}  // namespace
}  // namespace moat
