// Hertz impact law.
#pragma once

#include "materials/contact/viscous_hertz_contact.hpp"

namespace moat {

/// Hertz model: F = k d^1.5.
///
/// Source: Zhao, Liu & Li (2017), Eq. 5. Elastic: delivers e = 1; never pulls; the contact ends where the gap
/// opens. Deepest indentation (5 m v0^2/(4 k))^0.4, duration 2.94328 times that over v0. Indentation and
/// compression positive.
struct Hertz {
  static constexpr std::string_view name = "Hertz";
  static constexpr std::string_view formula = "k d^1.5";
  static constexpr std::string_view assumption = "Elastic: no energy is lost in a contact.";

  /// k > 0 N/m^1.5.
  Required<HertzStiffness> stiffness;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const { check.positive("stiffness", stiffness); }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const { return {{"stiffness", stiffness.si(), "N/m^1.5"}}; }
  /// The law between two bodies; this one does not depend on their effective mass (kg).
  [[nodiscard]] ViscousHertzContact between(double /*effective_mass*/) const { return {stiffness.si(), 0.0}; }
};

}  // namespace moat
