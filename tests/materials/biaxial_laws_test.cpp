// Hysteresis of two components: exact paths, tangents, energies.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/units.hpp"
#include "lead_bilinear.hpp"
#include "materials/bilinear.hpp"
#include "materials/plan/biaxial_bilinear.hpp"
#include "materials/plan/biaxial_bouc_wen.hpp"

namespace moat {
namespace {

using namespace units;

constexpr double strength = 2e5, reach = 0.01, post_yield = 1.5e6;  // N, m, N/m

BiaxialBoucWen bouc_wen(double k2 = post_yield) {
  return {.characteristic_strength = strength * N, .yield_displacement = reach * m, .post_yield_stiffness = k2 * N / m};
}
BiaxialBilinear bilinear(double k2 = post_yield) {
  return {
      .yield_force = (strength + k2 * reach) * N, .yield_displacement = reach * m, .post_yield_stiffness = k2 * N / m};
}

template <class Law>
class BiaxialLaw : public ::testing::Test {
 public:
  Law law;
  BiaxialLaw() : law{make()} {}
  static Law make() {
    if constexpr (std::is_same_v<Law, BiaxialBoucWen>)
      return bouc_wen();
    else
      return bilinear();
  }
};
using Laws = ::testing::Types<BiaxialBoucWen, BiaxialBilinear>;
TYPED_TEST_SUITE(BiaxialLaw, Laws);

template <class Law>
PlanarResponse follow(const Law& law, typename Law::State& state, PlanVector to, PlanVector rate = {},
                      double interval = 0.0) {
  typename Law::State after;
  const PlanarResponse response = law.evaluate(state, to, rate, interval, after);
  state = after;
  return response;
}

TYPED_TEST(BiaxialLaw, CornerOfAPathAtFullSlipHasTheClosedForm) {
  // Saturated along x, then along y by d_y: z = (sech 1, tanh 1).
  typename TypeParam::State state;
  follow(this->law, state, {100.0 * reach, 0.0});
  ASSERT_NEAR(state.z.x, 1.0, 1e-12);
  follow(this->law, state, {100.0 * reach, reach});
  EXPECT_NEAR(state.z.x, 1.0 / std::cosh(1.0), 1e-9);
  EXPECT_NEAR(state.z.y, std::tanh(1.0), 1e-9);
  EXPECT_NEAR(state.z.x, 0.648054274, 1e-9);
  EXPECT_NEAR(state.z.y, 0.761594156, 1e-9);
}

TYPED_TEST(BiaxialLaw, SteadyCircleHasItsForceAndEnergy) {
  // |z| = 1 with z = sqrt(1 - k^2) forward + k outward, k = d_y/R; 2 pi R Q sqrt(1 - k^2) per turn.
  constexpr double radius = 5.0 * reach;
  constexpr int steps = 20000;
  typename TypeParam::State state, start;
  const auto on_circle = [&](int i) {
    const double angle = 2.0 * std::numbers::pi * i / steps;
    return PlanVector{radius * std::cos(angle), radius * std::sin(angle)};
  };
  follow(this->law, state, on_circle(0));
  for (int i = 1; i <= 2 * steps; ++i) {
    if (i == steps) start = state;
    follow(this->law, state, on_circle(i));
  }
  EXPECT_NEAR(length(state.z), 1.0, 1e-6);
  // At angle 0 forward is y and outward is x.
  EXPECT_NEAR(state.z.y, 0.979795897, 2e-4);
  EXPECT_NEAR(state.z.x, 0.2, 2e-4);
  const double per_turn = 2.0 * std::numbers::pi * radius * strength * std::sqrt(1.0 - 0.04);
  EXPECT_NEAR(this->law.dissipated_energy(start, state) / per_turn, 1.0, 1e-3);
}

TYPED_TEST(BiaxialLaw, TurnedPathTurnsTheForce) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> step{-3.0 * reach, 3.0 * reach}, angle{0.0, 6.3};
  for (int trial = 0; trial < 50; ++trial) {
    typename TypeParam::State plain, turned_state;
    const double a = angle(random), c = std::cos(a), s = std::sin(a);
    const auto turn = [&](PlanVector v) { return PlanVector{c * v.x - s * v.y, s * v.x + c * v.y}; };
    PlanVector d;
    for (int i = 0; i < 20; ++i) {
      d += {step(random), step(random)};
      const PlanVector expected = turn(follow(this->law, plain, d).force);
      const PlanVector force = follow(this->law, turned_state, turn(d)).force;
      ASSERT_NEAR(force.x, expected.x, 1e-12 * strength);
      ASSERT_NEAR(force.y, expected.y, 1e-12 * strength);
      ASSERT_LE(length(plain.z), 1.0 + 1e-12);
    }
  }
}

TYPED_TEST(BiaxialLaw, DividedIncrementEndsAtTheSameForce) {
  // Exact for a straight increment: a hundred parts of it end where it ends, with the same heat.
  std::mt19937 random{11};
  std::uniform_real_distribution<double> step{-3.0 * reach, 3.0 * reach};
  typename TypeParam::State state;
  PlanVector d;
  for (int i = 0; i < 100; ++i) {
    const PlanVector from = d;
    d += {step(random), step(random)};
    typename TypeParam::State divided = state;
    constexpr int parts = 100;
    for (int k = 1; k <= parts; ++k) follow(this->law, divided, from + double(k) / parts * (d - from));
    follow(this->law, state, d);
    ASSERT_NEAR(divided.z.x, state.z.x, 1e-10);
    ASSERT_NEAR(divided.z.y, state.z.y, 1e-10);
    ASSERT_NEAR(divided.dissipated, state.dissipated, 1e-9);
  }
}

// Straight paths, paths that bend, and paths that turn back, where the area is cut off.
TYPED_TEST(BiaxialLaw, TangentsAreTheDerivatives) {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> part{-1.0, 1.0};
  for (const double interval : {0.0, 0.3, 1.0, 3.0}) {
    typename TypeParam::State state;
    PlanVector d;
    int bent = 0;
    for (int i = 0; i < 1000; ++i) {
      const PlanVector increment = (i % 2 == 0 ? 2.0 : 0.2) * reach * PlanVector{part(random), part(random)};
      d += increment;
      const PlanVector rate = increment + 0.7 * length(increment) * PlanVector{part(random), part(random)};
      typename TypeParam::State ignored;
      const PlanarResponse at = this->law.evaluate(state, d, rate, interval, ignored);
      bent += length(at.damping * PlanVector{1.0, 0.5}) > 0.0 ? 1 : 0;
      constexpr double h = 1e-7 * reach;
      const auto differs = [&](PlanVector ahead, PlanVector behind, PlanVector tangent) {
        return length((ahead - behind) / (2.0 * h) - tangent) > 1e-5 * strength / reach;
      };
      for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}}) {
        const auto force = [&](PlanVector by, PlanVector by_rate) {
          return this->law.evaluate(state, d + by, rate + by_rate, interval, ignored).force;
        };
        const PlanVector step = h * direction;
        ASSERT_FALSE(differs(force(step, {}), force(-step, {}), at.stiffness * direction)) << interval << " " << i;
        ASSERT_FALSE(differs(force({}, step), force({}, -step), at.damping * direction)) << interval << " " << i;
      }
      follow(this->law, state, d, rate, interval);
    }
    EXPECT_EQ(bent > 300, interval > 0.0);
  }
}

