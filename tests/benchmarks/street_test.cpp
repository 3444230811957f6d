// The street of the benchmarks has the same peaks whether its touches end steps or not.

#include "measuring/street.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "output/peak_recorder.hpp"

namespace moat {
namespace {

using namespace units;

std::vector<Peak> peaks(TransientOptions options, SolverStatistics& solver) {
  // Large enough that its touches do not end steps by default.
  Model model = performance::street(170);
  PeakRecorder recorder{model};
  options.end = 1 * s;
  Transient analysis{model, performance::street_motion(), options};
  analysis.attach(recorder);
  analysis.run();
  solver = analysis.statistics();
  return recorder.peaks();
}

// A peak may lie at a touch or yield inside a step. No cubic over the step shows it.
TEST(Street, HasThePeaksOfLocatedTouchesWithDefaults) {
  SolverStatistics solver;
  const std::vector<Peak> located =
      peaks({.tolerance = 1e-6, .steps_per_contact = 256, .events = EventTreatment::located}, solver);
  EXPECT_EQ(solver.changes_inside, 0);
  const std::vector<Peak> defaults = peaks({}, solver);
  EXPECT_GT(solver.changes_inside, 100);
  ASSERT_EQ(defaults.size(), located.size());
  constexpr double allowed = 1e-3;  // as promised
  for (std::size_t i = 0; i < located.size(); ++i) {
    EXPECT_NEAR(defaults[i].magnitude(), located[i].magnitude(), allowed * located[i].magnitude())
        << located[i].quantity << " " << located[i].where;
  }
}

}  // namespace
}  // namespace moat
