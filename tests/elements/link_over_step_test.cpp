// The force and the work of a link over a step inside which it changes.

#include "moat.hpp"

#include <gtest/gtest.h>

#include <array>

namespace moat {
namespace {

constexpr double stiffness = 2e8, damping = 3e6, speed = 0.5, step = 0.01;  // N/m, N s/m, m/s, s
constexpr double touch = 0.3;                                               // of the step

// A contact that touches inside the step, with constant speed: F = k d + c v from then on.
struct Touch {
  using State = ContactState;
  ViscousLinearContact law{.stiffness = stiffness, .damping = damping};
  LinkMotion start{{-touch * step * speed}, {speed}, {0.0}}, end{{(1.0 - touch) * step * speed}, {speed}, {0.0}};
  State closed{ContactPhase::loaded, speed};
  std::array<LinkChanges<State>::Change, 1> changes{{{0, {}, touch, 0.0}}};

  [[nodiscard]] LinkOverStep<ViscousLinearContact> over_step() const {
    return {law, start, end, 0, step, changes, closed};
  }
};

TEST(LinkOverStep, IntegratesAForceFromItsTouchOn) {
  const Touch contact;
  const ForceOverStep force = contact.over_step().force();
  const double time = (1.0 - touch) * step, deepest = speed * time;
  const double last = stiffness * deepest + damping * speed;
  EXPECT_DOUBLE_EQ(force.start, 0.0);
  EXPECT_DOUBLE_EQ(force.start_rate, 0.0);
  EXPECT_DOUBLE_EQ(force.end, last);
  EXPECT_DOUBLE_EQ(force.end_rate, stiffness * speed);
  const double impulse = 0.5 * stiffness * speed * time * time + damping * speed * time;
  EXPECT_NEAR(force.impulse, impulse, 1e-13 * impulse);
  // The integral of (h - t) F over h, with s the time since the touch: h - t = time - s.
  const double falling = (stiffness * speed * time * time * time / 6.0 + damping * speed * time * time / 2.0) / step;
  EXPECT_NEAR(force.falling, falling, 1e-13 * falling);
}

TEST(LinkOverStep, IntegratesItsWork) {
  const Touch contact;
  const TotalWork total = contact.over_step().work();
  const double time = (1.0 - touch) * step, deepest = speed * time;
  const double dissipated = damping * speed * speed * time;
  EXPECT_NEAR(total.dissipated, dissipated, 1e-13 * dissipated);
  EXPECT_NEAR(total.work, 0.5 * stiffness * deepest * deepest + dissipated, 1e-13 * total.work);
}

// Rules of all schemes: the integrals of forces that each of them forms exactly, over a step of 2 s.
TEST(ForceOverStep, MissesNothingThatTheSchemeIntegratesExactly) {
  constexpr double h = 2.0;
  const auto expect_none = [](const ForceOverStep& force, const ImpulseRules& rules) {
    EXPECT_NEAR(force.missed(force.impulse, rules.of_velocity, h), 0.0, 1e-14);
    EXPECT_NEAR(force.missed(force.impulse, rules.of_evaluated_velocity, h), 0.0, 1e-14);
    EXPECT_NEAR(force.missed(force.falling, rules.of_displacement, h), 0.0, 1e-14);
  };
  const ForceOverStep constant{3.0, 0.0, 3.0, 0.0, 3.0 * h, 3.0 * h / 2.0};
  const ForceOverStep linear{0.0, 1.0, h, 1.0, h * h / 2.0, h * h / 6.0};
  const ForceOverStep square{0.0, 0.0, h * h, 2.0 * h, h * h * h / 3.0, h * h * h / 12.0};
  expect_none(constant, StepScheme::average_acceleration().impulse_rules());
  expect_none(constant, StepScheme::fourth_order().impulse_rules());
  expect_none(linear, StepScheme::fourth_order().impulse_rules());
  expect_none(square, StepScheme::fourth_order().impulse_rules());
  // Linear acceleration integrates linear forces.
  expect_none(linear, StepScheme{.beta = 1.0 / 6.0}.impulse_rules());
  // Average acceleration takes the mean of both forces for the displacement.
  const ImpulseRules average = StepScheme::average_acceleration().impulse_rules();
  EXPECT_NEAR(linear.missed(linear.impulse, average.of_velocity, h), 0.0, 1e-14);
  EXPECT_NEAR(linear.missed(linear.falling, average.of_displacement, h), h * h / 6.0 - h * h / 4.0, 1e-14);
}

}  // namespace
}  // namespace moat
