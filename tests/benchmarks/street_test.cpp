// Peaks of the street of the benchmarks, with located touches and with those at the ends of steps.

#include "measuring/street.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "output/peaks/peak_recorder.hpp"

namespace moat {
namespace {

using namespace units;

std::vector<Peak> peaks(const Model& model, TransientOptions options) {
  PeakRecorder recorder{model};
  options.end = 1 * s;
  Transient analysis{model, performance::street_motion(), performance::street_at_start(model), options};
  analysis.attach(recorder);
  analysis.run();
  return recorder.peaks();
}

// Compares with touches located at a tight tolerance.
void expect_peaks(const Model& street, const TransientOptions& options, double allowed) {
  const std::vector<Peak> tight = peaks(street, {.tolerance = 1e-6, .steps_per_contact = 256});
  const std::vector<Peak> found = peaks(street, options);
  ASSERT_EQ(found.size(), tight.size());
  for (std::size_t i = 0; i < tight.size(); ++i) {
    const double right = tight[i].magnitude();
    EXPECT_NEAR(found[i].magnitude(), right, allowed * right) << tight[i].quantity << " " << tight[i].where;
  }
}

TEST(Street, HasThePeaksOfATightToleranceWithDefaults) { expect_peaks(performance::street(100), {}, 5e-4); }

// The documents state the loss.
TEST(Street, HasThePeaksOfChangesAtTheEndOfTheStepAtTheStatedLoss) {
  expect_peaks(performance::street(100), {.events = EventTreatment::at_end_of_step}, 2e-2);
}

}  // namespace
}  // namespace moat
