// High-damping rubber of Kikuchi and Aiken.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "base/units.hpp"
#include "materials/response.hpp"

namespace moat {

/// High-damping rubber bearing whose loops follow from measured properties of its compound over the shear strain.
///
///     g = d/H,   x = g/g_m,   g_m = largest |g| so far,   f_m = G_eq(g_m) g_m          F = A (Q1 + Q2)
///     Q1 = (1 - u) f_m (x + sgn(x) |x|^n)/2                       Q2 = u f_m x on the skeleton, |x| = 1
///     after a reversal at x_i:   Q2 = Q2_i + o alpha_i u f_m (2 - 2 e^(-a X) + b_i X e^(-c X)),   X = |x - x_i|
///
/// o is the direction of motion; alpha_i lets a branch meet the reversal before its own. A branch that passes that
/// reversal continues the one before (Masing), the last one ends on the skeleton. a and b give the loop at g_m the
/// measured damping h_eq: (1 - e^(-2 a))/a = 1 - pi h_eq/(2 u), a at most its limit; b adds what that leaves at large
/// strain. Below g = 0.05 it is elastic. The compounds hold up to g = 4.1; beyond, the skeleton goes on along its
/// tangent: look at the reported `shear_strain`. 64 reversals are remembered; beyond, the two innermost are forgotten.
///
/// A monotone move is exact for any length of the step. Stored is the energy of Q1 as it is now, the rest counts as
/// dissipated. Source: Kikuchi & Aiken (1997); compounds as in KikuchiAikenHDR of OpenSees.
struct KikuchiAikenRubber {
  static constexpr std::string_view name = "KikuchiAikenRubber";
  static constexpr std::string_view formula =
      "loops from G_eq and h_eq of the compound over the largest strain; Masing";

  enum class Compound : int {
    x06,  ///< Bridgestone X0.6
    x04,  ///< Bridgestone X0.4
  };

  /// A > 0 m^2: of the rubber.
  Required<decltype(units::m * units::m)> area;
  /// H > 0 m: of all layers of rubber.
  Required<Length> height;
  Compound compound = Compound::x06;

  struct Reversal {
    double x = 0.0, q = 0.0;      ///< q = Q2/f_m
    double alpha = 1.0, b = 0.0;  ///< of the branch that begins here
    friend bool operator==(const Reversal&, const Reversal&) = default;
  };
  static constexpr std::size_t most_reversals = 64;
  struct State {
    double strain = 0.0, largest = 0.0;  ///< g, g_m
    double heat = 0.0;                   ///< J, dissipated so far
    int direction = 0;                   ///< of motion
    int reversals = 0;
    std::array<Reversal, most_reversals> stack{};

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 1> quantities{{{"shear_strain", "1"}}};

  /// A bearing of 0.5 m2 with 20 cm of rubber.
  static KikuchiAikenRubber typical() {
    using namespace units;
    return {.area = 0.5 * m * m, .height = 20 * cm};
  }

  void check(const Check& check) const {
    check.positive("area", area.si(), "m^2");
    check.positive("height", height);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"area", area.si(), "m^2"},
            {"height", height.si(), "m"},
            {"compound", compound == Compound::x06 ? 0.6 : 0.4, "1"}};
  }

  Response evaluate(const State& committed, double deformation, double rate, State& trial) const {
    const double target = deformation / height.si(), moved = target - committed.strain;
    const int direction = moved > 0.0 || (moved == 0.0 && rate > 0.0) ? 1 : -1;
    trial = committed;
    double work = 0.0;  // integral of the stress over the strain, N/m^2
    if (moved != 0.0) {
      work = move(trial, target, direction);
      trial.heat += area.si() * height.si() * (work + stored(committed) - stored(trial));
    }
    const Stress stress = stress_of(trial, direction);
    return {area.si() * stress.value, area.si() / height.si() * stress.slope, 0.0};
  }
  double stored_energy(const State& committed, double) const { return area.si() * height.si() * stored(committed); }
  double dissipation_rate(const State& committed, double, double rate) const {
    if (committed.largest < elastic_strain) return 0.0;
    const Stress stress = stress_of(committed, committed.direction);
    const Properties p = properties(committed.largest);
    return area.si() * (stress.value - elastic_part(p, committed.strain / committed.largest).value) * rate;
  }
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const {
    constexpr double design_strain = 1.0;
    const double modulus =
        stage == StiffnessStage::initial ? shear_modulus(elastic_strain) : shear_modulus(design_strain);
    return modulus * area.si() / height.si();
  }
  double quantity(std::size_t, const State& state, double, double) const { return state.strain; }

