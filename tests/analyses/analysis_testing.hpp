// Helpers shared by the tests of analyses.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include "ended_case.hpp"
#include "moat.hpp"
#include "small_models.hpp"

namespace moat::testing {

/// A ground whose acceleration stays the same from the first instant on.
inline GroundMotion constant_acceleration(double acceleration, Time duration, Time time_step = 10 * units::ms) {
  return sampled("constant acceleration", duration, time_step, [=](double) { return acceleration; });
}

/// amplitude sin(frequency t), in m/s^2 and 1/s, with samples every 10 ms.
inline GroundMotion sine_motion(double amplitude, double frequency, Time duration) {
  return sampled("sine", duration, 10 * units::ms, [=](double t) { return amplitude * std::sin(frequency * t); });
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
