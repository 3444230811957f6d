// Options out of their range.

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "analysis_testing.hpp"
#include "base/check.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;
using testing::still_ground;

Model one_mass() {
  Model model;
  add(model, Node{.name = "mass", .mass = 1 * kg, .free = true});
  return model;
}

TEST(TransientOptions, AreRefusedOutsideTheirRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    TransientOptions options;
    std::string option, range;  // "step = -0.001 s", the allowed range, and a remedy
  };
  std::vector<Case> cases{
      {{.step = -1 * ms}, "step = -0.001 s", ">= 0 s and finite. Check its sign and its unit."},
      {{.step = nan * s},
       "step = nan s",
       ">= 0 s and finite. Look for a division by zero in the calculation that gave it."},
      {{.end = -1 * s}, "end = -1 s", ">= 0 s and finite. Check its sign and its unit."},
      {{.largest_step = -1 * ms}, "largest_step = -0.001 s", ">= 0 s and finite. Check its sign and its unit."},
      {{.location_tolerance = 0 * m}, "location_tolerance = 0 m", "> 0 m and finite. Check its sign and its unit."},
      {{.max_iterations = 0}, "max_iterations = 0", ">= 1. Give a number in this range."},
      {{.max_cuts = -1}, "max_cuts = -1", ">= 0. Give a number in this range."},
      {{.max_events_per_second = 0}, "max_events_per_second = 0", ">= 1. Give a number in this range."},
      {{.integrator = HilberHughesTaylor{.alpha = 0.1}},
       "integrator.alpha = 0.1",
       ">= -1/3 and <= 0. -0.1 damps a little; 0 is average acceleration."},
      {{.integrator = GeneralizedAlpha{.spectral_radius = 1.5}},
       "integrator.spectral_radius = 1.5",
       ">= 0 and <= 1. 0.8 damps a little; 1 damps nothing."},
      {{.integrator = ExactBetweenEvents{}, .step = 1 * ms},
       "step = 0.001 s",
       "0 s with ExactBetweenEvents{}. Its steps adapt themselves."}};
  for (const double beta : {0.0, -0.25, nan})
    cases.push_back({{.integrator = Newmark{.beta = beta}},
                     "integrator.beta = " + to_text(beta),
                     "> 0 and <= 0.5. Use Newmark::average_acceleration(), linear_acceleration() or fourth_order()."});
  for (const double tolerance : {0.0, 1.0, -1e-3})
    cases.push_back({{.force_tolerance = tolerance},
                     "force_tolerance = " + to_text(tolerance),
                     "> 0 and < 1. Give a number in this range."});
  for (const double tolerance : {1e-17, 1e-300, 0.9e-12})
    cases.push_back({{.tolerance = tolerance},
                     "tolerance = " + to_text(tolerance),
                     ">= 1e-12 and < 1. 3e-05 is the default; below 1e-12 is round-off."});
  const Model model = one_mass();
  for (const auto& [options, option, range] : cases)
    EXPECT_EQ(message_of([&, &options = options] { Transient(model, still_ground(1 * s), options); }),
              "TransientOptions: " + option + " is not allowed; it must be " + range);
  EXPECT_EQ(message_of([&] { Transient(model, still_ground(1 * s), {.integrator = Newmark{.beta = 0.5}}); }),
            "nothing was thrown");
}

TEST(TransientOptions, RefusesAModelWithoutNodesAndAHistoryInterval) {
  Model empty;
  EXPECT_EQ(message_of([&] { Transient(empty, still_ground(1 * s)); }),
            "Model: there is no node. Add nodes with add(model, Node{...}) first.");
  Model model = one_mass();
  EXPECT_EQ(message_of([&] { CaseRun(model, still_ground(1 * s), {.title = "case", .history_interval = -1 * s}); }),
            "CaseOptions \"case\": history_interval = -1 s is not allowed; it must be >= 0 s and finite. Check its "
            "sign and its unit.");
}

TEST(TransientOptions, EndAndStepAreKept) {
  Model model = one_mass();
  Transient analysis{model, still_ground(1 * s), {.step = 20 * ms, .end = 0.5 * s}};
  EXPECT_EQ(analysis.end_time(), 0.5);
  analysis.run();
  EXPECT_EQ(analysis.statistics().accepted_steps, 25);
  EXPECT_TRUE(analysis.finished());
}

}  // namespace
}  // namespace moat
