// Random models: the same for a seed, sensible, and of all kinds.

#include "random_model.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace moat::testing {
namespace {

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
      kinds.insert(spring.kind == PlainSpring::Kind::wall    ? "flexible wall"
                   : spring.kind == PlainSpring::Kind::frame ? "frame that bends"
                                                             : "storey");
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
       {"cut motion", "bearing", "yielding storey", "flexible wall", "frame that bends", "building A", "building B",
        "building C", "nine nodes", "light body", "pulls", "rigid wall", "mid-column", "node to node"})
    EXPECT_TRUE(kinds.contains(kind)) << kind;
}

}  // namespace
}  // namespace moat::testing
