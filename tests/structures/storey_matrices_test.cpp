#include "structures/storey_matrices.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <string>

#include "base/units.hpp"
#include "message_of.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

class StoreyMatricesOf : public testing::WrittenFiles {
 protected:
  [[nodiscard]] StoreyTable table() const {
    return read_storeys(write("storeys.csv",
                              "name,height [m],mass [t],inertia [t m2],x_mass [m],y_mass [m],x_rigidity [m],y_rigidity "
                              "[m],kx [kN/m],ky [kN/m],k_rotation [kN m]\n"
                              "base,,900,31500,0,0,,,,,\n"
                              "floor 1,4.5,820,28700,0.6,0,0,0.3,900e3,700e3,60e6\n"
                              "floor 2,3.6,780,27300,0.6,0.2,0.2,0.3,760e3,620e3,52e6\n"
                              "roof,3.6,430,9460,-2.0,0.4,-2.4,0.5,380e3,300e3,14e6\n"));
  }
};

// s, the longest six.
std::array<double, 6> periods_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes{stiffness, mass, Eigen::EigenvaluesOnly};
  std::array<double, 6> periods{};
  for (std::size_t i = 0; i < periods.size(); ++i)
    periods[i] = 2.0 * pi / std::sqrt(modes.eigenvalues()[static_cast<Eigen::Index>(i)]);
  return periods;
}

void expect_periods(const std::array<double, 6>& actual, const std::array<double, 6>& expected) {
  // Half a unit of the last digit given.
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 5e-9) << "mode " << i + 1;
}

// The periods were computed by an independent program.
TEST_F(StoreyMatricesOf, AnEccentricBuildingHaveItsPeriods) {
  const CondensedStructure matrices = storey_matrices(table());
  EXPECT_EQ(matrices.levels.size(), 3u);
  EXPECT_EQ(matrices.stiffness, matrices.stiffness.transpose());
  expect_periods(periods_of(matrices.stiffness, matrices.mass),
                 {0.43882671, 0.38986759, 0.27254312, 0.19598786, 0.17505696, 0.13843781});
}

// On nine springs of 1500 kN/m: u = R b + v, with the base in the first three rows.
TEST_F(StoreyMatricesOf, AnIsolatedBuildingHaveItsPeriods) {
  const StoreyTable storeys = table();
  const CondensedStructure matrices = storey_matrices(storeys);
  Eigen::MatrixXd rigid(9, 3), stiffness = Eigen::MatrixXd::Zero(12, 12), mass = Eigen::MatrixXd::Zero(12, 12);
  for (Eigen::Index floor = 0; floor < 3; ++floor) {
    const PlanVector at = storeys.floors[static_cast<std::size_t>(floor)].centre_of_mass.si();
    rigid.middleRows<3>(3 * floor) << 1, 0, -at.y, 0, 1, at.x, 0, 0, 1;
  }
  Eigen::MatrixXd relative(9, 12);
  relative << -rigid, Eigen::MatrixXd::Identity(9, 9);
  stiffness = relative.transpose() * matrices.stiffness * relative;
  for (const double x : {-12.0, 0.0, 12.0})
    for (const double y : {-7.5, 0.0, 7.5}) {
      Eigen::Matrix<double, 2, 3> motion;
      motion << 1, 0, -y, 0, 1, x;
      stiffness.topLeftCorner<3, 3>() += 1.5e6 * motion.transpose() * motion;
    }
  mass.diagonal().head<3>() << 900e3, 900e3, 31'500e3;
  mass.bottomRightCorner(9, 9) = matrices.mass;
  expect_periods(periods_of(stiffness, mass), {2.94769349, 2.94349903, 1.49041597, 0.28478266, 0.25487925, 0.18237441});
}

TEST_F(StoreyMatricesOf, StoreysWithoutAStiffnessAreRefused) {
  StoreyTable storeys = table();
  storeys.floors[1].stiffness_y = {};
  EXPECT_EQ(message_of([&] { (void)storey_matrices(storeys); }),
            "storey_matrices \"" + path("storeys.csv").string() +
                "\": floor 2 ky = 0 N/m is not allowed; it must be > 0 N/m and finite. Check its sign and its unit.");
  storeys = table();
  storeys.floors[0].rotational_stiffness = {};
  EXPECT_THROW((void)storey_matrices(storeys), InputError);
  storeys = table();
  storeys.floors[0].rotary_inertia = {};
  EXPECT_THROW((void)storey_matrices(storeys), InputError);
  EXPECT_EQ(message_of([] { (void)storey_matrices({}); }), "storey_matrices: there is no floor. Give at least one.");
}

}  // namespace
}  // namespace moat
