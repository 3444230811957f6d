// The energy ledger closes, to the error that the method promises.

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_buildings.hpp"
#include "plain_changes.hpp"

namespace moat::testing {
namespace {

// A run with a larger share warns (CaseOptions::warn_above_energy_error).
const double without_warning = CaseOptions{}.warn_above_energy_error;
// Average acceleration: forces that balance to 1e-8 of the largest, along some hundred times the largest displacement.
constexpr double balanced = 1e2 * 1e-8;

void expect_closed(const Problem& problem) {
  const EnergyBalance energy = outcome_of(problem).energy;
  RC_LOG() << "integration error " << energy.share(energy.integration_error) << ", residual "
           << energy.share(energy.equation_residual) << ", most at " << energy.worst_element << "\n";
  RC_ASSERT(energy.error_share() <= without_warning);
  // Every joule has its account.
  const double parts =
      energy.kinetic + energy.strain + energy.viscous + energy.hysteretic + energy.impact + energy.friction;
  const double sum = energy.input + energy.weight_work + energy.equation_residual - energy.integration_error;
  const double largest = std::max({energy.largest_input, energy.largest_kinetic, std::abs(parts)});
  RC_ASSERT(std::abs(parts - sum) <= 1e-9 * largest);
}

void expect_identity(const Problem& problem) {
  const EnergyBalance energy =
      outcome_of(problem, {.integrator = Newmark::average_acceleration(), .step = 5 * units::ms}).energy;
  RC_ASSERT(energy.share(energy.equation_residual) <= balanced);
}

TEST(Energy, OfPlainProblemsCloses) {
  for_random_cases(10, [] { expect_closed(problem_of((*plain_problems()).model)); });
}

TEST(Energy, OfAverageAccelerationIsAnIdentity) {
  for_random_cases(10, [] { expect_identity(problem_of((*plain_problems()).model)); });
}

class EnergyOf : public ::testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Families, EnergyOf, ::testing::ValuesIn(families), name_of_family);

TEST_P(EnergyOf, BuildingsCloses) {
  for_random_cases(10, [] { expect_closed(GetParam().building(*draws(), {})); });
}

TEST_P(EnergyOf, AverageAccelerationIsAnIdentity) {
  for_random_cases(5, [] { expect_identity(GetParam().building(*draws(), {})); });
}

}  // namespace
}  // namespace moat::testing
