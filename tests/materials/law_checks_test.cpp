#include <gtest/gtest.h>

#include "base/units.hpp"
#include "materials/bilinear.hpp"
#include "materials/impact_laws.hpp"
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

template <class Law, class Unit>
void expect_checked(Unit unit, const std::string& symbol, const std::string& range = restitution_range) {
  EXPECT_EQ(message(Law{1e9 * unit, 1.0}), "nothing was thrown");
  EXPECT_EQ(message(Law{1e9 * unit, 0.42}), "nothing was thrown");
  EXPECT_EQ(message(Law{-3.0 * unit, 0.65}), "Gap \"moat left\": stiffness = -3 " + symbol +
                                                 " is not allowed; it must be > 0 " + symbol + " and finite.");
  EXPECT_EQ(message(Law{1e9 * unit, 0.0}), "Gap \"moat left\": restitution = 0" + range);
  EXPECT_EQ(message(Law{1e9 * unit, 1.1}), "Gap \"moat left\": restitution = 1.1" + range);
  EXPECT_EQ(message(Law{1e9 * unit, 0.001}), "nothing was thrown");
  EXPECT_EQ(message(Law{1e9 * unit, 0.0009}),
            range == divisor_range ? "Gap \"moat left\": restitution = 0.0009" + range : "nothing was thrown");
}

TEST(ImpactLawCheck, NamesTheParameterItsRangeAndWhatToDo) {
  const Stiffness linear = 1 * N / m;
  const HertzStiffness hertz = 1 * N / m_3_2;
  expect_checked<Kelvin>(linear, "N/m");
  expect_checked<Anagnostopoulos>(linear, "N/m");
  expect_checked<ExactKelvin>(linear, "N/m");
  expect_checked<ModifiedLinearViscoelastic>(linear, "N/m", divisor_range);
  expect_checked<HertzDamp>(hertz, "N/m^1.5");
  expect_checked<LankaraniNikravesh>(hertz, "N/m^1.5");
  expect_checked<HuntCrossley>(hertz, "N/m^1.5");
  expect_checked<Ye2009>(hertz, "N/m^1.5", divisor_range);
  expect_checked<HuGuo>(hertz, "N/m^1.5", divisor_range);
  expect_checked<Gonthier>(hertz, "N/m^1.5", divisor_range);
  expect_checked<ModifiedHertzDamp>(hertz, "N/m^1.5", divisor_range);
  expect_checked<ModifiedHertzDampPrinted>(hertz, "N/m^1.5", divisor_range);
  expect_checked<NonlinearViscoelastic>(hertz, "N/m^1.5", divisor_range);
  expect_checked<ExactHertzDamp>(hertz, "N/m^1.5", divisor_range);
  EXPECT_EQ(message(Hertz{0 * hertz}),
            "Gap \"moat left\": stiffness = 0 N/m^1.5 is not allowed; it must be > 0 N/m^1.5 and finite.");
  EXPECT_EQ(message(LinearElastic{0 * linear}),
            "Gap \"moat left\": stiffness = 0 N/m is not allowed; it must be > 0 N/m and finite.");
}

TEST(ImpactLawCheck, RefusesAContactThatWouldNeverEnd) {
  EXPECT_EQ(message(KelvinByDampingRatio{.stiffness = 1e9 * N / m, .damping_ratio = -0.1}),
            "Gap \"moat left\": damping_ratio = -0.1 is not allowed; it must be >= 0 and finite.");
  EXPECT_EQ(message(KelvinByDampingRatio{.stiffness = 1e9 * N / m, .damping_ratio = 2.0}), "nothing was thrown");
  EXPECT_EQ(message(KelvinByDampingRatio{.stiffness = 1e9 * N / m, .damping_ratio = 1.0, .may_pull = true}),
            "Gap \"moat left\": damping_ratio = 1 is not allowed; it must be < 1 where may_pull is true. "
            "A contact that pulls and is damped critically never ends.");
  EXPECT_EQ(message(ModifiedHertzDampPrinted{
                .stiffness = 1e9 * N / m_3_2, .restitution = 0.4, .acts = ContactDamping::may_pull}),
            "Gap \"moat left\": restitution = 0.4 is not allowed; it must be >= 0.409 where the contact may pull. "
            "A contact that pulls and is damped critically never ends.");
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
