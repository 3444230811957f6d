// Sliders one upon another, under a weight that changes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "materials/series_of_sliders.hpp"

namespace moat {

/// SeriesOfSliders under the weight N of the instant:
///
///     slider i:   F = N/R_i u_i + clamp(k_e (u_i - s_i), +-mu_i N) + stops
///
/// R_i = W/k_i and mu_i = f_i/W are those of the law under its static weight W; k_e and the stiffness of the stops do
/// not change. Where N falls, a slider gives up at once the friction above its limit, and its slip follows. The force
/// is that of the piecewise linear law under the weight at the end of the step. Below W/100 the bearing is light: the
/// force is that of the law under W/100 times N/(W/100), and zero where the bearing lifts, N <= 0. The next corner of a
/// pressed bearing, which moves with N, is located, and so are N = W/100 and N = 0.
struct SeriesUnderWeight {
  static constexpr std::string_view name = "SeriesUnderWeight";
  static constexpr std::size_t most = SeriesOfSliders::most;  ///< Largest number of sliders.

  SeriesOfSliders line;        ///< The law under `static_weight`.
  double static_weight = 0.0;  ///< W > 0 N

  /// How the bearing is loaded.
  enum class Contact : signed char { pressed, light, lifted };
  struct State {
    SeriesOfSliders::State sliders{};                 ///< of the law under N, or under W/100 where it is more
    std::array<double, most> displacements{};         ///< u_i, m
    double compression = 0.0;                         ///< N, of the instant
    std::size_t corner = SeriesOfSliders::no_corner;  ///< the number of the corner of the course
    std::array<bool, most> yields{};                  ///< whether the friction of a slider follows its limit
    /// How the bearing is loaded.
    Contact contact = Contact::pressed;

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr auto quantities = SeriesOfSliders::quantities;

  /// A compression enters the regime margin as this length times its ratio to the static weight, m.
  static constexpr double length_of_weight = 1e-3;

