#include "materials/impact_law_named.hpp"

#include <algorithm>
#include <array>
#include <concepts>

#include "base/error.hpp"
#include "materials/impact_laws.hpp"

namespace moat {
namespace {

template <class Law>
constexpr bool is_linear = std::same_as<decltype(Law::stiffness), Required<Stiffness>>;

// The parameters of a law, filled from those fields that it has.
template <class Law>
Law parameters(const ImpactLawNamed& named) {
  const auto with = [&](auto stiffness) {
    if constexpr (requires { Law{.stiffness = stiffness, .restitution = 1.0, .may_pull = false}; })
      return Law{.stiffness = stiffness, .restitution = named.restitution, .may_pull = named.may_pull};
    else if constexpr (requires { Law{.stiffness = stiffness, .restitution = 1.0}; })
      return Law{.stiffness = stiffness, .restitution = named.restitution};
    else
      return Law{.stiffness = stiffness};
  };
  if constexpr (is_linear<Law>)
    return with(named.linear_stiffness);
  else
    return with(named.hertz_stiffness);
}

struct Entry {
  std::string_view name;
  void (*check)(const ImpactLawNamed&, const Check&);
  AnyContact (*between)(const ImpactLawNamed&, double);
};

template <class Law>
void check_law(const ImpactLawNamed& named, const Check& check) {
  const std::string advice = "The law " + named.name.value() + " needs it.";
  if constexpr (is_linear<Law>)
    check.positive("linear_stiffness", named.linear_stiffness, advice);
  else
    check.positive("hertz_stiffness", named.hertz_stiffness, advice);
  parameters<Law>(named).check(check);
}

template <class Law>
AnyContact make_law(const ImpactLawNamed& named, double effective_mass) {
  return AnyContact{parameters<Law>(named).between(effective_mass)};
}

template <class Law>
constexpr Entry entry(std::string_view name) {
  return {name, check_law<Law>, make_law<Law>};
}

constexpr std::array entries{entry<Anagnostopoulos>("anagnostopoulos"),
                             entry<ExactHertzDamp>("exact_hertz_damp"),
                             entry<ExactKelvin>("exact_kelvin"),
                             entry<Gonthier>("gonthier"),
                             entry<Hertz>("hertz"),
                             entry<HertzDamp>("hertz_damp"),
                             entry<HuGuo>("hu_guo"),
                             entry<HuntCrossley>("hunt_crossley"),
                             entry<Kelvin>("kelvin"),
                             entry<LankaraniNikravesh>("lankarani_nikravesh"),
                             entry<LinearElastic>("linear_elastic"),
                             entry<ModifiedHertzDamp>("modified_hertz_damp"),
                             entry<ModifiedHertzDampPrinted>("modified_hertz_damp_printed"),
                             entry<ModifiedLinearViscoelastic>("modified_linear_viscoelastic"),
                             entry<NonlinearViscoelastic>("nonlinear_viscoelastic"),
                             entry<Ye2009>("ye_2009")};

const Entry* find(std::string_view name) {
  const auto found = std::ranges::find(entries, name, &Entry::name);
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace

void ImpactLawNamed::check(const Check& check) const {
  const Entry* known = find(name.value());
  if (known == nullptr) {
    std::string list;
    for (const Entry& each : entries) list.append(list.empty() ? "" : ", ").append(each.name);
    check.that(false, "there is no impact law \"" + name.value() + "\".", "Choose one of " + list + ".");
  }
  known->check(*this, check);
}

AnyContact ImpactLawNamed::between(double effective_mass) const {
  const Entry* known = find(name.value());
  if (known == nullptr) throw InputError{"ImpactLawNamed: there is no impact law \"" + name.value() + "\"."};
  return known->between(*this, effective_mass);
}

std::vector<std::string_view> impact_law_names() {
  std::vector<std::string_view> names;
  for (const Entry& each : entries) names.push_back(each.name);
  return names;
}

}  // namespace moat
