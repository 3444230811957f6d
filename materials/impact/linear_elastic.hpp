// Linear elastic impact law.
#pragma once

#include "materials/contact/viscous_linear_contact.hpp"

namespace moat {

/// Linear elastic model: F = k d.
///
/// Source: Zhao, Liu & Li (2017), Eq. 1. Elastic: delivers e = 1; never pulls; the contact ends where the gap
/// opens. Deepest indentation v0 sqrt(m/k), duration pi sqrt(m/k). Indentation and compression positive.
struct LinearElastic {
  static constexpr std::string_view name = "LinearElastic";
  static constexpr std::string_view formula = "k d";
  static constexpr std::string_view assumption = "Elastic: no energy is lost in a contact.";

  /// k > 0 N/m.
  Required<Stiffness> stiffness;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const { check.positive("stiffness", stiffness); }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const { return {{"stiffness", stiffness.si(), "N/m"}}; }
  /// The law between two bodies; this one does not depend on their effective mass (kg).
  [[nodiscard]] ViscousLinearContact between(double /*effective_mass*/) const { return {stiffness.si()}; }
};

}  // namespace moat
