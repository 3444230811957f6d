// Impact laws with a changed stiffness and restitution.
//
// A law of a script takes part by its fields `stiffness` and `restitution`. A law with other parameters has functions
// of these names of its own, which a call finds beside it.
#pragma once

#include <concepts>
#include <optional>

#include "materials/contact/restitution.hpp"

namespace moat {

/// Returns e + change, at least 0.001 and at most 1, of a number or of a Restitution; an e outside that range limits it
/// in place of them.
template <class Value>
auto changed_restitution(const Value& restitution, double change) {
  if constexpr (std::convertible_to<const Value&, double>)
    return shifted_restitution(restitution, change);
  else
    return static_cast<const Restitution&>(restitution).changed_by(change);
}

/// A law whose field `stiffness` can be multiplied.
template <class Law>
concept HasStiffness = requires(Law law) {
  law.stiffness = 2.0 * law.stiffness;
};

/// A law whose field `restitution` can be changed.
template <class Law>
concept HasRestitution = requires(Law law) {
  law.restitution = changed_restitution(law.restitution, 0.1);
};

/// Returns whether with_stiffness_factor() changes the law.
template <class Law>
bool has_stiffness(const Law&) {
  return HasStiffness<Law>;
}

/// Returns the restitution at 1 m/s that with_restitution_change() changes; nothing where the law has none.
template <class Law>
std::optional<double> restitution_of_law(const Law& law) {
  if constexpr (HasRestitution<Law>) {
    const Restitution& restitution = law.restitution;
    return restitution.at(1.0);
  } else {
    return std::nullopt;
  }
}

/// Returns the law with its stiffness times `factor`; as it is where it has none.
template <class Law>
Law with_stiffness_factor(Law law, double factor) {
  if constexpr (HasStiffness<Law>) law.stiffness = factor * law.stiffness;
  return law;
}

/// Returns the law with its restitution changed; as it is where it has none.
template <class Law>
Law with_restitution_change(Law law, double change) {
  if constexpr (HasRestitution<Law>) law.restitution = changed_restitution(law.restitution, change);
  return law;
}

}  // namespace moat
