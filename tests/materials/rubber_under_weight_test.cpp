// Rubber bearings that soften under the axial force on them; on a line and in plan.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "elements/line/softening_rubber.hpp"
#include "materials/repeated.hpp"
#include "message_of.hpp"
#include "planar_battery.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

const RubberBearing round_rubber{
    .diameter = 0.7 * m, .layer_thickness = 6 * mm, .rubber_thickness = 180 * mm, .shear_modulus = 0.5 * MPa};
const RubberBearing oblong_rubber{.width_x = 0.6 * m,
                                  .width_y = 0.8 * m,
                                  .layer_thickness = 6 * mm,
                                  .rubber_thickness = 180 * mm,
                                  .shear_modulus = 0.5 * MPa};
const LeadRubberBearing lead_rubber{
    .yield_force = 215 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.5 * MN / m};
const SofteningRubber design{.bearing = lead_rubber, .rubber = round_rubber};

constexpr double k_20 = 1.5e6;    // N/m
constexpr double weight = 4e6;    // N
constexpr double largest = 0.35;  // m

// 1 - (N/P_cr)^2 with P_cr of a circle, by hand.
double reduced(double compression, double farthest) {
  const double delta = 2.0 * std::acos(farthest / 0.7), area = (delta - std::sin(delta)) / std::numbers::pi;
  const double critical = 24.2422641e6 * std::max(area, 0.2), ratio = compression / critical;
  return compression > 0.0 ? std::max(0.01, 1.0 - ratio * ratio) : 1.0;
}

TEST(AxialSoftening, HasTheFactorOfAComputedExample) {
  const AxialSoftening softening{round_rubber, weight, {0.35, 0.0}};
  EXPECT_NEAR(softening.critical_load, 9.4787791e6, 1.0);
  EXPECT_NEAR(softening.factor, 0.8219200, 5e-8);
  EXPECT_NEAR((AxialSoftening{round_rubber, weight, {0.21, -0.28}}.factor), 0.8219200, 5e-8);
  EXPECT_EQ((AxialSoftening{round_rubber, -weight, {0.35, 0.0}}.factor), 1.0);
  EXPECT_EQ((AxialSoftening{round_rubber, 2.5 * weight, {0.35, 0.0}}.factor), 0.01);
  // Overlap of a rectangle: (1 - 0.15/0.6)(1 - 0.2/0.8) = 0.5625.
  const double critical = 0.5625 * oblong_rubber.critical_load().si();
  EXPECT_NEAR((AxialSoftening{oblong_rubber, weight, {-0.15, 0.2}}.factor), 1.0 - std::pow(weight / critical, 2),
              1e-12);
}

TEST(AxialSoftening, HasTheDerivativesOfItsFactorAndCriticalLoad) {
  for (const RubberBearing& rubber : {round_rubber, oblong_rubber})
    for (const PlanVector d : {PlanVector{0.2, 0.1}, {-0.3, 0.05}, {0.05, -0.25}, {0.5, 0.45}, {0.9, 0.0}})
      for (const double compression : {2e6, 4e6, 30e6, -1e6}) {
        const auto at = [&](double dx, double dy, double dn) {
          return AxialSoftening{rubber, compression + dn, {d.x + dx, d.y + dy}};
        };
        const AxialSoftening softening = at(0, 0, 0);
        const double h = 1e-6, f = 10.0;
        EXPECT_NEAR(softening.by_compression, (at(0, 0, f).factor - at(0, 0, -f).factor) / (2 * f), 1e-15);
        EXPECT_NEAR(softening.by_displacement.x, (at(h, 0, 0).factor - at(-h, 0, 0).factor) / (2 * h), 1e-8);
        EXPECT_NEAR(softening.by_displacement.y, (at(0, h, 0).factor - at(0, -h, 0).factor) / (2 * h), 1e-8);
        EXPECT_NEAR(softening.critical_slope.x, (at(h, 0, 0).critical_load - at(-h, 0, 0).critical_load) / (2 * h),
                    1.0);
        EXPECT_NEAR(softening.critical_slope.y, (at(0, h, 0).critical_load - at(0, -h, 0).critical_load) / (2 * h),
                    1.0);
      }
}

TEST(RubberUnderWeight, PassesTheBattery) {
  const Carrying<RubberUnderWeight> law = design.carrying(weight * N);
  expect_sound_spring(law, {.deformation = largest});
  expect_rates_of_quantities(law, {.deformation = largest});
}

