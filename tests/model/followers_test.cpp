// Nodes and diaphragms that follow degrees of freedom of other bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "message_of.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

struct Pair {
  Model model;
  NodeId a = add(model, Node{.name = "a", .mass = 1e3 * kg, .initial_displacement = 1 * cm}),
         b = add(model, Node{.name = "b", .mass = 2e3 * kg, .initial_velocity = 0.3 * (m / s)});

  Pair() {
    add(model, ShearSpring{.name = "one", .lower = ground, .upper = a, .stiffness = 1 * MN / m});
    add(model, ShearSpring{.name = "two", .lower = a, .upper = b, .stiffness = 2 * MN / m});
  }
  NodeId middle() {
    return add(model, Node{.name = "middle", .mass = 1 * kg},
               Follower{.shares = {{{a, 0.25}, {b, 0.75}}}, .ground_influence = {{1.0, 0.0, 0.0}}});
  }
};

GroundMotion shaking() {
  std::vector<double> samples;
  for (int i = 0; i < 200; ++i) samples.push_back(2.0 * std::sin(0.2 * i));
  return {"shaking", 0.01, samples};
}

TEST(Follower, MovesAsTheSumOfItsShares) {
  Pair pair;
  const NodeId middle = pair.middle();
  EXPECT_EQ(pair.model.degrees_of_freedom(), 2);
  EXPECT_EQ(pair.model.nodes(), 3);
  EXPECT_EQ(pair.model.body_of(middle), (std::vector{pair.a, pair.b}));
  Transient analysis{pair.model, shaking()};
  analysis.run();
  const AnalysisState& state = analysis.state();
  EXPECT_DOUBLE_EQ(state.displacement(middle), 0.25 * state.displacement(pair.a) + 0.75 * state.displacement(pair.b));
  EXPECT_DOUBLE_EQ(state.velocity(middle), 0.25 * state.velocity(pair.a) + 0.75 * state.velocity(pair.b));
}

// A node may be added behind it: its own place is last, and its name stays.
TEST(Follower, StaysItselfWhenNodesAreAdded) {
  Pair pair;
  const NodeId middle = pair.middle();
  const NodeId later = add(pair.model, Node{.name = "later", .mass = 5 * kg});
  add(pair.model, ShearSpring{.name = "three", .lower = pair.b, .upper = later, .stiffness = 1 * kN / m});
  EXPECT_EQ(pair.model.node_name(middle), "middle");
  EXPECT_EQ(pair.model.node(pair.model.place(middle)), middle);
  const CaseResult result = run_case(pair.model, shaking());
  const auto named = [&](const std::string& place) {
    return std::ranges::count_if(result.peaks, [&](const Peak& peak) { return peak.where == place; });
  };
  EXPECT_EQ(named("middle"), named("later"));
}

// A gap on a point between two nodes, and one on a follower with the same shares, are the same.
TEST(Follower, AGapActsOnAllThatItFollows) {
  const auto impacts = [](bool follows) {
    Pair pair;
    const NodeId middle = follows ? pair.middle() : ground;
    const MemberPoint left = follows ? MemberPoint{middle} : MemberPoint{pair.a, pair.b, 0.75};
    add(pair.model, Gap{.name = "wall",
                        .left = left,
                        .right = ground,
                        .clearance = 3 * mm,
                        .law = Hertz{.stiffness = 1e9 * N / m_3_2}});
    return run_case(pair.model, shaking(), {.transient = {.step = 0.5 * ms, .force_tolerance = 1e-12}});
  };
  const CaseResult a = impacts(true), b = impacts(false);
  ASSERT_GT(b.impacts.size(), 2U);
  ASSERT_EQ(a.impacts.size(), b.impacts.size());
  for (std::size_t i = 0; i < a.impacts.size(); ++i) {
    EXPECT_NEAR(a.impacts[i].start, b.impacts[i].start, 1e-9);
    EXPECT_NEAR(a.impacts[i].largest_force, b.impacts[i].largest_force, 1e-8 * b.impacts[i].largest_force);
  }
}

TEST(Follower, BadSharesAreRefused) {
  const auto refused = [](const auto& motion_of) {
    return message_of([&] {
      Pair pair;
      add(pair.model, Node{.name = "middle", .mass = 1 * kg}, motion_of(pair));
    });
  };
  const auto has = [](const std::string& message, const std::string& words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  has(refused([](Pair&) { return Follower{}; }), "one entry for each degree of freedom");
  has(refused([](Pair&) { return Follower{.shares = {{}}, .ground_influence = {{}}}; }), "follows nothing");
  has(refused([](Pair&) { return Follower{.shares = {{{ground, 1.0}}}, .ground_influence = {{}}}; }), "the ground");
  has(refused([](Pair&) {
        return Follower{.shares = {{{NodeId{7}, 1.0}}}, .ground_influence = {{}}};
      }),
      "is not a node of this model");
  Pair pair;
  const NodeId middle = pair.middle();
  const Follower of_follower{.shares = {{{middle, 1.0}}}, .ground_influence = {{}}};
  has(message_of([&] { add(pair.model, Node{.name = "end", .mass = 1 * kg}, of_follower); }), "another follower");
  has(message_of([&] {
        add(pair.model, ShearSpring{.name = "spring", .lower = ground, .upper = middle, .stiffness = 1 * N / m});
      }),
      "follows others");
}

}  // namespace
}  // namespace moat
