// Contact of two stiffnesses that loses energy by yielding.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "materials/contact/contact_damping.hpp"
#include "materials/response.hpp"

namespace moat {

/// A spring K2 beside a spring K1 - K2 that yields at d_y and pushes only, for indentation d > 0, compression positive:
///
///     F ^       .-'/        F = K2 d + (K1 - K2) (d - s),    0 <= d - s <= d_y,    s = slip of this contact
///       |    .-'  / K1
///       |   /   .'          loads with K1 to d_y, then with K2; unloads with K1 to the line K2 d, then along it;
///       |  / .-'  K2        loads again with K1. The force is zero where the gap opens.
///     --+-/-'-------> d
///
/// All corners are located. Stored energy: that of both springs. Dissipation: (K1 - K2) d_y |ds| while s grows.
struct BilinearContact {
  static constexpr std::string_view name = "BilinearContact";

  double loading_stiffness = 0.0;   ///< K1 > K2, N/m
  double yielding_stiffness = 0.0;  ///< K2 > 0 N/m
  double yield_indentation = 0.0;   ///< d_y > 0 m
  /// K1 - K2 > 0 N/m of a contact, where it depends on the approach speed; a K1 + (1 - a) K2 is the same in each.
  std::optional<ContactDamping> difference{};
  double yield_share = 0.1;  ///< a, of `difference`

  using State = ContactState;

  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"loading_stiffness", loading_stiffness, "N/m"},
            {"yielding_stiffness", yielding_stiffness, "N/m"},
            {"yield_indentation", yield_indentation, "m"}};
  }

  Response evaluate(const State& committed, double indentation, double, State& trial) const {
    trial = committed;
    if (committed.phase != ContactPhase::loaded) return {};
    const Pair k = stiffnesses(committed.damping);
    const double stretch = stretch_of(committed, indentation);
    trial.slip = indentation - stretch;
    return {k.yielding * indentation + (k.loading - k.yielding) * stretch,
            committed.yields == 0 ? k.loading : k.yielding, 0.0};
  }
  double stored_energy(const State& committed, double indentation) const {
    if (committed.phase == ContactPhase::open) return 0.0;
    const Pair k = stiffnesses(committed.damping);
    const double stretch = stretch_of(committed, indentation);
    return 0.5 * k.yielding * indentation * indentation + 0.5 * (k.loading - k.yielding) * stretch * stretch;
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    if (committed.phase != ContactPhase::loaded || committed.yields != 1) return 0.0;
    const Pair k = stiffnesses(committed.damping);
    return (k.loading - k.yielding) * yield_indentation * std::max(rate, 0.0);
  }
  double linear_stiffness(StiffnessStage) const { return 0.0; }

  double regime_margin(const State& committed, double indentation, double rate) const {
    constexpr double time_of_rate = 1.0;  // s: a rate in a margin
    const double contact = contact_margin(committed, indentation, std::numeric_limits<double>::infinity());
    if (committed.phase != ContactPhase::loaded) return contact;
    if (committed.yields != 0) return std::min(contact, committed.yields * rate * time_of_rate);
    const double stretch = indentation - committed.slip;
    return std::min(contact, std::min(yield_indentation - stretch, stretch) + reload_threshold);
  }
  State next_regime(const State& committed, double indentation, double rate) const {
    if (committed.phase != ContactPhase::loaded || indentation <= 0.0)
      return next_contact_state(committed, indentation, rate, difference.value_or(0.0));
    State next = committed;
    const double stretch = stretch_of(committed, indentation);
    next.slip = indentation - stretch;
    next.yields = committed.yields != 0 ? 0 : stretch > 0.5 * yield_indentation ? 1 : -1;
    if (next.yields != 0) next.slip = indentation - stretch_of(next, indentation);
    return next;
  }
  /// Half a period of the stiffer spring, s: pi sqrt(m/K1); m is the effective mass. A contact that yields takes
  /// longer.
  double contact_duration(double effective_mass, double approach_speed) const {
    const double at_touch = difference ? difference->at(approach_speed) : 0.0;
    return std::numbers::pi * std::sqrt(effective_mass / stiffnesses(at_touch).loading);
  }

 private:
  struct Pair {
    double loading, yielding;  // N/m
  };
  // Returns the stiffnesses of a contact with this difference, N/m.
  [[nodiscard]] Pair stiffnesses(double of_contact) const {
    if (!difference) return {loading_stiffness, yielding_stiffness};
    const double effective = yield_share * loading_stiffness + (1.0 - yield_share) * yielding_stiffness;
    return {effective + (1.0 - yield_share) * of_contact, effective - yield_share * of_contact};
  }
  // Returns the stretch of the spring that yields, m.
  [[nodiscard]] double stretch_of(const State& state, double indentation) const {
    if (state.yields == 0) return indentation - state.slip;
    return state.yields > 0 ? yield_indentation : 0.0;
  }
};

}  // namespace moat