  Response evaluate(const State& committed, double deformation, double, Interval, AxialForce axial,
                    State& trial) const {
    const double compression = std::max(axial.compression, 0.0), weight = acting(compression);
    const SeriesOfSliders law = under(weight);
    const bool is_committed_instant =
        deformation == committed.sliders.deformation && axial.compression == committed.compression;
    const SeriesOfSliders::State& from = committed.sliders;
    trial = committed;
    Course course = from.course;
    if (course.direction == 0 && deformation != from.deformation)
      course = begin(trial, law, from.deformation, deformation > from.deformation ? 1 : -1);
    // From the slips at the start: with those at the end a corner that was passed would never lie behind.
    else if (course.direction != 0 && !is_committed_instant)
      course.corner = law.position(from, committed.corner, course.direction);
    Response response = law.evaluate(from, deformation, 0.0, trial.sliders);
    double flexibility = 0.0, stretch_by_compression = 0.0;
    for (std::size_t i = 0; i < line.count; ++i) {
      const SeriesOfSliders::Branch& branch = law.branches[i];
      const double u = law.displacement(branch, from.slips[i], response.force),
                   friction = law.friction_of(branch, from.slips[i], u);
      trial.yields[i] = is_committed_instant ? committed.yields[i] : std::abs(friction) >= branch.friction;
      // The force of the slider by N at this displacement.
      const double by_weight = spring_force(i, u) / static_weight +
                               (trial.yields[i] ? std::copysign(branch.friction, friction) / weight : 0.0),
                   tangent = law.tangent(branch, u, !trial.yields[i]);
      flexibility += 1.0 / tangent;
      stretch_by_compression += by_weight / tangent;
      trial.displacements[i] = u;
    }
    response.stiffness = 1.0 / flexibility;
    response.by_compression = stretch_by_compression / flexibility;
    if (compression < weight) {
      const double share = compression / weight;
      response = {share * response.force, share * response.stiffness, 0.0,
                  compression > 0.0 ? response.force / weight : 0.0};
      if (compression == 0.0) trial.sliders.slips = trial.displacements;
    }
    trial.compression = axial.compression;
    trial.sliders.course = course;
    if (is_committed_instant) trial = committed;
    return response;
  }
  /// The rate of the force at the instant of a state, N/s. Friction on its limit follows the limit, unless the slider
  /// moves back faster than the limit falls.
  double force_rate(const State& state, double deformation, double rate, double, double compression_rate) const {
    if (state.compression <= 0.0) return 0.0;
    const double weight = acting(state.compression), share = share_of(state);
    const SeriesOfSliders law = under(weight);
    const double weight_rate = share < 1.0 ? 0.0 : compression_rate;
    // A slider has u' = (F' - a)/(k + k_e) where it sticks, and (F' - a - c)/k where it yields, at its limit to the
    // side of its friction. Both are equal at F' = a + c (k + k_e)/k_e.
    struct Slider {
      double stiffness, elastic, of_spring, of_limit;  // k, k_e, a, c
      int side;                                        // of the friction on its limit; 0 within it

      [[nodiscard]] double at_change() const { return of_spring + of_limit * (stiffness + elastic) / elastic; }
      [[nodiscard]] bool yields(double force_rate) const { return side * (force_rate - at_change()) > 0.0; }
    };
    std::array<Slider, most> sliders{};
    for (std::size_t i = 0; i < line.count; ++i) {
      const SeriesOfSliders::Branch& branch = law.branches[i];
      const double u = state.displacements[i], stretch = u - state.sliders.slips[i];
      constexpr double round_off = 1e-9;
      const int side = std::abs(stretch) < law.reach(i) * (1.0 - round_off) ? 0 : stretch < 0.0 ? -1 : 1;
      sliders[i] = {law.tangent(branch, u, false), line.elastic_stiffness,
                    spring_force(i, u) / static_weight * weight_rate, side * branch.friction / weight * weight_rate,
                    side};
    }
    // The sum of all u' grows with F': at that of one slider's change it shows on which side of it F' lies.
    const auto sum_of_rates = [&](double force_rate) {
      double sum = 0.0;
      for (std::size_t i = 0; i < line.count; ++i) {
        const Slider& s = sliders[i];
        sum += s.yields(force_rate) ? (force_rate - s.of_spring - s.of_limit) / s.stiffness
                                    : (force_rate - s.of_spring) / (s.stiffness + s.elastic);
      }
      return sum;
    };
    double flexibility = 0.0, stretch_rate = rate;
    for (std::size_t i = 0; i < line.count; ++i) {
      const Slider& s = sliders[i];
      const bool yields = s.side * (rate - sum_of_rates(s.at_change())) > 0.0;
      const double tangent = s.stiffness + (yields ? 0.0 : s.elastic);
      flexibility += 1.0 / tangent;
      stretch_rate += (s.of_spring + (yields ? s.of_limit : 0.0)) / tangent;
    }
    const double of_share = share < 1.0 ? compression_rate / weight * law.force_at(state.sliders, deformation) : 0.0;
    return share * stretch_rate / flexibility + of_share;
  }
  double stored_energy(const State& committed, double deformation) const {
    double energy = std::max(committed.compression, 0.0) * weight_lever(committed, deformation, committed, deformation);
    for (std::size_t i = 0; i < line.count; ++i) {
      const double friction = friction_of(committed, i),
                   pressed = SeriesOfSliders::beyond(committed.displacements[i], line.branches[i].capacity);
      energy += 0.5 * friction * friction / line.elastic_stiffness + 0.5 * line.stop_stiffness * pressed * pressed;
    }
    return energy;
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    return share_of(committed) *
           under(acting(committed.compression)).dissipation_rate(committed.sliders, deformation, rate);
  }
  /// Mean friction times the change of slip.
  double dissipated_energy(const State& from, const State& to) const {
    double energy = 0.0;
    for (std::size_t i = 0; i < line.count; ++i) {
      const double before = friction_of(from, i), after = friction_of(to, i),
                   slip = to.displacements[i] - from.displacements[i] - (after - before) / line.elastic_stiffness;
      energy += 0.5 * (before + after) * slip;
    }
    return energy;
  }
  double linear_stiffness(StiffnessStage stage) const { return line.linear_stiffness(stage); }
  /// The sum of u_i(from) u_i(to)/(2 R_i), m: the work of a changing compression in a step is (N1 - N0) times it.
  double weight_lever(const State& from, double, const State& to, double) const {
    double lever = 0.0;
    for (std::size_t i = 0; i < line.count; ++i) {
      const double u0 = from.displacements[i], u1 = to.displacements[i], stop = line.branches[i].first_stop;
      lever += 0.5 * line.branches[i].stiffness / static_weight *
               (u0 * u1 + std::copysign(SeriesOfSliders::beyond(u0, stop), u0) *
                              std::copysign(SeriesOfSliders::beyond(u1, stop), u1));
    }
    return lever;
  }

