// Checks of parameters, with messages that give the remedy.
#pragma once

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/quantity.hpp"
#include "base/required.hpp"

namespace moat {

/// Checks the parameters of one object and throws InputError with a message of the form below. Where advice is left
/// out, a remedy that fits every value takes its place.
///
///     Gap "moat left": clearance = -0.1 m is not allowed; it must be >= 0 m and finite. Give the free distance ...
///
///     const Check check{"Gap", name};
///     check.not_negative("clearance", clearance, "Give the free distance to the wall at rest.");
class Check {
 public:
  /// kind is the type a user wrote ("Gap"); name is the object's own name, may be empty. Both must outlive the check: a
  /// message is formed only when a check fails.
  Check(std::string_view kind, std::string_view name) : kind_{kind}, name_{name} {}
  /// A name that ends with the expression, also a constant one: `empty ? "" : title`.
  template <class Temporary>
  requires std::same_as<std::remove_const_t<Temporary>, std::string> Check(std::string_view kind, Temporary&& name)
  = delete;

  /// value > 0 and finite.
  void positive(std::string_view parameter, double value, std::string_view unit, std::string_view advice = {}) const;
  /// value >= 0 and finite.
  void not_negative(std::string_view parameter, double value, std::string_view unit,
                    std::string_view advice = {}) const;
  /// Neither NaN nor infinite.
  void finite(std::string_view parameter, double value, std::string_view unit, std::string_view advice = {}) const;
  /// lowest < value <= highest.
  void above_up_to(std::string_view parameter, double value, double lowest, double highest, std::string_view unit,
                   std::string_view advice = {}) const;
  /// lowest <= value <= highest.
  void between(std::string_view parameter, double value, double lowest, double highest, std::string_view unit,
               std::string_view advice = {}) const;
  /// Any other condition, with its allowed range in words.
  void that(bool allowed, std::string_view parameter, double value, std::string_view unit, std::string_view range,
            std::string_view advice = {}) const;
  /// A condition that is not about one number: throws `Kind "name": problem advice`.
  void that(bool allowed, std::string_view problem, std::string_view advice = {}) const {
    if (!allowed) refuse(problem, advice);
  }
  /// Throws InputError for a name that tables cannot hold: one that is not UTF-8, or that a spreadsheet takes for a
  /// formula.
  void fits_tables(std::string_view name) const;

  /// Throws InputError unless the value is > 0 and finite.
  template <int m, int l, int t>
  void positive(std::string_view parameter, Quantity<m, l, t> value, std::string_view advice = {}) const {
    if (!(value.si() > 0.0 && std::isfinite(value.si()))) positive(parameter, value.si(), unit_symbol(m, l, t), advice);
  }
  /// Throws InputError unless the value is >= 0 and finite.
  template <int m, int l, int t>
  void not_negative(std::string_view parameter, Quantity<m, l, t> value, std::string_view advice = {}) const {
    if (!(value.si() >= 0.0 && std::isfinite(value.si())))
      not_negative(parameter, value.si(), unit_symbol(m, l, t), advice);
  }
  /// Throws InputError unless the value is finite.
  template <int m, int l, int t>
  void finite(std::string_view parameter, Quantity<m, l, t> value, std::string_view advice = {}) const {
    if (!std::isfinite(value.si())) finite(parameter, value.si(), unit_symbol(m, l, t), advice);
  }
  /// Throws InputError unless the value is given, > 0 and finite.
  template <class Q>
  void positive(std::string_view parameter, const Required<Q>& value, std::string_view advice = {}) const {
    positive(parameter, value.value(), advice);
  }
  /// Throws InputError unless the value is given, >= 0 and finite.
  template <class Q>
  void not_negative(std::string_view parameter, const Required<Q>& value, std::string_view advice = {}) const {
    not_negative(parameter, value.value(), advice);
  }

 private:
  [[nodiscard]] std::string object() const;
  [[noreturn]] void refuse(std::string_view problem, std::string_view advice) const;

  std::string_view kind_, name_;
};

/// A number as messages print it: the shortest form with up to 6 digits.
std::string to_text(double value);

}  // namespace moat
