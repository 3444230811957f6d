// Sliders one upon another: the law of double and triple pendulums.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "materials/course.hpp"
#include "materials/response.hpp"

namespace moat {

/// Up to three sliders in series, which carry the same force F; the deformation is the sum of their displacements.
///
///     branch i:   F = k_i u_i + clamp(k_e (u_i - s_i), +-f_i) + k_i (|u_i| - p_i) sgn u_i beyond p_i
///                                                           + k_stop (|u_i| - b_i) sgn u_i beyond the capacity b_i
///
/// Beyond p_i one of two equal surfaces of a branch is at its stop, and the other one moves on.
/// The displacement of every branch is a monotone, piecewise linear function of F, and so is their sum: the force
/// follows from the corners without iteration. Stored energy is that of the springs, dissipation the sum of f_i |ds_i|.
/// Both are exact for any length of a monotone step. Turns and all corners are located. Tension positive.
struct SeriesOfSliders {
  static constexpr std::string_view name = "SeriesOfSliders";
  static constexpr std::size_t most = 3;  ///< Largest number of branches.

  /// One slider: a spring beside friction, with a stop.
  struct Branch {
    double stiffness = 0.0;                                       ///< k_i > 0 N/m
    double friction = 0.0;                                        ///< f_i > 0 N
    double capacity = std::numeric_limits<double>::infinity();    ///< b_i > 0 m
    double first_stop = std::numeric_limits<double>::infinity();  ///< p_i > 0 m
  };
  std::array<Branch, most> branches{};  ///< the first `count` of them exist
  std::size_t count = 0;                ///< 1 to most
  double elastic_stiffness = 0.0;       ///< k_e > 0 N/m, of every branch
  double stop_stiffness = 0.0;          ///< k_stop > 0 N/m

  struct State {
    std::array<double, most> slips{};  ///< s_i, m
    double deformation = 0.0;          ///< m
    Course course{};                   ///< turns of the deformation

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, most> quantities{
      {{"first_surface_slip", "m"}, {"second_surface_slip", "m"}, {"third_surface_slip", "m"}}};

  Response evaluate(const State& committed, double deformation, double, State& trial) const {
    const double force = force_at(committed, deformation);
    double flexibility = 0.0;
    trial = committed;
    trial.deformation = deformation;
    trial.course = course_of_step(*this, committed, committed.deformation, deformation - committed.deformation);
    for (std::size_t i = 0; i < count; ++i) {
      const double u = displacement(branches[i], committed.slips[i], force);
      flexibility += 1.0 / tangent(branches[i], committed.slips[i], u);
      trial.slips[i] = u - friction_of(branches[i], committed.slips[i], u) / elastic_stiffness;
    }
    return {force, 1.0 / flexibility, 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    const double force = force_at(committed, deformation);
    double energy = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const Branch& branch = branches[i];
      const double u = displacement(branch, committed.slips[i], force),
                   friction = friction_of(branch, committed.slips[i], u), alone = beyond(u, branch.first_stop),
                   pressed = beyond(u, branch.capacity);
      energy += 0.5 * branch.stiffness * (u * u + alone * alone) + 0.5 * friction * friction / elastic_stiffness +
                0.5 * stop_stiffness * pressed * pressed;
    }
    return energy;
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    const std::array<double, most> slip_rates = slip_rates_at(committed, deformation, rate);
    double power = 0.0;
    for (std::size_t i = 0; i < count; ++i) power += branches[i].friction * std::abs(slip_rates[i]);
    return power;
  }
  double dissipated_energy(const State& from, const State& to) const {
    double energy = 0.0;
    for (std::size_t i = 0; i < count; ++i) energy += branches[i].friction * std::abs(to.slips[i] - from.slips[i]);
    return energy;
  }
  double linear_stiffness(StiffnessStage stage) const {
    double flexibility = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      flexibility += 1.0 / (branches[i].stiffness + (stage == StiffnessStage::initial ? elastic_stiffness : 0.0));
    return 1.0 / flexibility;
  }
  double regime_margin(const State& committed, double deformation, double rate) const {
    return committed.course.margin(deformation, rate);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    return next_on_course(*this, committed, deformation, rate);
  }
  /// Where a branch begins to slide or reaches its stop.
  [[nodiscard]] double next_corner(const State& state, double from, int direction) const {
    return position(state, nearest_corner(state, from, direction), direction);
  }
  ReportedValue quantity(std::size_t index, const State& state, double deformation, double rate, double) const {
    return {state.slips[index], slip_rates_at(state, deformation, rate)[index]};
  }

 private:
  friend struct SeriesUnderWeight;

