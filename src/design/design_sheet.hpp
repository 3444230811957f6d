// A design sheet: formulas of a code with their numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moat {

/// Where the formula of a clause comes from. A sheet shows it beside the clause.
enum class ClauseSource {
  followed,    ///< Read in published programs that follow the code, not in the code itself.
  recalled,    ///< Recalled, not read in the code: read the clause before you sign.
  by_statics,  ///< Follows from equilibrium; the number of the clause is recalled.
};

/// The three sets of isolator properties, in the order of the values of a line.
enum class Bound : std::size_t { lower, nominal, upper };
/// Returns "lower bounds", "nominal" or "upper bounds".
std::string_view name_of(Bound bound);

/// A row of a sheet: a formula and its result by lower bounds, nominal and upper bounds of the isolators.
///
/// Symbols and formulas are plain text that the page sets: `D_TM` has an index, `T^2` an exponent, and `beta` becomes a
/// Greek letter.
struct SheetLine {
  std::string symbol;                            ///< "D_M"
  std::string formula;                           ///< "g S_M1 T_M/(4 pi^2 B_M)"
  std::string clause{};                          ///< "17.5.3.1"; empty without one
  ClauseSource source = ClauseSource::recalled;  ///< of formula and clause
  std::vector<double> values{};                  ///< SI; three by bound, one for all bounds, or none
  std::string unit = "1";                        ///< SI symbol
  std::string numbers{};                         ///< the formula with the numbers of the bound `of`, in kN, m and s
  Bound of = Bound::nominal;                     ///< see `numbers`
  bool governs = false;                          ///< whether the value of `of` is that for design, shown bold
  std::optional<bool> is_kept{};                 ///< of a rule; none where it is not judged
  std::string verdict{};                         ///< of a rule: "clearance 0.45 m < D_TM 0.5717 m (lower bounds)"

  /// The value of a bound, SI. Throws InputError for a line without values.
  [[nodiscard]] double value(Bound bound) const;
  [[nodiscard]] double value() const { return value(of); }  ///< The value of the bound `of`.
};

/// A number that a sheet was given.
struct GivenValue {
  std::string symbol;  ///< "S_M1"
  double value;        ///< SI, accelerations in g
  std::string unit;    ///< "N", "m", "s", "g", "1"
};

/// All lines of a code for one building. An Asce7Sheet or an En1998Sheet converts to it:
///
///     const DesignSheet sheet = Asce7Sheet{.building = hospital, .s_m1 = 0.9, ...};
///     const Time period = sheet.line("T_M").value(Bound::upper) * s;
struct DesignSheet {
  std::string name;                  ///< of the building; may be empty
  std::string code;                  ///< with its chapter
  std::vector<GivenValue> given{};   ///< the numbers it began with
  std::vector<SheetLine> lines{};    ///< in the order of the calculation
  std::vector<std::string> notes{};  ///< assumptions, and rules that are not judged

  /// The line of a symbol. Throws InputError for an unknown one, with all that there are.
  [[nodiscard]] const SheetLine& line(std::string_view symbol) const;
  /// The rules: the gap first, then those that are not kept, those that are not judged, and the others.
  [[nodiscard]] std::vector<const SheetLine*> rules() const;
};

/// A value of a sheet with 4 significant digits and its unit, kN for N: "0.5717 m", "7460 kN".
std::string sheet_value(double value_in_si, std::string_view unit);

}  // namespace moat
