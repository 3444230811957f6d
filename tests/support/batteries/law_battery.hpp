// Tests that every contact law must pass.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <random>
#include <vector>

#include "materials/contact/contact_state.hpp"
#include "materials/response.hpp"
#include "spring_battery.hpp"

namespace moat::testing {

/// Where a law is tried: deformations up to `deformation` m, rates up to `rate` m/s to both sides, and close to
/// both sides of the values where it changes its branch.
struct LawRange {
  double deformation = 1.0;
  double rate = 1.0;
  std::vector<double> deformation_corners{0.0};
  std::vector<double> rate_corners{0.0};
};

/// Random arguments inside a range; half of them close to a corner, at distances over eight decades.
class Arguments {
 public:
  explicit Arguments(const LawRange& range) : range_{range} {}

  double deformation() { return draw(range_.deformation, range_.deformation_corners); }
  double rate() { return draw(range_.rate, range_.rate_corners); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>{low, high}(engine_); }

 private:
  double draw(double limit, const std::vector<double>& corners) {
    if (corners.empty() || uniform(0.0, 1.0) < 0.5) return uniform(-limit, limit);
    const double corner = corners[std::min(static_cast<std::size_t>(uniform(0.0, static_cast<double>(corners.size()))),
                                           corners.size() - 1)];
    return corner + std::copysign(limit * std::pow(10.0, uniform(-8.0, 0.0)), uniform(-1.0, 1.0));
  }

