// The fields of a law, without a list of them.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/required.hpp"

namespace moat::testing {

namespace detail {

template <class T>
inline constexpr bool is_required = false;
template <class T>
inline constexpr bool is_required<Required<T>> = true;
template <class T>
inline constexpr bool is_variant = false;
template <class... T>
inline constexpr bool is_variant<std::variant<T...>> = true;

// Takes the place of a field of any type. A Required makes itself from the type that it holds; a class that holds a
// variant is taken whole.
struct AnyField {
  template <class T>
  requires(!is_required<T> && !is_variant<T>) operator T() const;
};

template <class Struct, std::size_t... i>
constexpr bool takes(std::index_sequence<i...>) {
  return requires { Struct{(static_cast<void>(i), AnyField{})...}; };
}
template <class Struct, std::size_t count>
constexpr std::size_t number_of_fields() {
  static_assert(count > 0, "no aggregate, or one with more than 16 fields");
  if constexpr (takes<Struct>(std::make_index_sequence<count>{}))
    return count;
  else
    return number_of_fields<Struct, count - 1>();
}

}  // namespace detail

/// Calls action(field) for every field of an aggregate, in the order of their declaration; at most 16.
template <class Struct, class Action>
void for_each_field(Struct& of, Action action) {
  constexpr std::size_t count = detail::number_of_fields<std::remove_const_t<Struct>, 16>();
  const auto all = [&](auto&... fields) { (action(fields), ...); };
  if constexpr (count == 1) {
    auto& [a] = of;
    all(a);
  } else if constexpr (count == 2) {
    auto& [a, b] = of;
    all(a, b);
  } else if constexpr (count == 3) {
    auto& [a, b, c] = of;
    all(a, b, c);
  } else if constexpr (count == 4) {
    auto& [a, b, c, d] = of;
    all(a, b, c, d);
  } else if constexpr (count == 5) {
    auto& [a, b, c, d, e] = of;
    all(a, b, c, d, e);
  } else if constexpr (count == 6) {
    auto& [a, b, c, d, e, f] = of;
    all(a, b, c, d, e, f);
  } else if constexpr (count == 7) {
    auto& [a, b, c, d, e, f, g] = of;
    all(a, b, c, d, e, f, g);
  } else if constexpr (count == 8) {
    auto& [a, b, c, d, e, f, g, h] = of;
    all(a, b, c, d, e, f, g, h);
  } else if constexpr (count == 9) {
    auto& [a, b, c, d, e, f, g, h, i] = of;
    all(a, b, c, d, e, f, g, h, i);
  } else if constexpr (count == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = of;
    all(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (count == 11) {
    auto& [a, b, c, d, e, f, g, h, i, j, k] = of;
    all(a, b, c, d, e, f, g, h, i, j, k);
  } else if constexpr (count == 12) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l] = of;
    all(a, b, c, d, e, f, g, h, i, j, k, l);
  } else if constexpr (count == 13) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = of;
    all(a, b, c, d, e, f, g, h, i, j, k, l, m);
  } else {
    static_assert(count == 14, "write the next line");
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = of;
    all(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
  }
}

}  // namespace moat::testing
