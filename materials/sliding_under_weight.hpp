// A slider under a weight that changes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "materials/sliding_isolator.hpp"

namespace moat {

/// The force of a pendulum or flat slider under an axial force N that changes, of SlidingIsolator where it does not:
///
///     F = (N/R + k_r) d + q,    |q| <= L = mu(|v|, N) N,    s = d - q/k_0
///
/// k_0 comes from the static weight, so that the force of a stuck slider stays when N changes, and the energy
/// q^2/(2 k_0) is free of N.
///
/// - It sticks with q = k_0 (d - s). Where N falls so that |q| would exceed L while the rate does not push on, it
///   sheds: q = +-L, and the slip follows. This is a kink within the regime. If it sheds inside a step alone, the slip
///   is the largest that it needs in it, from the parabola through value and rate at the start and value at the end.
/// - It slides from where |q| reaches L while the rate pushes on to where the rate turns.
/// - It has lifted from where N reaches zero: q = 0, and the slip follows. It lands where N rises through zero again.
///
/// All these instants are located. Tension positive; N is compression.
struct SlidingUnderWeight {
  static constexpr std::string_view name = "SlidingUnderWeight";

  double radius = std::numeric_limits<double>::infinity();  ///< R > 0 m; infinite: flat
  double restoring_stiffness = 0.0;                         ///< k_r >= 0 N/m, of springs beside it
  double elastic_stiffness = 0.0;                           ///< k_0 > 0 N/m
  double static_weight = 0.0;                               ///< > 0 N
  Friction friction;                                        ///< of the surface

  [[nodiscard]] std::vector<Parameter> parameters() const {
    std::vector<Parameter> list = friction.parameters();
    list.push_back({"radius", radius, "m"});
    list.push_back({"restoring_stiffness", restoring_stiffness, "N/m"});
    list.push_back({"elastic_stiffness", elastic_stiffness, "N/m"});
    list.push_back({"static_weight", static_weight, "N"});
    return list;
  }

  /// How the surfaces meet.
  enum class Contact : signed char { slides_back = -1, sticks = 0, slides_on = 1, lifted = 2 };
  struct State {
    double slip = 0.0;            ///< s, m
    double friction_force = 0.0;  ///< q, N
    double compression = 0.0;     ///< N, N
    /// How the surfaces meet.
    Contact contact = Contact::sticks;
    signed char sheds = 0;  ///< sign of q while it sheds; else 0

    friend bool operator==(const State&, const State&) = default;
    /// The direction in which it slides, -1 or +1; 0 where it does not slide.
    [[nodiscard]] int direction() const { return contact == Contact::lifted ? 0 : static_cast<int>(contact); }
  };

  static constexpr std::array<ReportedQuantity, 2> quantities = SlidingIsolator::quantities;

  /// A compression enters the regime margin as this length times its ratio to the static weight, m.
  static constexpr double length_of_weight = 1e-3;

  Response evaluate(const State& committed, double deformation, double rate, Interval interval, AxialForce axial,
                    State& trial) const {
    trial = committed;
    trial.compression = axial.compression;
    trial.sheds = 0;
    if (committed.contact == Contact::lifted || axial.compression <= 0.0) {
      trial.slip = deformation;
      trial.friction_force = 0.0;
      return {restoring_stiffness * deformation, restoring_stiffness, 0.0};
    }
    const double restoring = axial.compression / radius + restoring_stiffness;
    const double by_spring = deformation / radius;
    const int direction = committed.direction();
    if (direction == 0) return stick(committed, deformation, rate, interval, axial, trial);
    const FrictionCoefficient mu = coefficient(direction * rate, axial.compression);
    trial.friction_force = direction * mu.value * axial.compression;
    trial.slip = deformation - trial.friction_force / elastic_stiffness;
    return {restoring * deformation + trial.friction_force, restoring, mu.slope * axial.compression,
            by_spring + direction * (mu.value + mu.by_force * axial.compression)};
  }
  /// The rate of the force at the instant of a state, N/s.
  double force_rate(const State& state, double deformation, double rate, double second_rate,
                    double compression_rate) const {
    if (state.contact == Contact::lifted || state.compression <= 0.0) return restoring_stiffness * rate;
    const double spring =
        (state.compression / radius + restoring_stiffness) * rate + deformation / radius * compression_rate;
    const int direction = state.direction() != 0 ? state.direction() : state.sheds;
    if (direction == 0) return spring + elastic_stiffness * rate;
    const double along = state.sheds != 0 && direction * rate < 0.0 ? -1.0 : 1.0;  // of the speed
    const FrictionCoefficient mu = coefficient(along * direction * rate, state.compression);
    return spring + along * mu.slope * state.compression * second_rate +
           direction * (mu.value + mu.by_force * state.compression) * compression_rate;
  }

  double stored_energy(const State& state, double deformation) const {
    return 0.5 * (std::max(state.compression, 0.0) / radius + restoring_stiffness) * deformation * deformation +
           0.5 * state.friction_force * state.friction_force / elastic_stiffness;
  }
  double dissipation_rate(const State& state, double, double rate) const {
    if (state.direction() * rate <= 0.0) return 0.0;
    return limit(std::abs(rate), state.compression) * std::abs(rate);
  }
  /// Mean q times the change of slip, as of SlidingIsolator. The force that it sheds is dissipated too.
  double dissipated_energy(const State& from, const State& to) const {
    return 0.5 * (from.friction_force + to.friction_force) * (to.slip - from.slip);
  }
  double weight_lever(const State&, double deformation, const State&, double end_deformation) const {
    return 0.5 * deformation * end_deformation / radius;
  }
  double linear_stiffness(StiffnessStage stage) const {
    return static_weight / radius + restoring_stiffness + (stage == StiffnessStage::initial ? elastic_stiffness : 0.0);
  }

