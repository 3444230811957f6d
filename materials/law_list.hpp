// A list of types of laws.
#pragma once

namespace moat {

/// Laws of one family. Names, tests and the tables of the guide are made from this list.
template <class... Laws>
struct LawList {
  static constexpr int size = sizeof...(Laws);

  /// Calls action.template operator()<Law>() for every law, in the order of the list:
  ///
  ///     AllImpactLaws::for_each([]<class Law>() { std::cout << Law::name << "\n"; });
  template <class Action>
  static constexpr void for_each(Action action) {
    (action.template operator()<Laws>(), ...);
  }
};

}  // namespace moat
