// The input of OpenSees by ./moat bench peers, and the reading of its output. OpenSees itself is not needed here.

#include "peers/opensees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <moat.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/yielding_building.hpp"
#include "in_folder.hpp"
#include "written_tcl.hpp"

namespace moat::peers {
namespace {

using namespace units;

constexpr double gap = 0.1, contact_stiffness = 5.8e8;  // m, N/m

Model tower(bool linear_contact) {
  Model model;
  const Building building =
      add(model, ShearBuilding{.storeys = 3,
                               .floor_mass = {400 * tonne, 300 * tonne, 350 * tonne},
                               .storey_stiffness = {0.8 * GN / m, 0.6 * GN / m, 0.7 * GN / m},
                               .damping = RayleighDamping{.ratio = 0.05},
                               .base_mass = 550 * tonne,
                               .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                              .yield_displacement = 1 * cm,
                                                              .post_yield_stiffness = 19.3 * MN / m}});
  if (linear_contact)
    add(model, Moat{.around = building.base,
                    .clearance = gap * m,
                    .law = LinearElastic{.stiffness = contact_stiffness * N / m}});
  else
    add(model, Moat{.around = building.base,
                    .clearance = gap * m,
                    .law = HertzDamp{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65}});
  return model;
}

Tcl tcl_of(const Model& model) {
  std::ostringstream text;
  std::vector<int> tags = write_opensees_model(AnalysisState{model}, {}, text);
  Tcl tcl{text.str()};
  tcl.measured = std::move(tags);
  return tcl;
}

/// The matrices that OpenSees' definitions of the written lines give are those of moat.
void expect_matrices_of(const Model& model) {
  const Tcl tcl = tcl_of(model);
  std::map<std::string, std::pair<double, double>> materials;  // initial stiffness and damping
  for (const auto& line : tcl.starting_with("uniaxialMaterial")) {
    if (line[1] == "Elastic") materials[line[2]] = {std::stod(line[3]), line.size() > 4 ? std::stod(line[4]) : 0.0};
    if (line[1] == "Steel01") materials[line[2]] = {std::stod(line[4]), 0.0};
    if (line[1] == "ElasticPPGap") materials[line[2]] = {0.0, 0.0};  // open
  }
  const int size = model.degrees_of_freedom();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size + 1, size + 1), damping = stiffness;
  for (const auto& line : tcl.starting_with("element")) {
    ASSERT_EQ(line[1], "zeroLength");
    const auto [k, c] = materials.at(line[6]);
    const int i = std::stoi(line[3]), j = std::stoi(line[4]);
    for (const auto& [matrix, value] : {std::pair{&stiffness, k}, std::pair{&damping, c}}) {
      (*matrix)(i, i) += value;
      (*matrix)(j, j) += value;
      (*matrix)(i, j) -= value;
      (*matrix)(j, i) -= value;
    }
  }
  SparseMatrix of_moat = model.linear_stiffness(StiffnessStage::initial);
  const auto compare = [&](const Eigen::MatrixXd& written) {
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        EXPECT_NEAR(written(row + 1, column + 1), of_moat.coeff(row, column), 1e-9 * written.lpNorm<Eigen::Infinity>());
  };
  compare(stiffness);
  AnalysisState{model}.assemble_tangent(0.0, 1.0, 0.0, of_moat);
  compare(damping);
  double mass = 0.0;
  for (const auto& line : tcl.starting_with("mass")) mass += std::stod(line[2]);
  EXPECT_NEAR(mass, model.mass_matrix().diagonal().sum(), 1e-6);
}
TEST(OpenSeesModel, HasTheMatricesOfTheModel) {
  expect_matrices_of(tower(true));
  expect_matrices_of(experiments::YieldingBuilding{}.model);
}

/// `zeroLength` strains by second minus first, and ElasticPPGap with a negative gap closes under compression.
TEST(OpenSeesModel, ClosesItsGapsOnTheRightSides) {
  const Model model = tower(true);
  const Tcl tcl = tcl_of(model);
  std::map<std::string, std::vector<std::string>> gaps;
  for (const auto& line : tcl.starting_with("uniaxialMaterial"))
    if (line[1] == "ElasticPPGap") gaps[line[2]] = line;
  ASSERT_EQ(gaps.size(), 2u);
  ASSERT_EQ(tcl.measured.size(), 2u);
  double sum_of_closing_moves = 0.0;
  int elements = 0;
  for (const auto& line : tcl.starting_with("element")) {
    const auto found = gaps.find(line[6]);
    if (found == gaps.end()) continue;
    ++elements;
    EXPECT_DOUBLE_EQ(std::stod(found->second[3]), contact_stiffness);
    EXPECT_DOUBLE_EQ(std::stod(found->second[5]), -gap);
    EXPECT_TRUE((line[3] == "0") != (line[4] == "0")) << "one end is the ground";
    // The move of the base that shortens the element: to the right where it is the first end.
    sum_of_closing_moves += line[3] == "1" ? 1.0 : -1.0;
  }
  EXPECT_EQ(elements, 2);
  EXPECT_EQ(sum_of_closing_moves, 0.0) << "one wall on either side";
}

