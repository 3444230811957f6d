#include "materials/contact/named_impact_law.hpp"

#include <algorithm>
#include <cctype>
#include <concepts>

#include "base/error.hpp"
#include "materials/contact/impact_laws.hpp"

namespace moat {
namespace {

template <class Law>
constexpr bool is_linear = std::same_as<decltype(Law::stiffness), Required<Stiffness>>;

// The law with those of the given parameters that it has. Laws that need other parameters are not offered by name.
template <class Law, class K>
concept GivenByStiffness = requires(K stiffness) {
  Law{.stiffness = stiffness};
};
template <class Law, class K>
concept GivenByRestitution = requires(K stiffness) {
  Law{.stiffness = stiffness, .restitution = 1.0};
};

template <class Law, class K>
Law law_with(K stiffness, const NamedImpactLaw& named) {
  if constexpr (requires { Law{.stiffness = stiffness, .restitution = 1.0, .may_pull = false}; })
    return Law{.stiffness = stiffness, .restitution = named.restitution, .may_pull = named.may_pull};
  else if constexpr (GivenByRestitution<Law, K>)
    return Law{.stiffness = stiffness, .restitution = named.restitution};
  else
    return Law{.stiffness = stiffness};
}

template <class Law>
Law law_of(const NamedImpactLaw& named) {
  if constexpr (is_linear<Law>)
    return law_with<Law>(named.linear_stiffness, named);
  else
    return law_with<Law>(named.hertz_stiffness, named);
}

template <class Law>
void check_law(const NamedImpactLaw& named, const Check& check) {
  const std::string advice = "The law " + named.name.value() + " needs it.";
  if constexpr (is_linear<Law>)
    check.positive("linear_stiffness", named.linear_stiffness, advice);
  else
    check.positive("hertz_stiffness", named.hertz_stiffness, advice);
  law_of<Law>(named).check(check);
}

struct Entry {
  std::string name;            // of the option
  std::string_view type_name;  // of the law itself, not of its alias
  void (*check)(const NamedImpactLaw&, const Check&);
  AnyContact (*between)(const NamedImpactLaw&, double);
  std::vector<Parameter> (*parameters)(const NamedImpactLaw&);
  bool has_restitution;
};

std::vector<Entry> make_entries() {
  std::vector<Entry> entries;
  AllImpactLaws::for_each([&]<class Law>() {
    using K = std::conditional_t<is_linear<Law>, Stiffness, HertzStiffness>;
    if constexpr (GivenByStiffness<Law, K> || GivenByRestitution<Law, K>) {
      const auto add = [&](std::string_view name) {
        entries.push_back(
            {.name = option_name(name),
             .type_name = Law::name,
             .check = check_law<Law>,
             .between = [](const NamedImpactLaw& named,
                           double effective_mass) { return AnyContact{law_of<Law>(named).between(effective_mass)}; },
             .parameters = [](const NamedImpactLaw& named) { return law_of<Law>(named).parameters(); },
             .has_restitution = GivenByRestitution<Law, K>});
      };
      add(Law::name);
      if (!alias_of<Law>().empty()) add(alias_of<Law>());
    }
  });
  std::ranges::sort(entries, {}, &Entry::name);
  return entries;
}

const std::vector<Entry>& all_entries() {
  static const std::vector<Entry> entries = make_entries();
  return entries;
}

const Entry* find(std::string_view name) {
  const auto found = std::ranges::find(all_entries(), name, &Entry::name);
  return found == all_entries().end() ? nullptr : &*found;
}

const Entry& entry_of(const NamedImpactLaw& law) {
  if (const Entry* known = find(law.name.value())) return *known;
  throw InputError{"NamedImpactLaw: there is no impact law \"" + law.name.value() + "\"."};
}

}  // namespace

std::string option_name(std::string_view type_name) {
  const auto is = [](int (*kind)(int), char letter) { return kind(static_cast<unsigned char>(letter)) != 0; };
  std::string name;
  for (std::size_t i = 0; i < type_name.size(); ++i) {
    const char letter = type_name[i];
    const bool begins_word =
        is(std::isupper, letter) || (is(std::isdigit, letter) && i > 0 && !is(std::isdigit, type_name[i - 1]));
    if (i > 0 && begins_word) name += '_';
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return name;
}

void NamedImpactLaw::check(const Check& check) const {
  const Entry* known = find(name.value());
  if (known == nullptr) {
    std::string list;
    for (const Entry& each : all_entries()) list.append(list.empty() ? "" : ", ").append(each.name);
    check.that(false, "there is no impact law \"" + name.value() + "\".", "Choose one of " + list + ".");
  }
  known->check(*this, check);
}

AnyContact NamedImpactLaw::between(double effective_mass) const {
  return entry_of(*this).between(*this, effective_mass);
}

std::vector<Parameter> NamedImpactLaw::parameters() const { return entry_of(*this).parameters(*this); }

std::string_view name_of(const NamedImpactLaw& law) { return entry_of(law).type_name; }

std::optional<double> restitution_of_law(const NamedImpactLaw& law) {
  return entry_of(law).has_restitution ? std::optional{law.restitution.at(1.0)} : std::nullopt;
}

NamedImpactLaw with_stiffness_factor(NamedImpactLaw law, double factor) {
  law.linear_stiffness *= factor;
  law.hertz_stiffness *= factor;
  return law;
}

std::vector<std::string> impact_law_names() {
  std::vector<std::string> names;
  for (const Entry& each : all_entries()) names.push_back(each.name);
  return names;
}

}  // namespace moat
