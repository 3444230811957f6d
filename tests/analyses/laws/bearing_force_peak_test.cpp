// The peak force of a bearing is one that the bearing can carry.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis_testing.hpp"
#include "moat.hpp"
#include "peak_in.hpp"
#include "unlocated_bilinear.hpp"

namespace moat {
namespace {

using namespace units;
using testing::peak;

constexpr double yield_force = 2000.0;        // N
constexpr double yield_displacement = 5e-3;   // m
constexpr double location_tolerance = 1e-12;  // m, the default
// Where yield is located, it is noticed a little later and passed by the tolerance at most; elsewhere the law caps the
// force.
constexpr double passed = Bilinear::threshold + location_tolerance / yield_displacement, last_digits = 1e-12;

struct Bearing {
  double post_yield_stiffness;  ///< N/m
  bool is_located;
};

CaseResult run(const Bearing& bearing, double period, const TransientOptions& options) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1000 * kg});
  if (bearing.is_located)
    add(model, LeadRubberBearing{.upper = body,
                                 .yield_force = yield_force * N,
                                 .yield_displacement = yield_displacement * m,
                                 .post_yield_stiffness = bearing.post_yield_stiffness * N / m});
  else
    add(model, Isolator<testing::UnlocatedBilinear>{
                   .upper = body, .law = {yield_force, yield_displacement, bearing.post_yield_stiffness}});
  return run_case(model, testing::sine_motion(5.0, 2.0 * std::numbers::pi / period, 8 * s),
                  {.transient = options, .error_bars = ErrorBarMode::never});
}

// The capacity of the law at any deformation up to the largest: k2 u + (k1 - k2) d_y.
double capacity(const Bearing& bearing, const CaseResult& result) {
  return bearing.post_yield_stiffness * (peak(result, "isolator_deformation") - yield_displacement) + yield_force;
}

TEST(BearingForcePeak, IsNeverAboveWhatTheBearingCanCarry) {
  const double initial_stiffness = yield_force / yield_displacement;
  for (const double post_yield_stiffness : {0.0, 1e-3, 1.0, 0.1 * initial_stiffness})
    for (const bool is_located : {false, true})
      for (const double period : {0.37, 0.5, 0.83, 1.1})
        for (const TransientOptions& options : {TransientOptions{}, TransientOptions{.tolerance = 1e-6},
                                                TransientOptions{.step = 5 * ms}, TransientOptions{.step = 10 * ms}}) {
          SCOPED_TRACE(::testing::Message()
                       << "k2 " << post_yield_stiffness << ", located " << is_located << ", period " << period
                       << ", step " << options.step.si() << ", tolerance " << options.tolerance);
          const Bearing bearing{post_yield_stiffness, is_located};
          const CaseResult result = run(bearing, period, options);
          const double force = peak(result, "isolator_force");
          // The largest deformation is that of a cubic inside a step; the law may see (w h)^4/384 more.
          const double phase = 2.0 * std::numbers::pi / period * std::max(result.solver.longest_step, 0.01);
          const double unseen =
              std::pow(phase, 4) / 384.0 * post_yield_stiffness * peak(result, "isolator_deformation") / yield_force;
          EXPECT_LE(force / capacity(bearing, result) - 1.0, last_digits + unseen + (is_located ? passed : 0.0));
          EXPECT_GE(force / yield_force - 1.0, -last_digits) << "it yields";
        }
}

TEST(BearingForcePeak, ExactStepsReachItToo) {
  for (const double period : {0.37, 0.5, 0.83, 1.1})
    EXPECT_NEAR(peak(run({0.0, true}, period, {.integrator = ExactBetweenEvents{}}), "isolator_force") / yield_force,
                1.0, last_digits + passed);
}

}  // namespace
}  // namespace moat
