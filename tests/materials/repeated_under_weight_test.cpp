// Equal laws side by side under an axial force: that on all of them in evaluate(), that on one in states and margins.
#include <gtest/gtest.h>

#include "elements/line/softening_rubber.hpp"
#include "materials/isolation/double_pendulum.hpp"
#include "materials/isolation/friction_pendulum.hpp"
#include "materials/isolation/heated_friction_pendulum.hpp"
#include "materials/repeated.hpp"

namespace moat {
namespace {

using namespace units;

constexpr double weight = 2e6, count = 4.0;  // N, 1

// `d` m at `v` m/s, where N falls by 3 MN/s on each of them.
template <class Law>
void expect_sum_of_equal_laws(const Law& one, double d, double v) {
  const Repeated<Law> four{one, count};
  const double n = 0.9 * weight, fall = -3e6;
  typename Law::State committed{}, of_one, of_four;
  committed.compression = weight;
  const Response a = one.evaluate(committed, d, v, {0.01, 0.9 * d, v}, {n, fall}, of_one),
                 b = four.evaluate(committed, d, v, {0.01, 0.9 * d, v}, {count * n, count * fall}, of_four);
  EXPECT_EQ(of_four, of_one);
  EXPECT_EQ(of_four.compression, n);
  EXPECT_EQ(b.force, count * a.force);
  EXPECT_EQ(b.stiffness, count * a.stiffness);
  EXPECT_EQ(b.damping, count * a.damping);
  EXPECT_EQ(b.by_compression, a.by_compression) << "by the axial force on all";
  EXPECT_EQ(four.stored_energy(of_four, d), count * one.stored_energy(of_one, d));
  EXPECT_EQ(four.dissipated_energy(committed, of_four), count * one.dissipated_energy(committed, of_one));
  static_assert(MarginUnderAxialForce<Repeated<Law>> == MarginUnderAxialForce<Law>);
  if constexpr (MarginUnderAxialForce<Law>) {
    EXPECT_EQ(four.regime_margin(committed, d, v, {of_four.compression}),
              one.regime_margin(committed, d, v, {of_one.compression}));
  } else {
    EXPECT_EQ(four.regime_margin(of_four, d, v), one.regime_margin(of_one, d, v));
  }
  EXPECT_EQ(four.next_regime(of_four, d, v), one.next_regime(of_one, d, v));
  const auto has_rate = [&](const auto& law) {
    return requires { law.force_rate(of_one, d, v, 0.5, fall); };
  };
  EXPECT_EQ(has_rate(four), has_rate(one));
  if constexpr (requires { one.force_rate(of_one, d, v, 0.5, fall); }) {
    EXPECT_EQ(four.force_rate(of_four, d, v, 0.5, count * fall), count * one.force_rate(of_one, d, v, 0.5, fall));
  }
  if constexpr (GivesWeightWork<Law, double>) {
    EXPECT_EQ(four.weight_power(of_four, d, v, count * fall), count * one.weight_power(of_one, d, v, fall));
  } else {
    EXPECT_EQ(four.weight_lever(committed, d, of_four, d), one.weight_lever(committed, d, of_one, d));
  }
}

TEST(RepeatedUnderWeight, IsTheSumOfEqualLaws) {
  const auto heated = HeatedFrictionPendulum::typical().under_changing_weight(weight * N);
  const auto pendulum = FrictionPendulum{.radius = 2 * m, .friction = 0.06}.under_changing_weight(weight * N);
  const auto series = DoublePendulum::typical().under_changing_weight(weight * N);
  const SofteningRubber rubber{
      .bearing = Bilinear{.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 2.4 * MN / m},
      .rubber = {
          .diameter = 0.7 * m, .layer_thickness = 6 * mm, .rubber_thickness = 180 * mm, .shear_modulus = 0.5 * MPa}};
  for (const double d : {0.5e-3, 0.1})
    for (const double v : {0.2, -0.2}) {
      expect_sum_of_equal_laws(heated, d, v);
      expect_sum_of_equal_laws(pendulum, d, v);
      expect_sum_of_equal_laws(series, d, v);
      expect_sum_of_equal_laws(rubber.under_changing_weight(weight * N), d, v);
    }
}

}  // namespace
}  // namespace moat
