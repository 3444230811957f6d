// One value for all storeys, or one for each.
#pragma once

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/check.hpp"

namespace moat {

/// A value for every storey of a building, from the lowest up: one for all, or a list.
///
///     .floor_mass = 500 * tonne                                  every floor
///     .floor_mass = {500 * tonne, 480 * tonne, 430 * tonne}      floor 1, 2 and 3
template <class T>
class PerStorey {
 public:
  /// A field that is left out does not compile, as with Required. Without this it would be an empty list.
  PerStorey() = delete;
  /// One value for every storey.
  PerStorey(T every) : values_{every} {}
  /// Also from a type that converts to a value: any law for the law of a storey.
  template <std::convertible_to<T> Any>
  requires(!std::same_as<Any, T>) PerStorey(const Any& every) : values_{every} {}
  /// One value for every storey, in braces: {1 * m, 0.6 * m} is a position.
  template <class... Parts>
  requires(sizeof...(Parts) >= 2 && std::is_aggregate_v<T> && requires(Parts... parts) { T{parts...}; })
      PerStorey(Parts... parts)
      : values_{T{parts...}} {}
  /// One value per storey, from the lowest up.
  PerStorey(std::initializer_list<T> list) : values_{list}, is_list_{true} {}
  /// One value per storey, from the lowest up.
  PerStorey(std::vector<T> list) : values_{std::move(list)}, is_list_{true} {}

  /// The value of every storey where the field is left out.
  static PerStorey unless_given(T every) {
    PerStorey values(every);  // braces would make a list
    values.is_given_ = false;
    return values;
  }

  /// Whether the field is not left out.
  [[nodiscard]] bool is_given() const { return is_given_; }
  /// Value of storey or floor 1, 2, ...
  [[nodiscard]] const T& of(int storey) const { return values_[is_list_ ? static_cast<std::size_t>(storey - 1) : 0]; }
  /// Whether every storey has its own.
  [[nodiscard]] bool is_list() const { return is_list_; }
  /// Values of storeys 1 to `storeys`.
  [[nodiscard]] std::vector<T> list(int storeys) const {
    return is_list_ ? values_ : std::vector<T>(static_cast<std::size_t>(storeys), values_.front());
  }

  /// Throws InputError unless a list has one value for each storey.
  void check_count(const Check& check, std::string_view field, int storeys) const {
    if (is_list_ && values_.size() != static_cast<std::size_t>(storeys))
      check.that(false,
                 std::string{field} + " has " + std::to_string(values_.size()) + " values for " +
                     std::to_string(storeys) + (storeys == 1 ? " storey." : " storeys."),
                 "Give one value for all storeys, or one for each from the lowest up.");
  }
  /// Throws InputError unless every value is > 0 and a list has one for each storey.
  void check(const Check& check, std::string_view field, int storeys) const {
    check_count(check, field, storeys);
    if (!is_list_) return check.positive(field, values_.front());
    for (std::size_t i = 0; i < values_.size(); ++i)
      check.positive(std::string{field} + " of storey " + std::to_string(i + 1), values_[i]);
  }

 private:
  std::vector<T> values_;
  bool is_list_ = false, is_given_ = true;
};

}  // namespace moat
