#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "law_battery.hpp"
#include "lead_bilinear.hpp"
#include "materials/bilinear.hpp"
#include "materials/linear.hpp"
#include "materials/viscous.hpp"
#include "unlocated_bilinear.hpp"

namespace moat::testing {
namespace {

using namespace units;

const Bilinear bearing{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};
constexpr double initial = 1.93e8, post_yield = 1.93e7, yield = 0.01;

// Leads the law along a path of corners in small steps; returns the last force and the work.
struct Loop {
  double force = 0.0, work = 0.0;
};
Loop lead_along(const Bilinear& law, Bilinear::State& state, double from, std::initializer_list<double> corners) {
  Loop loop;
  double d = from;
  loop.force = lead(law, state, d, d).force;
  for (const double corner : corners) {
    constexpr int steps = 1000;
    const double start = d;
    for (int i = 1; i <= steps; ++i) {
      const double next = start + (corner - start) * i / steps;
      const double next_force = lead(law, state, d, next).force;
      loop.work += 0.5 * (loop.force + next_force) * (next - d);
      d = next;
      loop.force = next_force;
    }
  }
  return loop;
}

TEST(LinearSpring, PassesTheBattery) {
  for (const double damping : {0.0, 3e5}) {
    const Linear law{.stiffness = 1e9 * N / m, .damping = DampingCoefficient{damping}};
    const LawRange range{.deformation = 0.02, .rate = 0.5};
    expect_sound_law(law, {}, range);
    expect_passive(law, range, 1e-9);
  }
}

TEST(ViscousDamper, PassesTheBattery) {
  const Viscous law{.damping = 7.67e5 * N * s / m};
  const LawRange range{.deformation = 0.02, .rate = 0.5};
  expect_sound_law(law, {}, range);
  expect_passive(law, range, 1e-9);
}

TEST(BilinearSpring, PassesTheBattery) {
  for (const double slip : {0.0, 0.013, -0.04})
    for (const int direction : {-1, 0, 1}) {
      const Bilinear::State committed{slip, direction};
      const LawRange range{.deformation = 0.1, .rate = 0.5};
      expect_exact_tangents(bearing, committed, range);
      expect_pure(bearing, committed, range);
      // A sliding spring keeps its direction until its regime ends.
      expect_energy_identity(bearing, committed, range,
                             [&](double, double v) { return direction == 0 || direction * v > 0.0; });
    }
  expect_passive(bearing, {.deformation = 0.1, .rate = 0.5}, 1e-5);
}

TEST(BilinearSpring, FollowsItsBackbone) {
  const auto force_at = [](double d) {
    Bilinear::State state;
    return lead(bearing, state, 0.0, d).force;
  };
  EXPECT_DOUBLE_EQ(force_at(0.004), 0.004 * initial);
  EXPECT_DOUBLE_EQ(force_at(yield), 1.93e6);
  EXPECT_NEAR(force_at(0.15), 1.93e6 + 0.14 * post_yield, 1e-6);
  EXPECT_NEAR(force_at(-0.15), -1.93e6 - 0.14 * post_yield, 1e-6);
}

TEST(BilinearSpring, UnloadsElasticallyOverTwiceTheYieldDisplacement) {
  Bilinear::State turned;
  const double force = lead(bearing, turned, 0.0, 0.1).force;
  EXPECT_NEAR(force, 1.93e6 + 0.09 * post_yield, 1e-3);
  for (const double back : {1e-6, 0.5 * yield, yield, 1.999 * yield}) {
    Bilinear::State state = turned;
    const Response response = lead(bearing, state, 0.1, 0.1 - back);
    EXPECT_NEAR(response.force, force - initial * back, 1e-3) << back;
    EXPECT_DOUBLE_EQ(response.stiffness, initial) << back;
  }
  const Response beyond = lead(bearing, turned, 0.1, 0.1 - 3.0 * yield);
  EXPECT_DOUBLE_EQ(beyond.stiffness, post_yield);
  EXPECT_NEAR(beyond.force, force - 2.0 * yield * initial - yield * post_yield, 1e-3);
}

TEST(BilinearSpring, HasTheLoopAreaOfTheClosedForm) {
  for (const double amplitude : {0.012, 0.05, 0.2}) {
    Bilinear::State committed;
    lead_along(bearing, committed, 0.0, {amplitude});
    const Loop loop = lead_along(bearing, committed, amplitude, {-amplitude, amplitude});
    const double area = 4.0 * (initial - post_yield) * yield * (amplitude - yield);
    // The trapezoidal rule cuts the two corners of the loop.
    EXPECT_NEAR(loop.work, area, 1e-4 * area) << amplitude;
  }
  Bilinear::State committed;
  EXPECT_NEAR(lead_along(bearing, committed, 0.0, {0.9 * yield, -0.9 * yield, 0.0}).work, 0.0, 1e-6);
}

TEST(BilinearSpring, DissipatesBetweenTwoStatesWhatWorkAndStoredEnergySay) {
  Bilinear::State committed;
  double from = 0.0;
  for (const double corner : {0.008, 0.1, 0.09, -0.05, 0.02}) {
    const Bilinear::State before = committed;
    const double stored = bearing.stored_energy(before, from);
    const double work = lead_along(bearing, committed, from, {corner}).work;
    EXPECT_NEAR(bearing.dissipated_energy(before, committed),
                work - (bearing.stored_energy(committed, corner) - stored), 1e-4 * std::abs(work))
        << corner;
    from = corner;
  }
}

// The law without regimes is written independently, as a return mapping.
TEST(BilinearSpring, FollowsTheLawWithoutRegimes) {
  const UnlocatedBilinear unlocated{1.93e6, yield, post_yield};
  Arguments arguments{{.deformation = 0.1, .rate = 0.5}};
  for (int count = 0; count < 3; ++count) {
    const ClosedPath path = random_path(arguments, 0.0, 0.06);
    UnlocatedBilinear::State plain, plain_trial;
    Bilinear::State state;
    double before = 0.0;
    constexpr int steps = 20000;
    for (int i = 0; i <= steps; ++i) {
      const double d = path.deformation(static_cast<double>(i) / steps);
      const double expected = unlocated.evaluate(plain, d, 0.0, plain_trial).force;
      ASSERT_NEAR(lead(bearing, state, before, d).force, expected, 1e-9 * 1.93e6) << i;
      plain = plain_trial;
      before = d;
    }
  }
}

TEST(BilinearSpring, HasALinearStiffnessForEachStage) {
  EXPECT_DOUBLE_EQ(bearing.linear_stiffness(StiffnessStage::initial), initial);
  EXPECT_DOUBLE_EQ(bearing.linear_stiffness(StiffnessStage::post_yield), post_yield);
}

}  // namespace
}  // namespace moat::testing
