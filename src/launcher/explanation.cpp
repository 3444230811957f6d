#include "launcher/explanation.hpp"

#include <algorithm>
#include <cstddef>
#include <regex>

#include "base/nearest_name.hpp"
#include "launcher/dimension_names.hpp"
#include "launcher/struct_fields.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

// A line of the source with a mark below.
Explanation marked(const Diagnostic& place, int line, const std::string& source, std::size_t column, std::size_t length,
                   const std::string& sentence) {
  const std::string number = std::to_string(line), bar = " | ";
  return {.sentence = sentence,
          .file = place.file,
          .line = line,
          .snippet = "   " + number + bar + source + "\n   " + std::string(number.size(), ' ') + bar +
                     std::string(column, ' ') + std::string(length, '^') + "\n"};
}

}  // namespace

std::string snippet_of(const Diagnostic& place) {
  constexpr std::size_t source_and_marks = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(source_and_marks, place.snippet.size()); ++i) text += place.snippet[i] + "\n";
  return text;
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
  const std::size_t newline = source.rfind('\n', field.offset);
  const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
  const auto line = 1 + std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
  return marked(place, static_cast<int>(line), source.substr(begin, source.find('\n', begin) - begin),
                field.offset - begin, field.name.size() + 1, sentence);
}

std::string plain_name(const std::string& type, const std::filesystem::path& root) {
  const std::string name = with_dimension_names(type);
  return name_in_scripts(name.starts_with("const ") ? name.substr(6) : name, root);
}

std::string without_second_names(const std::string& text) {
  static const std::regex second{R"( \{aka '[^']*'\})"};
  return std::regex_replace(text, second, "");
}

std::string unit_hint(const std::string& needed, const std::string& value) {
  static const std::regex simple{R"(.*\[([A-Za-z]+)\].*)"};
  std::smatch match;
  const bool has_example = !value.empty() && std::regex_match(needed, match, simple);
  return "; give it a unit, as in " + (has_example ? value + " * " + match[1].str() : "10 * cm");
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
