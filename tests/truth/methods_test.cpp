// All methods of integration come to the same results as their tolerance falls.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "drawn_buildings.hpp"
#include "plain_changes.hpp"

namespace moat::testing {
namespace {

TransientOptions with_tolerance(const Integrator& integrator, double tolerance) {
  return {.integrator = integrator, .tolerance = tolerance, .steps_per_contact = tolerance < 1e-5 ? 512 : 32};
}

// Without located changes of regime a sum of the steps with uplift has an error of the first order.
std::optional<double> of_higher_order(const Peak& peak) {
  return peak.quantity == "uplift_time" ? std::nullopt : same_magnitude(peak);
}

// The error bars of every method hold its error. With a thirtieth of the default tolerance peaks have a tenth of the
// default error where all changes of regime are located. Where a step may pass over a change of stiffness, its error
// does not fall in proportion to the tolerance.
void expect_agreement(const Problem& problem, const std::vector<Integrator>& integrators) {
  const Outcome truth = outcome_of(problem, with_tolerance(Newmark{}, 1e-7));
  for (const Integrator& integrator : integrators) {
    const TransientOptions loose = with_tolerance(integrator, 1e-4);
    Outcome coarse = outcome_of(problem, loose);
    const Outcome fine = outcome_of(problem, with_tolerance(integrator, 1e-6));
    const Difference of_coarse = difference_of_peaks(truth, coarse, of_higher_order),
                     of_fine = difference_of_peaks(truth, fine, of_higher_order);
    add_error_bars(coarse, problem, loose);
    const Difference beyond_bars = difference_of_peaks(truth, coarse);
    RC_LOG() << name_of(integrator) << ": " << of_coarse << ", " << of_fine << ", beyond the error bars " << beyond_bars
             << "\n";
    RC_ASSERT(beyond_bars <= equal_but_for_rounding);
    RC_ASSERT(of_fine <= (least_share_of_errors(problem.model, loose) > 0.0 ? accurate : 0.1 * accurate));
    RC_ASSERT(of_fine <= std::max(of_coarse.share, equal_but_for_rounding));
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
