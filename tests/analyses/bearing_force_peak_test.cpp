// The peak force of a bearing is one that the bearing can carry.

#include <gtest/gtest.h>

#include <cmath>

#include "analyses/case_run.hpp"
#include "elements/lead_rubber_bearing.hpp"
#include "materials/located_bilinear.hpp"

namespace moat {
namespace {

using namespace units;

constexpr double yield_force = 2000.0;        // N
constexpr double yield_displacement = 5e-3;   // m
constexpr double location_tolerance = 1e-12;  // m, the default
// Where yield is located, it is noticed a little later and passed by the tolerance at most; elsewhere the law caps the
// force.
constexpr double passed = LocatedBilinear::threshold + location_tolerance / yield_displacement, last_digits = 1e-12;

CaseResult run(bool locate_yield, double period, const TransientOptions& options) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1000 * kg});
  // Without any hardening: the force is never above that of yield.
  add(model, LeadRubberBearing{.upper = body,
                               .yield_force = yield_force * N,
                               .yield_displacement = yield_displacement * m,
                               .post_yield_stiffness = 0 * N / m,
                               .locate_yield = locate_yield});
  std::vector<double> samples(801);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = 5.0 * std::sin(6.283185307179586 / period * 0.01 * static_cast<double>(i));
  return run_case(model, GroundMotion{"sine", 0.01, samples},
                  {.transient = options, .error_bars = ErrorBarMode::never});
}

double peak_force(const CaseResult& result) {
  for (const Peak& each : result.peaks)
    if (each.quantity == "isolator_force") return each.value;
  return 0.0;
}

TEST(BearingForcePeak, IsNeverAboveThatOfYield) {
  for (const bool locate_yield : {false, true})
    for (const double period : {0.37, 0.5, 0.83, 1.1})
      for (const TransientOptions& options : {TransientOptions{}, TransientOptions{.tolerance = 1e-6},
                                              TransientOptions{.step = 5 * ms}, TransientOptions{.step = 10 * ms}}) {
        const double peak = peak_force(run(locate_yield, period, options));
        SCOPED_TRACE(::testing::Message() << "located " << locate_yield << ", period " << period << ", step "
                                          << options.step.si() << ", tolerance " << options.tolerance);
        EXPECT_LE(peak / yield_force - 1.0, last_digits + (locate_yield ? passed : 0.0));
        EXPECT_GE(peak / yield_force - 1.0, -last_digits) << "it yields";
      }
}

TEST(BearingForcePeak, ExactStepsReachItToo) {
  for (const double period : {0.37, 0.5, 0.83, 1.1})
    EXPECT_NEAR(peak_force(run(true, period, {.integrator = Integrator::exact_between_events})) / yield_force, 1.0,
                last_digits + passed);
}

}  // namespace
}  // namespace moat
