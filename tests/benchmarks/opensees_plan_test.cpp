// A building in plan in OpenSees' words.

#include <gtest/gtest.h>

#include <map>
#include <moat.hpp>
#include <sstream>
#include <string>

#include "peers/opensees.hpp"
#include "peers/plan.hpp"
#include "written_tcl.hpp"

namespace moat::peers {
namespace {

Tcl written(const Model& model) {
  std::ostringstream text;
  write_opensees_plan(model, text);
  return Tcl{text.str()};
}

/// The matrices of OpenSees' degrees of freedom x, y and rotation of every floor are those of moat, whose rotations
/// are lengths: theta times the radius of gyration.
TEST(OpenSeesPlan, HasTheMatricesOfTheModel) {
  const Case of = on_bearings_in_plan("", near_fault_pulse());
  const Model& model = of.model;
  const Tcl tcl = written(model);
  std::map<std::string, PlanVector> at;
  for (const auto& line : tcl.starting_with("node")) at[line[1]] = {std::stod(line[2]), std::stod(line[3])};
  std::map<std::string, std::string> master;  // of tied nodes
  for (const auto& line : tcl.starting_with("rigidDiaphragm")) {
    EXPECT_EQ(line[1], "3");
    master[line[3]] = line[2];
  }
  EXPECT_EQ(master.size(), 4u) << "the heads of the bearings; everything else acts at centres of mass";
  std::map<std::string, std::pair<double, double>> materials;
  for (const auto& line : tcl.starting_with("uniaxialMaterial"))
    materials[line[2]] = {std::stod(line[3]), line.size() > 4 ? std::stod(line[4]) : 0.0};
  const int size = model.degrees_of_freedom();
  // A row for the displacement of a node along a direction, in moat's coordinates.
  const auto row = [&](const std::string& node, int direction) {
    Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(size);
    const std::string floor = master.contains(node) ? master[node] : node;
    if (std::stoi(floor) > size) return weights;  // on the ground
    const int x = std::stoi(floor) - 1;
    const double gyration = model.diaphragm_of(NodeId{x})->gyration;
    const PlanVector arm = at.at(node) - at.at(floor);
    if (direction < 3) weights[x + direction - 1] = 1.0;
    weights[x + 2] = (direction == 1 ? -arm.y : direction == 2 ? arm.x : 1.0) / gyration;
    return weights;
  };
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size), damping = stiffness;
  for (const auto& line : tcl.starting_with("element")) {
    const auto add = [&](int direction, double k, double c) {
      const Eigen::RowVectorXd strain = row(line[4], direction) - row(line[3], direction);
      stiffness += k * strain.transpose() * strain;
      damping += c * strain.transpose() * strain;
    };
    if (line[1] == "zeroLength")
      add(std::stoi(line[8]), materials.at(line[6]).first, materials.at(line[6]).second);
    else
      for (const int direction : {1, 2}) add(direction, std::stod(line[5]), 0.0);
  }
  SparseMatrix of_moat = model.linear_stiffness(StiffnessStage::initial);
  const auto compare = [&](const Eigen::MatrixXd& found) {
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        EXPECT_NEAR(found(i, j), of_moat.coeff(i, j), 1e-9 * found.lpNorm<Eigen::Infinity>());
  };
  compare(stiffness);
  AnalysisState{model}.assemble_tangent(0.0, 1.0, 0.0, of_moat);
  compare(damping);
}

/// Q = F_y - k2 d_y, and the share of k2 in the initial stiffness.
TEST(OpenSeesPlan, HasBearingsThatYieldOnACircle) {
  const auto bearings = written(on_bearings_in_plan("", near_fault_pulse()).model)
                            .starting_with("element", "elastomericBearingPlasticity");
  ASSERT_EQ(bearings.size(), 4u);
  for (const auto& line : bearings) {
    EXPECT_NEAR(std::stod(line[5]), 35e6, 1e-3);
    EXPECT_NEAR(std::stod(line[6]), 0.35e6 - 3.5e6 * 0.01, 1e-6);
    EXPECT_NEAR(std::stod(line[7]), 0.1, 1e-12);
  }
}

TEST(OpenSeesPlan, RefusesALawThatOpenSeesDoesNotHave) {
  Model model;
  const DiaphragmId slab = add(model, Diaphragm{.name = "slab", .mass = 100 * tonne, .size = {10 * m, 8 * m}});
  add(model, PlanBearing<BiaxialLinear>{.name = "rubber", .under = slab, .law = {.stiffness = 1 * MN / m}});
  std::ostringstream text;
  EXPECT_THROW(write_opensees_plan(model, text), InputError);
}

}  // namespace
}  // namespace moat::peers