  /// At the instant of a state.
  double regime_margin(const State& state, double deformation, double rate) const {
    const double per_newton = length_of_weight / static_weight, above_light = state.compression - least();
    if (state.contact == Contact::lifted) return -per_newton * state.compression;
    if (state.contact == Contact::light) return per_newton * std::min(state.compression, -above_light);
    return std::min(per_newton * above_light, state.sliders.course.margin(deformation, rate));
  }
  /// The state at the instant of the change.
  State next_regime(const State& committed, double deformation, double rate) const {
    State next = committed;
    next.contact = committed.compression <= 0.0      ? Contact::lifted
                   : committed.compression < least() ? Contact::light
                                                     : Contact::pressed;
    const int before = committed.sliders.course.direction, direction = rate > 0.0 ? 1 : rate < 0.0 ? -1 : before;
    next.sliders.course =
        begin(next, under(acting(committed.compression)), deformation + direction * Course::threshold, direction);
    if (direction != before) next.yields = {};
    return next;
  }
  ReportedValue quantity(std::size_t index, const State& state, double deformation, double rate,
                         double second_rate) const {
    return under(acting(state.compression)).quantity(index, state.sliders, deformation, rate, second_rate);
  }

 private:
  [[nodiscard]] double least() const { return 0.01 * static_weight; }
  [[nodiscard]] double acting(double compression) const { return std::max(compression, least()); }
  // Returns the share of the force of the law under the acting weight.
  [[nodiscard]] double share_of(const State& state) const { return std::clamp(state.compression / least(), 0.0, 1.0); }
  [[nodiscard]] SeriesOfSliders under(double weight) const {
    SeriesOfSliders law = line;
    for (SeriesOfSliders::Branch& branch : law.branches) {
      branch.stiffness *= weight / static_weight;
      branch.friction *= weight / static_weight;
    }
    return law;
  }
  // The force of a slider's curvature under the static weight, N.
  [[nodiscard]] double spring_force(std::size_t i, double u) const {
    const SeriesOfSliders::Branch& branch = line.branches[i];
    return branch.stiffness * (u + std::copysign(SeriesOfSliders::beyond(u, branch.first_stop), u));
  }
  [[nodiscard]] double friction_of(const State& state, std::size_t i) const {
    return share_of(state) * line.elastic_stiffness * (state.displacements[i] - state.sliders.slips[i]);
  }
  // The motion goes in a direction from here on.
  static Course begin(State& state, const SeriesOfSliders& law, double from, int direction) {
    state.corner = direction == 0 ? SeriesOfSliders::no_corner : law.nearest_corner(state.sliders, from, direction);
    return {direction, law.position(state.sliders, state.corner, direction)};
  }
};

}  // namespace moat