TEST(PlanarRubberUnderWeight, PassesTheBattery) {
  expect_sound_planar_law(in_plan(design, weight * N), {.move = 0.02, .force = 2e5});
  // A rectangle is not the same in all directions.
  SofteningRubber oblong = design;
  oblong.rubber = oblong_rubber;
  const Carrying<PlanarRubberUnderWeight> law = in_plan(oblong, weight * N);
  const PlanarTrial trial{.force = 2e5};
  expect_planar_tangents(law, trial, trial.interval());
  expect_force_rates(law, trial);
  expect_energy_balance(law, trial);
  expect_planar_purity(law, trial);
}

// A path of the bearing under an axial force, in steps on which both are linear; changes of regime are located.
struct Path {
  RubberUnderWeight law;
  RubberUnderWeight::State state{};
  double deformation = 0.0, force = 0.0, work = 0.0, weight_work = 0.0, dissipated = 0.0, done = 0.0;

  [[nodiscard]] double stored() const { return law.stored_energy(state, deformation); }
  void step(double target, double compression) {
    const double rate = target - deformation, from = deformation, compression_before = state.compression;
    double share = 0.0;
    for (int changes = 0; law.regime_margin(state, target, rate, {}) < 0.0; ++changes) {
      ASSERT_LT(changes, 6);
      double beyond = 1.0;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (share + beyond);
        (law.regime_margin(state, from + middle * rate, rate, {}) < 0.0 ? beyond : share) = middle;
      }
      share = beyond;
      move(from + share * rate, rate, compression_before + share * (compression - compression_before));
      const double before = stored();
      state = law.next_regime(state, deformation, rate);
      dissipated += before - stored();
    }
    move(target, rate, compression);
  }

 private:
  void move(double target, double rate, double compression) {
    RubberUnderWeight::State after;
    const double before = force;
    force = law.evaluate(state, target, rate, {}, {compression, 0.0}, after).force;
    work += 0.5 * (before + force) * (target - deformation);
    done += std::abs(0.5 * (before + force) * (target - deformation));
    weight_work += law.weight_work(state, deformation, after, target);
    dissipated += law.dissipated_energy(state, after);
    state = after;
    deformation = target;
  }
};

// For any N: (k_20 d0 + k_21 d1)/2 (d1 - d0) = (k_21 d1^2 - k_20 d0^2)/2 - (k_21 - k_20) d0 d1/2.
TEST(RubberUnderWeight, EnergyIsAnIdentityOfTheMeanForceWhileNChangesAndDGrows) {
  Path path{design.under_changing_weight(weight * N)};
  const double tension = -1e6;
  path.state.compression = weight;
  for (int i = 1; i <= 5000; ++i) {
    const double t = 1e-3 * i;
    path.step(0.1 * t * std::sin(5.0 * t), weight * (1.0 + 0.8 * std::cos(11.0 * t)) + (i % 1000 == 7 ? tension : 0.0));
  }
  EXPECT_GT(std::abs(path.state.farthest), 0.4);
  EXPECT_GT(std::abs(path.weight_work), 1e-3 * path.done);
  EXPECT_NEAR(path.work + path.weight_work, path.stored() + path.dissipated, 1e-12 * path.done);
}

TEST(RubberUnderWeight, FollowsTheReducedStiffnessOfTheLargestDisplacement) {
  Path path{design.under_changing_weight(weight * N)};
  double farthest = 0.0;
  const double strength = 215e3 - k_20 * 0.01;
  for (int i = 1; i <= 4000; ++i) {
    const double t = 1e-3 * i, d = 0.1 * t * std::sin(5.0 * t), n = weight * (1.0 + 1.2 * std::cos(11.0 * t));
    path.step(d, n);
    farthest = std::max(farthest, std::abs(d));
    const double k_2 = k_20 * reduced(n, farthest), q = strength / 0.01 * (d - path.state.yielding.slip);
    ASSERT_NEAR(path.force, k_2 * d + q, 1.0) << i;
    ASSERT_NEAR(std::abs(path.state.farthest), farthest, 1e-10) << i;
  }
}

