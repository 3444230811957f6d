// Shocks one after the other: the joined motion is the sum of the single ones, each at its time.

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/ground_motion.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/plan_motion.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const GroundMotion foreshock{"foreshock", 0.02, {0.0, 1.0, -2.0, 0.5}};
const GroundMotion shock{"shock", 0.02, {0.25, 3.0, -1.0, 0.0, 0.0}};

TEST(Joined, IsTheSumOfTheShocksEachAtItsTime) {
  for (const double rest : {0.0, 0.02, 0.1, 20.0}) {
    SCOPED_TRACE(rest);
    const GroundMotion motion = joined({foreshock, shock, foreshock}, rest * s);
    const double second = foreshock.duration() + rest, third = second + shock.duration() + rest;
    EXPECT_NEAR(motion.duration(), third + foreshock.duration(), 1e-12);
    for (std::size_t i = 0; i < motion.samples().size(); ++i) {
      const double t = 0.02 * static_cast<double>(i), later = 1e-7;  // samples stand on either side of round-off
      const auto at = [&](const GroundMotion& each, double start) {
        const double inside = t - start;
        return std::abs(inside - each.duration()) < later
                   ? each.samples().back()
                   : each.acceleration_at(std::abs(inside) < later ? 0.0 : inside);
      };
      EXPECT_NEAR(motion.samples()[i], at(foreshock, 0.0) + at(shock, second) + at(foreshock, third), 1e-12) << t;
    }
  }
}

TEST(Joined, RestsForAWholeNumberOfIntervals) {
  const auto rest_of = [](Time rest) {
    return joined({foreshock, shock}, rest).duration() - foreshock.duration() - shock.duration();
  };
  EXPECT_NEAR(rest_of(20 * s), 20.0, 1e-9);
  EXPECT_NEAR(rest_of(31 * ms), 0.04, 1e-12);
  EXPECT_NEAR(rest_of(1 * ms), 0.02, 1e-12);
}

TEST(Joined, NamesEveryShockWithItsStart) {
  const GroundMotion motion = joined({foreshock.scaled_by(0.5), shock}, 1 * s);
  EXPECT_EQ(motion.name(), "foreshock, then shock");
  ASSERT_EQ(motion.notes().size(), 3u);
  EXPECT_TRUE(motion.notes()[0].starts_with("from 0 s on: foreshock: PGA ")) << motion.notes()[0];
  EXPECT_EQ(motion.notes()[1], "accelerations multiplied by 0.5");
  EXPECT_TRUE(motion.notes()[2].starts_with("from 1.06 s on: shock: PGA ")) << motion.notes()[2];
}

TEST(Joined, HoldsPairsEachWithItsIncidence) {
  const PlanMotion first{foreshock, shock, 30 * deg}, second{shock, foreshock, -90 * deg};
  const GroundMotion motion = joined({first, second}, 2 * s);
  ASSERT_TRUE(motion.has_two_components());
  const GroundMotion one = first.resolved(), other = second.resolved();
  EXPECT_NEAR(motion.duration(), one.duration() + 2.0 + other.duration(), 1e-12);
  const std::size_t start = motion.samples_y().size() - other.samples_y().size();
  for (std::size_t i = 0; i < one.samples().size(); ++i) {
    EXPECT_EQ(motion.samples()[i], one.samples()[i]);
    EXPECT_EQ(motion.samples_y()[i], one.samples_y()[i]);
    EXPECT_EQ(motion.samples()[start + i], other.samples()[i]);
    EXPECT_EQ(motion.samples_y()[start + i], other.samples_y()[i]);
  }
  EXPECT_EQ(motion.samples_y()[one.samples_y().size()], 0.0);
}

TEST(Joined, RefusesMotionsThatDoNotFit) {
  const GroundMotion fine{"fine", 0.01, {0.0, 1.0}};
  EXPECT_EQ(message_of([&] {
              (void)joined({foreshock, fine}, 1 * s);
            }),
            "joined \"fine\": time step = 0.01 s is not allowed; it must be that of the first motion, 0.02 s. Make a "
            "GroundMotion of samples at that interval; accelerations are linear between samples.");
  EXPECT_EQ(message_of([&] {
              (void)joined({foreshock, shock}, -1 * s);
            }),
            "joined: rest = -1 s is not allowed; it must be from 0 s to 1e+06 s. Give the time between two shocks.");
  EXPECT_NE(message_of([&] {
              (void)joined({foreshock, shock}, NAN * s);
            }).find("joined: rest = nan s"),
            std::string::npos);
  EXPECT_EQ(message_of([&] { (void)joined({}, 1 * s); }),
            "joined: there is no motion. Give the shocks in their order.");
  const GroundMotion pair = PlanMotion{foreshock, shock};
  EXPECT_EQ(message_of([&] {
              (void)joined({foreshock, pair}, 1 * s);
            }),
            "joined \"foreshock + shock\": some of the motions have two components and others one. Give a PlanMotion "
            "for each shock, or for none.");
}

}  // namespace
}  // namespace moat