  /// Of the compound at a strain > 0: G_eq N/m^2, h_eq, u.
  [[nodiscard]] double shear_modulus(double g) const {
    if (g > largest_strain) return skeleton(g) / g;
    const double mega =
        compound == Compound::x06
            ? (g < 1.15 ? 0.68358 * std::pow(g, -0.39964) : 1.10103 + g * (-0.61946 + g * (0.22047 - 0.022191 * g)))
            : (g < 2.0 ? 0.38073 * std::pow(g, -0.42052) : 0.46499 + g * (-0.12723 + 0.0184823 * g));
    return 1e6 * mega;
  }
  [[nodiscard]] double damping_ratio(double g) const {
    g = std::min(g, largest_strain);
    return compound == Compound::x06 ? 0.23834 + g * (-0.028108 + 8.7664e-5 * g)
                                     : 0.22184 + g * (0.0059574 + g * (-0.0072693 + 0.0014267 * g));
  }
  [[nodiscard]] double hysteretic_share(double g) const {
    g = std::min(g, largest_strain);
    return compound == Compound::x06 ? 0.44236 + g * (-0.062943 - 0.0037571 * g)
                                     : 0.42715 + g * (-0.041644 + g * (0.0070867 - 0.0019158 * g));
  }
  /// a of the branches, at the largest strain g.
  [[nodiscard]] double decay(double g) const {
    const double limit = compound == Compound::x06 ? 10.19171 : 12.5603;
    const double share = hysteretic_share(g), ratio = 1.0 - std::numbers::pi * damping_ratio(g) / (2.0 * share);
    if (ratio <= -std::expm1(-2.0 * limit) / limit) return limit;
    // (1 - e^(-2a))/a falls from 2 to 0: Newton's method from its large-a limit, bounded.
    double a = std::min(1.0 / ratio, limit);
    constexpr int most_iterations = 50;
    for (int i = 0; i < most_iterations; ++i) {
      const double value = -std::expm1(-2.0 * a) / a, slope = (2.0 * std::exp(-2.0 * a) - value) / a;
      const double next = std::clamp(a - (value - ratio) / slope, 0.1 * a, limit);
      const bool settled = std::abs(next - a) < 1e-15 * a;
      a = next;
      if (settled) break;
    }
    return a;
  }

 private:
  static constexpr double elastic_strain = 0.05, largest_strain = 4.1;

  struct Properties {
    double f = 0.0, share = 0.0, exponent = 1.0, a = 1.0, b = 0.0, c = 1.0;  // f_m, u, n
  };
  struct Stress {
    double value, slope;  // over the strain
  };

