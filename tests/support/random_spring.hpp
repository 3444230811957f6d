// Laws of isolators, dampers, storeys and soil with random parameters.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "fields.hpp"
#include "moat.hpp"
#include "random_draws.hpp"

namespace moat::testing {

/// Multiplies every number in a field by a random factor of its own; fields that are zero, or left out, stay.
template <class Field>
void vary(RandomDraws& draws, Field& field) {
  constexpr double least = 0.4, most = 2.5;
  if constexpr (std::is_same_v<Field, bool> || std::is_enum_v<Field>) {
    return;
  } else if constexpr (std::is_same_v<Field, double>) {
    field = rounded(field * draws.decades(least, most));
  } else if constexpr (requires { field.si(); } && std::is_default_constructible_v<Field>) {
    field = Field{rounded(field.si() * draws.decades(least, most))};
  } else if constexpr (detail::is_required<Field>) {
    auto value = field.value();
    vary(draws, value);
    field = Field{value};
  } else if constexpr (std::is_same_v<Field, Friction>) {
    const double slow = draws.uniform(0.01, 0.1);
    if (draws.chance(0.5))
      field = Friction{slow};
    else
      field = VelocityDependent{.slow = slow,
                                .fast = rounded(slow * draws.uniform(1.0, 2.5)),
                                .rate = draws.uniform(10.0, 100.0) * units::s / units::m};
  } else {
    for_each_field(field, [&](auto& part) { vary(draws, part); });
  }
}

/// A law with parameters about its typical ones, each within a factor of 2.5, and allowed by its check().
template <class Law>
Law random_spring(RandomDraws& draws) {
  constexpr int most_draws = 10000;
  for (int i = 0; i < most_draws; ++i) {
    Law law = Law::typical();
    vary(draws, law);
    try {
      law.check(Check{"Isolator", "bearings"});
      return law;
    } catch (const InputError&) {
      // Drawn again.
    }
  }
  throw std::runtime_error{"no allowed parameters were drawn of " + std::string{Law::name}};
}

/// The law itself, or that of the parameters under a weight.
template <class Law>
auto force_law(const Law& law) {
  if constexpr (WeightBearing<Law>)
    return law.carrying(20.0 * units::MN);
  else
    return law;
}

/// Calls action(law) for the typical law and for `count` random ones.
template <class Law, class Action>
void for_random_laws(int count, Action action, std::uint64_t seed = 20261122) {
  RandomDraws draws{seed};
  for (int i = 0; i <= count; ++i) {
    const Law law = i == 0 ? Law::typical() : random_spring<Law>(draws);
    std::string text{Law::name};
    for (const Parameter& each : law.parameters())
      text.append(" ").append(each.name).append(" ").append(to_text(each.value));
    SCOPED_TRACE(text);
    action(force_law(law));
    if (::testing::Test::HasFailure()) return;
  }
}

/// F/d on first loading to a deformation at constant speed, in fifty pieces.
template <ForceLaw Law>
double secant_stiffness(const Law& law, double deformation, double speed = 0.3) {
  constexpr int pieces = 50;
  typename Law::State state{}, trial;
  const double piece = deformation / pieces;
  double force = 0.0;
  for (int i = 1; i <= pieces; ++i) {
    const double at = i * piece;
    if constexpr (LawWithRegimes<Law>)
      for (int k = 0; k < 4 && law.regime_margin(state, at, speed) < 0.0; ++k)
        state = law.next_regime(state, at, speed);
    force = respond(law, state, at, speed, {piece / speed, at - piece, speed}, trial).force;
    state = trial;
  }
  return force / deformation;
}

/// The deformation at which a law is far from linear: three times that where its secant stiffness has changed by half,
/// from 1 mm to 0.3 m, or half more than where a law begins to act; 0.3 m for a law that is linear.
template <ForceLaw Law>
double natural_deformation(const Law& law) {
  constexpr double least = 1e-3, most = 0.3, farthest = 1.0;
  const double first = secant_stiffness(law, 0.1 * least);
  for (double d = least; d < (first == 0.0 ? farthest : most); d *= 1.3)
    if (std::abs(secant_stiffness(law, d) - first) > 0.5 * std::abs(first))
      return std::min(3.0 * d, std::max(most, 1.5 * d));
  return most;
}

}  // namespace moat::testing
