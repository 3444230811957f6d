// Options out of their range.

#include <gtest/gtest.h>

#include <limits>

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

std::string refusal(const TransientOptions& options) {
  Model model = one_mass();
  return message_of([&] { Transient(model, still_ground(1 * s), options); });
}

TEST(TransientOptions, RefusesAScheme) {
  for (const double beta : {0.0, -0.25})
    EXPECT_EQ(refusal({.integrator = Newmark{.beta = beta}}),
              "TransientOptions: integrator.beta = " + to_text(beta) +
                  " is not allowed; it must be > 0 and <= 0.5. Use Newmark::average_acceleration(), "
                  "linear_acceleration() or fourth_order().");
  EXPECT_EQ(refusal({.integrator = Newmark{.beta = 0.5}}), "nothing was thrown");
  EXPECT_NE(refusal({.integrator = Newmark{.beta = std::numeric_limits<double>::quiet_NaN()}}), "nothing was thrown");
}

TEST(TransientOptions, RefusesTimes) {
  EXPECT_EQ(refusal({.step = -1 * ms}),
            "TransientOptions: step = -0.001 s is not allowed; it must be >= 0 s and finite.");
  EXPECT_EQ(refusal({.end = -1 * s}), "TransientOptions: end = -1 s is not allowed; it must be >= 0 s and finite.");
  EXPECT_EQ(refusal({.largest_step = -1 * ms}),
            "TransientOptions: largest_step = -0.001 s is not allowed; it must be >= 0 s and finite.");
  EXPECT_EQ(refusal({.step = std::numeric_limits<double>::quiet_NaN() * s}),
            "TransientOptions: step = nan s is not allowed; it must be >= 0 s and finite.");
}

TEST(TransientOptions, RefusesTolerances) {
  for (const double tolerance : {0.0, 1.0, -1e-3})
    EXPECT_EQ(refusal({.force_tolerance = tolerance}),
              "TransientOptions: force_tolerance = " + to_text(tolerance) + " is not allowed; it must be > 0 and < 1.");
  EXPECT_EQ(refusal({.location_tolerance = 0 * m}),
            "TransientOptions: location_tolerance = 0 m is not allowed; it must be > 0 m and finite.");
}

TEST(TransientOptions, RefusesCounts) {
  EXPECT_EQ(refusal({.max_iterations = 0}), "TransientOptions: max_iterations = 0 is not allowed; it must be >= 1.");
  EXPECT_EQ(refusal({.max_cuts = -1}), "TransientOptions: max_cuts = -1 is not allowed; it must be >= 0.");
  EXPECT_EQ(refusal({.max_events_per_second = 0}),
            "TransientOptions: max_events_per_second = 0 is not allowed; it must be >= 1.");
}

TEST(TransientOptions, RefusesAModelWithoutNodesAndAHistoryInterval) {
  Model empty;
  EXPECT_EQ(message_of([&] { Transient(empty, still_ground(1 * s)); }),
            "Model: there is no node. Add nodes with add(model, Node{...}) first.");
  Model model = one_mass();
  EXPECT_EQ(message_of([&] { CaseRun(model, still_ground(1 * s), {.title = "case", .history_interval = -1 * s}); }),
            "CaseOptions \"case\": history_interval = -1 s is not allowed; it must be >= 0 s and finite.");
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