// z' = w - z (z.w) by Runge and Kutta's method, along an ellipse on which z never stops being pulled.
TYPED_TEST(BiaxialLaw, ErrorOfABentPathIsOfFourthOrder) {
  const auto rate = [](double t) { return reach * PlanVector{-3.0 * std::sin(t), 5.0 * std::cos(t)}; };
  const auto place = [](double t) { return reach * PlanVector{3.0 * std::cos(t), 5.0 * std::sin(t)}; };
  const PlanVector start = std::is_same_v<TypeParam, BiaxialBoucWen> ? PlanVector{0.1, 0.4} : PlanVector{0.6, 0.8};
  constexpr double duration = 2.0;
  PlanVector exact = start;
  constexpr int fine = 20000;
  const auto slope = [&](double t, PlanVector z) {
    const PlanVector w = rate(t) / reach;
    return w - dot(z, w) * z;
  };
  double dissipated = 0.0;
  for (int i = 0; i < fine; ++i) {
    const double h = duration / fine, t = i * h;
    const PlanVector k1 = slope(t, exact), k2 = slope(t + 0.5 * h, exact + 0.5 * h * k1),
                     k3 = slope(t + 0.5 * h, exact + 0.5 * h * k2), k4 = slope(t + h, exact + h * k3);
    const auto power = [&](double at, PlanVector z) {
      const double along = dot(z, rate(at) / reach);
      return along * dot(z, z);
    };
    const PlanVector middle = exact + 0.5 * h * k2, end = exact + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    dissipated += h / 6.0 * (power(t, exact) + 4.0 * power(t + 0.5 * h, middle) + power(t + h, end));
    exact = end;
  }
  std::vector<double> errors, of_heat;
  for (const int steps : {10, 20, 40, 80}) {
    typename TypeParam::State state{.z = start, .deformation = place(0.0), .rate = rate(0.0)};
    const double h = duration / steps;
    for (int i = 1; i <= steps; ++i) follow(this->law, state, place(i * h), rate(i * h), h);
    errors.push_back(length(state.z - exact));
    of_heat.push_back(std::abs(state.dissipated - dissipated));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_NEAR(errors[i - 1] / errors[i], 16.0, 4.0) << i;
    EXPECT_NEAR(of_heat[i - 1] / of_heat[i], 16.0, 6.0) << i;
  }
  EXPECT_LT(errors.back(), 1e-6);
}

