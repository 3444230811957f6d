// All methods of integration come to the same results as their tolerance falls.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "drawn_buildings.hpp"
#include "plain_changes.hpp"

namespace moat::testing {
namespace {

TransientOptions with_tolerance(const Integrator& integrator, double tolerance) {
  return {.integrator = integrator, .tolerance = tolerance, .steps_per_contact = tolerance < 1e-5 ? 512 : 32};
}

// With a thirtieth of the default tolerance peaks of every method have a tenth of the default error.
void expect_agreement(const Problem& problem, const std::vector<Integrator>& integrators) {
  const Outcome truth = outcome_of(problem, with_tolerance(Newmark{}, 1e-7));
  for (const Integrator& integrator : integrators) {
    const Outcome coarse = outcome_of(problem, with_tolerance(integrator, 1e-4)),
                  fine = outcome_of(problem, with_tolerance(integrator, 1e-6));
    const Difference of_coarse = difference_of_peaks(truth, coarse), of_fine = difference_of_peaks(truth, fine);
    RC_LOG() << name_of(integrator) << ": " << of_coarse << ", " << of_fine << "\n";
    RC_ASSERT(of_fine <= 0.1 * accurate);
    RC_ASSERT(of_fine <= std::max(of_coarse.share, 1e-6));
  }
}

const std::vector<Integrator> of_newmarks_family{Newmark{}, Newmark::average_acceleration(), HilberHughesTaylor{},
                                                 GeneralizedAlpha{}};

TEST(Methods, AgreeOnPlainProblems) {
  for_random_cases(3, [] {
    std::vector<Integrator> all = of_newmarks_family;
    all.emplace_back(ExactBetweenEvents{});
    expect_agreement(problem_of((*plain_problems()).model), all);
  });
}

class MethodsOn : public ::testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Families, MethodsOn, ::testing::ValuesIn(families), name_of_family);

TEST_P(MethodsOn, BuildingsAgree) {
  for_random_cases(1, [] { expect_agreement(GetParam().building(*draws(), {}), of_newmarks_family); });
}

}  // namespace
}  // namespace moat::testing
