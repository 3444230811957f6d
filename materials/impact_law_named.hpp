// An impact law chosen by its name, so that a script can offer it as an option.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "materials/any_contact.hpp"

namespace moat {

/// Any law of materials/impact_laws.hpp that is given by a stiffness and a restitution, by its name:
///
///     add(model, Moat{..., .law = ImpactLawNamed{.name = script.text("law", "hertz_damp", "impact law"),
///                                                .linear_stiffness = 5.8e8 * N / m,
///                                                .hertz_stiffness = 2.95e9 * N / m_3_2,
///                                                .restitution = 0.65}});
///
/// Laws with a linear spring use linear_stiffness, the others hertz_stiffness; both can be given, so that the
/// name alone changes between runs.
struct ImpactLawNamed {
  /// One of impact_law_names(): the law's own name in small letters, "hertz_damp" for HertzDamp.
  Required<std::string> name;
  /// > 0 N/m, for laws with a linear spring.
  Stiffness linear_stiffness{};
  /// > 0 N/m^1.5, for the others.
  HertzStiffness hertz_stiffness{};
  /// 0 < e <= 1, and at least 0.001 for laws that divide by it; elastic laws ignore it.
  double restitution = 1.0;
  /// Whether the contact may pull, for laws that leave it open; the others ignore it.
  bool may_pull = false;

  /// Throws InputError for an unknown name, which lists the known ones, for the stiffness that the law needs, or for
  /// what the law itself refuses.
  void check(const Check& check) const;
  /// The law between two bodies of the given effective mass, kg.
  [[nodiscard]] AnyContact between(double effective_mass) const;
};

/// The names, sorted.
std::vector<std::string_view> impact_law_names();

}  // namespace moat