TYPED_TEST(BiaxialLaw, ForceRateIsThatOfTheMotionThatGoesOn) {
  std::mt19937 random{5};
  std::uniform_real_distribution<double> step{-2.0 * reach, 2.0 * reach};
  typename TypeParam::State state;
  PlanVector d;
  for (int i = 0; i < 200; ++i) {
    d += {step(random), step(random)};
    const PlanVector rate{step(random), step(random)};
    const PlanarResponse at = follow(this->law, state, d, rate);
    typename TypeParam::State ignored;
    constexpr double h = 1e-6;
    const PlanVector after = this->law.evaluate(state, d + h * rate, rate, 0.0, ignored).force;
    ASSERT_NEAR((after.x - at.force.x) / h, at.force_rate.x, 1e-4 * strength);
    ASSERT_NEAR((after.y - at.force.y) / h, at.force_rate.y, 1e-4 * strength);
  }
}

TYPED_TEST(BiaxialLaw, WorkIsStoredOrDissipated) {
  std::mt19937 random{13};
  std::uniform_real_distribution<double> step{-2.0 * reach, 2.0 * reach};
  typename TypeParam::State state;
  PlanVector d, force;
  double work = 0.0, scale = 0.0;
  for (int i = 0; i < 50; ++i) {
    const PlanVector from = d;
    d += {step(random), step(random)};
    constexpr int parts = 2000;
    for (int k = 1; k <= parts; ++k) {
      const PlanVector after = follow(this->law, state, from + double(k) / parts * (d - from)).force;
      work += dot(0.5 * (force + after), (d - from) / parts);
      force = after;
    }
    scale = std::max(scale, std::abs(work));
  }
  const double dissipated = this->law.dissipated_energy({}, state);
  EXPECT_GT(dissipated, 0.3 * work);
  EXPECT_NEAR(work, this->law.stored_energy(state, d) + dissipated, 1e-5 * scale);
}

TEST(BiaxialBilinear, AlongALineIsBilinear) {
  const Bilinear line{.yield_force = (strength + post_yield * reach) * N,
                      .yield_displacement = reach * m,
                      .post_yield_stiffness = post_yield * N / m};
  std::mt19937 random{17};
  std::uniform_real_distribution<double> step{-3.0 * reach, 3.0 * reach};
  const double c = std::cos(0.7), s = std::sin(0.7);
  Bilinear::State line_state;
  BiaxialBilinear::State state;
  double d = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double before = d;
    d += step(random);
    const Response expected = testing::lead(line, line_state, before, d);
    const PlanarResponse response = follow(bilinear(), state, {c * d, s * d});
    ASSERT_NEAR(response.force.x, c * expected.force, 1e-9 * strength);
    ASSERT_NEAR(response.force.y, s * expected.force, 1e-9 * strength);
  }
}

TEST(BiaxialBoucWen, SteadyCycleHasTheClosedForm) {
  // Amplitude D: |z| = z_m solves z = tanh(2 D/d_y - z); energy 2 (ln cosh s - z^2/2) Q d_y, s = 2 D/d_y - z.
  struct Case {
    double amplitude, z, energy;
  };
  for (const Case& each :
       {Case{1.5, 0.9663307170, 1.781205060}, Case{2.0, 0.9951028346, 3.638173489}, Case{10.0, 1.0, 35.613705639}}) {
    BiaxialBoucWen::State state, start;
    for (int cycle = 0; cycle < 40; ++cycle) {
      start = state;
      follow(bouc_wen(), state, {-each.amplitude * reach, 0.0});
      follow(bouc_wen(), state, {each.amplitude * reach, 0.0});
    }
    EXPECT_NEAR(state.z.x, each.z, 1e-9);
    EXPECT_NEAR(state.dissipated - start.dissipated, each.energy, 2e-9 * each.energy);
  }
  BiaxialBoucWen::State virgin;
  follow(bouc_wen(), virgin, {0.0, reach});
  EXPECT_NEAR(virgin.z.y, 0.761594156, 1e-9);
}

}  // namespace
}  // namespace moat
