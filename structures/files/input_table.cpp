#include "structures/files/input_table.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <utility>

#include "base/error.hpp"
#include "base/text/nearest_name.hpp"

namespace moat {
namespace {

// "kx" and "kN/m" of "kx [kN/m]". The unit is as parse_si() reads it: "t m^2" for "t m2"; radians are plain numbers.
std::pair<std::string, std::optional<std::string>> name_and_unit(const std::string& text) {
  static const std::regex power{"([A-Za-z])(-?[0-9])"}, radian{"^rad$|/rad$"};
  const std::size_t open = text.find('['), close = text.find(']');
  const std::string name{trimmed(std::string_view{text}.substr(0, open))};
  if (close == std::string::npos || open >= close) return {name, std::nullopt};
  const std::string unit = text.substr(open + 1, close - open - 1);
  return {name, std::regex_replace(std::regex_replace(unit, power, "$1^$2"), radian, "")};
}

}  // namespace

InputTable::InputTable(Rows rows, const std::vector<std::string>& required, const std::vector<std::string>& optional)
    : rows_{std::move(rows)} {
  std::vector<std::string> known;
  for (const auto* list : {&required, &optional})
    for (const std::string& text : *list) columns_.push_back({text, known.emplace_back(name_and_unit(text).first)});
  const Row header = rows_.take_heading();
  for (std::size_t field = 0; field < header.fields.size(); ++field) {
    const auto [name, unit] = name_and_unit(header.fields[field]);
    const auto column = std::ranges::find(columns_, upper_case(name), [](const auto& c) { return upper_case(c.name); });
    if (column == columns_.end()) {
      notes_.push_back("column " + quoted(name) + " of " + rows_.file.path.filename().string() + " is not used." +
                       did_you_mean(known, name));
      continue;
    }
    if (column->field) rows_.refuse(header, "column " + column->name + " is given twice.");
    if (!unit && column->text != column->name)
      rows_.refuse(header, "column " + column->name + " has no unit; write " + column->text + ".");
    column->field = field;
    column->unit = unit.value_or("");
  }
  for (std::size_t i = 0; i < required.size(); ++i)
    if (!columns_[i].field)
      rows_.refuse(header, "column " + columns_[i].name + " is missing; write " + required[i] + ".");
  if (rows_.list.empty()) rows_.refuse("there are no rows below the names of the columns.");
  for (const Row& row : rows_.list)
    if (row.fields.size() != header.fields.size())
      rows_.refuse(row, "it has " + std::to_string(row.fields.size()) + " fields, line " +
                            std::to_string(header.line_number) + " has " + std::to_string(header.fields.size()) + ".");
}

const InputTable::Column& InputTable::named(std::string_view column) const {
  return *std::ranges::find(columns_, column, &Column::name);
}

std::string InputTable::text(std::size_t row, std::string_view column) const {
  const std::optional<std::size_t> field = named(column).field;
  return field ? rows_.list[row].fields[*field] : "";
}

std::string InputTable::word(std::size_t row, std::string_view column) const {
  if (!has(column)) rows_.refuse("column " + std::string{column} + " is missing; write " + named(column).text + ".");
  const std::string word = text(row, column);
  if (word.empty()) refuse(row, std::string{column} + " is empty.");
  return word;
}

double InputTable::si(std::size_t row, std::string_view column, int mass, int half_length, int time) const try {
  const std::string field = word(row, column), unit = named(column).unit;
  return parse_si(
      unit.empty() ? field : field + " " + unit,
      rows_.file.path.string() + ", line " + std::to_string(rows_.list[row].line_number) + ", " + std::string{column},
      mass, half_length, time);
} catch (const InputError& error) {
  throw FileError{error.what()};
}

void InputTable::require_unique(std::string_view column) const {
  std::map<std::string, std::size_t> lines;
  for (std::size_t row = 0; row < size(); ++row) {
    const auto [known, is_new] = lines.try_emplace(upper_case(word(row, column)), rows_.list[row].line_number);
    if (!is_new) refuse(row, quoted(text(row, column)) + " stands in line " + std::to_string(known->second) + " too.");
  }
}

}  // namespace moat
