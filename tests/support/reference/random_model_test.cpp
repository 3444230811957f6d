// Random models: the same for a seed, sensible, and of all kinds.

#include "random_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace moat::testing {
namespace {

TEST(RandomModel, TheSameSeedGivesTheSameModel) {
  const PlainModel one = random_model(7), other = random_model(7), next = random_model(8);
  EXPECT_EQ(one.motion.samples, other.motion.samples);
  ASSERT_EQ(one.gaps.size(), other.gaps.size());
  for (std::size_t i = 0; i < one.gaps.size(); ++i) EXPECT_EQ(one.gaps[i].clearance, other.gaps[i].clearance);
  EXPECT_NE(one.motion.samples, next.motion.samples);
}

TEST(RandomModel, EveryModelIsWithinItsRanges) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const PlainModel model = random_model(seed);
    std::set<std::string> names;
    for (const PlainNode& node : model.nodes) {
      EXPECT_GE(node.mass, 100.0);
      EXPECT_LE(node.mass, 1e6);
      EXPECT_TRUE(names.insert(node.name).second) << node.name;
    }
    for (const PlainGap& gap : model.gaps) {
      EXPECT_GE(gap.clearance, 1e-3);
      EXPECT_GT(gap.law.stiffness, 0.0);
      EXPECT_TRUE(gap.left.node != plain_ground || gap.right.node != plain_ground);
    }
    for (const PlainBearing& bearing : model.bearings)
      EXPECT_LT(bearing.post_yield_stiffness, bearing.yield_force / bearing.yield_displacement);
    const double steps = model.end / model.motion.time_step;
    EXPECT_NEAR(steps, std::round(steps), 1e-9 * steps);
    EXPECT_GE(std::round(steps), static_cast<double>(model.motion.samples.size() - 1));
    EXPECT_LE(model.end, 22.0);
    double largest = 0.0;
    for (const double sample : model.motion.samples) largest = std::max(largest, std::abs(sample));
    EXPECT_GE(largest, 0.098);
    EXPECT_LE(largest, 8.0);
  }
}

TEST(RandomModel, AHundredModelsHaveEveryKind) {
  std::set<PlainLawKind> laws;
  std::set<double> time_steps;
  std::set<std::string> kinds;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const PlainModel model = random_model(seed);
    time_steps.insert(model.motion.time_step);
    if (model.motion.samples.back() != 0.0) kinds.insert("cut motion");
    for (const PlainBearing& bearing : model.bearings)
      kinds.insert(bearing.kind == PlainBearing::Kind::storey ? "yielding storey" : "bearing");
    for (const PlainSpring& spring : model.springs)
      if (spring.kind == PlainSpring::Kind::wall) kinds.insert("flexible wall");
    for (const PlainNode& node : model.nodes) {
      kinds.insert("building " + node.name.substr(0, 1));
      if (node.name.find("floor 9") != std::string::npos) kinds.insert("nine nodes");
      if (node.mass < 300.0) kinds.insert("light body");
    }
    for (const PlainGap& gap : model.gaps) {
      laws.insert(gap.law.kind);
      if (gap.law.acts == PlainDamping::may_pull) kinds.insert("pulls");
      const bool wall = gap.left.node == plain_ground || gap.right.node == plain_ground;
      kinds.insert(wall ? "rigid wall" : gap.left.share > 0.0 || gap.right.share > 0.0 ? "mid-column" : "node to node");
    }
  }
  EXPECT_EQ(laws.size(), static_cast<std::size_t>(plain_law_kinds));
  EXPECT_EQ(time_steps, (std::set<double>{0.005, 0.01, 0.02}));
  for (const char* kind :
       {"cut motion", "bearing", "yielding storey", "flexible wall", "building A", "building B", "building C",
        "nine nodes", "light body", "pulls", "rigid wall", "mid-column", "node to node"})
    EXPECT_TRUE(kinds.contains(kind)) << kind;
}

}  // namespace
}  // namespace moat::testing
