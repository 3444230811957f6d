#include "solvers/modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "matrices.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using std::numbers::pi;
using testing::chain_stiffness;
using testing::message_of;

// A uniform chain of `size` masses, held at its foot by the same spring.
struct UniformChain {
  int size;
  double spring = 1e9, mass = 5e5;

  [[nodiscard]] SparseMatrix stiffness() const { return chain_stiffness(size, spring, spring); }
  [[nodiscard]] Vector masses() const { return Vector::Constant(size, mass); }
  [[nodiscard]] double angular_frequency(int mode) const {
    return 2.0 * std::sqrt(spring / mass) * std::sin((2 * mode - 1) * pi / (2.0 * (2 * size + 1)));
  }
};

double largest_error_of_frequencies(const UniformChain& chain, int count) {
  const auto modes = slowest_modes(chain.stiffness(), chain.masses(), count);
  EXPECT_EQ(static_cast<int>(modes.size()), count);
  double error = 0.0;
  for (int i = 1; i <= count; ++i)
    error = std::max(
        error, std::abs(modes[static_cast<std::size_t>(i - 1)].angular_frequency / chain.angular_frequency(i) - 1.0));
  return error;
}

void expect_orthonormal(const std::vector<Mode>& modes, const Vector& masses) {
  for (std::size_t i = 0; i < modes.size(); ++i)
    for (std::size_t k = 0; k <= i; ++k)
      EXPECT_NEAR(modes[i].shape.dot(masses.cwiseProduct(modes[k].shape)), i == k ? 1.0 : 0.0, 1e-9) << i << " " << k;
}

void expect_solutions(const SparseMatrix& stiffness, const Vector& masses, const std::vector<Mode>& modes) {
  for (const Mode& mode : modes) {
    const double eigenvalue = mode.angular_frequency * mode.angular_frequency;
    const Vector elastic = stiffness * mode.shape;
    const Vector inertia = eigenvalue * masses.cwiseProduct(mode.shape);
    const double scale = (stiffness * mode.shape.cwiseAbs()).lpNorm<Eigen::Infinity>();
    EXPECT_LT((elastic - inertia).lpNorm<Eigen::Infinity>(), 1e-8 * (scale + inertia.lpNorm<Eigen::Infinity>()));
  }
}

TEST(SlowestModes, SmallChainHasTheClosedForm) {
  for (const int size : {1, 2, 5, 40}) EXPECT_LT(largest_error_of_frequencies({.size = size}, size), 1e-10) << size;
}

TEST(SlowestModes, LargeChainHasTheClosedForm) {
  // The sparse path, beyond 200 degrees of freedom, and the dense one that serves when many modes are asked for.
  for (const int size : {200, 201}) EXPECT_LT(largest_error_of_frequencies({.size = size}, 10), 1e-9) << size;
  EXPECT_LT(largest_error_of_frequencies({.size = 2000}, 8), 1e-9);
  EXPECT_LT(largest_error_of_frequencies({.size = 210}, 150), 1e-8);
}

TEST(SlowestModes, ShapesAreOrthonormalAndSolveTheEquations) {
  for (const int size : {6, 300}) {
    const SparseMatrix stiffness = chain_stiffness(size, 1e9, 2e7);
    // Masses that differ by a factor of 10.
    const Vector masses = Vector::LinSpaced(size, 1e5, 1e6);
    const auto modes = slowest_modes(stiffness, masses, 6);
    expect_orthonormal(modes, masses);
    expect_solutions(stiffness, masses, modes);
    for (std::size_t i = 1; i < modes.size(); ++i)
      EXPECT_LT(modes[i - 1].angular_frequency, modes[i].angular_frequency);
  }
}

TEST(SlowestModes, AFreeBodyHasAnInfinitePeriod) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(slowest_modes(chain_stiffness(1, 0.0, 0.0), Vector::Constant(1, 5e5), 1).front().period(), infinity);
  for (const int size : {2, 3, 4, 5, 6, 7, 8, 11, 17, 30, 120, 300}) {
    // Free at both ends: omega_i = 2 sqrt(k/m) sin((i - 1) pi / (2 n)).
    const auto modes = slowest_modes(chain_stiffness(size, 1e9, 0.0), Vector::Constant(size, 5e5), 2);
    EXPECT_EQ(modes[0].period(), infinity) << size << " masses: " << modes[0].angular_frequency << " 1/s";
    EXPECT_NEAR(modes[1].angular_frequency / (2.0 * std::sqrt(1e9 / 5e5) * std::sin(pi / (2.0 * size))), 1.0, 1e-8);
    expect_orthonormal(modes, Vector::Constant(size, 5e5));
    const auto unequal = slowest_modes(chain_stiffness(size, 1.1e9, 0.0), Vector::LinSpaced(size, 1.234e5, 9.87e5), 2);
    EXPECT_EQ(unequal[0].period(), infinity) << size << " masses: " << unequal[0].angular_frequency << " 1/s";
    EXPECT_GT(unequal[1].angular_frequency, 0.0);
  }
}

TEST(SlowestModes, ASlowButHeldBodyKeepsItsPeriod) {
  // A foot a million times softer than the springs above it.
  const auto modes = slowest_modes(chain_stiffness(2, 1e9, 1e3), Vector::Constant(2, 5e5), 1);
  EXPECT_NEAR(modes[0].period(), 2.0 * pi * std::sqrt(1e6 / 1e3), 1e-4 * modes[0].period());
}

TEST(SlowestModes, TheSlowestOfTwoSlowBodiesComesFirst) {
  // 300 bodies on springs of their own, k = m omega^2; two springs are about a million times softer than the others.
  constexpr double mass = 5e5;
  Vector springs = Vector::LinSpaced(300, 5e8, 1e9);
  springs[120] = 1200.0;
  springs[200] = 100.0;
  const SparseMatrix stiffness{Eigen::MatrixXd{springs.asDiagonal()}.sparseView()};
  const auto modes = slowest_modes(stiffness, Vector::Constant(300, mass), 1);
  EXPECT_NEAR(modes[0].angular_frequency, std::sqrt(100.0 / mass), 1e-9 * std::sqrt(100.0 / mass));
}

TEST(SlowestModes, PeriodIsThatOfTheFrequency) {
  EXPECT_DOUBLE_EQ((Mode{.angular_frequency = 4.0, .shape = {}}.period()), pi / 2.0);
}

TEST(SlowestModes, RefusesACountThatIsNotAvailable) {
  const UniformChain chain{.size = 5};
  const auto refusal = [&](int count) {
    return message_of([&] { slowest_modes(chain.stiffness(), chain.masses(), count); });
  };
  EXPECT_EQ(refusal(6),
            "modal analysis: number of modes = 6 is not allowed; it must be from 1 to 5. "
            "A structure has as many modes as degrees of freedom.");
  EXPECT_EQ(refusal(0),
            "modal analysis: number of modes = 0 is not allowed; it must be from 1 to 5. "
            "A structure has as many modes as degrees of freedom.");
}

}  // namespace
}  // namespace moat
