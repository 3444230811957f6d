#include "structures/files/text_rows.hpp"

#include <algorithm>
#include <boost/tokenizer.hpp>
#include <utility>

namespace moat {
namespace {

std::vector<TextRow> lines_of(const TextFile& file) {
  std::vector<TextRow> lines;
  LineReader reader{file};
  for (std::string_view line; reader.next(line);) {
    const std::string_view words = trimmed(line);
    if (words.empty() || words.starts_with('#') || words.starts_with('%') || words.starts_with("//")) continue;
    lines.push_back({.line_number = reader.line_number(), .text = std::string{line}});
  }
  if (lines.empty()) refuse_file(file.path, "it has no lines, or comments only.");
  return lines;
}

template <class Separator>
std::vector<std::string> split(const std::string& text, const Separator& separator) {
  const boost::tokenizer<Separator> fields{text, separator};
  return {fields.begin(), fields.end()};
}

void cut(TextRow& row, char separator) {
  if (separator == ' ') {
    row.fields = split(row.text, boost::char_separator<char>{" \t"});
    return;
  }
  row.fields = split(row.text, boost::escaped_list_separator<char>{"", std::string{separator}, "\""});
  for (std::string& field : row.fields) field = trimmed(field);
}

// "1,5"
bool has_decimal_comma(std::string word) {
  const std::size_t comma = word.find(',');
  if (comma == std::string::npos || comma == 0 || comma + 1 == word.size()) return false;
  word[comma] = '.';
  return is_number(word);
}

}  // namespace

bool is_number(const std::string& field) { return parse_number(field).problem == nullptr; }

TextRows rows_of(const TextFile& file, char separator) {
  TextRows all{.rows = lines_of(file), .separator = separator};
  for (TextRow& row : all.rows) cut(row, separator);
  return all;
}

TextRows rows_of(const TextFile& file) {
  const std::string text = lines_of(file).back().text;
  const std::string_view last = trimmed(text);
  char separator = ' ';
  for (const char each : {',', '\t', ';'})
    if (last.find(each) != std::string::npos) separator = each;
  return rows_of(file, separator);
}

double number_in(const TextFile& file, const TextRow& row, std::size_t field) {
  const ScannedNumber number = parse_number(row.fields[field]);
  if (!number.problem) return number.value;
  const std::vector<std::string> words = split(row.text, boost::char_separator<char>{" \t;"});
  const auto is_or_has = [](const std::string& word) { return is_number(word) || has_decimal_comma(word); };
  if (std::ranges::all_of(words, is_or_has) && std::ranges::any_of(words, has_decimal_comma))
    refuse_line(file.path, row.line_number,
                quoted(row.text) + " has a decimal comma. Write decimals with a point: 1.5.");
  if (row.fields[field].empty())
    refuse_line(file.path, row.line_number, "field " + std::to_string(field + 1) + " is empty.");
  refuse_line(file.path, row.line_number, quoted(row.fields[field]) + " " + number.problem + ".");
}

}  // namespace moat
