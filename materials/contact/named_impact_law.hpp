// An impact law chosen by its name, so that a script can offer it as an option.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "materials/contact/any_contact.hpp"
#include "materials/contact/changed_law.hpp"

namespace moat {

/// Any law of AllImpactLaws that is given by a stiffness and a restitution, by its name:
///
///     add(model, Moat{..., .law = NamedImpactLaw{.name = script.text("law", "hertz_damp", "impact law"),
///                                                .linear_stiffness = 5.8e8 * N / m,
///                                                .hertz_stiffness = 2.95e9 * N / m_3_2,
///                                                .restitution = 0.65}});
///
/// Laws with a linear spring use linear_stiffness, the others hertz_stiffness; both can be given, so that the
/// name alone changes between runs.
struct NamedImpactLaw {
  /// One of impact_law_names(): "hertz_damp" for HertzDamp.
  Required<std::string> name;
  /// > 0 N/m, for laws with a linear spring.
  Stiffness linear_stiffness{};
  /// > 0 N/m^1.5, for the others.
  HertzStiffness hertz_stiffness{};
  /// 0 < e <= 1, and at least 0.001 for laws that divide by it; elastic laws ignore it. It may fall with the speed.
  Restitution restitution = 1.0;
  /// Whether the contact may pull, for laws with this field; the others ignore it.
  bool may_pull = false;

  /// Throws InputError for an unknown name, with a list of the known ones, for a missing stiffness, and for a parameter
  /// that the law itself refuses.
  void check(const Check& check) const;
  /// Returns the parameters of the law of that name, as given here. Throws InputError for an unknown name.
  [[nodiscard]] std::vector<Parameter> parameters() const;
  /// The law between two bodies of the given effective mass, kg.
  [[nodiscard]] AnyContact between(double effective_mass) const;
};

/// "HertzDamp" of the law "hertz_damp", for reports. Throws InputError for an unknown name.
std::string_view name_of(const NamedImpactLaw& law);

/// Returns true: it has one, under two names.
inline bool has_stiffness(const NamedImpactLaw&) { return true; }
/// Returns nothing for an elastic law, which ignores the field.
std::optional<double> restitution_of_law(const NamedImpactLaw& law);
/// Returns the law with both stiffnesses times `factor`.
NamedImpactLaw with_stiffness_factor(NamedImpactLaw law, double factor);

/// The names, sorted, those of aliases among them.
std::vector<std::string> impact_law_names();

/// The name of a type as options write it: "hertz_damp" for "HertzDamp", "ye_2009" for "Ye2009".
std::string option_name(std::string_view type_name);

}  // namespace moat
