// Restitution that is constant, falls with the approach speed, or follows a table.
#include "materials/contact/restitution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "materials/contact/contact_estimates.hpp"
#include "materials/contact/free_impact.hpp"
#include "materials/impact/bilinear_impact.hpp"
#include "materials/impact/exact_hertz_damp.hpp"
#include "materials/impact/exact_kelvin.hpp"
#include "materials/impact/modified_hertz_damp_printed.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

const MeasuredRestitution measured{{{0.1 * m / s, 0.8}, {1 * m / s, 0.5}, {2 * m / s, 0.4}}};

TEST(Restitution, FallsWithTheFourthRootOfTheSpeedBelowItsCap) {
  const Restitution concrete = FallingRestitution{};
  EXPECT_FALSE(concrete.is_constant());
  for (const auto& [speed, expected] : {std::pair{0.05, 0.9}, std::pair{0.1, 0.8554}, std::pair{0.3, 0.65},
                                        std::pair{1.0, 0.4811}, std::pair{2.0, 0.4045}})
    EXPECT_NEAR(concrete.at(speed), expected, 5e-5) << speed;
  // The cap: 0.3 m/s (0.65/0.9)^4.
  EXPECT_NEAR(concrete.at(0.0816 * 1.001), 0.9, 1e-3);
  EXPECT_LT(concrete.at(0.083), 0.9);
  EXPECT_EQ(concrete.at(0.081), 0.9);
  EXPECT_EQ(concrete.at(0.0), 0.9);
  const Restitution steel = FallingRestitution{.restitution = 0.5, .at_speed = 1 * m / s, .largest = 0.8};
  EXPECT_NEAR(steel.at(16.0), 0.25, 1e-15);
}

TEST(Restitution, FollowsATableBetweenItsEnds) {
  const Restitution table = measured;
  for (const auto& [speed, expected] :
       {std::pair{0.0, 0.8}, std::pair{0.1, 0.8}, std::pair{0.55, 0.65}, std::pair{1.0, 0.5}, std::pair{1.25, 0.475},
        std::pair{2.0, 0.4}, std::pair{9.0, 0.4}})
    EXPECT_NEAR(table.at(speed), expected, 1e-15) << speed;
  const Restitution single = MeasuredRestitution{{{1 * m / s, 0.6}}};
  EXPECT_EQ(single.at(0.3), 0.6);
}

TEST(Restitution, IsAConstantOfANumberAndOfAnEstimate) {
  EXPECT_TRUE(Restitution{1}.is_constant());
  EXPECT_EQ(Restitution{0.65}.at(3.0), 0.65);
  const ExactHertzDamp law{.stiffness = contact_stiffness_of_slab_edge({.mass = 550 * tonne}),
                           .restitution = restitution_of(Faces::concrete)};
  EXPECT_EQ(law.restitution.value().at(3.0), 0.65);
  EXPECT_NEAR(law.stiffness.si(), 4.031634082e10 / 4.0, 1.0);
  for (const Faces faces : {Faces::concrete, Faces::steel, Faces::crushed_corner}) {
    const Estimate<double> estimate = restitution_of(faces);
    EXPECT_LE(estimate.low, estimate.value);
    EXPECT_LE(estimate.value, estimate.high);
    EXPECT_FALSE(estimate.source.empty());
  }
}

TEST(Restitution, TypicalLawIsTheDefendedDefault) {
  EXPECT_EQ(ExactHertzDamp::typical().stiffness.si(), 1e10);
  EXPECT_EQ(ExactHertzDamp::typical().restitution.value().at(1.0), 0.65);
}

TEST(Restitution, IsDeliveredAtEverySpeed) {
  constexpr double mass = 5.5e5;
  for (const Restitution& restitution : {Restitution{FallingRestitution{}}, Restitution{measured}}) {
    const ExactHertzDamp hertz{.stiffness = 1e10 * N / m_3_2, .restitution = restitution};
    const ExactKelvin kelvin{.stiffness = 1e9 * N / m, .restitution = restitution},
        pulling{.stiffness = 1e9 * N / m, .restitution = restitution, .may_pull = true};
    for (const double speed : {0.01, 0.05, 0.1, 0.3, 1.0, 2.0, 5.0}) {
      EXPECT_NEAR(delivered_restitution(hertz.between(mass), mass, speed), restitution.at(speed), 1e-8) << speed;
      EXPECT_NEAR(delivered_restitution(kelvin.between(mass), mass, speed), restitution.at(speed), 1e-8) << speed;
      EXPECT_NEAR(delivered_restitution(pulling.between(mass), mass, speed), restitution.at(speed), 1e-8) << speed;
    }
  }
}

// The same bits as a constant, where the speed gives this constant.
TEST(Restitution, OfAConstantChangesNoBit) {
  const MeasuredRestitution level{{{0.1 * m / s, 0.65}, {1 * m / s, 0.65}}};
  const auto expect_same = [](const auto& constant, const auto& table) {
    const ContactState of_constant = constant.next_regime({}, 0.0, 0.3), of_table = table.next_regime({}, 0.0, 0.3);
    ContactState trial;
    for (const double rate : {-0.2, 0.25}) {
      const Response one = constant.evaluate(of_constant, 0.01, rate, trial),
                     other = table.evaluate(of_table, 0.01, rate, trial);
      EXPECT_EQ(one.force, other.force);
      EXPECT_EQ(one.stiffness, other.stiffness);
      EXPECT_EQ(one.damping, other.damping);
    }
    EXPECT_EQ(constant.contact_duration(5.5e5, 0.3), table.contact_duration(5.5e5, 0.3));
  };
  expect_same(ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65}.between(5.5e5),
              ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = level}.between(5.5e5));
  expect_same(ExactKelvin{.stiffness = 1e9 * N / m, .restitution = 0.65}.between(5.5e5),
              ExactKelvin{.stiffness = 1e9 * N / m, .restitution = level}.between(5.5e5));
  expect_same(ModifiedHertzDampPrinted{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65}.between(5.5e5),
              ModifiedHertzDampPrinted{.stiffness = 1e10 * N / m_3_2, .restitution = level}.between(5.5e5));
}

