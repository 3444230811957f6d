#include <gtest/gtest.h>

#include "base/units.hpp"
#include "impact_cases.hpp"
#include "materials/bilinear.hpp"
#include "materials/contact/impact_laws.hpp"
#include "message_of.hpp"

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
                                                                      " and finite.");
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
            "Gap \"moat left\": damping_ratio = -0.1 is not allowed; it must be >= 0 and finite.");
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

TEST(BilinearCheck, NamesTheParameterItsRangeAndWhatToDo) {
  const auto with = [](Force force, Length displacement, Stiffness stiffness) {
    return message(
        Bilinear{.yield_force = force, .yield_displacement = displacement, .post_yield_stiffness = stiffness});
  };
  EXPECT_EQ(with(0 * N, 1 * cm, 1 * N / m),
            "Gap \"moat left\": yield_force = 0 N is not allowed; it must be > 0 N and finite.");
  EXPECT_EQ(with(1 * N, -1 * cm, 1 * N / m),
            "Gap \"moat left\": yield_displacement = -0.01 m is not allowed; it must be > 0 m and finite.");
  EXPECT_EQ(with(1 * N, 1 * cm, -1 * N / m),
            "Gap \"moat left\": post_yield_stiffness = -1 N/m is not allowed; it must be >= 0 N/m and finite.");
  EXPECT_EQ(with(1 * N, 1 * cm, 100 * N / m),
            "Gap \"moat left\": post_yield_stiffness = 100 N/m is not allowed; it must be below the initial stiffness "
            "yield_force / yield_displacement = 100 N/m. Check the exponents of the three parameters.");
}

}  // namespace
}  // namespace moat::testing
