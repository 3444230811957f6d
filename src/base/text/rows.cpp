#include "base/text/rows.hpp"

#include <algorithm>
#include <boost/tokenizer.hpp>
#include <span>
#include <utility>

namespace moat {
namespace {

char separator_in(std::string_view line) {
  for (const char each : {';', '\t', ','})
    if (line.find(each) != std::string_view::npos) return each;
  return ' ';
}

template <class Separator>
std::vector<std::string> split(const std::string& text, const Separator& separator) {
  const boost::tokenizer<Separator> fields{text, separator};
  return {fields.begin(), fields.end()};
}

std::vector<std::string> fields_of(const std::string& line, char separator) {
  if (separator == ' ') return split(line, boost::char_separator<char>{" \t"});
  auto fields = split(line, boost::escaped_list_separator<char>{"", std::string{separator}, "\""});
  for (std::string& field : fields) field = trimmed(field);
  return fields;
}

// "1,5"
bool has_decimal_comma(std::string word) {
  const std::size_t comma = word.find(',');
  if (comma == 0 || comma >= word.size() - 1) return false;
  word[comma] = '.';
  return is_number(word);
}

}  // namespace

bool is_number(const std::string& field) { return parse_number(field).problem == nullptr; }

Rows::Rows(TextFile text, std::optional<char> separator_of_fields) : file{std::move(text)} {
  LineReader reader{file};
  for (std::string_view line; reader.next(line);) {
    const std::string_view words = trimmed(line);
    if (words.empty() || words.starts_with('#') || words.starts_with('%') || words.starts_with("//")) continue;
    list.push_back({.line_number = reader.line_number(), .text = std::string{line}});
  }
  if (list.empty()) refuse("it has no lines, or comments only.");
  separator = separator_of_fields.value_or(separator_in(trimmed(list.back().text)));
  for (Row& row : list) row.fields = fields_of(row.text, separator);
}

Row Rows::take_heading() {
  const Row heading = list.front();
  if (std::ranges::any_of(heading.fields, is_number))
    refuse(heading, "there are numbers where the heading must stand.");
  list.erase(list.begin());
  return heading;
}

double Rows::number(const Row& row, std::size_t field) const {
  const std::string& text = row.fields[field];
  const ScannedNumber number = parse_number(text);
  if (!number.problem) return number.value;
  const std::vector<std::string> words = split(row.text, boost::char_separator<char>{" \t;"});
  const auto commas = std::ranges::count_if(words, has_decimal_comma);
  if (commas > 0 && commas + std::ranges::count_if(words, is_number) == std::ssize(words))
    refuse(row, quoted(row.text) + " has a decimal comma. Write decimals with a point: 1.5.");
  refuse(row, text.empty() ? "field " + std::to_string(field + 1) + " is empty."
                           : quoted(text) + " " + number.problem + ".");
}

NumberRows numbers_of(const Rows& rows) {
  NumberRows numbers;
  const Row& first = rows.list.front();
  // Names may hold numbers: "floor 1" cut at the blank.
  if (rows.separator == ' ' ? !is_number(first.fields[0]) : std::ranges::none_of(first.fields, is_number))
    numbers.heading = first;
  const std::span<const Row> lines = std::span{rows.list}.subspan(numbers.heading ? 1 : 0);
  if (lines.empty()) rows.refuse("there are no numbers in it.");
  const std::size_t begin = std::ranges::none_of(lines, [](const Row& row) { return is_number(row.fields[0]); });
  const std::size_t columns = lines.front().fields.size() - begin;
  if (columns == 0) rows.refuse(lines.front(), "there is no number behind " + quoted(lines.front().fields[0]) + ".");
  numbers.values.resize(std::ssize(lines), static_cast<Eigen::Index>(columns));
  for (Eigen::Index i = 0; const Row& row : lines) {
    // A bad number, such as one with a decimal comma, may be the reason of a wrong count.
    std::vector<double> values;
    for (std::size_t field = begin; field < row.fields.size(); ++field) values.push_back(rows.number(row, field));
    if (values.size() != columns)
      rows.refuse(row, "it has " + counted(values.size(), "number") + ", line " +
                           std::to_string(lines.front().line_number) + " has " + std::to_string(columns) + ".");
    numbers.values.row(i++) = Eigen::RowVectorXd::Map(values.data(), numbers.values.cols());
    if (begin == 1) numbers.row_names.push_back(row.fields[0]);
  }
  return numbers;
}

}  // namespace moat
