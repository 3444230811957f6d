#include "design/sheet_lines.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <regex>

#include "base/root.hpp"

namespace moat {
namespace {

constexpr double accidental = 0.05;  // of the longer side

std::array<IsolationLoop, 3> loops_of(const SheetBuilding& building, const Check& check) {
  building.check(check);
  const IsolationLoop loop = building.isolation.value().under(building.weight, check);
  return {loop.times(building.bounds.lower), loop, loop.times(building.bounds.upper)};
}

double mean_square_distance(const std::vector<PlanPosition>& bearings) {
  PlanVector centre{};
  const auto count = static_cast<double>(bearings.size());
  for (const PlanPosition& each : bearings) centre += each.si() / count;
  double sum = 0.0;
  for (const PlanPosition& each : bearings) sum += dot(each.si() - centre, each.si() - centre);
  return sum / count;
}

}  // namespace

std::string named_value(const SheetLine& line) {
  return line.symbol + " " + sheet_value(line.value(), line.unit) +
         (line.values.size() == 3 ? " (" + std::string{name_of(line.of)} + ")" : "");
}

SheetLines::SheetLines(std::string_view kind, const SheetBuilding& building, std::string code)
    : in_{building},
      check_{kind, building.name},
      loops_{loops_of(building, check_)},
      w_{building.weight.si()},
      y_{building.corner_distance.si() > 0.0 ? building.corner_distance.si() : 0.5 * building.longer_side.si()},
      e_{building.eccentricity.si() + accidental * building.longer_side.si()},
      mean_square_{mean_square_distance(building.bearings)} {
  for (const SheetFloor& floor : building.floors) w_s_ += floor.weight.si();
  sheet_.name = building.name;
  sheet_.code = std::move(code);
  const IsolationLoop& nominal = loops_[1];
  give("W", w_, "N");
  give("W_s", w_s_, "N");
  give("Q_nom", nominal.characteristic_strength.si(), "N");
  give("k_nom", nominal.post_yield_stiffness.si(), "N/m");
  give("d_y", nominal.yield_displacement.si(), "m");
  give("b", building.shorter_side.si(), "m");
  give("d", building.longer_side.si(), "m");
  give("N", static_cast<double>(building.bearings.size()), "1");
  give("y", y_, "m");
  give("T_fb", building.fixed_base_period.si(), "s");
  if (building.clearance) give("clearance", building.clearance->si(), "m");
}

SheetLine& SheetLines::add(SheetLine line, Governs governs) {
  if (governs != Governs::nobody) {
    const auto [least, most] = std::ranges::minmax_element(line.values);
    line.of = static_cast<Bound>((governs == Governs::largest ? most : least) - line.values.begin());
    line.governs = true;
  } else if (line.values.size() == 3) {
    line.of = far_;
  }
  return sheet_.lines.emplace_back(std::move(line));
}

void SheetLines::judge(SheetLine& line, bool is_kept, std::string verdict) {
  line.is_kept = is_kept;
  line.verdict = std::move(verdict);
}

void SheetLines::add_rule(SheetLine line, Governs governs, double limit, const std::string& otherwise) {
  SheetLine& added = add(std::move(line), governs);
  const bool is_least = governs == Governs::smallest;
  const bool is_kept = is_least ? added.value() >= limit : added.value() <= limit;
  judge(added, is_kept,
        named_value(added) + (is_kept == is_least ? (is_kept ? " >= " : " > ") : (is_kept ? " <= " : " < ")) +
            sheet_value(limit, added.unit) + (is_kept ? "" : ": " + otherwise));
}

std::string SheetLines::touching_records() const {
  if (!in_.suite) return "";
  const SuiteForSheet& suite = *in_.suite;
  const std::size_t most = std::max({suite.lower.touching, suite.nominal.touching, suite.upper.touching});
  if (most == 0) return "";
  return std::to_string(most) + (most == 1 ? " record touches" : " records touch");
}

std::string SheetLines::bare(double value, const std::string& unit) {
  const std::string text = sheet_value(value, unit);
  return text.substr(0, text.find(' '));
}

std::string SheetLines::with_numbers(const std::string& formula, Bound of) const {
  const auto number_of = [&](const std::string& symbol) -> std::string {
    if (symbol == "g") return bare(standard_gravity, "1");
    for (const SheetLine& line : sheet_.lines)
      if (line.symbol == symbol && !line.values.empty()) return bare(line.value(of), line.unit);
    const auto given = std::ranges::find(sheet_.given, symbol, &GivenValue::symbol);
    return given == sheet_.given.end() ? "" : bare(given->value, given->unit);
  };
  // Symbols, numbers, and single characters.
  static const std::regex token{R"([A-Za-z][\w']*(,\w+)?|[0-9.]+|.)"};
  std::string text;
  bool is_factor = false, was_symbol = false,
       found = false;  // the token before; any symbol
  for (std::sregex_iterator each{formula.begin(), formula.end(), token}, end; each != end; ++each) {
    const std::string word = each->str(), number = number_of(word);
    const bool is_symbol = !number.empty(), is_digit = std::isdigit(static_cast<unsigned char>(word[0])) != 0;
    const bool begins = is_symbol || is_digit || word == "(" || word == "sqrt" || word == "pi";
    if (is_factor && begins && (was_symbol || is_symbol || is_digit) && text.ends_with(' ')) text += "x ";
    text += is_symbol ? number : word;
    found = found || is_symbol;
    if (word == " ") continue;
    is_factor = is_symbol || is_digit || word == ")" || word == "pi";
    was_symbol = is_symbol;
  }
  return found ? text : "";
}

DesignSheet SheetLines::finished() {
  if (in_.suite && !in_.suite->scaling.empty()) {
    std::string& note = sheet_.notes.emplace_back();
    for (const std::string& line : in_.suite->scaling) note += (note.empty() ? "" : " ") + line + ".";
  }
  // Formulas have symbols of later lines too.
  for (SheetLine& line : sheet_.lines)
    if (line.numbers.empty()) line.numbers = with_numbers(line.formula, line.of);
  return std::move(sheet_);
}

void SheetLines::add_isolators(const std::string& clause) {
  const std::array<PropertyFactors, 3> factors{in_.bounds.lower, PropertyFactors{}, in_.bounds.upper};
  const auto recalled = ClauseSource::recalled;
  add({"lambda_Q", "factor of strength", clause, recalled,
       by_bound([&](std::size_t i) { return factors[i].strength; })});
  add({"lambda_k", "factor of stiffness", clause, recalled,
       by_bound([&](std::size_t i) { return factors[i].stiffness; })});
  add({"Q", "lambda_Q Q_nom", "", ClauseSource::by_statics,
       by_bound([&](std::size_t i) { return loops_[i].characteristic_strength.si(); }), "N"});
  add({"k_2", "lambda_k k_nom", "", ClauseSource::by_statics,
       by_bound([&](std::size_t i) { return loops_[i].post_yield_stiffness.si(); }), "N/m"});
}

void SheetLines::solve(std::string_view symbol, const std::function<double(std::size_t, double)>& demand) {
  constexpr double farthest = 5.0;
  d_ = by_bound([&](std::size_t i) {
    const double yield = loops_[i].yield_displacement.si();
    const std::string of = std::string{symbol} + " (" + std::string{name_of(static_cast<Bound>(i))} + ")";
    check_.that(demand(i, yield) > yield,
                of + " does not exceed the yield displacement " + sheet_value(yield, "m") + ".",
                "Check strength, weight and the spectrum, which is in g.");
    // Spectra end at a period, so that no displacement is tried far beyond the solution.
    double high = yield;
    while (demand(i, high) >= high) {
      check_.that(high < farthest, of + " has no solution below 5 m.",
                  "Check strength, stiffness and the spectrum, which is in g.");
      high = std::min(1.5 * high, farthest);
    }
    return root_between([&](double d) { return d - demand(i, d); }, yield, high);
  });
  far_ = static_cast<Bound>(std::ranges::max_element(d_) - d_.begin());
  k_ = by_bound([&](std::size_t i) { return loops_[i].stiffness(Length{d_[i]}).si(); });
  beta_ = by_bound([&](std::size_t i) { return loops_[i].damping_ratio(Length{d_[i]}); });
  t_ = by_bound([&](std::size_t i) { return period(k_[i]); });
}

double SheetLines::period(double stiffness) const {
  return 2.0 * std::numbers::pi * std::sqrt(w_ / (stiffness * standard_gravity));
}

SheetLines::Values SheetLines::restoring() const {
  return by_bound(
      [&](std::size_t i) { return (loops_[i].force(Length{d_[i]}) - loops_[i].force(Length{0.5 * d_[i]})).si() / w_; });
}

void SheetLines::add_gap(const std::string& of_histories, const Values& corner, const std::string& of_formula,
                         const std::string& clause, Values values) {
  SheetLine& line = add({"gap", "", clause, ClauseSource::recalled, std::move(values), "m"}, Governs::largest);
  const std::string& needed = corner[static_cast<std::size_t>(line.of)] > 0.0 ? of_histories : of_formula;
  line.formula = needed;
  const std::string value = sheet_value(line.value(), "m") + " (" + std::string{name_of(line.of)} + ")";
  if (in_.clearance) {
    const bool is_kept = in_.clearance->si() >= line.value();
    judge(line, is_kept,
          "clearance " + sheet_value(in_.clearance->si(), "m") + (is_kept ? " >= " : " < ") + needed + " " + value);
    // Walls limit the displacements of these records.
    if (const std::string touching = touching_records(); is_kept && !touching.empty()) {
      line.is_kept.reset();
      line.verdict += ", not judged: " + touching + "; repeat the histories with a gap that stays open";
    }
  } else {
    line.verdict = "gap needed: " + needed + " " + value;
  }
}

}  // namespace moat
