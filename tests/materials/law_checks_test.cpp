#include <gtest/gtest.h>

#include "impact_cases.hpp"
#include "message_of.hpp"
#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

const Check check{"Gap", "moat left"};
const std::string restitution_range =
    " is not allowed; it must be > 0 and <= 1. "
    "It is the speed after the impact over the speed before; 1 is elastic.";
// Of laws that divide by it.
const std::string divisor_range =
    " is not allowed; it must be from 0.001 to 1. "
    "It is the speed after the impact over the speed before; 1 is elastic. The damping of this law grows without bound "
    "as it falls to zero, and no time step follows such a contact.";

template <class Law>
std::string message(const Law& law) {
  return message_of([&] { law.check(check); });
}

TEST(ImpactLawCheck, NamesTheStiffnessAndItsUnit) {
  AllImpactLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    const std::string unit = unit_symbol<StiffnessOf<Law>>();
    for (const double e : {1.0, 0.65, 0.42}) EXPECT_EQ(message(impact_law<Law>(1e9, e)), "nothing was thrown");
    for (const std::string wrong : {"-3", "0"})
      EXPECT_EQ(message(impact_law<Law>(std::stod(wrong), 0.65)), "Gap \"moat left\": stiffness = " + wrong + " " +
                                                                      unit + " is not allowed; it must be > 0 " + unit +
                                                                      " and finite. Check its sign and its unit.");
  });
}

TEST(ImpactLawCheck, NamesTheRestitutionItsRangeAndWhatToDo) {
  AllImpactLaws::for_each([]<class Law>() {
    if constexpr (requires(Law law) { law.restitution; }) {
      SCOPED_TRACE(Law::name);
      const auto refusal = [](double e) { return message(impact_law<Law>(1e9, e)); };
      const bool divides = refusal(0.0009) != "nothing was thrown";
      const std::string range = divides ? divisor_range : restitution_range;
      EXPECT_EQ(refusal(0.0), "Gap \"moat left\": restitution = 0" + range);
      EXPECT_EQ(refusal(1.1), "Gap \"moat left\": restitution = 1.1" + range);
      EXPECT_EQ(refusal(0.001), "nothing was thrown");
      if (divides) {
        EXPECT_EQ(refusal(0.0009), "Gap \"moat left\": restitution = 0.0009" + range);
      }
    }
  });
}

TEST(ImpactLawCheck, RefusesSmallRestitutionsWhereTheDampingGrowsAsTheirInverse) {
  AllImpactLaws::for_each([]<class Law>() {
    if constexpr (requires(Law law) { law.restitution; }) {
      SCOPED_TRACE(Law::name);
      const auto first_force = [](double e) {
        ContactState trial;
        return impact_law<Law>(1e9, e).between(1e3).evaluate({ContactPhase::loaded, 0.3}, 1e-3, 0.3, trial).force;
      };
      const bool grows = first_force(1e-6) > 100.0 * first_force(1e-3);
      EXPECT_EQ(message(impact_law<Law>(1e9, 1e-6)) != "nothing was thrown", grows);
    }
  });
}

TEST(ImpactLawCheck, RefusesAContactThatWouldNeverEnd) {
  EXPECT_EQ(message(KelvinByDampingRatio{.stiffness = 1e9 * N / m, .damping_ratio = -0.1}),
            "Gap \"moat left\": damping_ratio = -0.1 is not allowed; it must be >= 0 and finite. Give a number in this "
            "range.");
  EXPECT_EQ(message(KelvinByDampingRatio{.stiffness = 1e9 * N / m, .damping_ratio = 2.0}), "nothing was thrown");
  EXPECT_EQ(message(KelvinByDampingRatio{.stiffness = 1e9 * N / m, .damping_ratio = 1.0, .may_pull = true}),
            "Gap \"moat left\": damping_ratio = 1 is not allowed; it must be < 1 where may_pull is true. "
            "A contact that pulls and is damped critically never ends.");
  EXPECT_EQ(message(ModifiedHertzDampPrinted{
                .stiffness = 1e9 * N / m_3_2, .restitution = 0.4, .approach_only = false, .may_pull = true}),
            "Gap \"moat left\": restitution = 0.4 is not allowed; it must be >= 0.409 where the contact may pull. "
            "A contact that pulls and is damped critically never ends.");
}

TEST(ImpactLawCheck, RefusesToPullWithADashpotThatNeverPulls) {
  EXPECT_EQ(message(ModifiedHertzDampPrinted{.stiffness = 1e9 * N / m_3_2, .restitution = 0.6, .may_pull = true}),
            "Gap \"moat left\": may_pull = 1 is not allowed; it must be false where "
            "approach_only is true. A dashpot that acts on approach only never pulls.");
}

// The message for a law of which something was changed, without the name of its element.
template <class Law, class Change>
std::string refusal(Law law, Change change) {
  change(law);
  return message(law).substr(std::string{"Gap \"moat left\": "}.size());
}

