// Error bars of models whose corners nobody locates: laws of a script, and bearings in plan.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "moat.hpp"
#include "peak_in.hpp"
#include "unlocated_bilinear.hpp"

namespace moat {
namespace {

using namespace units;
using testing::UnlocatedBilinear;

constexpr double mass = 3e5, duration = 6.0;

struct Trial {
  UnlocatedBilinear law;
  GroundMotion motion;
};

Trial random_trial(int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>{from, to}(random); };
  constexpr double pi = std::numbers::pi;
  const double post_yield = mass * std::pow(2.0 * pi / uniform(1.5, 3.0), 2), initial = post_yield * uniform(5.0, 15.0),
               reach = uniform(0.003, 0.015);
  const double interval = seed % 3 == 0 ? 0.005 : seed % 3 == 1 ? 0.01 : 0.02;
  const auto count = static_cast<std::size_t>(std::lround(duration / interval));
  std::vector<double> samples(count + 1, 0.0);
  for (int wave = 0; wave < 6; ++wave) {
    const double frequency = uniform(0.4, 4.0), size = uniform(0.3, 1.2), phase = uniform(0.0, 6.0);
    for (std::size_t i = 1; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      samples[i] += size * std::sin(2.0 * pi * frequency * share * duration + phase) * std::sin(pi * share);
    }
  }
  return {{initial * reach, reach, post_yield}, GroundMotion{"noise", interval, samples}};
}

// Largest displacement, with every corner located and exact steps between them.
double exact_peak(const Trial& trial) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = mass * kg});
  add(model, LeadRubberBearing{.upper = node,
                               .yield_force = trial.law.yield_force * N,
                               .yield_displacement = trial.law.yield_displacement * m,
                               .post_yield_stiffness = trial.law.post_yield_stiffness * N / m});
  CaseOptions options{.error_bars = ErrorBarMode::never};
  options.transient.integrator = ExactBetweenEvents{};
  options.transient.tolerance = 1e-9;
  return testing::peak(run_case(model, trial.motion, options), "displacement");
}

CaseResult script_result(const Trial& trial) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = mass * kg});
  add(model, Isolator<UnlocatedBilinear>{.upper = node, .law = trial.law});
  return run_case(model, trial.motion, {.error_bars = ErrorBarMode::always});
}

CaseResult plan_result(const Trial& trial) {
  Model model;
  const DiaphragmId floor =
      add(model, Diaphragm{.name = "mass", .mass = mass * kg, .outline = rectangle(10 * m, 10 * m), .free = true});
  add(model, PlanBearing<BiaxialBilinear>{.name = "bearing",
                                          .under = floor,
                                          .law = {.yield_force = trial.law.yield_force * N,
                                                  .yield_displacement = trial.law.yield_displacement * m,
                                                  .post_yield_stiffness = trial.law.post_yield_stiffness * N / m}});
  return run_case(model, PlanMotion{trial.motion, trial.motion.scaled_by(0.0), 0.0 * deg},
                  {.error_bars = ErrorBarMode::always});
}

// Where a path turns inside a step, a law without regimes does not see the way beyond its ends. Both runs of an error
// bar may lose the same way.
void expect_bars_to_hold(CaseResult (*result_of)(const Trial&), const char* quantity) {
  constexpr int trials = 40;
  double largest = 0.0;
  for (int seed = 1; seed <= trials; ++seed) {
    const Trial trial = random_trial(seed);
    const CaseResult result = result_of(trial);
    const Peak found = testing::peak_in(result, quantity);
    const double exact = exact_peak(trial), error = std::abs(found.magnitude() - exact);
    EXPECT_LE(error, found.error) << "seed " << seed;
    largest = std::max(largest, error / exact);
  }
  // A bar that is wide enough for everything holds too.
  EXPECT_LT(largest, 2e-4);
}

TEST(UnlocatedCorners, OfALawOfAScriptAreInsideTheBars) { expect_bars_to_hold(script_result, "displacement"); }
TEST(UnlocatedCorners, OfABearingInPlanAreInsideTheBars) { expect_bars_to_hold(plan_result, "displacement_x"); }

}  // namespace
}  // namespace moat
