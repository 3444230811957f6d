// The path over a step is the motion of the exponential.
#include "analyses/integrators/linear_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "elements/line/spring.hpp"
#include "exponential_motion.hpp"
#include "materials/linear.hpp"

namespace moat {
namespace {

using namespace units;

constexpr Eigen::Index count = 3;
constexpr double step_length = 0.01;  // s

// A building of three storeys that moves at the start of a step.
class LinearPathTest : public ::testing::Test {
 protected:
  LinearPathTest() {
    NodeId lower = ground;
    for (const char* name : {"first", "second", "third"}) {
      const NodeId upper = add(model, Node{.name = name, .mass = 1e3 * kg});
      add(model, Spring<Linear>{.name = "below " + std::string{name},
                                .lower = lower,
                                .upper = upper,
                                .law = {.stiffness = 200 * kN / m, .damping = 300 * N * s / m}});
      lower = upper;
    }
    model.prepare();
    const testing::Tangents tangents{model};
    system.emplace(tangents.stiffness, tangents.damping, model.masses(), step_length);
    exact.emplace(model, tangents, offset);
    model.trial().displacement.head(count) << 0.01, -0.02, 0.03;
    model.trial().velocity.head(count) << 0.5, 0.1, -0.4;
  }

  [[nodiscard]] Vector start() const {
    Vector motion(2 * count);
    motion << model.trial().displacement.head(count), model.trial().velocity.head(count);
    return motion;
  }

  void begin(const StepTask& step) { path.begin(*system, offset, model.trial(), step); }
  // u, u', u'' and the absolute jerk after h s.
  [[nodiscard]] Vector at(double h) {
    MotionState motion = model.trial();
    path.move(h, motion);
    Vector all(4 * count);
    all << motion.displacement.head(count), motion.velocity.head(count), motion.acceleration.head(count),
        motion.jerk.head(count);
    return all;
  }

  Model model;
  LinearPath path;
  const Vector offset{{0.3, -0.2, 0.1}};
  std::optional<LinearSystem> system;
  std::optional<testing::ExponentialMotion> exact;
};

void expect_equal(const Vector& found, const Vector& exact, double time) {
  for (Eigen::Index i = 0; i < exact.size(); ++i)
    EXPECT_NEAR(found[i], exact[i], 1e-12 * std::max(1.0, std::abs(exact[i]))) << time << " " << i;
}

// The ground accelerates as 2 + 30 t (m/s^2).
StepTask step_of(double start, double length) {
  return {.length = length,
          .end_time = start + length,
          .ground_acceleration = {2.0 + 30.0 * (start + length), 0.0},
          .ground_jerk = {30.0, 0.0},
          .ground_acceleration_at_start = {2.0 + 30.0 * start, 0.0},
          .start_time = start};
}

// Ends and insides of whole and of shorter steps, not in their order.
TEST_F(LinearPathTest, IsTheExponentialUnderASteadySlopeOfTheGround) {
  for (const double length : {step_length, 0.37 * step_length}) {
    begin(step_of(0.004, length));
    for (const double share : {1.0, 0.2, 0.0, 0.999, 0.5, 1.0})
      expect_equal(at(share * length), exact->after(share * length, start(), 2.0 + 30.0 * 0.004, 30.0), share);
  }
}

}  // namespace
}  // namespace moat
