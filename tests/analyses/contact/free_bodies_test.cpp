// Bodies without springs: few steps in flight, and no false report of chatter.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "analysis_testing.hpp"
#include "message_of.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

TEST(FreeBodies, ABodyInASlotNeedsFewSteps) {
  for (const double frequency : {2.0 * std::numbers::pi, 5.0, 9.0}) {
    SCOPED_TRACE(frequency);
    Model model;
    const NodeId body = add(model, Node{.name = "body", .mass = 100 * tonne, .free = true});
    add(model,
        Moat{.around = body, .clearance = 5 * cm, .law = ExactKelvin{.stiffness = 1e9 * N / m, .restitution = 0.65}});
    double first_touch = -1.0;
    long steps_before_touch = 0;
    Transient analysis{model, sine_motion(2.0, frequency, 5 * s)};
    Watch watch{[&](const StepView& view) {
      if (watch.events == 0 || first_touch >= 0.0) return;
      first_touch = view.state.time();
      steps_before_touch = analysis.statistics().accepted_steps;
    }};
    analysis.attach(watch);
    analysis.run();
    // u = a/w^2 sin wt - a t/w as long as nothing is in the way: -5 cm in between 5 cm is passed at first_touch.
    const double free =
        2.0 / (frequency * frequency) * std::sin(frequency * first_touch) - 2.0 / frequency * first_touch;
    // The motion is linear between samples, low by (w dt)^2/12 of itself on average.
    EXPECT_NEAR(free, -0.05, 0.05 * std::pow(frequency * 0.01, 2));
    EXPECT_LT(steps_before_touch, 200);
    EXPECT_LT(analysis.statistics().accepted_steps, 5000);
  }
}

// Nearly free: a spring so soft that its accelerations are far below those of the ground.
TEST(FreeBodies, ABodyOnAVerySoftSpringNeedsFewSteps) {
  for (const double stiffness : {1.0, 1e-3, 1e-6}) {
    SCOPED_TRACE(stiffness);
    Model model;
    const NodeId body = add(model, Node{.name = "body", .mass = 100 * tonne});
    add(model, ShearSpring{.name = "spring", .lower = ground, .upper = body, .stiffness = stiffness * N / m});
    add(model,
        Moat{.around = body, .clearance = 5 * cm, .law = ExactKelvin{.stiffness = 1e9 * N / m, .restitution = 0.65}});
    Transient analysis{model, sine_motion(2.0, 2.0 * std::numbers::pi, 5 * s)};
    analysis.run();
    EXPECT_GT(analysis.statistics().events, 4);
    EXPECT_LT(analysis.statistics().accepted_steps, 5000);
  }
}

TEST(FreeBodies, ManyThatHitOnceDoNotChatter) {
  constexpr int bodies = 300;
  Model model;
  for (int i = 0; i < bodies; ++i) {
    const std::string name = std::to_string(i);
    const NodeId body = add(model, Node{.name = name, .mass = 1000 * kg, .initial_velocity = 1 * m / s});
    add(model, Gap{.name = "gap " + name,
                   .left = body,
                   .right = ground,
                   .clearance = (10.0 + 0.4 * i) * mm,
                   .law = LinearElastic{.stiffness = 1e8 * N / m}});
  }
  // 600 changes within 0.14 s, two for each gap.
  const auto [result, state] = run_to_end(
      model, still_ground(0.2 * s), {.transient = {.max_events_per_second = 20}, .error_bars = ErrorBarMode::never});
  ASSERT_EQ(result.impacts.size(), static_cast<std::size_t>(bodies));
  for (int i = 0; i < bodies; ++i) EXPECT_NEAR(state.velocity(NodeId{i}), -1.0, 1e-3) << i;
}

TEST(FreeBodies, OneThatChattersIsNamed) {
  Model model;
  // One body bounces in a narrow slot: 2 mm at 1 m/s, with a hundred touches of each wall in a second. Another hits
  // once.
  const NodeId calm = add(model, Node{.name = "calm", .mass = 1000 * kg, .initial_velocity = 1 * m / s});
  const NodeId busy = add(model, Node{.name = "busy", .mass = 1000 * kg, .initial_velocity = 1 * m / s});
  const LinearElastic law{.stiffness = 1e9 * N / m};
  add(model, Gap{.name = "calm gap", .left = calm, .right = ground, .clearance = 1 * cm, .law = law});
  add(model, Gap{.name = "busy gap", .left = busy, .right = ground, .clearance = 1 * mm, .law = law});
  add(model, Gap{.name = "other gap", .left = ground, .right = busy, .clearance = 1 * mm, .law = law});
  Transient analysis{model, still_ground(1 * s), {.max_events_per_second = 20}};
  const std::string message = message_of<Error>([&] { analysis.run(); });
  EXPECT_TRUE(message.starts_with("\"busy gap\" changed more than 20 times within one second")) << message;
  EXPECT_TRUE(
      message.ends_with(" s: it chatters. Check its stiffness and damping, or raise "
                        "TransientOptions::max_events_per_second."))
      << message;
  // Ten touches and ten separations are allowed. From one touch to the next there are two ways of 2 mm and two contacts
  // of half a period each, whose durations are right to 1e-3 or better.
  const double contact = std::numbers::pi * std::sqrt(1000.0 / 1e9);
  EXPECT_NEAR(analysis.state().time(), 1e-3 + 10.0 * (4e-3 + 2.0 * contact), 20.0 * contact * 1e-3);
}

}  // namespace
}  // namespace moat
