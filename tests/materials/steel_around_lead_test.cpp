// Heat that flows from a lead core into the steel: sequences of shocks and rests against a direct superposition.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "base/units.hpp"
#include "materials/isolation/heated_lead_rubber.hpp"
#include "steel_response.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double pi = std::numbers::pi;

HeatedLeadRubber bearing(double radius, double shims_per_radius) {
  HeatedLeadRubber law = HeatedLeadRubber::typical();
  law.lead_diameter = 2.0 * radius * m;
  law.lead_height = (2.0 * radius + 2.0 * shims_per_radius * radius) * m;
  law.shim_thickness = shims_per_radius * radius * m;
  law.strength = 13e6 * pi * radius * radius * N;
  law.yield_displacement = 1e-3 * mm;
  return law;
}

// y(t+), the flow after a unit step of T, in steps on graded times: the T of a bearing that slides on, t+/(1 +
// t+/0.135), loses by superposition as much heat as the theory of Kalpakidis & Constantinou says.
class StepResponse {
 public:
  explicit StepResponse(double shims) {
    constexpr double first = 1e-7, last = 300.0, ratio = 1.05;
    times_.push_back(0.0);
    for (double t = first; t < last; t *= ratio) {
      const double theory = 1.0 / steel_response(t) + shims / std::cbrt(t), length = t - times_.back();
      double flow = temperature(t) * theory;
      for (std::size_t j = 0; j < values_.size(); ++j)
        flow -= values_[j] * (temperature(t - times_[j]) - temperature(t - times_[j + 1]));
      values_.push_back(flow / temperature(length));
      twice_.push_back(twice_.back() + length * (once_.back() + 0.5 * values_.back() * length));
      once_.push_back(once_.back() + values_.back() * length);
      times_.push_back(t);
    }
  }
  // The flow integrated twice, from 0 to t.
  [[nodiscard]] double twice_integrated(double t) const {
    if (t <= 0.0) return 0.0;
    const auto k = static_cast<std::size_t>(std::ranges::lower_bound(times_, t) - times_.begin()) - 1;
    const double x = t - times_[k];
    return twice_[k] + x * (once_[k] + 0.5 * values_[k] * x);
  }

 private:
  static double temperature(double t) { return t / (1.0 + t / 0.135); }
  std::vector<double> times_, values_, once_{0.0}, twice_{0.0};  // the last two: the integral, and that of the integral
};

// The temperature of lead that gets heat Q(T) |dS|, by direct superposition of the flows of all its former changes.
class DirectSuperposition {
 public:
  explicit DirectSuperposition(const HeatedLeadRubber& law)
      : law_{law},
        radius_{0.5 * law.lead_diameter.si()},
        per_kelvin_{law.lead_density.si() * law.lead_specific_heat * law.lead_height.si()},  // J/(m^2 K)
        response_{1.274 * law.shim_thickness.si() / radius_} {}
  void step(double length, double slip) {
    const double scale = law_.steel_diffusivity / (radius_ * radius_), time = times_.back() + length;
    const double conduction = law_.steel_conductivity / radius_ / scale;
    double lost = 0.0;
    for (std::size_t j = 0; j < slopes_.size(); ++j)
      lost += slopes_[j] / scale *
              (response_.twice_integrated(scale * (time - times_[j])) -
               response_.twice_integrated(scale * (time - times_[j + 1])));
    const double own = response_.twice_integrated(scale * length) / scale;
    const double before = temperature(), stress = law_.strength.si() / (pi * radius_ * radius_);
    double slope = 0.0;
    for (int i = 0; i < 20; ++i) {
      const double heat = heat_ + stress * std::exp(-law_.weakening * (before + 0.5 * slope * length)) * slip;
      slope = (heat - per_kelvin_ * before - conduction * lost) / (per_kelvin_ * length + conduction * own);
    }
    heat_ += stress * std::exp(-law_.weakening * (before + 0.5 * slope * length)) * slip;
    slopes_.push_back(slope);
    temperatures_.push_back(before + slope * length);
    times_.push_back(time);
  }
  [[nodiscard]] double temperature() const { return temperatures_.back(); }