TEST(SpringLawCheck, NamesTheParameterItsRangeAndWhatToDo) {
  const Bilinear bilinear{.yield_force = 1 * N, .yield_displacement = 1 * cm, .post_yield_stiffness = 1 * N / m};
  const BilinearImpact yielding{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65, .expected_indentation = 2 * cm};
  struct Row {
    std::string found, expected;
  };
  const std::vector<Row> rows{
      {refusal(bilinear, [](auto& law) { law.yield_force = 0 * N; }),
       "yield_force = 0 N is not allowed; it must be > 0 N and finite. Check its sign and its unit."},
      {refusal(bilinear, [](auto& law) { law.yield_displacement = -1 * cm; }),
       "yield_displacement = -0.01 m is not allowed; it must be > 0 m and finite. Check its sign and its unit."},
      {refusal(bilinear, [](auto& law) { law.post_yield_stiffness = -1 * N / m; }),
       "post_yield_stiffness = -1 N/m is not allowed; it must be >= 0 N/m and finite. Check its sign and its unit."},
      {refusal(bilinear, [](auto& law) { law.post_yield_stiffness = 100 * N / m; }),
       "post_yield_stiffness = 100 N/m is not allowed; it must be below the initial stiffness yield_force / "
       "yield_displacement = 100 N/m. Check the exponents of the three parameters."},
      {refusal(yielding, [](auto& law) { law.yield_share = 0.6; }),
       "yield_share = 0.6 is not allowed; it must be > 0 and <= 0.5. 0.1 is usual."},
      {refusal(yielding, [](auto& law) { law.expected_indentation = 0 * m; }),
       "expected_indentation = 0 m is not allowed; it must be > 0 m and finite. Check its sign and its unit."},
      {refusal(BoucWen::typical(), [](auto& law) { law.beta = 0.4; }),
       "beta = 0.4 is not allowed; it must be from 0.5 to 10. Below 1/2 small cycles would gain energy."},
      {refusal(BoucWen::typical(), [](auto& law) { law.exponent = 0.5; }),
       "exponent = 0.5 is not allowed; it must be from 1 to 50. 1 to 2 is usual; 50 is nearly bilinear."},
      {refusal(BoucWen::typical(), [](auto& law) { law.post_yield_stiffness = 1 * GN / m; }),
       "post_yield_stiffness = 1e+09 N/m is not allowed; it must be below the initial stiffness yield_force / "
       "yield_displacement = 1.93e+08 N/m. Check the exponents of the three parameters."},
      {refusal(FrictionPendulum::typical(), [](auto& law) { law.radius = -1 * m; }),
       "radius = -1 m is not allowed; it must be > 0 m and finite. Check its sign and its unit."},
      {refusal(FrictionPendulum::typical(), [](auto& law) { law.friction = 0.4; }),
       "friction.coefficient = 0.4 is not allowed; it must be > 0 and <= 0.3. Give a number in this range."},
      {refusal(FrictionPendulum::typical(),
               [](auto& law) { law.friction = VelocityDependent{.slow = 0.08, .fast = 0.06, .rate = 50 * s / m}; }),
       "friction.slow = 0.08 is not allowed; it must be > 0 and <= 0.06. Friction at rest is at most that at high "
       "speed."},
      {refusal(BiaxialFrictionPendulum{FrictionPendulum::typical()}, [](auto& law) { law.pendulum.weight = Force{}; }),
       "weight = 0 N is not allowed; it must be > 0 N and finite. Give the weight on this bearing; a PlanBuilding "
       "knows "
       "its share."},
      {refusal(TriplePendulum::typical(), [](auto& law) { law.inner_friction = 0.05; }),
       "inner_friction = 0.05 is not allowed; it must be > 0 and below lower_friction = 0.04. Three sliders in series "
       "need friction that rises from inside to outside."},
      {refusal(TriplePendulum::typical(), [](auto& law) { law.lower_capacity = 0.1 * m; }),
       "lower_capacity = 0.1 m is not allowed; it must be >= (upper_friction - lower_friction) lower_radius = 0.14986 "
       "m. Else the lower surface reaches its stop before the upper one slides, which this model does not cover."},
      {refusal(TriplePendulum::typical(), [](auto& law) { law.inner_capacity = 0.02 * m; }),
       "inner_capacity = 0.02 m is not allowed; it must be >= (upper_friction - inner_friction) inner_radius = "
       "0.027559 "
       "m. Else an inner surface reaches its stop before the upper one slides, which this model does not cover."},
      {refusal(GrantRubber::typical(), [](auto& law) { law.a2 = -1e8 * N / (m * m * m); }),
       "a2 = -1e+08 N/m^3 is not allowed; it must be so that a1 + 3 a2 d^2 + 5 a3 d^4 >= 0 at every d. The elastic "
       "force must grow with d."},
      {refusal(MaxwellDamper::typical(), [](auto& law) { law.exponent = 1.2; }),
       "exponent = 1.2 is not allowed; it must be from 0.1 to 1. Fluid dampers have 0.15 to 1."},
      {refusal(ImkBilinear::typical(), [](auto& law) { law.ultimate_drift = 5 * mm; }),
       "ultimate_drift = 0.005 m is not allowed; it must be above the yield drift yield_force / stiffness = 0.01 m. "
       "Check its sign and its unit."},
      {refusal(HyperbolicBackfill{.initial_stiffness = 20.3 * MN / m, .ultimate_force = 326 * kN},
               [](auto& law) { law.unloading_stiffness = 10 * MN / m; }),
       "unloading_stiffness = 1e+07 N/m is not allowed; it must be >= initial_stiffness = 2.03e+07 N/m. A softer line "
       "would give back more energy than went in."}};
  for (const auto& [found, expected] : rows) EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace moat::testing
