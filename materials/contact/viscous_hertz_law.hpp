// Impact laws of Hertz with damping in proportion to the elastic force.
#pragma once

#include <concepts>

#include "materials/contact/viscous_hertz_contact.hpp"
#include "materials/law_list.hpp"

namespace moat {

/// The damping factor z(e) of one author: all that distinguishes the laws of this form.
template <class Factor>
concept DampingFactor = requires(double e) {
  { Factor::name } -> std::convertible_to<std::string_view>;     // of the law
  { Factor::formula } -> std::convertible_to<std::string_view>;  // of z
  { Factor::divides_by_restitution } -> std::convertible_to<bool>;
  { Factor::of(e) } -> std::same_as<double>;
};

/// F = k d^1.5 (1 + z d'/v0); v0 is the approach speed. Indentation and compression positive. The contact ends where
/// the force reaches zero or the gap opens, in free impact always the latter. ViscousHertzContact says more.
template <DampingFactor Factor>
struct ViscousHertzLaw {
  static constexpr std::string_view name = Factor::name;
  static constexpr std::string_view alias = alias_of<Factor>();
  static constexpr std::string_view formula = Factor::formula;
  static constexpr std::string_view assumption = assumption_of<Factor>();

  /// k > 0 N/m^1.5.
  Required<HertzStiffness> stiffness;
  /// e, the intended coefficient of restitution: 0 < e <= 1, and e >= 0.001 if z grows as 1/e. A number, or one that
  /// falls with the approach speed.
  Required<Restitution> restitution;
  /// Whether the force may turn negative while bodies in contact are drawn apart. Changes nothing in free impact.
  bool may_pull = false;

  /// A floor of a building against concrete: 1e10 N/m^1.5, 3e9 to 3e10 in use and by geometry, and e = 0.65.
  static ViscousHertzLaw typical() { return {.stiffness = HertzStiffness{1e10}, .restitution = 0.65}; }

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    restitution.value().check(check, Factor::divides_by_restitution ? least_restitution_in_divisor : 0.0);
  }
  /// The parameters as given.
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return with_restitution({"stiffness", stiffness.si(), "N/m^1.5"}, restitution,
                            {{"may_pull", may_pull ? 1.0 : 0.0, "1"}});
  }
  /// The law between two bodies; it does not depend on their effective mass (kg).
  [[nodiscard]] ViscousHertzContact between(double /*effective_mass*/) const {
    return {stiffness.si(), {restitution, Factor::of}, separation(may_pull)};
  }
};

}  // namespace moat
