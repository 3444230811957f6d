// moat against the independent reference on random models. ./moat bench accuracy does the same for 200 of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "moat_model.hpp"
#include "random_model.hpp"
#include "reference_history.hpp"

namespace moat {
namespace {

using namespace testing;

constexpr std::uint64_t first_seed = 1, models = 12;

// The reference's own change with half its steps; its error is about a thirtieth of that.
constexpr double settled = 1e-6;
// Of the worst peak of a model. The promised accuracy of default settings for nine models of ten, and of exact steps
// for 99 of a hundred; of half of the models by default.
constexpr double bound_with_default_settings = 1e-3, bound_of_exact_steps = 5e-4;
constexpr double median_bound_with_default_settings = 2e-4;
// Tight settings have no promise. All corners are located, so that errors are those of location.
constexpr double bound_with_tight_settings = 1e-6;

CaseResult run(const PlainModel& plain, TransientOptions options) {
  Model model = moat_model(plain);
  options.end = plain.end * units::s;
  return run_case(model, moat_motion(plain.motion), {.transient = options});
}

double worst_error(const CaseResult& result, const ReferenceResult& reference) {
  std::map<std::string, double> values;
  for (const Peak& peak : result.peaks) values[peak.quantity + " " + peak.where] = peak.magnitude();
  const std::vector<bool> counts = counting_peaks(reference.peaks);
  double worst = 0.0;
  for (std::size_t i = 0; i < reference.peaks.size(); ++i) {
    const ReferencePeak& peak = reference.peaks[i];
    if (counts[i]) worst = std::max(worst, std::abs(values.at(peak.quantity + " " + peak.where) / peak.value - 1.0));
  }
  return worst;
}

// Its errors stay above the tolerance down to the shortest step, which must be accepted all the same.
TEST(RandomModels, GoOnWithTheShortestStep) { EXPECT_LT(run(random_model(95), {}).solver.accepted_steps, 20000); }

TEST(RandomModels, PeaksAndImpactsAreThoseOfTheReference) {
  std::vector<double> default_errors;
  for (std::uint64_t seed = first_seed; seed < first_seed + models; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const PlainModel plain = random_model(seed);
    const CheckedReference reference = checked_reference(plain);
    ASSERT_TRUE(reference.settled(settled)) << reference.largest_change;
    const CaseResult tight = run(plain, {.tolerance = 1e-7, .steps_per_contact = 512});
    EXPECT_EQ(tight.impacts.size(), reference.result.touches.size());
    EXPECT_LT(worst_error(tight, reference.result), bound_with_tight_settings);
    default_errors.push_back(worst_error(run(plain, {}), reference.result));
    EXPECT_LT(default_errors.back(), bound_with_default_settings);
    const CaseResult exact = run(plain, {.integrator = ExactBetweenEvents{}});
    EXPECT_EQ(exact.impacts.size(), reference.result.touches.size());
    EXPECT_LT(worst_error(exact, reference.result), bound_of_exact_steps);
  }
  std::sort(default_errors.begin(), default_errors.end());
  EXPECT_LT(default_errors[models / 2], median_bound_with_default_settings);
}

}  // namespace
}  // namespace moat