  [[nodiscard]] double skeleton(double g) const {
    if (g > largest_strain) {
      return shear_modulus(largest_strain) * largest_strain + skeleton_slope(largest_strain) * (g - largest_strain);
    }
    return shear_modulus(g) * g;
  }
  [[nodiscard]] double skeleton_slope(double g) const {
    g = std::min(g, largest_strain);
    if (compound == Compound::x06)
      return 1e6 * (g < 1.15 ? 0.60036 * 0.68358 * std::pow(g, -0.39964)
                             : 1.10103 + g * (-2.0 * 0.61946 + g * (3.0 * 0.22047 - 4.0 * 0.022191 * g)));
    return 1e6 *
           (g < 2.0 ? 0.57948 * 0.38073 * std::pow(g, -0.42052) : 0.46499 + g * (-2.0 * 0.12723 + 3.0 * 0.0184823 * g));
  }
  [[nodiscard]] Properties properties(double largest) const {
    const double g = std::min(largest, largest_strain);
    Properties p;
    p.f = skeleton(largest);
    p.share = hysteretic_share(g);
    p.a = decay(g);
    const bool x06 = compound == Compound::x06;
    p.c = x06 ? 5.0 : 5.5;
    if (x06)
      p.exponent = g < 1.5 ? 1.0 : 0.91173 + g * (-0.59184 + 0.43379 * g);
    else
      p.exponent = g < 2.0 ? 1.0 : 0.20924 + 0.39538 * g;
    if (g > (x06 ? 1.4 : 1.5))
      p.b = p.c * p.c * (std::numbers::pi * damping_ratio(g) / p.share - (2.0 + 2.0 / p.a * std::expm1(-2.0 * p.a)));
    return p;
  }
  // Q1 and its slope over the strain times g_m.
  static Stress elastic_part(const Properties& p, double x) {
    const double size = std::abs(x);
    return {0.5 * (1.0 - p.share) * p.f * (x + std::copysign(std::pow(size, p.exponent), x)),
            0.5 * (1.0 - p.share) * p.f * (1.0 + p.exponent * std::pow(size, p.exponent - 1.0))};
  }
  // Of a branch at the distance X from its reversal, over alpha u f_m: value, slope and integral.
  struct Shape {
    double value, slope, integral;
  };
  static Shape shape(const Properties& p, double b, double distance) {
    const double first = std::exp(-p.a * distance), second = std::exp(-p.c * distance);
    return {2.0 - 2.0 * first + b * distance * second, 2.0 * p.a * first + b * (1.0 - p.c * distance) * second,
            2.0 * distance + 2.0 / p.a * (first - 1.0) +
                b * (1.0 / (p.c * p.c) - second * (distance / p.c + 1.0 / (p.c * p.c)))};
  }

  [[nodiscard]] const Reversal& last(const State& state) const {
    return state.stack[static_cast<std::size_t>(state.reversals - 1)];
  }
  [[nodiscard]] Stress stress_of(const State& state, int direction) const {
    if (state.largest < elastic_strain) {
      const double modulus = shear_modulus(elastic_strain);
      return {modulus * state.strain, modulus};
    }
    const Properties p = properties(state.largest);
    const double x = state.strain / state.largest;
    if (state.reversals == 0) {
      const double value = std::copysign(skeleton(std::abs(state.strain)), state.strain);
      if (direction * state.strain >= 0.0) return {value, skeleton_slope(std::abs(state.strain))};
      // About to unload.
      return {value, (elastic_part(p, x).slope + p.share * p.f * shape(p, p.b, 0.0).slope) / state.largest};
    }
    const Reversal& from = last(state);
    const Shape branch = shape(p, from.b, std::abs(x - from.x));
    const Stress elastic = elastic_part(p, x);
    const double size = from.alpha * p.share * p.f;
    if (direction != state.direction && direction != 0) {
      // About to turn: the slope of the branch that would begin here.
      const Reversal next = turned(p, from, x, hysteretic(p, state));
      return {elastic.value + p.f * next.q,
              (elastic.slope + next.alpha * p.share * p.f * shape(p, next.b, 0.0).slope) / state.largest};
    }
    return {elastic.value + p.f * hysteretic(p, state), (elastic.slope + size * branch.slope) / state.largest};
  }
  // Q2/f_m.
  [[nodiscard]] double hysteretic(const Properties& p, const State& state) const {
    const double x = state.strain / state.largest;
    if (state.reversals == 0) return p.share * x;
    const Reversal& from = last(state);
    const int along = x > from.x || (x == from.x && state.direction > 0) ? 1 : -1;
    return from.q + along * from.alpha * p.share * shape(p, from.b, std::abs(x - from.x)).value;
  }
  static Reversal turned(const Properties& p, const Reversal& before, double x, double q) {
    Reversal next{.x = x, .q = q, .b = before.b};
    if (before.x * x >= 0.0) next.b = 0.0;
    const double distance = std::abs(before.x - x);
    if (distance == 0.0) {
      next.alpha = before.alpha;
      return next;
    }
    next.alpha = before.alpha * shape(p, before.b, distance).value / shape(p, next.b, distance).value;
    return next;
  }

  // Energy of the elastic part, over A H.
  [[nodiscard]] double stored(const State& state) const {
    if (state.largest < elastic_strain) return 0.5 * shear_modulus(elastic_strain) * state.strain * state.strain;
    const Properties p = properties(state.largest);
    const double x = std::abs(state.strain / state.largest);
    return 0.5 * (1.0 - p.share) * p.f * state.largest *
           (0.5 * x * x + std::pow(x, p.exponent + 1.0) / (p.exponent + 1.0));
  }

