// A design sheet while it grows. Included by .cpp files alone.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "design/design_sheet.hpp"
#include "design/sheet_inputs.hpp"

namespace moat {

/// Makes the lines that all codes have, and puts numbers into formulas.
class SheetLines {
 protected:
  using Values = std::vector<double>;
  enum class Governs { nobody, largest, smallest };

  /// Throws InputError for a bad building.
  SheetLines(std::string_view kind, const SheetBuilding& building, std::string code);

  /// A number that formulas may use.
  void give(std::string symbol, double value, std::string unit) {
    sheet_.given.push_back({std::move(symbol), value, std::move(unit)});
  }
  /// Appends the line and chooses its bound: where nobody governs, that of the largest displacement for three values.
  SheetLine& add(SheetLine line, Governs governs = Governs::nobody);
  /// Makes a rule of the line.
  static void judge(SheetLine& line, bool is_kept, std::string verdict);
  /// Appends a rule: the smallest value is at least `limit`, or the largest at most that. otherwise: follows from a
  /// rule that is not kept, as a few words.
  void add_rule(SheetLine line, Governs governs, double limit, const std::string& otherwise);
  /// Values of a function by bound, counted from 0.
  template <class Function>
  static Values by_bound(const Function& value) {
    return {value(0), value(1), value(2)};
  }
  /// The sheet, with the numbers in its formulas.
  DesignSheet finished();

  /// Lines of the isolators' properties.
  void add_isolators(const std::string& clause);
  /// Sets d_ to the displacements that equal their own demand, in m, to the last digits, and the properties there.
  /// Throws InputError where there is none between yield and 5 m.
  void solve(std::string_view symbol, const std::function<double(std::size_t, double)>& demand);
  /// 2 pi sqrt(W/(g k)), s.
  [[nodiscard]] double period(double stiffness) const;
  /// The results of a suite, zeros without one; `value` is a member of SuiteValues.
  template <class Member>
  [[nodiscard]] Values of_suite(Member value) const {
    if (!in_.suite) return Values(3, 0.0);
    const SuiteForSheet& suite = *in_.suite;
    if constexpr (std::is_same_v<Member, double SuiteValues::*>)
      return {suite.lower.*value, suite.nominal.*value, suite.upper.*value};
    else
      return {(suite.lower.*value).si(), (suite.nominal.*value).si(), (suite.upper.*value).si()};
  }
  /// "2 records touch" where histories have impacts, by the bound with most; else empty.
  [[nodiscard]] std::string touching_records() const;
  /// The number alone, in the unit of sheets.
  static std::string bare(double value, const std::string& unit);
  /// The gap that is needed, and its verdict: by the histories of a bound that has a displacement of its corner, else
  /// by the formula.
  void add_gap(const std::string& of_histories, const Values& corner, const std::string& of_formula,
               const std::string& clause, Values values);
  /// (F(d) - F(d/2))/W at d_.
  [[nodiscard]] Values restoring() const;
  /// The forces of floors, each the share of its floor in the total; the numbers are the product. The total is a copy:
  /// the values of a line move when lines are added.
  template <class Share>
  void add_floors(const std::string& symbol, SheetLine line, Values total, const Share& share) {
    for (std::size_t floor = 0; floor < in_.floors.size(); ++floor) {
      line.symbol = symbol + " floor " + std::to_string(floor + 1);
      line.values = by_bound([&](std::size_t i) { return total[i] * share(floor, i); });
      SheetLine& added = add(line, Governs::largest);
      const auto of = static_cast<std::size_t>(added.of);
      added.numbers = bare(total[of], line.unit) + " x " + bare(share(floor, of), "1");
    }
  }

  const SheetBuilding& in_;
  const Check check_;
  std::array<IsolationLoop, 3> loops_;
  double w_, w_s_ = 0.0;        // N
  double y_, e_, mean_square_;  // m, m, m^2: of corner, eccentricity, bearings about their centre
  Values d_{};                  // m, design displacement of the centre
  Values k_{}, beta_{}, t_{};   // N/m, 1, s: secant stiffness, damping, period at d_
  Bound far_ = Bound::lower;    // of the largest d_
  DesignSheet sheet_{};

 private:
  [[nodiscard]] std::string with_numbers(const std::string& formula, Bound of) const;
};

/// "D_M 0.49 m (lower bounds)" of a line with its value.
std::string named_value(const SheetLine& line);

}  // namespace moat
