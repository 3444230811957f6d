// Mass matrices with coupled degrees of freedom, against dense matrices.
#include "model/mass_matrix.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>

namespace moat {
namespace {

using Matrix3 = Eigen::Matrix3d;

// Masses 5, 7 and 9 kg, and a coupling of 0 with 1, then one of 1 with 2.
struct Coupled {
  MassMatrix mass;
  Matrix3 expected{{9.0, 1.0, 0.0}, {1.0, 12.0, -2.0}, {0.0, -2.0, 15.0}};

  Coupled() {
    for (const double each : {5.0, 7.0, 9.0}) mass.append(each);
    EXPECT_TRUE(mass.add(std::array{0, 1}, Eigen::Matrix2d{{4.0, 1.0}, {1.0, 2.0}}));
    EXPECT_TRUE(mass.add(std::array{2, 1}, Eigen::Matrix2d{{6.0, -2.0}, {-2.0, 3.0}}));
  }
};

TEST(MassMatrix, IsTheSumOfItsParts) {
  const Coupled coupled;
  const Eigen::Vector3d values{1.0, -2.0, 3.0};
  Eigen::Vector3d product, solution = values;
  coupled.mass.multiply(values.data(), product.data());
  coupled.mass.solve(solution.data());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(coupled.mass.diagonal()[i], coupled.expected(i, i)) << i;
    for (int j = 0; j < 3; ++j) EXPECT_EQ(coupled.mass.at(i, j), coupled.expected(i, j)) << i << " " << j;
  }
  EXPECT_EQ(product, coupled.expected * values);
  EXPECT_LT((coupled.expected * solution - values).norm(), 1e-13);
  const Eigen::Vector3d sizes = values.cwiseAbs();
  EXPECT_LT((coupled.mass.largest_accelerations(sizes) - coupled.expected.inverse().cwiseAbs() * sizes).norm(), 1e-14);
}

TEST(MassMatrix, StaysAsItWasWhereItWouldNotBePositive) {
  Coupled coupled;
  EXPECT_FALSE(coupled.mass.add(std::array{0, 2}, Eigen::Matrix2d{{0.0, 20.0}, {20.0, 0.0}}));
  EXPECT_EQ(coupled.mass.at(0, 2), 0.0);
  EXPECT_EQ(coupled.mass.at(1, 2), -2.0);
}

}  // namespace
}  // namespace moat