  LawRange range_;
  std::mt19937_64 engine_{20170119};
};

inline double distance_to_nearest(const std::vector<double>& corners, double value, double at_most) {
  double nearest = at_most;
  for (const double corner : corners) nearest = std::min(nearest, std::abs(value - corner));
  return nearest;
}

// The slope of a function between the nearest corners, by central differences of two widths (Richardson), and how
// far round-off may have moved it.
struct Slope {
  double value, round_off;
};
template <class Function>
Slope slope_of(Function function, double at, double room) {
  const double h = 4e-3 * room;
  const auto central = [&](double width) {
    const double right = at + width, left = at - width;
    return (function(right) - function(left)) / (right - left);
  };
  const double largest = std::max(std::abs(function(at + h)), std::abs(function(at - h)));
  // The argument itself is rounded, too.
  const double rounding = 1e-15 * (largest / h + std::abs(at) / h * std::abs(central(h)));
  return {(64.0 * central(0.25 * h) - 20.0 * central(0.5 * h) + central(h)) / 45.0, 20.0 * rounding};
}

/// Both tangents against differences of the force.
template <ForceLaw Law>
void expect_exact_tangents(const Law& law, const typename Law::State& committed, const LawRange& range) {
  Arguments arguments{range};
  typename Law::State trial;
  const auto force = [&](double deformation, double rate) {
    return law.evaluate(committed, deformation, rate, trial).force;
  };
  for (int count = 0; count < 400; ++count) {
    const double d = arguments.deformation(), v = arguments.rate();
    const Response response = law.evaluate(committed, d, v, trial);
    const double room_d = distance_to_nearest(range.deformation_corners, d, range.deformation);
    const double room_v = distance_to_nearest(range.rate_corners, v, range.rate);
    const Slope stiffness = slope_of([&](double x) { return force(x, v); }, d, room_d);
    const Slope damping = slope_of([&](double x) { return force(d, x); }, v, room_v);
    EXPECT_NEAR(response.stiffness, stiffness.value, 1e-7 * std::abs(response.stiffness) + stiffness.round_off)
        << "dF/dd at d = " << d << " m, d' = " << v << " m/s";
    EXPECT_NEAR(response.damping, damping.value, 1e-7 * std::abs(response.damping) + damping.round_off)
        << "dF/dd' at d = " << d << " m, d' = " << v << " m/s";
    if (::testing::Test::HasFailure()) return;
  }
}

/// d(stored)/dt + dissipation rate = F d', and the dissipation rate is not negative. `reachable` selects the arguments
/// that can follow from the committed state; of some states (an elastic contact that was released) none can.
template <ForceLaw Law, class Reachable>
void expect_energy_identity(const Law& law, const typename Law::State& committed, const LawRange& range,
                            Reachable reachable) {
  Arguments arguments{range};
  typename Law::State trial;
  for (int drawn = 0, tried = 0; drawn < 20000 && tried < 400; ++drawn) {
    const double d = arguments.deformation(), v = arguments.rate();
    if (!reachable(d, v)) continue;
    ++tried;
    const double room = distance_to_nearest(range.deformation_corners, d, range.deformation);
    const Slope stored = slope_of([&](double x) { return law.stored_energy(committed, x); }, d, room);
    const double dissipation = law.dissipation_rate(committed, d, v);
    const double power = law.evaluate(committed, d, v, trial).force * v;
    const double largest = std::max({std::abs(stored.value * v), dissipation, std::abs(power)});
    EXPECT_GE(dissipation, 0.0) << "d = " << d << " m, d' = " << v << " m/s";
    EXPECT_NEAR(stored.value * v + dissipation, power, 1e-9 * largest + stored.round_off * std::abs(v))
        << "d = " << d << " m, d' = " << v << " m/s";
    if (::testing::Test::HasFailure()) return;
  }
}

template <ForceLaw Law>
void expect_energy_identity(const Law& law, const typename Law::State& committed, const LawRange& range) {
  expect_energy_identity(law, committed, range, [](double, double) { return true; });
}

/// The margin is negative where the regime has ended, next_regime() leads to one that has not, the approach speed
/// belongs to the touch, and a loaded contact that must not pull does not while its margin is positive.
template <LawWithRegimes Law>
void expect_consistent_regimes(const Law& law, const LawRange& range, bool may_pull) {
  static_assert(std::same_as<typename Law::State, ContactState>);
  Arguments arguments{range};
  ContactState trial;
  for (int count = 0; count < 3000; ++count) {
    const double d = arguments.deformation(), v = arguments.rate();
    for (const ContactPhase phase : {ContactPhase::open, ContactPhase::loaded, ContactPhase::released}) {
      ContactState state{phase, phase == ContactPhase::open ? 0.0 : 0.3 * range.rate};
      const double margin = law.regime_margin(state, d, v);
      const double force = law.evaluate(state, d, v, trial).force;
      if (phase != ContactPhase::loaded) {
        EXPECT_EQ(force, 0.0);
      } else if (margin >= 0.0 && !may_pull) {
        EXPECT_GE(force, 0.0) << "d = " << d << " m, d' = " << v << " m/s";
      }
      int changes = 0;
      while (law.regime_margin(state, d, v) < 0.0 && changes < 5) {
        const ContactState next = law.next_regime(state, d, v);
        EXPECT_FALSE(next == state);
        if (state.phase == ContactPhase::open) {
          EXPECT_EQ(next.phase, ContactPhase::loaded);
          EXPECT_EQ(next.approach_speed, std::max(v, least_approach_speed));
        } else if (next.phase == ContactPhase::open) {
          EXPECT_LE(d, 0.0);
          EXPECT_EQ(next.approach_speed, 0.0);
        } else {
          EXPECT_EQ(next.approach_speed, state.approach_speed);
        }
        state = next;
        ++changes;
      }
      EXPECT_LT(changes, 4) << "the regimes chatter at d = " << d << " m, d' = " << v << " m/s";
    }
    if (::testing::Test::HasFailure()) return;
  }
}

/// Everything above for a contact, in all its phases; `range.rate` is several times the approach speed.
template <LawWithRegimes Law>
void expect_sound_contact(const Law& law, const LawRange& range, bool may_pull) {
  const double approach_speed = 0.3 * range.rate;
  expect_exact_tangents(law, {}, range);
  expect_energy_identity(law, {}, range);
  for (const ContactPhase phase : {ContactPhase::loaded, ContactPhase::released}) {
    const ContactState state{phase, approach_speed};
    expect_exact_tangents(law, state, range);
    expect_energy_identity(law, state, range, [&](double d, double v) {
      return phase == ContactPhase::loaded || (v < 0.0 && law.regime_margin(state, d, v) >= 0.0);
    });
  }
  expect_consistent_regimes(law, range, may_pull);
  const SpringTrial trial{.deformation = range.deformation, .rate = range.rate, .energy = 1e-7, .moves = 60};
  expect_energy_balance(law, trial);
  expect_purity(law, trial);
  EXPECT_EQ(law.linear_stiffness(StiffnessStage::initial), 0.0);
}

}  // namespace moat::testing
