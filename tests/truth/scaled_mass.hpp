// Models in which every mass, stiffness and force is multiplied by one factor.
#pragma once

#include <cmath>
#include <type_traits>

#include "fields.hpp"
#include "moat.hpp"

namespace moat::testing {

/// Multiplies every quantity in a field by the factor of mass in its dimension.
template <class Field>
void scale_mass(Field& field, double mass) {
  if constexpr (std::is_arithmetic_v<Field> || std::is_enum_v<Field> || std::is_same_v<Field, Friction>) {
    return;
  } else if constexpr (requires { Field::mass_exponent; }) {
    field = Field{field.si() * std::pow(mass, Field::mass_exponent)};
  } else if constexpr (detail::is_required<Field>) {
    auto value = field.value();
    scale_mass(value, mass);
    field = Field{value};
  } else {
    for_each_field(field, [&](auto& part) { scale_mass(part, mass); });
  }
}

}  // namespace moat::testing
