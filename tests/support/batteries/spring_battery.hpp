// Tests that every law of isolators, dampers, storeys and soil must pass: one line for each law.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "materials/response.hpp"

namespace moat::testing {

/// How a law is tried, and which of the properties it has.
struct SpringTrial {
  double deformation = 0.3;  ///< m, the largest on the paths
  double rate = 1.0;         ///< m/s, the largest on the paths
  double energy = 1e-9;      ///< allowed error of the energy balance, relative to the energy that went in
  double pieces = 1e-9;      ///< allowed difference of the force where a path is cut in pieces; 0: not tried
  bool symmetric = true;     ///< F(-path) = -F(path)
  bool one_sided = false;    ///< paths stay at positive deformations more often than not
  bool gives_back = false;   ///< part of the energy that counts as dissipated comes back
  bool one_speed = false;    ///< a force that follows the speed would jump where the speed does
  int panels = 1;            ///< of the integral of the work; more where corners are not located
  int moves = 1000;          ///< length of the paths; fewer for laws that integrate numerically
};

/// Leads a law along monotone moves at constant speed. Regimes change where their margin reaches zero.
template <ForceLaw Law>
class LawPath {
 public:
  using State = typename Law::State;

  /// The work costs many evaluations: it is integrated over panels that double in length from the start of a move, so
  /// that short elastic parts are seen. Without panels only force and dissipation are known; with mean_of_ends work
  /// and dissipation of a piece are those of the mean of force and power at its ends.
  explicit LawPath(const Law& law, int panels = 1) : law_{law}, panels_{panels} {}
  static constexpr int mean_of_ends = -1;

  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] double deformation() const { return deformation_; }
  [[nodiscard]] double rate() const { return rate_; }
  [[nodiscard]] double force() const { return force_; }
  [[nodiscard]] double work() const { return work_; }
  [[nodiscard]] double dissipated() const { return dissipated_; }
  [[nodiscard]] double stored() const { return law_.stored_energy(state_, deformation_); }

  /// The response at another deformation, from the committed state on.
  [[nodiscard]] Response at(double deformation, double rate, State& trial) const {
    return respond(law_, state_, deformation, rate, interval(deformation, rate), trial);
  }

  /// Moves to a deformation in equal pieces; speed > 0 m/s.
  void move(double target, double speed, int pieces = 1) {
    const double start = deformation_;
    for (int i = 1; i <= pieces; ++i) move_once(i == pieces ? target : start + (target - start) * i / pieces, speed);
  }

 private:
  [[nodiscard]] Interval interval(double deformation, double rate) const {
    return {std::abs(deformation - deformation_) / std::abs(rate), deformation_, rate};
  }

  void move_once(double target, double speed) {
    const double rate = std::copysign(speed, target - deformation_);
    if constexpr (LawWithRegimes<Law>) {
      const auto margin = [&](double d) { return law_.regime_margin(state_, d, rate); };
      for (int changes = 0; changes < 100; ++changes) {
        if (margin(deformation_) < 0.0) {
          enter(rate);
          continue;
        }
        if (margin(target) >= 0.0) break;
        double before = deformation_, beyond = target;
        for (int i = 0; i < 200 && before != beyond; ++i) {
          const double middle = before + 0.5 * (beyond - before);
          if (middle == before || middle == beyond) break;
          (margin(middle) < 0.0 ? beyond : before) = middle;
        }
        advance(beyond, rate);
        enter(rate);
        if (changes == 99) ADD_FAILURE() << "the regimes chatter at d = " << deformation_ << " m";
      }
    }
    advance(target, rate);
  }

  // A change of regime may release stored energy, as it does in the elements.
  void enter(double rate) {
    const double stored_before = stored();
    state_ = law_.next_regime(state_, deformation_, rate);
    dissipated_ += stored_before - stored();
  }

  template <class Function>
  static double integral(const Function& function, double from, double to) {
    if (from == to) return 0.0;
    const double size = boost::math::quadrature::gauss_kronrod<double, 15>::integrate(function, std::min(from, to),
                                                                                      std::max(from, to), 12, 1e-10);
    return to > from ? size : -size;
  }

