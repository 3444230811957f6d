#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "materials/isolation/double_pendulum.hpp"
#include "materials/isolation/triple_pendulum.hpp"
#include "message_of.hpp"
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

TEST(DoublePendulum, PassesTheBattery) {
  expect_sound_spring(DoublePendulum::typical().carrying(30 * MN),
                      {.deformation = 0.5, .energy = 1e-8, .panels = 8, .moves = 12});
}

TEST(TriplePendulum, PassesTheBattery) {
  // Up to the stops and beyond.
  expect_sound_spring(TriplePendulum::typical().carrying(30 * MN),
                      {.deformation = 0.9, .energy = 1e-8, .panels = 8, .moves = 12});
  expect_sound_spring(TriplePendulum::typical().carrying(30 * MN),
                      {.deformation = 1.152, .energy = 1e-8, .panels = 8, .moves = 12});
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

TEST(TriplePendulum, HasTheLoopOfTheClosedForm) {
  const SeriesOfSliders law = rigid_plastic(13345 * kN);
  LawPath<SeriesOfSliders> path{law, 0};
  path.move(0.6, 1.0);
  EXPECT_NEAR(path.force() / 13345e3, 0.134820, 1e-6);
  // The first reversal: the inner surfaces let go after 2 mu_1 W.
  LawPath<SeriesOfSliders> back = path;
  back.move(0.6 - 1e-6, 1.0);
  EXPECT_NEAR(back.force() / 13345e3, 0.134820 - 2.0 * 0.01, 3e-6);
  const double before = path.dissipated();
  path.move(-0.6, 1.0);
  path.move(0.6, 1.0);
  EXPECT_NEAR(path.dissipated() - before, 1516.183e3, 20.0);
}

TEST(TriplePendulum, HasTheForcesOfItsBranchesInSeries) {
  const SeriesOfSliders law = rigid_plastic();
  SeriesOfSliders::State trial;
  EXPECT_NEAR(law.evaluate({}, 0.488950, 1.0, trial).force, 0.12, 1e-6);
  EXPECT_NEAR(law.evaluate({}, 1.003248, 1.0, trial).force, 0.2, 1e-6);
}

TEST(DoublePendulum, HasTheStagesOfTheClosedForm) {
  DoublePendulum design = DoublePendulum::typical();
  design.yield_displacement = 1e-9 * m;
  const SeriesOfSliders law = design.carrying(1 * N);
  SeriesOfSliders::State trial;
  EXPECT_NEAR(law.evaluate({}, 0.08, 1.0, trial).force, 0.07, 1e-8);
  EXPECT_NEAR(law.evaluate({}, 0.2, 1.0, trial).stiffness, 0.25, 1e-8);
}

TEST(TriplePendulum, RefusesWhatThreeSlidersInSeriesCannotBe) {
  const auto message = [](auto change) {
    TriplePendulum law = TriplePendulum::typical();
    change(law);
    return message_of([&] { law.check(Check{"Isolator", "bearings"}); });
  };
  EXPECT_EQ(message([](TriplePendulum&) {}), "nothing was thrown");
  EXPECT_EQ(message([](TriplePendulum& law) { law.inner_friction = 0.05; }),
            "Isolator \"bearings\": inner_friction = 0.05 is not allowed; it must be > 0 and below lower_friction = "
            "0.04. Three sliders in series need friction that rises from inside to outside.");
  EXPECT_EQ(message([](TriplePendulum& law) { law.lower_capacity = 0.1 * m; }),
            "Isolator \"bearings\": lower_capacity = 0.1 m is not allowed; it must be >= (upper_friction - "
            "lower_friction) lower_radius = 0.14986 m. Else the lower surface reaches its stop before the upper one "
            "slides, which this model does not cover.");
}

}  // namespace
}  // namespace moat::testing