TEST(Restitution, OfABilinearTrussKeepsItsEffectiveStiffness) {
  BilinearImpact law{
      .stiffness = 2.95e9 * N / m_3_2, .restitution = FallingRestitution{}, .expected_indentation = 2 * cm};
  const BilinearContact falling = law.between(1e5);
  for (const double speed : {0.1, 0.3, 2.0}) {
    law.restitution = Restitution{FallingRestitution{}}.at(speed);
    const BilinearContact constant = law.between(1e5);
    ContactState trial;
    const ContactState one = falling.next_regime({}, 0.0, speed), other = constant.next_regime({}, 0.0, speed);
    EXPECT_NEAR(falling.evaluate(one, 1e-3, 0.1, trial).force / constant.evaluate(other, 1e-3, 0.1, trial).force, 1.0,
                1e-12);
    EXPECT_NEAR(falling.contact_duration(1e5, speed) / constant.contact_duration(1e5, speed), 1.0, 1e-12);
  }
}

TEST(Restitution, IsListedAsItWasGiven) {
  const auto parameters = [](const Restitution& restitution) {
    return ExactKelvin{.stiffness = 1 * GN / m, .restitution = restitution}.parameters();
  };
  using Parameters = std::vector<Parameter>;
  EXPECT_EQ(parameters(0.65),
            (Parameters{{"stiffness", 1e9, "N/m"}, {"restitution", 0.65, "1"}, {"may_pull", 0.0, "1"}}));
  EXPECT_EQ(parameters(FallingRestitution{}), (Parameters{{"stiffness", 1e9, "N/m"},
                                                          {"falling_restitution", 0.65, "1"},
                                                          {"at_speed", 0.3, "m/s"},
                                                          {"largest_restitution", 0.9, "1"},
                                                          {"may_pull", 0.0, "1"}}));
  EXPECT_EQ(parameters(measured), (Parameters{{"stiffness", 1e9, "N/m"},
                                              {"largest_restitution", 0.8, "1"},
                                              {"smallest_restitution", 0.4, "1"},
                                              {"restitution_points", 3.0, "1"},
                                              {"may_pull", 0.0, "1"}}));
}

TEST(Restitution, RefusesBadInputByName) {
  const auto message = [](const Restitution& restitution) {
    return message_of([&] {
      ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = restitution}.check(Check{"Gap", "west"});
    });
  };
  EXPECT_EQ(message(FallingRestitution{}), "nothing was thrown");
  EXPECT_EQ(message(measured), "nothing was thrown");
  EXPECT_EQ(message(FallingRestitution{.restitution = 0.005}),
            "Gap \"west\": restitution = 0.005 is not allowed; it must be from 0.01 to 1. It is that at at_speed.");
  EXPECT_EQ(
      message(FallingRestitution{.at_speed = 0 * m / s}),
      "Gap \"west\": at_speed = 0 m/s is not allowed; it must be > 0 m/s and finite. Check its sign and its unit.");
  for (const double largest : {0.5, 1.1})
    EXPECT_EQ(message(FallingRestitution{.largest = largest}),
              "Gap \"west\": largest = " + to_text(largest) +
                  " is not allowed; it must be from 0.65 to 1. It is that of slow impacts.");
  EXPECT_EQ(message(MeasuredRestitution{}),
            "Gap \"west\": restitution has no points. Give speeds and restitutions of tests.");
  EXPECT_EQ(
      message(MeasuredRestitution{{{1 * m / s, 1.5}}}),
      "Gap \"west\": points[0].restitution = 1.5 is not allowed; it must be from 0.001 to 1. It is the speed after "
      "the impact over the speed before; 1 is elastic. The damping of this law grows without bound as it falls to "
      "zero, and no time step follows such a contact.");
  EXPECT_EQ(message(MeasuredRestitution{{{0 * m / s, 0.5}}}),
            "Gap \"west\": points[0].speed = 0 m/s is not allowed; it must be > 0 m/s and finite. Check its sign and "
            "its unit.");
  EXPECT_EQ(message(MeasuredRestitution{{{1 * m / s, 0.5}, {1 * m / s, 0.4}}}),
            "Gap \"west\": points[1].speed = 1 m/s is not allowed; it must be > 1 m/s, the speed before it. Check its "
            "sign and its unit.");
  EXPECT_EQ(message(MeasuredRestitution{{{1 * m / s, 0.5}, {2 * m / s, 0.6}}}),
            "Gap \"west\": points[1].restitution = 0.6 is not allowed; it must be <= 0.5, the restitution before it. "
            "Restitution does not grow with the speed; take a mean of tests that scatter.");
  EXPECT_EQ(message(std::numeric_limits<double>::quiet_NaN()).find("Gap \"west\": restitution = "), 0U);
  EXPECT_EQ(
      message_of([] {
        ModifiedHertzDampPrinted{.stiffness = 1e10 * N / m_3_2,
                                 .restitution = FallingRestitution{},
                                 .approach_only = false,
                                 .may_pull = true}
            .check(Check{"Gap", "west"});
      }),
      "Gap \"west\": restitution = 0 is not allowed; it must be >= 0.409 where the contact may pull. A contact that "
      "pulls and is damped critically never ends.");
}

}  // namespace
}  // namespace moat::testing