// With N and D fixed it is the bilinear law of the reduced stiffness and the same strength.
TEST(RubberUnderWeight, WithConstantNAndDIsBilinear) {
  const double k_2 = k_20 * reduced(weight, largest);
  const Bilinear reference{.yield_force = (215e3 - 0.01 * (k_20 - k_2)) * N,
                           .yield_displacement = 1 * cm,
                           .post_yield_stiffness = k_2 * N / m};
  const RubberUnderWeight law = design.under_changing_weight(weight * N);
  Bilinear::State plain, plain_after;
  RubberUnderWeight::State state{.farthest = largest, .compression = weight}, after;
  const BiaxialBilinear planar_reference{reference.yield_force, reference.yield_displacement,
                                         reference.post_yield_stiffness};
  const PlanarRubberUnderWeight planar_law = in_plan_under_changing_weight(design, weight * N);
  BiaxialBilinear::State planar_plain;
  PlanarRubberUnderWeight::State planar{.farthest = {0.0, -largest}};
  for (int i = 1; i < 4000; ++i) {
    const double t = 1e-3 * i, d = 0.3 * std::sin(3.0 * t), v = 0.9 * std::cos(3.0 * t);
    const Response one = reference.evaluate(plain, d, v, plain_after);
    const Response two = law.evaluate(state, d, v, {}, {weight, 0.0}, after);
    ASSERT_NEAR(two.force, one.force, 1e-2) << i;  // 7 digits of the critical load
    ASSERT_NEAR(two.stiffness, one.stiffness, 0.1);
    ASSERT_NEAR(law.stored_energy(after, d), reference.stored_energy(plain_after, d), 1e-2);
    plain = plain_after;
    state = after;
    while (reference.regime_margin(plain, d, v) < 0.0) plain = reference.next_regime(plain, d, v);
    while (law.regime_margin(state, d, v, {}) < 0.0) state = law.next_regime(state, d, v);
    const PlanVector along{d, 0.1 * d}, rate{v, 0.1 * v};
    const PlanVector expected = planar_reference.evaluate(planar_plain, along, rate, 1e-3, planar_plain).force,
                     force = planar_law.evaluate(planar, along, rate, 1e-3, {weight, 0.0}, planar).force;
    ASSERT_NEAR(force.x, expected.x, 1e-2);
    ASSERT_NEAR(force.y, expected.y, 1e-2);
  }
}

// dF/dd where D grows and where it does not, and dF/dN; of one bearing and of four side by side.
TEST(RubberUnderWeight, TangentsAreThoseOfItsForce) {
  const Repeated<RubberUnderWeight> law{design.under_changing_weight(weight * N), 4.0};
  for (const bool grows : {true, false}) {
    const RubberUnderWeight::State committed{
        .yielding = {.slip = -0.19, .direction = -1}, .farthest = -0.2, .grows = grows, .compression = weight};
    const auto at = [&](double dd, double dn) {
      RubberUnderWeight::State trial;
      return law.evaluate(committed, -0.21 + dd, -0.3, {}, {4.0 * 1.1 * weight + dn, 0.0}, trial);
    };
    EXPECT_NEAR(at(0, 0).stiffness, (at(1e-6, 0).force - at(-1e-6, 0).force) / 2e-6, 1.0);
    EXPECT_NEAR(at(0, 0).by_compression, (at(0, 100).force - at(0, -100).force) / 200.0, 1e-9);
    RubberUnderWeight::State trial;
    law.evaluate(committed, -0.21, -0.3, {}, {4.0 * 1.1 * weight, 0.0}, trial);
    // k_2' d^2/2 of all four, where N grows by 2 MN/s.
    const double h = 1e-6;
    RubberUnderWeight::State before, later;
    law.evaluate(committed, -0.21 + 0.3 * h, -0.3, {}, {4.0 * 1.1 * weight - 2e6 * h, 0.0}, before);
    law.evaluate(committed, -0.21 - 0.3 * h, -0.3, {}, {4.0 * 1.1 * weight + 2e6 * h, 0.0}, later);
    const double power = law.weight_power(trial, -0.21, -0.3, 2e6);
    EXPECT_NEAR(power, law.weight_work(before, -0.21, later, -0.21) / (2.0 * h), 1e-5 * std::abs(power)) << grows;
  }
}

