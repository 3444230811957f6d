#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "law_battery.hpp"
#include "materials/bilinear.hpp"
#include "materials/linear.hpp"
#include "materials/located_bilinear.hpp"
#include "materials/viscous.hpp"

namespace moat::testing {
namespace {

using namespace units;

const Bilinear bearing{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};
constexpr double initial = 1.93e8, post_yield = 1.93e7, yield = 0.01;

// Leads the law along a path of corners in small steps, committing each; returns the last force and the work.
struct Loop {
  double force = 0.0, work = 0.0;
};
Loop lead(const Bilinear& law, Bilinear::State& committed, double from, std::initializer_list<double> corners) {
  Loop loop;
  Bilinear::State trial;
  double d = from;
  double force = law.evaluate(committed, d, 0.0, trial).force;
  for (const double corner : corners) {
    constexpr int steps = 1000;
    const double start = d;
    for (int i = 1; i <= steps; ++i) {
      const double next = start + (corner - start) * i / steps;
      const double next_force = law.evaluate(committed, next, 0.0, trial).force;
      loop.work += 0.5 * (force + next_force) * (next - d);
      committed = trial;
      d = next;
      force = next_force;
    }
  }
  loop.force = force;
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
  for (const double slip : {0.0, 0.013, -0.04}) {
    const Bilinear::State committed{slip};
    const LawRange range{.deformation = 0.1, .rate = 0.5, .deformation_corners = {slip - yield, slip + yield}};
    expect_exact_tangents(bearing, committed, range);
    expect_pure(bearing, committed, range);
    // Beyond the yield surface of the committed state a spring always slides.
    expect_energy_identity(bearing, committed, range,
                           [&](double d, double v) { return std::abs(d - slip) < yield || (d - slip) * v > 0.0; });
    expect_passive(bearing, range, 1e-5);
  }
}

TEST(BilinearSpring, FollowsItsBackbone) {
  Bilinear::State committed, trial;
  EXPECT_DOUBLE_EQ(bearing.evaluate(committed, 0.004, 0.0, trial).force, 0.004 * initial);
  EXPECT_DOUBLE_EQ(bearing.evaluate(committed, yield, 0.0, trial).force, 1.93e6);
  EXPECT_NEAR(bearing.evaluate(committed, 0.15, 0.0, trial).force, 1.93e6 + 0.14 * post_yield, 1e-6);
  EXPECT_NEAR(bearing.evaluate(committed, -0.15, 0.0, trial).force, -1.93e6 - 0.14 * post_yield, 1e-6);
}

TEST(BilinearSpring, UnloadsElasticallyOverTwiceTheYieldDisplacement) {
  Bilinear::State committed;
  const Loop turned = lead(bearing, committed, 0.0, {0.1});
  EXPECT_NEAR(turned.force, 1.93e6 + 0.09 * post_yield, 1e-3);
  Bilinear::State trial;
  for (const double back : {1e-6, 0.5 * yield, yield, 1.999 * yield}) {
    const Response response = bearing.evaluate(committed, 0.1 - back, 0.0, trial);
    EXPECT_NEAR(response.force, turned.force - initial * back, 1e-3) << back;
    EXPECT_DOUBLE_EQ(response.stiffness, initial) << back;
  }
  const Response beyond = bearing.evaluate(committed, 0.1 - 3.0 * yield, 0.0, trial);
  EXPECT_DOUBLE_EQ(beyond.stiffness, post_yield);
  EXPECT_NEAR(beyond.force, turned.force - 2.0 * yield * initial - yield * post_yield, 1e-3);
}

TEST(BilinearSpring, HasTheLoopAreaOfTheClosedForm) {
  for (const double amplitude : {0.012, 0.05, 0.2}) {
    Bilinear::State committed;
    lead(bearing, committed, 0.0, {amplitude});
    const Loop loop = lead(bearing, committed, amplitude, {-amplitude, amplitude});
    const double area = 4.0 * (initial - post_yield) * yield * (amplitude - yield);
    // The trapezoidal rule cuts the two corners of the loop.
    EXPECT_NEAR(loop.work, area, 1e-4 * area) << amplitude;
  }
  Bilinear::State committed;
  EXPECT_NEAR(lead(bearing, committed, 0.0, {0.9 * yield, -0.9 * yield, 0.0}).work, 0.0, 1e-6);
}

TEST(BilinearSpring, DissipatesBetweenTwoStatesWhatWorkAndStoredEnergySay) {
  Bilinear::State committed;
  double from = 0.0;
  for (const double corner : {0.008, 0.1, 0.09, -0.05, 0.02}) {
    const Bilinear::State before = committed;
    const double stored = bearing.stored_energy(before, from);
    const double work = lead(bearing, committed, from, {corner}).work;
    EXPECT_NEAR(bearing.dissipated_energy(before, committed),
                work - (bearing.stored_energy(committed, corner) - stored), 1e-4 * std::abs(work))
        << corner;
    from = corner;
  }
}

TEST(LocatedBilinearSpring, PassesTheBattery) {
  const LocatedBilinear law{bearing};
  for (const double slip : {0.0, 0.013, -0.04})
    for (const int direction : {-1, 0, 1}) {
      const LocatedBilinear::State committed{slip, direction};
      const LawRange range{.deformation = 0.1, .rate = 0.5};
      expect_exact_tangents(law, committed, range);
      expect_pure(law, committed, range);
      // A sliding spring keeps its direction until its regime ends.
      expect_energy_identity(law, committed, range,
                             [&](double, double v) { return direction == 0 || direction * v > 0.0; });
    }
  expect_passive(law, {.deformation = 0.1, .rate = 0.5}, 1e-5);
}

TEST(LocatedBilinearSpring, HasTheForceOfTheBilinearOne) {
  const LocatedBilinear located{bearing};
  Arguments arguments{{.deformation = 0.1, .rate = 0.5}};
  for (int count = 0; count < 3; ++count) {
    const ClosedPath path = random_path(arguments, 0.0, 0.06);
    Bilinear::State plain, plain_trial;
    LocatedBilinear::State regime, trial;
    constexpr int steps = 20000;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps, d = path.deformation(t), v = path.rate(t);
      for (int changes = 0; changes < 2 && located.regime_margin(regime, d, v) < 0.0; ++changes)
        regime = located.next_regime(regime, d, v);
      const double force = located.evaluate(regime, d, v, trial).force;
      regime = trial;
      // The corners are not located here, but noticed one short step late.
      EXPECT_NEAR(force, bearing.evaluate(plain, d, v, plain_trial).force, 1e-3 * 1.93e6) << t;
      plain = plain_trial;
    }
  }
}

TEST(BilinearSpring, HasALinearStiffnessForEachStage) {
  EXPECT_DOUBLE_EQ(bearing.linear_stiffness(StiffnessStage::initial), initial);
  EXPECT_DOUBLE_EQ(bearing.linear_stiffness(StiffnessStage::post_yield), post_yield);
}

}  // namespace
}  // namespace moat::testing