/// A zeroLength element that is added later takes the displacements that it finds as those of its rest.
TEST(OpenSeesModel, SetsItsStateBehindItsElements) {
  bool set = false;
  for (const auto& line : tcl_of(tower(true)).lines) {
    set = set || line[0] == "setNodeDisp";
    EXPECT_FALSE(set && line[0] == "element");
  }
  EXPECT_TRUE(set);
}

TEST(OpenSeesModel, GivesHertzDampItsDampingRatio) {
  int gaps = 0;
  for (const auto& line : tcl_of(tower(false)).starting_with("uniaxialMaterial")) {
    if (line[1] != "Hertzdamp") continue;
    EXPECT_NEAR(std::stod(line[4]), 0.433125, 1e-12) << "3/4 (1 - e^2) at e = 0.65";
    ++gaps;
  }
  EXPECT_EQ(gaps, 2);
}

TEST(OpenSeesModel, RefusesALawThatOpenSeesDoesNotHave) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
  add(model, Gap{.name = "wall",
                 .left = body,
                 .right = ground,
                 .clearance = 1 * cm,
                 .law = ExactKelvin{.stiffness = 1 * GN / m, .restitution = 0.5}});
  std::ostringstream text;
  EXPECT_THROW(write_opensees_model(AnalysisState{model}, {}, text), InputError);
}

class OpenSeesProgram : public paper::InFolder {
 protected:
  ~OpenSeesProgram() override { unsetenv("OPENSEES"); }

  // A program in the place of OpenSees.
  void install(const std::string& body) {
    const std::filesystem::path program = folder / "open sees";
    std::ofstream{program} << "#!/bin/sh\n" << body;
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    setenv("OPENSEES", program.c_str(), 1);
  }
  [[nodiscard]] OpenSeesRun run() const {
    const Case tower_case{"tower", tower(true), NodeId{0}, NodeId{3}, near_fault_pulse(), 1.0};
    return OpenSees::find(folder / "files")
        ->run(AnalysisState{tower_case.model}, tower_case, 0.005, {"textbook", "Newmark"});
  }
};

TEST_F(OpenSeesProgram, IsCalledWithTheModelAndItsResultIsRead) {
  install("shift; printf '%s\\n' \"$@\" > '" + (folder / "arguments").string() +
          "'\n"
          "echo 'a message of OpenSees' >&2\necho 'HISTORY 0 0.25 -0.1 0.2 -3 4 5e6' >&2\n");
  const OpenSeesRun result = run();
  EXPECT_TRUE(result.solved);
  EXPECT_EQ(result.cpu_seconds, 0.25);
  EXPECT_EQ(result.peaks, (std::vector<double>{0.1, 0.2, 3.0, 4.0, 5e6}));
  std::istringstream lines{text_of("arguments")};
  std::vector<std::string> arguments;
  for (std::string line; std::getline(lines, line);) arguments.push_back(line);
  ASSERT_EQ(arguments.size(), 11u);
  EXPECT_TRUE(std::filesystem::exists(arguments[0]));
  EXPECT_TRUE(std::filesystem::exists(arguments[1].substr(1, arguments[1].find('}') - 1))) << "a list of one file";
  EXPECT_EQ(std::stod(arguments[3]) * std::stod(arguments[4]), 1.0) << "steps to the end";
  EXPECT_EQ(arguments[5], "textbook");
  EXPECT_EQ(arguments[7], "impacts");
  EXPECT_EQ(arguments[8], "1");
  EXPECT_EQ(arguments[9], "4");
}

TEST_F(OpenSeesProgram, NamesItsVersion) {
  install("echo '   OpenSees' >&2\necho '      Version 3.7.1 64-Bit' >&2\n");
  EXPECT_EQ(OpenSees::find(folder)->version(), "Version 3.7.1 64-Bit");
}

TEST_F(OpenSeesProgram, MayFailToSolveAStep) {
  install("echo 'HISTORY -3 0.25' >&2\n");
  EXPECT_FALSE(run().solved);
}

TEST_F(OpenSeesProgram, MustPrintAResult) {
  install("echo 'Segmentation fault' >&2\n");
  EXPECT_THROW(run(), Error);
}

TEST_F(OpenSeesProgram, IsRefusedWhereItDoesNotExist) {
  setenv("OPENSEES", "/nowhere/OpenSees", 1);
  EXPECT_THROW(OpenSees::find(folder), InputError);
}

}  // namespace
}  // namespace moat::peers