TEST(PlanarRubberUnderWeight, DerivativesByTheWeightAreThoseOfItsForce) {
  const PlanarRubberUnderWeight law = in_plan_under_changing_weight(design, weight * N);
  const PlanarRubberUnderWeight::State committed{
      .yielding = {.z = {0.5, 0.6}, .deformation = {0.1, 0.2}}, .farthest = {0.1, 0.2}, .compression = weight};
  for (const PlanVector d : {PlanVector{0.11, 0.21}, {0.09, 0.19}}) {
    const auto force = [&](double dn) {
      PlanarRubberUnderWeight::State trial;
      return law.evaluate(committed, d, {0.1, 0.1}, 0.1, {weight + dn, 0.0}, trial);
    };
    const PlanVector slope = (force(100).force - force(-100).force) / 200.0;
    EXPECT_NEAR(force(0).by_compression.x, slope.x, 1e-9);
    EXPECT_NEAR(force(0).by_compression.y, slope.y, 1e-9);
    EXPECT_EQ(force(0).rate_by_compression, force(0).by_compression);
  }
}

// A straight path in plan is that of the line.
TEST(PlanarRubberUnderWeight, AlongALineIsTheLawOfTheLine) {
  Path path{design.under_changing_weight(weight * N)};
  const PlanarRubberUnderWeight law = in_plan_under_changing_weight(design, weight * N);
  PlanarRubberUnderWeight::State state, after;
  double work = 0.0;
  for (int i = 1; i <= 5000; ++i) {
    const double t = 1e-3 * i, d = 0.1 * t * std::sin(5.0 * t), n = weight * (1.0 + 0.8 * std::cos(11.0 * t));
    path.step(d, n);
    const PlanVector to{0.6 * d, 0.8 * d}, from = state.yielding.deformation;
    const PlanVector force = law.evaluate(state, to, {}, 0.0, {n, 0.0}, after).force;
    work += law.weight_work(state, from, after, to);
    ASSERT_NEAR(force.x, 0.6 * path.force, 1e-3) << i;
    ASSERT_NEAR(force.y, 0.8 * path.force, 1e-3) << i;
    state = after;
  }
  EXPECT_NEAR(work, path.weight_work, 1e-4 * std::abs(work));
}

TEST(SofteningRubber, TakesBilinearDesignsAndRefusesBadOnes) {
  const Bilinear law = design.under_changing_weight(weight * N).bilinear;
  EXPECT_EQ(law.yield_force.si(), 215e3);
  EXPECT_EQ(law.post_yield_stiffness.si(), k_20);
  const BearingDesign by_period{.strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 1 * cm};
  const SofteningRubber of_period{.bearing = by_period, .rubber = round_rubber};
  EXPECT_EQ(of_period.under_changing_weight(weight * N).bilinear.post_yield_stiffness.si(),
            by_period.carrying(weight * N).post_yield_stiffness.si());
  EXPECT_EQ(of_period.parameters().back().name, "critical_load");
  EXPECT_EQ((SofteningRubber{.bearing = law, .rubber = round_rubber}
                 .under_changing_weight(weight * N)
                 .bilinear.yield_force.si()),
            215e3);
  const auto refusal = [](SofteningRubber bearing) {
    return message_of([&] { bearing.check(Check{SofteningRubber::name, ""}); });
  };
  SofteningRubber bad = design;
  bad.rubber.diameter = -0.7 * m;
  EXPECT_NE(refusal(bad).find("SofteningRubber: diameter"), std::string::npos) << refusal(bad);
  bad = design;
  bad.bearing = Bilinear{.yield_force = 215 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 30 * MN / m};
  EXPECT_NE(refusal(bad).find("post_yield_stiffness"), std::string::npos);
  bad.bearing = BearingDesign{.strength_ratio = 6.0, .isolation_period = 3 * s, .yield_displacement = 1 * cm};
  EXPECT_NE(refusal(bad).find("strength_ratio"), std::string::npos);
  bad.bearing =
      BearingDesign{.weight = 1 * MN, .strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 1 * cm};
  EXPECT_NE(refusal(bad).find("bearing.weight = 1e+06 N is not allowed; it must be left out. Give the weight of the "),
            std::string::npos)
      << refusal(bad);
  bad.bearing = BearingDesign{.strength_ratio = 6.0, .isolation_period = 3 * s, .yield_displacement = 1 * cm};
  EXPECT_NE(message_of([&] { in_plan_under_changing_weight(bad, weight * N); }).find("strength_ratio"),
            std::string::npos);
}

}  // namespace
}  // namespace moat::testing
