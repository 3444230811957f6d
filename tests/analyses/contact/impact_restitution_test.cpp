// Free impacts of two bodies through the whole analysis: the computed restitution is that of the law.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analyses/case/case_run.hpp"
#include "analysis_testing.hpp"
#include "collision.hpp"
#include "elements/contact/gap.hpp"
#include "impact_cases.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

const std::vector<double> restitutions{0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.65, 0.8, 0.9, 0.97, 1.0};
const std::vector<Collision> collisions{
    {5.5e5, 5.5e5, 0.5}, {5.5e5, 1e2, 1e-3}, {1.0, 3e6, 5.0}, {3.05e6, 5.5e5, 0.1}, {1e-2, 1e-2, 1.0}};
// Eight decades, N/m and N/m^1.5.
const std::vector<double> stiffnesses{1e4, 1e6, 1e8, 1e10, 1e12};

template <class Check>
void for_every_case(Check check) {
  for (const double restitution : restitutions)
    for (const Collision& collision : collisions)
      for (const double stiffness : stiffnesses) {
        SCOPED_TRACE("e " + std::to_string(restitution) + ", masses " + std::to_string(collision.left_mass) + " and " +
                     std::to_string(collision.right_mass) + ", v0 " + std::to_string(collision.approach_speed) +
                     ", k " + std::to_string(stiffness));
        check(restitution, collision, stiffness);
      }
}

TEST(ImpactRestitution, ExactLawsDeliverWhatIsAskedWithDefaults) {
  for_every_case([](double restitution, const Collision& collision, double stiffness) {
    const ExactHertzDamp hertz{.stiffness = stiffness * N / m_3_2, .restitution = restitution};
    EXPECT_NEAR(delivered(hertz, collision), restitution, 1e-3);
    const ExactKelvin kelvin{.stiffness = stiffness * N / m, .restitution = restitution};
    EXPECT_NEAR(delivered(kelvin, collision), restitution, 1e-3);
    const ExactKelvin pulling{.stiffness = stiffness * N / m, .restitution = restitution, .may_pull = true};
    EXPECT_NEAR(delivered(pulling, collision), restitution, 1e-3);
  });
}

TEST(ImpactRestitution, ExactLawsDeliverToAMillionthWithTightSettings) {
  const TransientOptions tight{.tolerance = 1e-8, .steps_per_contact = 2048};
  for (const double restitution : {0.02, 0.1, 0.3, 0.65, 0.9, 1.0})
    for (const Collision& collision : {Collision{5.5e5, 3e6, 1e-3}, Collision{1e2, 5.5e5, 5.0}}) {
      SCOPED_TRACE("e " + std::to_string(restitution) + ", v0 " + std::to_string(collision.approach_speed));
      const ExactHertzDamp hertz{.stiffness = 2.95e9 * N / m_3_2, .restitution = restitution};
      EXPECT_NEAR(delivered(hertz, collision, tight), restitution, 1e-6);
      const ExactKelvin kelvin{.stiffness = 5.8e8 * N / m, .restitution = restitution};
      EXPECT_NEAR(delivered(kelvin, collision, tight), restitution, 1e-6);
    }
}

TEST(ImpactRestitution, FallsWithTheApproachSpeed) {
  const TransientOptions tight{.tolerance = 1e-8, .steps_per_contact = 2048};
  const FallingRestitution falling{.restitution = 0.65, .at_speed = 0.3 * m / s, .largest = 0.9};
  // min(0.9, 0.65 (v/0.3)^(-1/4))
  for (const auto& [speed, expected] : {std::pair{0.05, 0.9}, std::pair{0.3, 0.65}, std::pair{4.8, 0.325}}) {
    SCOPED_TRACE(speed);
    const Collision collision{5.5e5, 3e6, speed};
    const ExactHertzDamp hertz{.stiffness = 1e10 * N / m_3_2, .restitution = falling};
    EXPECT_NEAR(delivered(hertz, collision, tight), expected, 1e-6);
    const ExactKelvin kelvin{.stiffness = 1e9 * N / m, .restitution = falling};
    EXPECT_NEAR(delivered(kelvin, collision, tight), expected, 1e-6);
  }
}

TEST(ImpactRestitution, OfAGapThatIsClosedAtTheStartIsThatOfAnImpactOfItsDepth) {
  const auto speed_after = [](const Restitution& restitution) {
    Model model;
    const NodeId body =
        add(model, Node{.name = "body", .mass = 550 * tonne, .initial_displacement = 2 * cm, .free = true});
    add(model, Gap<ExactHertzDamp>{.name = "gap",
                                   .left = body,
                                   .right = ground,
                                   .clearance = 1 * cm,
                                   .law = {.stiffness = 1e10 * N / m_3_2, .restitution = restitution}});
    return run_to_end(model, still_ground(1 * s, 5 * ms)).state.velocity(body);
  };
  // An elastic impact of m v^2/2 = 0.4 k d^2.5 reaches the depth of 1 cm.
  const double speed = std::sqrt(0.8 * 1e10 * std::pow(0.01, 2.5) / 550e3);
  EXPECT_NEAR(speed_after(FallingRestitution{}), speed_after(0.65 * std::pow(speed / 0.3, -0.25)), 1e-9);
  EXPECT_LT(speed_after(FallingRestitution{}), 0.0);
}

TEST(ImpactRestitution, EveryLawDeliversItsClosedForm) {
  AllImpactLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    for (const double e : {0.4, 0.65, 0.8}) {
      SCOPED_TRACE(e);
      const Law law = impact_law<Law>(2.95e9, e);
      for (const Collision& collision : collisions)
        EXPECT_NEAR(delivered(law, collision), delivered_by(law, collision.effective_mass(), collision.approach_speed),
                    1e-3);
    }
  });
}

TEST(ImpactRestitution, DoesNotDependOnThePhaseOfArrival) {
  const ExactHertzDamp law{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65};
  double least = 1.0, most = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double e = delivered(law, {5.5e5, 5.5e5, 0.5, 0.01 * i});
    least = std::min(least, e);
    most = std::max(most, e);
  }
  EXPECT_LT(most - least, 1e-3);
  EXPECT_NEAR(0.5 * (least + most), 0.65, 1e-3);
}

// The first step after the touch ends on the sample, and may be as short as one likes. The jerk behind it is that of
// the touch, where some laws rise with an infinite slope.
TEST(ImpactRestitution, IsThatOfTheLawHoweverShortlyBeforeASampleItTouches) {
  AllImpactLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    const Law law = impact_law<Law>(2.95e9, 0.65);
    for (double before = 1e-2; before > 1e-12; before *= 0.1) {
      const Collision collision{5.5e5, 5.5e5, 0.5, 1.0 - before};
      EXPECT_NEAR(delivered(law, collision), delivered_by(law, collision.effective_mass(), 0.5), 1e-4) << before;
    }
  });
}

}  // namespace
}  // namespace moat