 private:
  HeatedLeadRubber law_;
  double radius_, per_kelvin_;
  StepResponse response_;
  double heat_ = 0.0;  // J/m^2
  std::vector<double> times_{0.0}, temperatures_{0.0}, slopes_;
};

// Leads a bearing along motions and rests.
class Driven {
 public:
  explicit Driven(const HeatedLeadRubber& law) : law_{law} {}
  void shake(double amplitude, double frequency, int cycles, int steps_per_cycle) {
    for (int i = 1; i <= cycles * steps_per_cycle; ++i) {
      const double phase = 2.0 * pi * i / steps_per_cycle;
      step(amplitude * std::sin(phase), 2.0 * pi * frequency * amplitude * std::cos(phase),
           1.0 / frequency / steps_per_cycle);
    }
  }
  void rest(double length, int steps = 1) {
    for (int i = 0; i < steps; ++i) step(before_, 0.0, length / steps);
  }
  [[nodiscard]] const HeatedLeadRubber::State& state() const { return state_; }
  [[nodiscard]] double force() const { return force_; }

 private:
  void step(double d, double v, double length) {
    const double rate = std::copysign(v, d - before_);
    for (int changes = 0; changes < 2 && law_.regime_margin(state_, d, rate) < 0.0; ++changes)
      state_ = law_.next_regime(state_, state_.direction == 0 ? d : before_, rate);
    HeatedLeadRubber::State trial;
    force_ = law_.evaluate(state_, d, v, {length, before_, v}, trial).force;
    state_ = trial;
    before_ = d;
  }
  HeatedLeadRubber law_;
  HeatedLeadRubber::State state_{};
  double before_ = 0.0, force_ = 0.0;
};

TEST(SteelAroundLead, CoolsInARestAsTheSuperpositionOfAllStepsSays) {
  constexpr double amplitude = 0.15, frequency = 0.5;
  constexpr int cycles = 4, steps = 800, coarse = 80;
  for (const double radius : {0.03, 0.07, 0.15})
    for (const double shims : {0.3, 1.0, 3.0}) {
      const HeatedLeadRubber law = bearing(radius, shims);
      Driven first_shock{law};
      first_shock.shake(amplitude, frequency, cycles, steps);
      DirectSuperposition first_exact{law};
      const auto shake = [&](DirectSuperposition& exact) {
        for (int i = 1; i <= cycles * coarse; ++i)
          exact.step(1.0 / frequency / coarse,
                     amplitude * std::abs(std::sin(2.0 * pi * i / coarse) - std::sin(2.0 * pi * (i - 1) / coarse)));
      };
      shake(first_exact);
      const double hot = first_exact.temperature();
      EXPECT_NEAR(first_shock.state().temperature, hot, 1.5e-3 * hot);
      for (const double rest : {1.0, 20.0, 300.0, 3600.0}) {
        SCOPED_TRACE("a = " + std::to_string(radius) + " m, t_s/a = " + std::to_string(shims) +
                     ", rest = " + std::to_string(rest) + " s");
        Driven moat = first_shock;
        moat.rest(rest);
        DirectSuperposition exact = first_exact;
        constexpr int parts = 60;
        const double ratio = std::pow(rest / 1e-2, 1.0 / parts);
        for (int i = 0; i < parts; ++i) exact.step(1e-2 * std::pow(ratio, i) * (ratio - 1.0), 0.0);
        EXPECT_NEAR(moat.state().temperature, exact.temperature(), 1.5e-3 * hot);
        moat.shake(amplitude, frequency, cycles, steps);
        shake(exact);
        EXPECT_NEAR(moat.state().temperature, exact.temperature(), 1.5e-3 * hot);
      }
    }
}

}  // namespace
}  // namespace moat::testing