  void advance(double target, double rate) {
    State trial = state_;
    const auto force = [&](double d) { return at(d, rate, trial).force; };
    if (panels_ > 0 && target != deformation_) {
      const auto power = [&](double d) { return law_.dissipation_rate(state_, d, rate) / rate; };
      double from = deformation_;
      for (int panel = panels_ - 1; panel >= 0; --panel) {
        const double to = deformation_ + std::ldexp(target - deformation_, -panel);
        work_ += integral(force, from, to);
        if constexpr (!requires { law_.dissipated_energy(state_, state_); }) dissipated_ += integral(power, from, to);
        // A stiffness that falls gives up a part of its store.
        if constexpr (GivesWeightWork<Law, double>)
          dissipated_ -= integral(
              [&](double d) {
                force(d);
                return law_.weight_power(trial, d, rate, 0.0) / rate;
              },
              from, to);
        from = to;
      }
    }
    const double force_before = force_;
    force_ = force(target);
    if (panels_ == mean_of_ends) work_ += 0.5 * (force_before + force_) * (target - deformation_);
    if constexpr (requires { law_.dissipated_energy(state_, state_); })
      dissipated_ += law_.dissipated_energy(state_, trial);
    else if (panels_ == mean_of_ends)
      dissipated_ += 0.5 *
                     (law_.dissipation_rate(state_, deformation_, rate) + law_.dissipation_rate(trial, target, rate)) *
                     (target - deformation_) / rate;
    state_ = trial;
    deformation_ = target;
    rate_ = rate;
  }

  Law law_;
  int panels_;
  State state_{};
  double deformation_ = 0.0, rate_ = 0.0, force_ = 0.0, work_ = 0.0, dissipated_ = 0.0;
};

/// Random moves: reversals at all sizes, some of them tiny.
class RandomMoves {
 public:
  explicit RandomMoves(const SpringTrial& trial, std::uint64_t seed = 20261122) : trial_{trial}, engine_{seed} {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>{low, high}(engine_); }
  double target(double from) {
    const double low = trial_.one_sided ? -0.3 * trial_.deformation : -trial_.deformation;
    if (uniform(0.0, 1.0) < 0.4) return uniform(low, trial_.deformation);
    const double moved =
        from + std::copysign(trial_.deformation * std::pow(10.0, uniform(-4.0, -0.5)), uniform(-1.0, 1.0));
    return std::abs(moved) < trial_.deformation ? moved : 0.9 * from;
  }
  double speed() { return trial_.one_speed ? trial_.rate : trial_.rate * std::pow(10.0, uniform(-2.0, 0.0)); }

 private:
  SpringTrial trial_;
  std::mt19937_64 engine_;
};

