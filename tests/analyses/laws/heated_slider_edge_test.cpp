// A slider that leaves the centre of its surface again and again: the flux of heat begins and ends at located instants.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "base/units.hpp"
#include "elements/line/isolator.hpp"
#include "materials/isolation/heated_friction_pendulum.hpp"
#include "peak_in.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double pi = std::numbers::pi, mass = 6e5, weight = 6e6, radius = 2.2, contact = 0.1;

PressureTemperatureVelocity friction() {
  return {.reference_coefficient = 0.06,
          .reference_pressure = weight / (pi * contact * contact) * N / (m * m),
          .slider_radius = contact * m};
}

// A sine that swells and fades, in samples that both programs join by straight lines.
std::vector<double> samples() {
  std::vector<double> list;
  for (int i = 0; i <= 1500; ++i)
    list.push_back(3.0 * std::sin(2.0 * pi * 0.45 * 0.01 * i) * std::sin(pi * i / 1500.0));
  list.back() = 0.0;
  return list;
}

struct Reference {
  double temperature, displacement;
};
// In steps of 10 microseconds, each with the friction of the one before; nothing is located.
Reference by_short_steps() {
  using Memory = PressureTemperatureVelocity;
  const PressureTemperatureVelocity law = friction();
  const std::vector<double> ground = samples();
  constexpr int per_sample = 1000;
  constexpr double h = 0.01 / per_sample, elastic = 0.06 * weight / 1e-3, pressure = weight / (pi * contact * contact);
  std::array<double, Memory::memory_size> memory{}, kept{};
  for (std::size_t j = 0; j < kept.size(); ++j) kept[j] = std::exp(-h / Memory::memory_times[j]);
  double d = 0.0, v = 0.0, slip = 0.0, rise = 0.0, flux = 0.0;
  int direction = 0;
  Reference largest{};
  const auto coefficient = [&](double speed) {
    return 0.06 * law.speed_factor(speed) * law.temperature_factor(20.0 + rise);
  };
  const auto acceleration = [&](double at, int i) {
    const double share = static_cast<double>(i % per_sample) / per_sample;
    const auto k = static_cast<std::size_t>(i / per_sample);
    const double a = ground[k] + share * (k + 1 < ground.size() ? ground[k + 1] - ground[k] : 0.0);
    const double q =
        direction == 0 ? elastic * (at - slip) : direction * coefficient(std::max(direction * v, 0.0)) * weight;
    return -(weight / radius * at + q) / mass - a;
  };
  for (int i = 0; i < 1500 * per_sample; ++i) {
    v += 0.5 * h * acceleration(d, i);
    d += h * v;
    v += 0.5 * h * acceleration(d, i + 1);
    const bool heats = direction * v > 0.0 && std::abs(d) < 0.5 * std::sqrt(pi) * contact;
    const double now = heats ? coefficient(std::abs(v)) * pressure * std::abs(v) : 0.0, mean = 0.5 * (now + flux);
    flux = now;
    double sum = Memory::memory_rest * flux;
    for (std::size_t j = 0; j < kept.size(); ++j) {
      memory[j] = memory[j] * kept[j] + mean * Memory::memory_weights[j] * Memory::memory_times[j] * (1.0 - kept[j]);
      sum += memory[j];
    }
    rise = law.heating_factor() * sum;
    if (direction != 0 && direction * v < 0.0) {
      slip = d - direction * coefficient(0.0) * weight / elastic;
      direction = 0;
    } else if (direction == 0 && std::abs(d - slip) > coefficient(std::abs(v)) * weight / elastic) {
      direction = d > slip ? 1 : -1;
    }
    largest = {std::max(largest.temperature, 20.0 + rise), std::max(largest.displacement, std::abs(d))};
  }
  return largest;
}

TEST(HeatedFrictionPendulum, IsHeatedOverTheCentreAlone) {
  const Reference exact = by_short_steps();
  EXPECT_GT(exact.displacement, 5.0 * contact);
  const double rise = exact.temperature - 20.0;
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = mass * kg});
  add(model, Isolator<HeatedFrictionPendulum>{
                 .upper = node, .law = {.radius = radius * m, .friction = friction(), .weight = weight * N}});
  CaseOptions options;
  options.error_bars = ErrorBarMode::always;
  const CaseResult result = run_case(model, GroundMotion{"swell", 0.01, samples()}, options);
  EXPECT_FALSE(result.error_bars.sensitive);
  EXPECT_NEAR(peak(result, "surface_temperature", "bearings"), exact.temperature, 1e-3 * rise);
  EXPECT_NEAR(peak(result, "isolator_deformation", "bearings"), exact.displacement, 2e-4 * exact.displacement);
  for (const Peak& each : result.peaks)
    if (each.quantity == "surface_temperature") {
      EXPECT_NEAR(each.value, exact.temperature, each.error);
    }
}

}  // namespace
}  // namespace moat::testing
