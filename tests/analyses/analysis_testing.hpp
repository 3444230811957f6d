// Helpers shared by the tests of analyses.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "base/units.hpp"
#include "motions/ground_motion.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat::testing {

/// A ground that does not move, for analyses that start from initial values.
inline GroundMotion still_ground(Time duration, Time time_step = 10 * units::ms) {
  const auto samples = static_cast<std::size_t>(std::lround(duration / time_step)) + 1;
  return GroundMotion{"still ground", time_step.si(), std::vector<double>(samples, 0.0)};
}

/// A ground whose acceleration stays the same from the first instant on.
inline GroundMotion constant_acceleration(double acceleration, Time duration, Time time_step = 10 * units::ms) {
  const auto samples = static_cast<std::size_t>(std::lround(duration / time_step)) + 1;
  return GroundMotion{"constant acceleration", time_step.si(), std::vector<double>(samples, acceleration)};
}

/// Order of convergence from errors at a step and at half of it.
inline double order(double error, double error_at_half_the_step) { return std::log2(error / error_at_half_the_step); }

/// Calls one function after every step and after every event.
class Watch final : public StepObserver {
 public:
  explicit Watch(std::function<void(const StepView&)> look) : look_{std::move(look)} {}
  int events = 0;

  void start(const StepView& view) override { look_(view); }
  void step(const StepView& view) override { look_(view); }
  void event(const StepView& view, std::span<const RegimeChange>) override {
    ++events;
    look_(view);
  }
  void finish(const StepView&) override {}

 private:
  std::function<void(const StepView&)> look_;
};

}  // namespace moat::testing
