#include "launcher/explanation.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <regex>
#include <string_view>
#include <utility>

#include "base/nearest_name.hpp"
#include "launcher/dimension_names.hpp"
#include "launcher/struct_fields.hpp"
#include "launcher/text.hpp"
#include "launcher/value_dimension.hpp"

namespace moat::launcher {
namespace {

// A line of the source, such as "   12 | return hight;", and its marks. Of a long one the surroundings of the marks.
std::string lines_near_marks(const std::string& source, const std::string& marks) {
  if (source.size() <= longest_line) return source + "\n" + marks + "\n";
  constexpr std::size_t shown = longest_line / 2;
  const std::size_t front = source.find('|') + 2, mark = std::min(marks.find_first_of("~^", front), marks.size());
  const std::size_t begin = std::max(front, mark - std::min(mark, shown / 2));
  return source.substr(0, front) + "... " + source.substr(begin, shown) + " ...\n" + marks.substr(0, front) + "    " +
         marks.substr(std::min(begin, marks.size()), shown) + "\n";
}

// A line of the source with a mark below.
Explanation marked(const Diagnostic& place, int line, const std::string& source, std::size_t column, std::size_t length,
                   const std::string& sentence) {
  const std::string number = std::to_string(line), bar = " | ";
  return {.sentence = sentence,
          .file = place.file,
          .line = line,
          .snippet =
              lines_near_marks("   " + number + bar + source, "   " + std::string(number.size(), ' ') + bar +
                                                                  std::string(column, ' ') + std::string(length, '^'))};
}

// The unit of a quantity as scripts write it: "N * s / m" for "N s/m".
std::string in_source(const std::string& unit) {
  static const std::array<std::pair<std::string_view, std::string_view>, 7> units{{{"1/s", "Hz"},
                                                                                   {"m/s", "m / s"},
                                                                                   {"m/s^2", "m / (s * s)"},
                                                                                   {"W", "J / s"},
                                                                                   {"N/m", "N / m"},
                                                                                   {"N s/m", "N * s / m"},
                                                                                   {"N/m^1.5", "N / m_3_2"}}};
  for (const auto& [symbol, words] : units)
    if (symbol == unit) return std::string{words};
  return unit;
}

}  // namespace

std::string snippet_of(const Diagnostic& place) {
  if (place.snippet.empty()) return "";
  return lines_near_marks(place.snippet[0], place.snippet.size() > 1 ? place.snippet[1] : "");
}

Explanation at(const Diagnostic& place, const std::string& sentence) {
  return {.sentence = sentence, .file = place.file, .line = place.line, .snippet = snippet_of(place)};
}

Explanation at_field(const Diagnostic& place, const std::string& field, const std::string& sentence) {
  const std::vector<std::string> source = lines_of(text_of(place.file));
  for (std::size_t line = std::min(source.size(), static_cast<std::size_t>(place.line)); line > 0; --line) {
    const std::size_t column = source[line - 1].find("." + field);
    if (column == std::string::npos) continue;
    return marked(place, static_cast<int>(line), source[line - 1], column, field.size() + 1, sentence);
  }
  return at(place, sentence);
}

Explanation at_field(const Diagnostic& place, const std::string& source, const NamedField& field,
                     const std::string& sentence) {
  return at_offset(place, source, field.offset, field.name.size() + 1, sentence);
}

Explanation at_offset(const Diagnostic& place, const std::string& source, std::size_t offset, std::size_t length,
                      const std::string& sentence) {
  const std::size_t newline = offset == 0 ? std::string::npos : source.rfind('\n', offset - 1);
  const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
  return marked(place, line_at(source, offset), source.substr(begin, source.find('\n', begin) - begin), offset - begin,
                length, sentence);
}

std::string plain_name(const std::string& type, const std::filesystem::path& root) {
  const std::string name = with_dimension_names(type);
  return name_in_scripts(name.starts_with("const ") ? name.substr(6) : name, root);
}

std::string without_second_names(const std::string& text) {
  static const std::regex second{R"( \{aka '[^']*'\})"};
  return replaced(text, second, "");
}

std::string needed_in_words(const std::string& type) {
  static const std::regex optional{R"((?:std::)?optional<(.*)>)"};
  const std::string plain = replaced(with_dimension_names(type), optional, "$1");
  return plain == "int" ? "a whole number" : described(plain);
}

std::string unit_hint(const std::string& needed, const std::string& value) {
  static const std::regex symbol{R"(.*\[(.*?)(?: = .*)?\].*)"};
  std::smatch match;
  if (!matches(needed, match, symbol)) return {};
  if (value.empty() && match[1] == "m") return "; give it a unit, as in 10 * cm";
  const bool is_sum = value.find_first_of("+-", 1) != std::string::npos && !is_number(value);
  const std::string number = is_sum ? "(" + value + ")" : value;
  return "; give it a unit, as in " + (value.empty() ? "10" : number) + " * " + in_source(match[1]);
}

std::string whole_number_hint(const std::string& value) {
  static const std::regex whole{R"(([0-9]+)\.0*)"};
  std::smatch match;
  return matches(value, match, whole) ? "; write " + match[1].str() : "";
}

std::string no_such_field(const std::string& type, const std::string& field, const std::vector<std::string>& fields) {
  const std::string nearest = nearest_name(fields, field);
  std::string hint;
  if (!nearest.empty())
    hint = "; did you mean " + nearest + "?";
  else if (!fields.empty())
    hint = "; it has " + joined(fields, ", ");
  return type + " has no field " + field + hint;
}

std::string wrong_place(const std::string& type, const std::string& field, const std::vector<std::string>& fields) {
  return "field " + field + " of " + type + " stands in the wrong place; the order is " +
         (fields.empty() ? "that of the struct" : joined(fields, ", "));
}

}  // namespace moat::launcher
