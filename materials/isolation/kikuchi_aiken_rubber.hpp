// High-damping rubber of Kikuchi and Aiken.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "base/units.hpp"
#include "materials/course.hpp"
#include "materials/response.hpp"
#include "materials/rubber_compound.hpp"

namespace moat {

/// High-damping rubber bearing whose loops follow from measured properties of its compound over the shear strain.
///
///     g = d/H,   x = g/g_m,   g_m = largest |g| so far,   f_m = G_eq(g_m) g_m          F = A (Q1 + Q2)
///     Q1 = (1 - u) f_m (x + sgn(x) |x|^n)/2                       Q2 = u f_m x on the skeleton, |x| = 1
///     after a reversal at x_i:   Q2 = Q2_i + o alpha_i u f_m (2 - 2 e^(-a X) + b_i X e^(-c X)),   X = |x - x_i|
///
/// o is the direction of motion; alpha_i lets a branch meet the reversal before its own. A branch that passes that
/// reversal continues the one before (Masing), the last one ends on the skeleton. a and b give the loop at g_m the
/// measured damping h_eq: (1 - e^(-2 a))/a = 1 - pi h_eq/(2 u), a at most its limit; b adds the rest at large
/// strain. Below g = 0.05 it is elastic. The compounds hold up to g = 4.1; beyond, the skeleton goes on along its
/// tangent: look at the reported `shear_strain`. 64 reversals are remembered; beyond, the two innermost are forgotten.
///
/// A monotone move is exact for any length of the step; turns and the ends of branches are located. Stored is the
/// energy of Q1 as it is now, the rest counts as dissipated. Source: Kikuchi & Aiken (1997); compounds as in
/// KikuchiAikenHDR of OpenSees.
struct KikuchiAikenRubber {
  static constexpr std::string_view name = "KikuchiAikenRubber";
  static constexpr std::string_view formula =
      "loops from G_eq and h_eq of the compound over the largest strain; Masing";
  static constexpr std::string_view assumption =
      "Fitted up to a shear strain of 4.1; beyond, the skeleton goes on along its tangent.";

  /// The compounds with a fit.
  using Compound = RubberCompound::Kind;

  /// A > 0 m^2: of the rubber.
  Required<decltype(units::m * units::m)> area;
  /// H > 0 m: of all layers of rubber.
  Required<Length> height;
  Compound compound = Compound::x06;  ///< Of this bearing.

  /// A turn of the deformation.
  struct Reversal {
    double x = 0.0, q = 0.0;      ///< q = Q2/f_m
    double alpha = 1.0, b = 0.0;  ///< of the branch that begins here
    friend bool operator==(const Reversal&, const Reversal&) = default;
  };
  static constexpr std::size_t most_reversals = 64;  ///< That are remembered.
  struct State {
    double strain = 0.0, largest = 0.0;            ///< g, g_m
    double heat = 0.0;                             ///< J, dissipated so far
    int direction = 0;                             ///< of motion
    int reversals = 0;                             ///< That are remembered now.
    std::array<Reversal, most_reversals> stack{};  ///< The last on top.
    Course course{};                               ///< Where its next corner lies.

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 2> quantities{
      {{.name = "shear_strain", .unit = "1", .of_deformation = true}, {.name = "fitted_strain_share", .unit = "1"}}};

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
    trial.course = course_of_step(*this, committed, committed.strain * height.si(), moved);
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
    const double modulus = stage == StiffnessStage::initial ? of_rubber().shear_modulus(elastic_strain)
                                                            : of_rubber().shear_modulus(design_strain);
    return modulus * area.si() / height.si();
  }
  ReportedValue quantity(std::size_t index, const State& state, double deformation, double rate, double) const {
    const double strain = deformation / height.si(), strain_rate = rate / height.si();
    if (index == 0) return {strain, strain_rate};
    const bool grows = std::abs(strain) >= state.largest && strain * rate > 0.0;
    return {state.largest / RubberCompound::largest_strain,
            grows ? std::abs(strain_rate) / RubberCompound::largest_strain : 0.0};
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    return committed.course.margin(deformation, rate);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    return next_on_course(*this, committed, deformation, rate);
  }
  /// Where the elastic range or a branch ends, or the fit of the skeleton changes.
  [[nodiscard]] double next_corner(const State& state, double from, int direction) const {
    const double outside = direction * from / height.si();
    const auto beyond = [&](double strain) {
      return direction * (strain > outside ? strain * height.si() : std::numeric_limits<double>::infinity());
    };
    if (state.largest < elastic_strain) return beyond(elastic_strain);
    const bool turns = state.reversals > 0 && direction != state.direction;
    const int left = turns ? before_push(state) + 1 : state.reversals;
    const bool on_skeleton = left == 0 && direction * state.strain >= 0.0;
    if (on_skeleton) return beyond(of_rubber().change_of_fit());
    if (left < 2) return beyond(state.largest);
    return beyond(direction * state.stack[static_cast<std::size_t>(left - 2)].x * state.largest);
  }
  /// The properties of the compound.
  [[nodiscard]] RubberCompound of_rubber() const { return {compound}; }

 private:
  static constexpr double elastic_strain = 0.05;

  struct Properties {
    double f = 0.0, share = 0.0, exponent = 1.0, a = 1.0, b = 0.0, c = 1.0;  // f_m, u, n
  };
  struct Stress {
    double value, slope;  // over the strain
  };

  [[nodiscard]] Properties properties(double largest) const {
    const RubberCompound rubber = of_rubber();
    const double g = std::min(largest, RubberCompound::largest_strain);
    return {.f = rubber.skeleton(largest),
            .share = rubber.hysteretic_share(g),
            .exponent = rubber.elastic_exponent(g),
            .a = rubber.decay(g),
            .b = rubber.second_size(g),
            .c = rubber.second_decay()};
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
      const double modulus = of_rubber().shear_modulus(elastic_strain);
      return {modulus * state.strain, modulus};
    }
    const Properties p = properties(state.largest);
    const double x = state.strain / state.largest;
    if (state.reversals == 0) {
      const double value = std::copysign(of_rubber().skeleton(std::abs(state.strain)), state.strain);
      if (direction * state.strain >= 0.0) return {value, of_rubber().skeleton_slope(std::abs(state.strain))};
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
    if (state.largest < elastic_strain)
      return 0.5 * of_rubber().shear_modulus(elastic_strain) * state.strain * state.strain;
    const Properties p = properties(state.largest);
    const double x = std::abs(state.strain / state.largest);
    return 0.5 * (1.0 - p.share) * p.f * state.largest *
           (0.5 * x * x + std::pow(x, p.exponent + 1.0) / (p.exponent + 1.0));
  }

  // Leads the state to a strain in one direction and returns the integral of the stress.
  double move(State& state, double target, int direction) const {
    double work = 0.0;
    if (state.largest < elastic_strain) {
      const double modulus = of_rubber().shear_modulus(elastic_strain),
                   end = std::clamp(target, -elastic_strain, elastic_strain);
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
    work += of_rubber().skeleton_work(std::abs(state.strain), std::abs(target));
    state.strain = target;
    state.largest = std::max(state.largest, std::abs(target));
    return work;
  }
  // The number of reversals to which another may be added: the two innermost make room.
  static int before_push(const State& state) {
    return state.reversals == static_cast<int>(most_reversals) ? state.reversals - 2 : state.reversals;
  }
  static void push(State& state, const Reversal& reversal) {
    state.reversals = before_push(state);
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
};

}  // namespace moat
