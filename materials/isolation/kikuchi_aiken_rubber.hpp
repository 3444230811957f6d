// High-damping rubber of Kikuchi and Aiken.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "materials/course.hpp"
#include "materials/response.hpp"
#include "materials/rubber_compound.hpp"
#include "materials/rubber_loop.hpp"

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
  Compound compound = Compound::x06;  ///< Compound of this bearing.

  using Reversal = RubberLoop::Reversal;             ///< A turn of the deformation.
  static constexpr std::size_t most_reversals = 64;  ///< More are forgotten.
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
      {{.name = "shear_strain", .unit = "1"}, {.name = "fitted_strain_share", .unit = "1"}}};

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
    const double elastic = loop(committed).elastic(committed.strain / committed.largest).value;
    return area.si() * (stress.value - elastic) * rate;
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

  using Stress = RubberLoop::Stress;

  [[nodiscard]] RubberLoop loop(const State& state) const { return RubberLoop::at(of_rubber(), state.largest); }
  [[nodiscard]] const Reversal& last(const State& state) const {
    return state.stack[static_cast<std::size_t>(state.reversals - 1)];
  }
  [[nodiscard]] Stress stress_of(const State& state, int direction) const {
    if (state.largest < elastic_strain) {
      const double modulus = of_rubber().shear_modulus(elastic_strain);
      return {modulus * state.strain, modulus};
    }
    const RubberLoop loop = this->loop(state);
    const double x = state.strain / state.largest;
    const Stress elastic = loop.elastic(x);
    if (state.reversals == 0) {
      const double size = std::abs(state.strain), value = std::copysign(of_rubber().skeleton(size), state.strain);
      if (direction * state.strain >= 0.0) return {value, of_rubber().skeleton_slope(size)};
      // About to unload.
      return {value, elastic.slope + loop.first_slope({.b = loop.second_size})};
    }
    const Reversal& from = last(state);
    const double q = hysteretic(loop, state), value = elastic.value + loop.skeleton * q;
    // About to turn: the slope of the branch that would begin here.
    if (direction != state.direction && direction != 0)
      return {value, elastic.slope + loop.first_slope(loop.turned(from, x, q))};
    return {value, elastic.slope + from.alpha * loop.share * loop.skeleton *
                                       loop.branch(from.b, std::abs(x - from.x)).slope / state.largest};
  }
  // Q2/f_m.
  [[nodiscard]] double hysteretic(const RubberLoop& loop, const State& state) const {
    const double x = state.strain / state.largest;
    if (state.reversals == 0) return loop.share * x;
    const Reversal& from = last(state);
    return loop.hysteretic(from, x, x > from.x || (x == from.x && state.direction > 0) ? 1 : -1);
  }

  // Energy of the elastic part, over A H.
  [[nodiscard]] double stored(const State& state) const {
    if (state.largest < elastic_strain)
      return 0.5 * of_rubber().shear_modulus(elastic_strain) * state.strain * state.strain;
    return loop(state).elastic_energy(state.strain / state.largest);
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
      const RubberLoop loop = this->loop(state);
      const double x = state.strain < 0.0 ? -1.0 : 1.0;
      push(state, {.x = x, .q = loop.share * x, .alpha = 1.0, .b = loop.second_size});
    } else if (state.reversals > 0 && direction != state.direction) {
      const RubberLoop loop = this->loop(state);
      push(state, loop.turned(last(state), state.strain / state.largest, hysteretic(loop, state)));
    }
    state.direction = direction;
    while (state.reversals > 0) {
      const double end =
          state.reversals == 1 ? direction : state.stack[static_cast<std::size_t>(state.reversals - 2)].x;
      const bool passes = direction * (target / state.largest - end) >= 0.0;
      const double to = passes ? end : target / state.largest;
      work += loop(state).work(last(state), state.strain / state.largest, to);
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
};

}  // namespace moat
