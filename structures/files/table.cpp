#include "structures/files/table.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <utility>

#include "base/error.hpp"
#include "base/text/nearest_name.hpp"

namespace moat {
namespace {

// As parse_si() reads it: "t m^2" for "t m2"; radians are plain numbers.
std::string readable(const std::string& unit) {
  static const std::regex power{"([A-Za-z])(-?[0-9])"}, radian{"^rad$|/rad$"};
  return std::regex_replace(std::regex_replace(unit, power, "$1^$2"), radian, "");
}

std::string with_unit(const TableColumn& column) {
  return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

}  // namespace

Table::Table(const std::filesystem::path& path, std::vector<TableColumn> columns)
    : file_{read_text_file(path)}, columns_{std::move(columns)}, rows_{rows_of(file_).rows} {
  const TextRow header = rows_.front();
  rows_.erase(rows_.begin());
  read_header(header, columns_);
  if (rows_.empty()) refuse_file(file_.path, "there are no rows below the names of the columns.");
  for (const TextRow& row : rows_)
    if (row.fields.size() != header.fields.size())
      refuse_line(file_.path, row.line_number,
                  "it has " + std::to_string(row.fields.size()) + " fields, line " +
                      std::to_string(header.line_number) + " has " + std::to_string(header.fields.size()) + ".");
}

void Table::read_header(const TextRow& header, const std::vector<TableColumn>& columns) {
  std::vector<std::string> known;
  for (const TableColumn& column : columns) known.push_back(column.name);
  for (std::size_t field = 0; field < header.fields.size(); ++field) {
    const std::string& text = header.fields[field];
    const std::size_t open = text.find('['), close = text.find(']');
    const std::string name{trimmed(text.substr(0, open))};
    const auto column = std::ranges::find(columns, upper_case(name), [](const auto& c) { return upper_case(c.name); });
    if (column == columns.end()) {
      notes_.push_back("column " + quoted(name) + " of " + file_.path.filename().string() + " is not used." +
                       did_you_mean(known, name));
      continue;
    }
    if (find_place(column->name) != nullptr)
      refuse_line(file_.path, header.line_number, "column " + column->name + " is given twice.");
    const bool has_unit = close != std::string::npos && open < close;
    if (!column->unit.empty() && !has_unit)
      refuse_line(file_.path, header.line_number,
                  "column " + column->name + " has no unit; write " + with_unit(*column) + ".");
    places_.push_back({*column, field, has_unit ? readable(text.substr(open + 1, close - open - 1)) : ""});
  }
  for (const TableColumn& column : columns)
    if (column.required && find_place(column.name) == nullptr)
      refuse_line(file_.path, header.line_number,
                  "column " + column.name + " is missing; write " + with_unit(column) + ".");
}

const Table::Place* Table::find_place(std::string_view column) const {
  const auto place = std::ranges::find(places_, column, [](const Place& each) { return each.column.name; });
  return place == places_.end() ? nullptr : &*place;
}

bool Table::has(std::string_view column) const { return find_place(column) != nullptr; }

std::string Table::text(std::size_t row, std::string_view column) const {
  const Place* place = find_place(column);
  return place == nullptr ? "" : rows_[row].fields[place->field];
}

std::string Table::word(std::size_t row, std::string_view column) const {
  if (!has(column)) {
    const auto known = std::ranges::find(columns_, column, &TableColumn::name);
    refuse_file(file_.path, "column " + known->name + " is missing; write " + with_unit(*known) + ".");
  }
  const std::string word = text(row, column);
  if (word.empty()) refuse(row, std::string{column} + " is empty.");
  return word;
}

double Table::si(std::size_t row, std::string_view column, int mass, int half_length, int time) const try {
  const Place& place = *find_place(column);
  const std::string field = text(row, column);
  return parse_si(place.unit.empty() ? field : field + " " + place.unit,
                  file_.path.string() + ", line " + std::to_string(rows_[row].line_number) + ", " + place.column.name,
                  mass, half_length, time);
} catch (const InputError& error) {
  throw FileError{error.what()};
}

void Table::refuse(std::size_t row, const std::string& problem) const {
  refuse_line(file_.path, rows_[row].line_number, problem);
}

void Table::require_unique(std::string_view column) const {
  std::map<std::string, std::size_t> lines;
  for (std::size_t row = 0; row < size(); ++row) {
    const std::string word_here = word(row, column);
    const auto [known, is_new] = lines.try_emplace(upper_case(word_here), rows_[row].line_number);
    if (!is_new) refuse(row, quoted(word_here) + " stands in line " + std::to_string(known->second) + " too.");
  }
}

}  // namespace moat
