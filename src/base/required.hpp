// Fields that have no sensible default.
#pragma once

#include <concepts>
#include <utility>

namespace moat {

/// A field of a parameter struct that must be given. It has no default constructor, so leaving it
/// out of a designated initialiser does not compile:
///
///     struct Node { std::string name; Required<Mass> mass; };
///     add(model, Node{.name = "base"});   // error: use of deleted function Required<Mass>::Required()
///
/// Elsewhere it behaves as the value it holds.
template <class T>
class Required {
 public:
  Required() = delete;

  /// From any value that converts to T, but no whole number from one with a fraction.
  template <class Source>
  requires(std::convertible_to<Source, T> && !std::same_as<std::remove_cvref_t<Source>, Required> &&
           !(std::integral<T> && std::floating_point<std::remove_cvref_t<Source>>)) constexpr Required(Source&& value)
      : value_(std::forward<Source>(value)) {}

  constexpr operator const T&() const { return value_; }             ///< Returns the value.
  [[nodiscard]] constexpr const T& value() const { return value_; }  ///< Returns the value.

  /// The value of a quantity in SI units.
  [[nodiscard]] constexpr double si() const requires requires(const T& quantity) { quantity.si(); }
  { return value_.si(); }

 private:
  T value_;
};

}  // namespace moat