  static constexpr std::size_t corners_per_branch = 6, no_corner = most * corners_per_branch;
  // The number of the next corner beyond a deformation; none if there is none.
  [[nodiscard]] std::size_t nearest_corner(const State& state, double from, int direction) const {
    std::size_t nearest = no_corner;
    for (std::size_t corner = 0; corner < count * corners_per_branch; ++corner) {
      const double at = position(state, corner, direction);
      if (direction * (at - from) > 0.0 && direction * (position(state, nearest, direction) - at) > 0.0)
        nearest = corner;
    }
    return nearest;
  }
  // The deformation at a corner; infinite in this direction without one.
  [[nodiscard]] double position(const State& state, std::size_t corner, int direction) const {
    const std::size_t i = corner / corners_per_branch;
    const double u = i < count ? corners(branches[i], state.slips[i])[corner % corners_per_branch]
                               : std::numeric_limits<double>::infinity();
    return std::isfinite(u) ? sum_of_displacements(state, force_of(branches[i], state.slips[i], u))
                            : direction * std::numeric_limits<double>::infinity();
  }
  // How far a branch moves before it slides, m.
  [[nodiscard]] double reach(std::size_t i) const { return branches[i].friction / elastic_stiffness; }
  // How far a displacement passes a stop on either side, m.
  static double beyond(double u, double stop) { return std::max(std::abs(u) - stop, 0.0); }
  [[nodiscard]] double friction_of(const Branch& branch, double slip, double u) const {
    return std::clamp(elastic_stiffness * (u - slip), -branch.friction, branch.friction);
  }
  [[nodiscard]] double force_of(const Branch& branch, double slip, double u) const {
    const double of_stops =
        branch.stiffness * beyond(u, branch.first_stop) + stop_stiffness * beyond(u, branch.capacity);
    return branch.stiffness * u + friction_of(branch, slip, u) + std::copysign(of_stops, u);
  }
  [[nodiscard]] double tangent(const Branch& branch, double slip, double u) const {
    return tangent(branch, u, elastic_stiffness * std::abs(u - slip) < branch.friction);
  }
  [[nodiscard]] double tangent(const Branch& branch, double u, bool sticks) const {
    return branch.stiffness + (sticks ? elastic_stiffness : 0.0) +
           (std::abs(u) > branch.first_stop ? branch.stiffness : 0.0) +
           (std::abs(u) > branch.capacity ? stop_stiffness : 0.0);
  }
  // At a rate of the deformation, m/s.
  [[nodiscard]] std::array<double, most> slip_rates_at(const State& state, double deformation, double rate) const {
    const double force = force_at(state, deformation);
    std::array<double, most> slip_rates{};
    double flexibility = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const Branch& branch = branches[i];
      const double u = displacement(branch, state.slips[i], force), stretch = u - state.slips[i];
      const bool slides =
          elastic_stiffness * std::abs(stretch) >= branch.friction * (1.0 - 1e-12) && stretch * rate > 0.0;
      const double k = tangent(branch, u, !slides);
      flexibility += 1.0 / k;
      if (slides) slip_rates[i] = rate / k;
    }
    for (double& slip_rate : slip_rates) slip_rate /= flexibility;
    return slip_rates;
  }
  // The displacements at which a branch changes its stiffness.
  [[nodiscard]] std::array<double, corners_per_branch> corners(const Branch& branch, double slip) const {
    const double reach = branch.friction / elastic_stiffness;
    return {slip - reach, slip + reach, -branch.first_stop, branch.first_stop, -branch.capacity, branch.capacity};
  }
  // Returns the displacement of one branch under a force.
  [[nodiscard]] double displacement(const Branch& branch, double slip, double force) const {
    auto list = corners(branch, slip);
    std::ranges::sort(list);
    double below = -std::numeric_limits<double>::infinity(), above = -below;
    for (const double corner : list) {
      if (!std::isfinite(corner)) continue;
      if (force_of(branch, slip, corner) <= force)
        below = corner;
      else {
        above = corner;
        break;
      }
    }
    // On the segment between two corners the force is linear.
    const double from = std::isfinite(below) ? below : above;
    const double inside =
        std::isfinite(below) ? (std::isfinite(above) ? 0.5 * (below + above) : below + 1.0) : above - 1.0;
    return from + (force - force_of(branch, slip, from)) / tangent(branch, slip, inside);
  }
  [[nodiscard]] double sum_of_displacements(const State& state, double force) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += displacement(branches[i], state.slips[i], force);
    return sum;
  }
  // The force at which the displacements add up to the deformation.
  [[nodiscard]] double force_at(const State& state, double deformation) const {
    std::array<double, most * corners_per_branch> forces{};
    std::size_t used = 0;
    for (std::size_t i = 0; i < count; ++i)
      for (const double corner : corners(branches[i], state.slips[i]))
        if (std::isfinite(corner)) forces[used++] = force_of(branches[i], state.slips[i], corner);
    const auto end = forces.begin() + static_cast<std::ptrdiff_t>(used);
    std::sort(forces.begin(), end);
    const auto above = std::partition_point(
        forces.begin(), end, [&](double force) { return sum_of_displacements(state, force) <= deformation; });
    const bool has_below = above != forces.begin(), has_above = above != end;
    const double from = has_below ? *(above - 1) : *above;
    const double inside =
        has_below ? (has_above ? 0.5 * (from + *above) : from + 1.0 + std::abs(from)) : from - 1.0 - std::abs(from);
    double flexibility = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      flexibility += 1.0 / tangent(branches[i], state.slips[i], displacement(branches[i], state.slips[i], inside));
    return from + (deformation - sum_of_displacements(state, from)) / flexibility;
  }
};

}  // namespace moat
