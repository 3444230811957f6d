#include <gtest/gtest.h>

#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;
using Parameters = std::vector<Parameter>;

TEST(LawParameters, AreThoseOfTheLawWithTheirUnits) {
  const Bilinear bearing{.yield_force = 2 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 20 * MN / m};
  const Parameters expected{
      {"yield_force", 2e6, "N"}, {"yield_displacement", 0.01, "m"}, {"post_yield_stiffness", 2e7, "N/m"}};
  EXPECT_EQ(parameters_of(bearing), expected);
  EXPECT_EQ(name_of(bearing), "Bilinear");
  EXPECT_EQ(parameters_of(Linear{.stiffness = 1 * MN / m}),
            (Parameters{{"stiffness", 1e6, "N/m"}, {"damping", 0.0, "N s/m"}}));
  EXPECT_EQ(parameters_of(Viscous{.damping = 5 * N * s / m}), (Parameters{{"damping", 5.0, "N s/m"}}));
}

TEST(LawParameters, OfAnImpactLawAreThoseGivenAndBetweenBodiesThoseThatAct) {
  const HertzDamp law{.stiffness = 2e9 * N / m_3_2, .restitution = 0.6};
  EXPECT_EQ(name_of(law), "HertzDamp");
  EXPECT_EQ(parameters_of(law),
            (Parameters{{"stiffness", 2e9, "N/m^1.5"}, {"restitution", 0.6, "1"}, {"may_pull", 0.0, "1"}}));
  EXPECT_EQ(parameters_of(law.between(1e5)), (Parameters{{"stiffness", 2e9, "N/m^1.5"},
                                                         {"damping_factor", 0.75 * (1.0 - 0.6 * 0.6), "1"},
                                                         {"may_pull", 0.0, "1"}}));
  const AnyContact any{law.between(1e5)};
  EXPECT_EQ(name_of(any), name_of(law.between(1e5)));
  EXPECT_EQ(parameters_of(any), parameters_of(law.between(1e5)));
}

TEST(LawParameters, AreNoneForALawThatDoesNotSay) {
  struct Silent {};
  EXPECT_EQ(name_of(Silent{}), "Silent");
  EXPECT_TRUE(parameters_of(Silent{}).empty());
}

}  // namespace
}  // namespace moat::testing
