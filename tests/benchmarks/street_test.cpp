// The street of the benchmarks has the same peaks whether its touches end steps or not.

#include "measuring/street.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "output/peaks/peak_recorder.hpp"

namespace moat {
namespace {

using namespace units;

struct Run {
  std::vector<Peak> peaks;
  SolverStatistics solver;
};

Run run(Model model, TransientOptions options) {
  PeakRecorder recorder{model};
  options.end = 1 * s;
  Transient analysis{model, performance::street_motion(), options};
  analysis.attach(recorder);
  analysis.run();
  return {recorder.peaks(), analysis.statistics()};
}

// With defaults and with located touches at a tight tolerance. Returns the changes of the defaults inside steps.
long expect_peaks_of_located_touches(const Model& street, double allowed) {
  const Run located = run(street, {.tolerance = 1e-6, .steps_per_contact = 256, .events = EventTreatment::located});
  EXPECT_EQ(located.solver.changes_inside, 0);
  const Run defaults = run(street, {});
  EXPECT_EQ(defaults.peaks.size(), located.peaks.size());
  if (defaults.peaks.size() != located.peaks.size()) return 0;
  for (std::size_t i = 0; i < located.peaks.size(); ++i) {
    const double right = located.peaks[i].magnitude();
    EXPECT_NEAR(defaults.peaks[i].magnitude(), right, allowed * right)
        << located.peaks[i].quantity << " " << located.peaks[i].where;
  }
  return defaults.solver.changes_inside;
}

TEST(Street, HasThePeaksOfLocatedTouchesWithDefaults) {
  EXPECT_EQ(expect_peaks_of_located_touches(performance::street(100), 5e-4), 0);
}

// Above 1000 degrees of freedom touches do not end steps. Promised is 1e-3.
TEST(Street, HasThemWhereTouchesDoNotEndSteps) {
  for (const char* law : {"hertz_damp", "linear_elastic", "nonlinear_viscoelastic"}) {
    SCOPED_TRACE(law);
    EXPECT_GT(expect_peaks_of_located_touches(performance::street(170, performance::street_law(law)), 2e-4), 100);
  }
}

}  // namespace
}  // namespace moat
