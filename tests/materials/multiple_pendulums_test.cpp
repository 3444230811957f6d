#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "moat.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Nearly rigid before sliding.
SeriesOfSliders rigid_plastic(Force weight = 1 * N) {
  TriplePendulum law = TriplePendulum::typical();
  law.yield_displacement = 1e-9 * m;
  return law.carrying(weight);
}

// Up to the stops and beyond, with equal and with unequal plates.
TEST(TriplePendulum, PassesTheBattery) {
  TriplePendulum unequal = TriplePendulum::typical();
  unequal.lower_radius = 5 * m;
  unequal.upper_radius = 2.5 * m;
  for (const TriplePendulum& law : {TriplePendulum::typical(), unequal})
    expect_sound_spring(law.carrying(30 * MN), {.deformation = 1.152, .energy = 1e-8, .panels = 8, .moves = 8});
}

TEST(TriplePendulum, HasTheStagesOfTheClosedForm) {
  const SeriesOfSliders law = rigid_plastic();
  struct Stage {
    double end, force, slope;
  };
  double before = 0.0;
  for (const Stage& stage :
       {Stage{0.023622, 0.040000, 0.7874}, Stage{0.189230, 0.080000, 4.1402}, Stage{0.898110, 0.174606, 7.4930},
        Stage{1.063718, 0.214606, 4.1402}, Stage{1.151800, 0.326470, 0.7874}}) {
    SeriesOfSliders::State trial;
    EXPECT_NEAR(law.evaluate({}, stage.end, 1.0, trial).force, stage.force, 2e-6) << stage.end;
    EXPECT_NEAR(1.0 / law.evaluate({}, 0.5 * (before + stage.end), 1.0, trial).stiffness, stage.slope, 1e-4);
    before = stage.end;
  }
}

// The four surfaces of a triple pendulum that is nearly rigid before it slides, W = 1 N: equilibrium of each slider
// with Coulomb friction and a stop, under a force that changes slowly.
class FourSurfaces {
 public:
  explicit FourSurfaces(const TriplePendulum& design) : design_{design} {}
  void load(double force) {
    const double inner = design_.inner_radius.si();
    slide(lower_, force, design_.lower_radius.si(), design_.lower_friction, design_.lower_capacity.si());
    slide(upper_, force, design_.upper_radius.si(), design_.upper_friction, design_.upper_capacity.si());
    // The outer sliders carry the inner surfaces, which tilt with them.
    slide(beside_lower_, force - lower_ / design_.lower_radius.si(), inner, design_.inner_friction,
          design_.inner_capacity.si());
    slide(beside_upper_, force - upper_ / design_.upper_radius.si(), inner, design_.inner_friction,
          design_.inner_capacity.si());
  }
  [[nodiscard]] double displacement() const { return lower_ + upper_ + beside_lower_ + beside_upper_; }

 private:
  static void slide(double& u, double force, double radius, double friction, double capacity) {
    const double moved = std::clamp(u / radius, force - friction, force + friction) * radius;
    u = std::clamp(moved, -capacity, capacity);
  }
  TriplePendulum design_;
  double lower_ = 0.0, upper_ = 0.0, beside_lower_ = 0.0, beside_upper_ = 0.0;
};

TEST(TriplePendulum, FollowsItsFourSurfacesForUnequalPlates) {
  std::mt19937_64 engine{20261127};
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(engine);
  };
  for (int k = 0; k < 60; ++k) {
    const double inner = uniform(0.2, 0.6), lower = uniform(1.5, 4.0), upper = uniform(1.5, 4.0);
    const double first = uniform(0.01, 0.04), second = first + uniform(0.005, 0.05),
                 third = second + uniform(0.0, 0.06);
    TriplePendulum design{.inner_radius = inner * m,
                          .lower_radius = lower * m,
                          .upper_radius = upper * m,
                          .inner_friction = first,
                          .lower_friction = second,
                          .upper_friction = third,
                          .inner_capacity = ((third - first) * inner + uniform(0.005, 0.08)) * m,
                          .lower_capacity = ((third - second) * lower + uniform(0.05, 0.4)) * m,
                          .upper_capacity = uniform(0.1, 0.5) * m,
                          .yield_displacement = 1e-9 * m};
    design.check(Check{"Isolator", "bearings"});
    const SeriesOfSliders law = design.carrying(1 * N);
    const double d1 = design.inner_capacity.si() / inner, d2 = design.lower_capacity.si() / lower,
                 d3 = design.upper_capacity.si() / upper;
    const double last = d1 + std::max(d2, d3) + first;  // all surfaces are at their stops
    FourSurfaces exact{design};
    LawPath<SeriesOfSliders> path{law, 0};
    double force = 0.0;
    int compared = 0;
    for (int move = 0; move < 60; ++move) {
      const double target = move == 0 ? 0.9999 * last : uniform(-0.9999, 0.9999) * last;
      constexpr int parts = 50;
      for (int i = 1; i <= parts; ++i) {
        const double before = exact.displacement();
        const double now = force + (target - force) * i / parts;
        exact.load(now);
        const double moved = std::abs(exact.displacement() - before);
        if (moved > 0.0) path.move(exact.displacement(), 1.0);
        if (moved < 1e-4) continue;  // the law is not quite rigid
        EXPECT_NEAR(path.force(), now, 2e-7) << "pendulum " << k << ", u = " << exact.displacement() << " m";
        ++compared;
      }
      force = target;
      if (::testing::Test::HasFailure()) return;
    }
    EXPECT_GT(compared, 500);
  }
}

TEST(DoublePendulum, HasTheStagesOfTheClosedForm) {
  DoublePendulum design = DoublePendulum::typical();
  design.yield_displacement = 1e-9 * m;
  const SeriesOfSliders law = design.carrying(1 * N);
  SeriesOfSliders::State trial;
  EXPECT_NEAR(law.evaluate({}, 0.08, 1.0, trial).force, 0.07, 1e-8);
  EXPECT_NEAR(law.evaluate({}, 0.2, 1.0, trial).stiffness, 0.25, 1e-8);
}

}  // namespace
}  // namespace moat::testing