  // Leads the state to a strain in one direction and returns the integral of the stress.
  double move(State& state, double target, int direction) const {
    double work = 0.0;
    if (state.largest < elastic_strain) {
      const double modulus = shear_modulus(elastic_strain), end = std::clamp(target, -elastic_strain, elastic_strain);
      work += 0.5 * modulus * (end * end - state.strain * state.strain);
      state.strain = end;
      state.largest = std::max(state.largest, std::abs(end));
      state.direction = direction;
      if (end == target) return work;
      state.largest = elastic_strain;
    }
    if (state.reversals == 0 && direction * state.strain < 0.0) {
      const Properties p = properties(state.largest);
      const double x = state.strain < 0.0 ? -1.0 : 1.0;
      push(state, {.x = x, .q = p.share * x, .alpha = 1.0, .b = p.b});
    } else if (state.reversals > 0 && direction != state.direction) {
      const Properties p = properties(state.largest);
      push(state, turned(p, last(state), state.strain / state.largest, hysteretic(p, state)));
    }
    state.direction = direction;
    while (state.reversals > 0) {
      const Properties p = properties(state.largest);
      const double end =
          state.reversals == 1 ? direction : state.stack[static_cast<std::size_t>(state.reversals - 2)].x;
      const bool passes = direction * (target / state.largest - end) >= 0.0;
      const double to = passes ? end : target / state.largest;
      work += branch_work(p, state, to);
      state.strain = passes ? end * state.largest : target;
      if (!passes) return work;
      state.reversals = state.reversals > 2 ? state.reversals - 2 : 0;
    }
    work += skeleton_work(std::abs(state.strain), std::abs(target));
    state.strain = target;
    state.largest = std::max(state.largest, std::abs(target));
    return work;
  }
  static void push(State& state, const Reversal& reversal) {
    // The two innermost reversals make room.
    if (state.reversals == static_cast<int>(most_reversals)) state.reversals -= 2;
    state.stack[static_cast<std::size_t>(state.reversals++)] = reversal;
  }
  [[nodiscard]] double branch_work(const Properties& p, const State& state, double to) const {
    const Reversal& from = last(state);
    const double start = state.strain / state.largest;
    const auto elastic = [&](double x) {
      const double size = std::abs(x);
      return 0.5 * (1.0 - p.share) * p.f * (0.5 * size * size + std::pow(size, p.exponent + 1.0) / (p.exponent + 1.0));
    };
    const double hysteretic = p.f * (from.q * (to - start) + from.alpha * p.share *
                                                                 (shape(p, from.b, std::abs(to - from.x)).integral -
                                                                  shape(p, from.b, std::abs(start - from.x)).integral));
    return state.largest * (elastic(to) - elastic(start) + hysteretic);
  }
  // The integral of the skeleton, in parts where the fit of the compound changes.
  [[nodiscard]] double skeleton_work(double from, double to) const {
    const bool x06 = compound == Compound::x06;
    const double change = x06 ? 1.15 : 2.0;
    const auto power = [&](double g) {
      return 1e6 * (x06 ? 0.68358 * std::pow(g, 1.60036) / 1.60036 : 0.38073 * std::pow(g, 1.57948) / 1.57948);
    };
    const auto polynomial = [&](double g) {
      return 1e6 * g * g *
             (x06 ? 1.10103 / 2.0 + g * (-0.61946 / 3.0 + g * (0.22047 / 4.0 - 0.022191 / 5.0 * g))
                  : 0.46499 / 2.0 + g * (-0.12723 / 3.0 + 0.0184823 / 4.0 * g));
    };
    double sum = 0.0;
    if (from < change) sum += power(std::min(to, change)) - power(from);
    if (to > change && from < largest_strain)
      sum += polynomial(std::min(to, largest_strain)) - polynomial(std::max(from, change));
    if (to > largest_strain) {
      const double start = std::max(from, largest_strain);
      sum += 0.5 * (skeleton(start) + skeleton(to)) * (to - start);
    }
    return sum;
  }
};

}  // namespace moat
