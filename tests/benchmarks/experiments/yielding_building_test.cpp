// The yielding building of ./moat bench experiments, against its published numbers.
#include "experiments/yielding_building.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <moat.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "peers/opensees.hpp"

namespace moat::experiments {
namespace {

using Given = YieldingBuilding;

TEST(YieldingBuilding, HasThePublishedPeriodsAndFactors) {
  const std::vector<double> periods = periods_of(YieldingBuilding{});
  ASSERT_EQ(periods.size(), std::size(Given::periods));
  // Half of the last digit that is given.
  for (std::size_t i = 0; i < periods.size(); ++i) EXPECT_NEAR(periods[i], Given::periods[i], 5e-7);
  const RayleighFactors factors =
      rayleigh_factors(Given::damping_ratio, 2.0 * std::numbers::pi / periods[0], 2.0 * std::numbers::pi / periods[1]);
  EXPECT_NEAR(factors.mass_factor, Given::alpha, 5e-11);
  EXPECT_NEAR(factors.stiffness_factor, Given::beta, 5e-13);
}

TEST(YieldingBuilding, IsDampedByMassAgainstTheGroundAndInitialStiffness) {
  const YieldingBuilding building;
  SparseMatrix damping = building.model.zero_matrix();
  AnalysisState{building.model}.assemble_tangent(0.0, 1.0, 0.0, damping);
  Eigen::MatrixXd expected = Given::beta * Eigen::MatrixXd{building.model.linear_stiffness(StiffnessStage::initial)};
  expected += Given::alpha * Eigen::Map<const Eigen::Vector4d>{Given::masses}.asDiagonal().toDenseMatrix();
  EXPECT_LT((Eigen::MatrixXd{damping} - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.maxCoeff());
}

// Steel01 with yield force, stiffness and ratio after yield, of bearings and storeys.
TEST(YieldingBuilding, YieldsInOpenSeesToo) {
  std::stringstream tcl;
  EXPECT_TRUE(
      peers::write_opensees_model(AnalysisState{YieldingBuilding{}.model}, peers::opensees_settings().front(), tcl)
          .size() == 1);
  std::vector<std::vector<double>> materials;
  for (std::string line; std::getline(tcl, line);) {
    std::istringstream words{line};
    std::string command, type;
    std::vector<double> values(4);
    if (words >> command >> type && type == "Steel01" && words >> values[0] >> values[1] >> values[2] >> values[3])
      materials.emplace_back(values.begin() + 1, values.end());
  }
  ASSERT_EQ(materials.size(), 4u);
  const std::vector<std::vector<double>> expected{
      {500e3, 50e6, 0.05}, {1225e3, 245e6, 0.0}, {975e3, 195e6, 0.0}, {490e3, 98e6, 0.0}};
  for (const std::vector<double>& each : expected)
    EXPECT_TRUE(std::ranges::any_of(materials, [&](const std::vector<double>& material) {
      return std::ranges::equal(material, each,
                                [](double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); });
    })) << each[0];
}

}  // namespace
}  // namespace moat::experiments
