// The name of a type.
#pragma once

#include <cstddef>
#include <string_view>

namespace moat {

/// The name of a type without its namespaces: "HardeningSpring".
template <class T>
constexpr std::string_view type_name() {
  // "... [with T = tower::HardeningSpring; ...]" of GCC, "... [T = tower::HardeningSpring]" of clang.
  constexpr std::string_view function = __PRETTY_FUNCTION__, before = "T = ";
  constexpr std::size_t begin = function.find(before) + before.size();
  constexpr std::string_view name = function.substr(begin, function.find_first_of(";]", begin) - begin);
  constexpr std::size_t colons = name.substr(0, name.find('<')).rfind("::");
  return colons == std::string_view::npos ? name : name.substr(colons + 2);
}

}  // namespace moat
