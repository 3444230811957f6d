// Dashpots that hold their ends together do not set the step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "moat.hpp"
#include "peak_in.hpp"
#include "small_models.hpp"

namespace moat {
namespace {

using namespace units;
using std::numbers::pi;

constexpr double mass = 5e5;

double stiffness_of_period(double period) { return mass * std::pow(2.0 * pi / period, 2); }

// Eight waves between 0.3 and 5 Hz, 4 m/s^2, 10 s.
const GroundMotion& motion() {
  static const GroundMotion noise = [] {
    std::mt19937_64 random{1};
    const auto uniform = [&](double from, double to) {
      return std::uniform_real_distribution<double>{from, to}(random);
    };
    constexpr std::size_t count = 1000;
    std::vector<double> samples(count + 1, 0.0);
    for (int wave = 0; wave < 8; ++wave) {
      const double frequency = uniform(0.3, 5.0), size = uniform(0.2, 1.0), phase = uniform(0.0, 6.28);
      for (std::size_t i = 1; i < count; ++i) {
        const double share = static_cast<double>(i) / count;
        samples[i] += size * std::sin(2.0 * pi * frequency * 10.0 * share + phase) * std::sin(pi * share);
      }
    }
    return GroundMotion{"noise", 0.01, samples}.scaled_to_pga(4.0 * m / (s * s));
  }();
  return noise;
}

struct Pounding {
  Model model;
  NodeId base, floor;
};

// Two floors on a bearing inside a moat.
Pounding building(double floor_mass = mass) {
  Pounding made;
  Model& model = made.model;
  made.base = add(model, Node{.name = "base", .mass = mass * kg});
  made.floor = add(model, Node{.name = "floor", .mass = floor_mass * kg});
  add(model, LeadRubberBearing{.upper = made.base,
                               .yield_force = 0.01 * stiffness_of_period(0.5) * N,
                               .yield_displacement = 1 * cm,
                               .post_yield_stiffness = stiffness_of_period(2.5) * N / m});
  const double storey = stiffness_of_period(0.3);
  add(model, ShearSpring{.name = "storey", .lower = made.base, .upper = made.floor, .stiffness = storey * N / m});
  add(model, ViscousDamper{.name = "damper",
                           .lower = made.base,
                           .upper = made.floor,
                           .damping = 0.1 * std::sqrt(storey * mass) * N * s / m});
  add(model, Moat{.around = made.base,
                  .clearance = 8 * cm,
                  .law = ExactHertzDamp{.stiffness = 3e9 * N / m_3_2, .restitution = 0.65}});
  return made;
}

CaseResult run(const Model& model) { return run_case(model, motion(), {.error_bars = ErrorBarMode::always}); }

// Peaks of the building in two models, whose difference is that of the models themselves plus `apart`.
void expect_same_peaks(const CaseResult& found, const CaseResult& expected, double apart) {
  for (const char* quantity : {"displacement", "absolute_acceleration"})
    for (const char* where : {"base", "floor"}) {
      const Peak one = testing::peak_in(found, quantity, where), other = testing::peak_in(expected, quantity, where);
      EXPECT_NEAR(one.magnitude(), other.magnitude(), one.error + other.error + apart * other.magnitude())
          << quantity << " " << where;
      EXPECT_LT(one.error, 1e-3 * one.magnitude()) << quantity << " " << where;
    }
}

constexpr long most_steps = 3;  // of a strong dashpot, in those of the model without it

// A second body that a dashpot holds to the ground: the building must not notice, and the body's displacement is the
// impulse of its inertia over the damping.
TEST(StrongDashpots, ToTheGroundTakeTheStepsOfTheRest) {
  const CaseResult alone = run(building().model);
  for (const double damping : {1e9, 1e12, 1e15}) {
    SCOPED_TRACE(damping);
    Model model = building().model;
    const NodeId held = add(model, testing::Oscillator{.name = "held", .mass = mass});
    add(model, ViscousDamper{.name = "dashpot", .lower = ground, .upper = held, .damping = damping * N * s / m});
    const CaseResult result = run(model);
    EXPECT_LE(result.solver.accepted_steps, most_steps * alone.solver.accepted_steps);
    expect_same_peaks(result, alone, 1e-5);
    double velocity = 0.0, displacement = 0.0, largest = 0.0;  // of the ground, by the trapezoidal rule
    const auto samples = motion().samples();
    for (std::size_t i = 1; i < samples.size(); ++i) {
      velocity += 0.5 * motion().time_step() * (samples[i - 1] + samples[i]);
      displacement = -mass / damping * velocity;
      largest = std::max(largest, std::abs(displacement));
    }
    EXPECT_NEAR(testing::peak(result, "displacement", "held"), largest, 0.02 * largest) << "without the spring";
    EXPECT_NEAR(testing::peak(result, "absolute_acceleration", "held"), 4.0, 2e-3 * 4.0);
  }
}

// Two bodies joined by a dashpot that holds them together move as one with the sum of their masses.
TEST(StrongDashpots, BetweenTwoBodiesTakeTheStepsOfOneBody) {
  const CaseResult one = run(building(2.0 * mass).model);
  for (const double damping : {1e12, 1e15}) {
    SCOPED_TRACE(damping);
    Pounding made = building();
    const NodeId second = add(made.model, Node{.name = "second", .mass = mass * kg});
    add(made.model,
        ViscousDamper{.name = "dashpot", .lower = made.floor, .upper = second, .damping = damping * N * s / m});
    const CaseResult result = run(made.model);
    EXPECT_LE(result.solver.accepted_steps, most_steps * one.solver.accepted_steps);
    expect_same_peaks(result, one, 2e-5);
  }
}

// The brace of a Maxwell damper may be as stiff as one likes: it becomes a damper without brace.
TEST(StrongDashpots, AStiffBraceTakesTheStepsOfADamperWithoutBrace) {
  Pounding rounded = building();
  add(rounded.model, Isolator<NonlinearViscous>{
                         .name = "damper of base",
                         .upper = rounded.base,
                         .law = {.reference_force = 0.5 * MN, .exponent = 0.3, .rounding_speed = 1e-6 * m / s}});
  const CaseResult expected = run(rounded.model);
  for (const double brace : {1e10, 1e12, 1e14}) {
    SCOPED_TRACE(brace);
    Pounding made = building();
    add(made.model, Isolator<MaxwellDamper>{
                        .name = "damper of base",
                        .upper = made.base,
                        .law = {.brace_stiffness = brace * N / m, .reference_force = 0.5 * MN, .exponent = 0.3}});
    const CaseResult result = run(made.model);
    EXPECT_LE(result.solver.accepted_steps, most_steps * expected.solver.accepted_steps);
    if (brace > 1e11) expect_same_peaks(result, expected, 1e-4);
  }
}

}  // namespace
}  // namespace moat
