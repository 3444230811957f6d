// A list of types of laws.
#pragma once

#include <string_view>

namespace moat {

/// The second name of a law, `Law::alias`; empty for laws that have one name only.
template <class Law>
constexpr std::string_view alias_of() {
  if constexpr (requires { Law::alias; })
    return Law::alias;
  else
    return {};
}

/// The limits of a law in one or two sentences, for reports: Law::assumption; empty where it says none.
template <class Law>
constexpr std::string_view assumption_of() {
  if constexpr (requires { Law::assumption; })
    return Law::assumption;
  else
    return {};
}

/// Laws of one family. Names, tests and the tables of the guide are made from this list.
template <class... Laws>
struct LawList {
  /// Number of laws.
  static constexpr int size = sizeof...(Laws);

  /// Calls `action.template operator()<Law>()` for every law, in the order of the list:
  ///
  ///     AllImpactLaws::for_each([]<class Law>() { std::cout << Law::name << "\n"; });
  template <class Action>
  static constexpr void for_each(Action action) {
    (action.template operator()<Laws>(), ...);
  }
};

}  // namespace moat
