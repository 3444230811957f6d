// Hysteresis of two components: exact paths, tangents, energies.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "moat.hpp"

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