  double regime_margin(const State& state, double deformation, double rate) const {
    const double weight = length_of_weight * state.compression / static_weight;
    if (state.contact == Contact::lifted) return -weight;
    const int direction = state.direction();
    if (direction != 0) return std::min(weight, direction * rate * SlidingIsolator::time_of_rate);
    const double strain = deformation - state.slip;
    const double within =
        limit(std::abs(rate), state.compression) / elastic_stiffness * (1.0 + SlidingIsolator::threshold) -
        std::abs(strain);
    // Beyond the limit it slides only where its rate pushes on.
    return std::min(weight, std::max(within, -std::copysign(SlidingIsolator::time_of_rate, strain) * rate));
  }
  State next_regime(const State& state, double deformation, double rate) const {
    State next = state;
    next.sheds = 0;
    if (state.contact == Contact::lifted || state.compression <= 0.0) {
      next.slip = deformation;
      next.friction_force = 0.0;
      next.contact = state.contact != Contact::lifted ? Contact::lifted : sliding(rate);
      return next;
    }
    const bool slid = state.direction() != 0;
    const int direction = slid ? state.direction() : deformation > state.slip ? 1 : -1;
    next.friction_force = direction * limit(slid ? 0.0 : std::abs(rate), state.compression);
    next.slip = deformation - next.friction_force / elastic_stiffness;
    next.contact = slid ? Contact::sticks : sliding(direction);
    return next;
  }

  ReportedValue quantity(std::size_t index, const State& state, double, double rate, double second_rate) const {
    // The rate at the end of a slide may have the other sign by round-off.
    const int direction = state.direction() != 0 ? state.direction() : rate < 0.0 ? -1 : 1;
    const double normal = std::max(state.compression, 0.0);
    const FrictionCoefficient mu = coefficient(direction * rate, normal);
    if (index == 0) return {normal > 0.0 ? mu.value : 0.0, mu.slope * direction * second_rate};
    return {state.slip, state.direction() == 0 ? 0.0 : rate};
  }

 private:
  static Contact sliding(double rate) {
    return rate == 0.0 ? Contact::sticks : rate > 0.0 ? Contact::slides_on : Contact::slides_back;
  }
  [[nodiscard]] double limit(double speed, double compression) const {
    return compression > 0.0 ? coefficient(speed, compression).value * compression : 0.0;
  }
  // Returns the coefficient as SlidingIsolator does.
  [[nodiscard]] FrictionCoefficient coefficient(double speed, double compression) const {
    FrictionCoefficient mu = friction.at(std::max(speed, 0.0), compression);
    if (speed < 0.0) mu.value += mu.slope * speed;
    return mu;
  }

  Response stick(const State& committed, double deformation, double rate, Interval interval, AxialForce axial,
                 State& trial) const {
    const double restoring = axial.compression / radius + restoring_stiffness, flexibility = 1.0 / elastic_stiffness;
    const int o = deformation < committed.slip ? -1 : 1;  // sense of q
    const FrictionCoefficient mu = coefficient(std::abs(rate), axial.compression);
    const double capacity = mu.value * axial.compression, limit_slope = mu.value + mu.by_force * axial.compression;
    const double slip = o * committed.slip, reach = o * deformation - flexibility * capacity;
    // The largest o s that it needs while the rate does not push on: at the end of the step, or inside it.
    double needed = slip, share = 0.0;
    constexpr double round_off = 1e-12;  // of the slip under the limit
    const bool goes_on =
        interval.length == 0.0 && committed.sheds == o && reach >= slip - round_off * flexibility * capacity;
    if (o * rate <= 0.0 && (reach > slip || goes_on)) {
      needed = reach;
      share = 1.0;
    }
    if (interval.length > 0.0 && committed.compression > 0.0) {
      const FrictionCoefficient before = coefficient(std::abs(interval.start_rate), committed.compression);
      const double start = o * interval.start_deformation - flexibility * before.value * committed.compression;
      const double loss = (before.value + before.by_force * committed.compression) * axial.rate_at_start;
      const double rise = interval.length * (o * interval.start_rate - flexibility * loss), change = reach - start;
      // Where the rate turns inside the step it pushes on before or behind that.
      const bool turns = interval.start_rate * rate < 0.0;
      const double turn = turns ? interval.start_rate / (interval.start_rate - rate) : 1.0;
      const double first = o * interval.start_rate <= 0.0 ? 0.0 : turn, last = o * rate <= 0.0 ? 1.0 : turn;
      const double top = std::clamp(rise > change ? 0.5 * rise / (rise - change) : 1.0, first, std::max(first, last));
      const double highest = start + top * (rise + top * (change - rise));
      if (top < 1.0 && highest > needed) {
        needed = highest;
        share = top * top;
      }
    }
    if (share > 0.0) trial.slip = o * needed;
    if (share == 1.0) trial.sheds = static_cast<signed char>(o);
    trial.friction_force = elastic_stiffness * (deformation - trial.slip);
    const double sense_of_rate = rate > 0.0 ? 1.0 : rate < 0.0 ? -1.0 : 0.0;
    return {restoring * deformation + trial.friction_force, restoring + (1.0 - share) * elastic_stiffness,
            share * o * sense_of_rate * mu.slope * axial.compression, deformation / radius + share * o * limit_slope};
  }
};

}  // namespace moat