/// Work = stored + dissipated along random moves, and no move dissipates less than nothing.
template <ForceLaw Law>
void expect_energy_balance(const Law& law, const SpringTrial& trial) {
  LawPath<Law> path{law, trial.panels};
  RandomMoves moves{trial};
  double scale = 0.0;
  for (int i = 0; i < trial.moves; ++i) {
    const double dissipated = path.dissipated(), work = path.work(), stored = path.stored();
    path.move(moves.target(path.deformation()), moves.speed());
    scale += std::abs(path.work() - work);
    if (!trial.gives_back) {
      EXPECT_GE(path.dissipated() - dissipated, -1e-12 * scale) << "move " << i;
    }
    EXPECT_NEAR(path.work() - work, path.stored() - stored + path.dissipated() - dissipated, trial.energy * scale)
        << "move " << i << " from d = " << path.deformation() << " m";
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(scale, 0.0);
}

/// The same for a law that evolves in time. It balances its energy in the limit of short steps only: with steps of a
/// quarter, the error is at most half.
template <TimeDependentLaw Law>
void expect_energy_balance_in_short_steps(const Law& law, const SpringTrial& trial) {
  const auto error = [&](int pieces) {
    LawPath<Law> path{law, LawPath<Law>::mean_of_ends};
    RandomMoves moves{trial};
    double largest = 0.0, scale = 0.0;
    for (int i = 0; i < trial.moves; ++i) {
      const double dissipated = path.dissipated(), work = path.work();
      path.move(moves.target(path.deformation()), moves.speed(), pieces);
      scale += std::abs(path.work() - work);
      if (!trial.gives_back) {
        EXPECT_GE(path.dissipated() - dissipated, -1e-12 * scale) << "move " << i;
      }
      largest = std::max(largest, std::abs(path.work() - path.stored() - path.dissipated()));
    }
    EXPECT_GT(scale, 0.0);
    return largest / scale;
  };
  constexpr int pieces = 100;
  const double of_long_steps = error(pieces);
  EXPECT_LE(error(4 * pieces), std::max(0.5 * of_long_steps, trial.energy));
}

/// Both tangents against differences of the force, at states along random moves and on every side of them. Places
/// beside a corner, where the stiffness differs on both sides, are left out; they must be few.
template <ForceLaw Law>
void expect_tangents(const Law& law, const SpringTrial& trial) {
  LawPath<Law> path{law, 0};
  RandomMoves moves{trial};
  int tried = 0, beside_corners = 0;
  for (int i = 0; i < trial.moves / 3; ++i) {
    path.move(moves.target(path.deformation()), moves.speed());
    for (int k = 0; k < 4; ++k) {
      const double d = moves.target(path.deformation());
      const double v = std::copysign(moves.speed(), d - path.deformation());
      typename Law::State after;
      const double length = std::abs(d - path.deformation()) / std::abs(v);
      const Interval interval{length, path.deformation(), v};
      const auto evaluate = [&](double x, double y) { return respond(law, path.state(), x, y, interval, after); };
      const Response here = evaluate(d, v);
      const auto compare = [&](double width, bool by_rate, double expected) {
        const auto at = [&](double x) { return by_rate ? evaluate(d, v + x) : evaluate(d + x, v); };
        const double left = by_rate ? at(-2.0 * width).damping : at(-2.0 * width).stiffness,
                     right = by_rate ? at(2.0 * width).damping : at(2.0 * width).stiffness;
        const double largest = std::max({std::abs(left), std::abs(right), std::abs(expected)});
        ++tried;
        if (std::abs(right - left) > 1e-2 * largest) {
          ++beside_corners;
          return;
        }
        const double near = (at(width).force - at(-width).force) / (2.0 * width),
                     far = (at(2.0 * width).force - at(-2.0 * width).force) / (4.0 * width);
        const double slope = (4.0 * near - far) / 3.0;
        const double round_off = 1e-14 * std::abs(here.force) / width;
        EXPECT_NEAR(expected, slope, 1e-6 * largest + round_off)
            << (by_rate ? "dF/dd'" : "dF/dd") << " at d = " << d << " m, d' = " << v << " m/s, from "
            << path.deformation() << " m";
      };
      compare(1e-5 * std::min(trial.deformation, std::abs(d - path.deformation()) + 1e-6), false, here.stiffness);
      compare(1e-5 * std::abs(v), true, here.damping);
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_LT(beside_corners, tried / 5);
}

/// The rates of the quantities that a law reports, against their differences over two short steps with an acceleration,
/// behind random moves. Places beside a corner, where the rates of both steps differ, are left out; they must be few.
template <ForceLaw Law>
void expect_rates_of_quantities(const Law& law, const SpringTrial& trial) {
  const std::size_t count = quantities_of(law).size();
  if constexpr (requires(const typename Law::State& state) { law.quantity(0, state, 0.0, 0.0, 0.0); }) {
    LawPath<Law> path{law, 0};
    RandomMoves moves{trial};
    std::vector<double> largest(count, 0.0);  // rates
    int tried = 0, beside_corners = 0;
    for (int i = 0; i < trial.moves; ++i) {
      path.move(moves.target(path.deformation()), moves.speed());
      const double v = path.rate(), time = trial.deformation / trial.rate, h = 1e-5 * time, a = 0.3 * v / time;
      const auto deformation = [&](double t) { return path.deformation() + t * (v + 0.5 * t * a); };
      const auto rate = [&](double t) { return v + t * a; };
      std::array<typename Law::State, 3> states{path.state()};
      bool stays = true;
      for (std::size_t step = 1; step <= 2; ++step) {
        const double before = (static_cast<double>(step) - 1.0) * h, t = static_cast<double>(step) * h;
        static_cast<void>(respond(law, states[step - 1], deformation(t), rate(t),
                                  {h, deformation(before), rate(before)}, states[step]));
        if constexpr (LawWithRegimes<Law>) stays &= law.regime_margin(states[step - 1], deformation(t), rate(t)) > 0.0;
      }
      if (!stays) continue;
      for (std::size_t q = 0; q < count; ++q) {
        const auto at = [&](std::size_t step) {
          const double t = static_cast<double>(step) * h;
          return law.quantity(q, states[step], deformation(t), rate(t), a);
        };
        const ReportedValue start = at(0), middle = at(1), end = at(2);
        largest[q] = std::max(largest[q], std::abs(middle.rate));
        ++tried;
        // A slip is a difference of deformations.
        const double terms = quantities_of(law)[q].unit == "m" ? trial.deformation : std::abs(middle.value);
        const double round_off = 1e-14 * terms;
        if (std::abs(end.value - 2.0 * middle.value + start.value) > 1e-3 * h * largest[q] + round_off) {
          ++beside_corners;
          continue;
        }
        EXPECT_NEAR((end.value - start.value) / (2.0 * h), middle.rate, 2e-3 * largest[q] + round_off / h)
            << quantities_of(law)[q].name << " at d = " << deformation(h) << " m, d' = " << v << " m/s, move " << i;
      }
      if (::testing::Test::HasFailure()) return;
    }
    EXPECT_LT(beside_corners, tried / 5);
  } else {
    EXPECT_EQ(count, 0U);
  }
}

/// The same arguments give the same bits for every former content of the trial state.
template <ForceLaw Law>
void expect_purity(const Law& law, const SpringTrial& trial) {
  using State = typename Law::State;
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  LawPath<Law> path{law, 0};
  RandomMoves moves{trial};
  for (int i = 0; i < trial.moves / 5; ++i) {
    path.move(moves.target(path.deformation()), moves.speed());
    const double d = moves.target(path.deformation()), v = std::copysign(moves.speed(), d - path.deformation());
    const State before = path.state();
    State first{}, second = before, elsewhere{};
    const Response one = path.at(d, v, first);
    static_cast<void>(path.at(moves.target(d), -v, elsewhere));
    const Response two = path.at(d, v, second);
    EXPECT_EQ(bits(one.force), bits(two.force));
    EXPECT_EQ(bits(one.stiffness), bits(two.stiffness));
    EXPECT_EQ(bits(one.damping), bits(two.damping));
    EXPECT_TRUE(first == second);
    EXPECT_TRUE(before == path.state());
    if constexpr (TimeDependentLaw<Law>) {
      // The committed instant again.
      State again{};
      const double force = path.force();
      const Interval none{0.0, path.deformation(), path.rate()};
      EXPECT_NEAR(respond(law, path.state(), path.deformation(), path.rate(), none, again).force, force,
                  1e-9 * (std::abs(force) + 1.0));
      EXPECT_TRUE(again == path.state());
    }
    if (::testing::Test::HasFailure()) return;
  }
}

/// A path in one piece, in ten and in a thousand ends at the same force.
template <ForceLaw Law>
void expect_independence_of_pieces(const Law& law, const SpringTrial& trial) {
  if (trial.pieces == 0.0) return;
  LawPath<Law> whole{law, 0}, ten{law, 0}, thousand{law, 0};
  RandomMoves moves{trial};
  double largest = 0.0;
  for (int i = 0; i < std::max(trial.moves / 16, 4); ++i) {
    const double target = moves.target(whole.deformation()), speed = moves.speed();
    whole.move(target, speed);
    ten.move(target, speed, 10);
    thousand.move(target, speed, 1000);
    largest = std::max(largest, std::abs(whole.force()));
    EXPECT_NEAR(ten.force(), whole.force(), trial.pieces * largest) << "move " << i;
    EXPECT_NEAR(thousand.force(), whole.force(), trial.pieces * largest) << "move " << i;
    if (::testing::Test::HasFailure()) return;
  }
}

template <ForceLaw Law>
void expect_symmetry(const Law& law, const SpringTrial& trial) {
  if (!trial.symmetric) return;
  LawPath<Law> path{law, 0}, mirrored{law, 0};
  RandomMoves moves{trial};
  for (int i = 0; i < 300; ++i) {
    const double target = moves.target(path.deformation()), speed = moves.speed();
    path.move(target, speed);
    mirrored.move(-target, speed);
    EXPECT_NEAR(mirrored.force(), -path.force(), 1e-9 * std::abs(path.force()) + 1e-9) << "move " << i;
    if (::testing::Test::HasFailure()) return;
  }
}

/// All properties above but the energy balance in short steps and the rates of quantities.
template <ForceLaw Law>
void expect_sound_spring(const Law& law, const SpringTrial& trial) {
  expect_tangents(law, trial);
  expect_purity(law, trial);
  expect_energy_balance(law, trial);
  expect_independence_of_pieces(law, trial);
  expect_symmetry(law, trial);
}

}  // namespace moat::testing
