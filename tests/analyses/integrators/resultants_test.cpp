// Sizes that do not depend on the axes of a model in plan.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <string>

#include "analyses/integrators/acceleration_scales.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;

// Two diaphragms on springs at random places and directions, turned by an angle about the origin.
Model springs(unsigned seed, Angle turn) {
  std::mt19937 generator{seed};
  std::uniform_real_distribution<> part{-1.0, 1.0};
  const auto place = [&] {
    const double x = part(generator), y = part(generator);
    return turned({10.0 * x * m, 6.0 * y * m}, turn);
  };
  Model model;
  const DiaphragmId base = add(model, Diaphragm{.name = "base", .mass = 8e5 * kg, .size = {20 * m, 12 * m}}),
                    floor = add(model, Diaphragm{.name = "floor", .mass = 7e5 * kg, .size = {20 * m, 12 * m}});
  for (int i = 0; i < 10; ++i) {
    const PlanPosition at = place();
    const double angle = pi * part(generator) + turn.si();
    add(model, PlanSpring<Linear>{.name = "spring " + std::to_string(i),
                                  .lower = i % 2 == 0 ? PlanPoint{ground, at} : PlanPoint{base, at},
                                  .upper = i % 2 == 0 ? PlanPoint{base, at} : PlanPoint{floor, at},
                                  .direction = {std::cos(angle), std::sin(angle)},
                                  .law = {.stiffness = 1 * MN / m}});
  }
  return model;
}

Vector bounds(const Model& model) {
  return Resultants{model}
      .row_sums(model.linear_stiffness(StiffnessStage::initial))
      .cwiseQuotient(model.mass_matrix().diagonal());
}

TEST(Resultants, BoundsAreAboveAllEigenvalues) {
  for (const unsigned seed : {4u, 5u, 6u}) {
    const Model model = springs(seed, 1.0);
    const Vector root = model.mass_matrix().diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled =
        root.asDiagonal() * Eigen::MatrixXd{model.linear_stiffness(StiffnessStage::initial)} * root.asDiagonal();
    const double largest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{scaled}.eigenvalues().maxCoeff();
    EXPECT_GE(bounds(model).maxCoeff(), largest * (1.0 - 1e-12));
    EXPECT_LE(bounds(model).maxCoeff(), 4.0 * largest);
  }
}

TEST(Resultants, SizesInPlanAreThoseOfTheTranslation) {
  const Model model = springs(7, 0.0);
  const std::vector<double> values{3.0, -4.0, -2.0, 5.0, 12.0, 7.0};
  const std::vector<double> expected{5.0, 5.0, 2.0, 13.0, 13.0, 7.0};
  Resultants{model}.with([&](const auto& size) {
    for (int i = 0; i < 6; ++i)
      EXPECT_DOUBLE_EQ(size(i, [&](int k) { return values[static_cast<std::size_t>(k)]; }),
                       expected[static_cast<std::size_t>(i)]);
  });
}

TEST(Resultants, OnALineEveryNodeStandsForItself) {
  Model model;
  const NodeId a = add(model, Node{.name = "a", .mass = 1 * kg}), b = add(model, Node{.name = "b", .mass = 2 * kg});
  add(model, ShearSpring{.name = "spring", .lower = a, .upper = b, .stiffness = 3 * N / m});
  add(model, ShearSpring{.name = "to the ground", .lower = ground, .upper = a, .stiffness = 5 * N / m});
  const Vector sums = bounds(model);
  EXPECT_DOUBLE_EQ(sums[0], 8.0 + 3.0);
  EXPECT_DOUBLE_EQ(sums[1], (3.0 + 3.0) / 2.0);
  Resultants{model}.with([&](const auto& size) { EXPECT_EQ(size(1, [](int) { return -4.0; }), 4.0); });
}

}  // namespace
}  // namespace moat
