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
/// is that of the piecewise linear law under the weight at the end of the step. Below W/100 it is in proportion to N:
/// zero where the bearing lifts, N <= 0. Corners that move with N are located.
struct SeriesUnderWeight {
  static constexpr std::string_view name = "SeriesUnderWeight";
  static constexpr std::size_t most = SeriesOfSliders::most;  ///< Sliders, at most.

  SeriesOfSliders line;        ///< The law under `static_weight`.
  double static_weight = 0.0;  ///< W > 0 N

  struct State {
    SeriesOfSliders::State sliders{};                 ///< slips and deformation
    std::array<double, most> displacements{};         ///< u_i, m
    double compression = 0.0;                         ///< N, of the instant
    int direction = 0;                                ///< of the motion, -1 or +1; 0 before it has begun
    std::size_t corner = SeriesOfSliders::no_corner;  ///< the next one in this direction

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr auto quantities = SeriesOfSliders::quantities;

  Response evaluate(const State& committed, double deformation, double, Interval, AxialForce axial,
                    State& trial) const {
    const double compression = std::max(axial.compression, 0.0), weight = acting(compression);
    const SeriesOfSliders law = under(weight);
    SeriesOfSliders::State from = committed.sliders;
    trial = committed;
    if (committed.direction == 0 && deformation != from.deformation)
      begin(trial, law, from.deformation, deformation > from.deformation ? 1 : -1);
    std::array<bool, most> sheds{};
    for (std::size_t i = 0; i < line.count; ++i) {
      const double stretch = committed.displacements[i] - from.slips[i], reach = law.reach(i);
      sheds[i] = weight < committed.compression && std::abs(stretch) > reach;
      if (sheds[i]) from.slips[i] = committed.displacements[i] - std::copysign(reach, stretch);
    }
    Response response = law.evaluate(from, deformation, 0.0, trial.sliders);
    for (std::size_t i = 0; i < line.count; ++i) {
      const SeriesOfSliders::Branch& branch = law.branches[i];
      const double u = law.displacement(branch, from.slips[i], response.force),
                   friction = law.friction_of(branch, from.slips[i], u);
      const bool slides = std::abs(friction) >= branch.friction;
      // The force of the slider by N at this displacement.
      double by_weight =
          branch.stiffness / weight * (u + std::copysign(SeriesOfSliders::beyond(u, branch.first_stop), u));
      if (slides)
        by_weight += std::copysign(branch.friction, friction) / weight;
      else if (sheds[i])
        by_weight += std::copysign(branch.friction, committed.displacements[i] - committed.sliders.slips[i]) / weight;
      response.by_compression += response.stiffness / law.tangent(branch, from.slips[i], u) * by_weight;
      trial.displacements[i] = u;
    }
    if (compression < weight) {
      const double share = compression / weight;
      response = {share * response.force, share * response.stiffness, 0.0,
                  compression > 0.0 ? response.force / weight : 0.0};
      for (std::size_t i = 0; i < line.count; ++i)
        trial.sliders.slips[i] += (1.0 - share) * (trial.displacements[i] - trial.sliders.slips[i]);
    }
    trial.compression = axial.compression;
    // The committed instant again.
    if (deformation == committed.sliders.deformation && axial.compression == committed.compression) trial = committed;
    return response;
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
    return committed.compression > 0.0
               ? under(acting(committed.compression)).dissipation_rate(committed.sliders, deformation, rate)
               : 0.0;
  }
  /// Mean friction times the change of slip.
  double dissipated_energy(const State& from, const State& to) const {
    double energy = 0.0;
    for (std::size_t i = 0; i < line.count; ++i)
      energy += 0.5 * (friction_of(from, i) + friction_of(to, i)) * (to.sliders.slips[i] - from.sliders.slips[i]);
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

  double regime_margin(const State& committed, double deformation, double rate, AxialForce axial) const {
    const SeriesOfSliders law = under(acting(axial.compression));
    State at = committed;
    if (at.direction == 0) begin(at, law, at.sliders.deformation, rate < 0.0 ? -1 : 1);
    return Course{at.direction, law.position(at.sliders, at.corner, at.direction)}.margin(deformation, rate);
  }
  /// The state at the instant of the change.
  State next_regime(const State& committed, double deformation, double rate) const {
    State next = committed;
    const int direction = rate > 0.0 ? 1 : rate < 0.0 ? -1 : committed.direction;
    begin(next, under(acting(committed.compression)), deformation + direction * Course::threshold, direction);
    return next;
  }
  ReportedValue quantity(std::size_t index, const State& state, double deformation, double rate,
                         double second_rate) const {
    return under(acting(state.compression)).quantity(index, state.sliders, deformation, rate, second_rate);
  }

 private:
  [[nodiscard]] double acting(double compression) const { return std::max(compression, 0.01 * static_weight); }
  [[nodiscard]] SeriesOfSliders under(double weight) const {
    SeriesOfSliders law = line;
    for (SeriesOfSliders::Branch& branch : law.branches) {
      branch.stiffness *= weight / static_weight;
      branch.friction *= weight / static_weight;
    }
    return law;
  }
  [[nodiscard]] double friction_of(const State& state, std::size_t i) const {
    return line.elastic_stiffness * (state.displacements[i] - state.sliders.slips[i]);
  }
  // The motion goes in a direction from here on.
  static void begin(State& state, const SeriesOfSliders& law, double from, int direction) {
    state.direction = direction;
    state.corner = law.nearest_corner(state.sliders, from, direction);
  }
};

}  // namespace moat
