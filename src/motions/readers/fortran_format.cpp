#include "motions/readers/fortran_format.hpp"

#include <algorithm>
#include <string>

#include "motions/readers/text_file.hpp"

namespace moat {

std::optional<FortranFormat> find_fortran_format(std::string_view line) {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  rest.remove_prefix(std::min(rest.rfind("FORMAT"), rest.size()));
  if (!take(rest, "FORMAT") || !take(rest, "=") || !take(rest, "(")) return std::nullopt;
  FortranFormat found{.per_line = take_whole_number(rest).value_or(1)};
  rest = without_leading_blanks(rest);
  const std::string_view kind = rest.substr(0, 1);
  rest.remove_prefix(kind.size());
  // A blank inside is a digit that was lost.
  if (!rest.starts_with(' ')) found.width = take_whole_number(rest).value_or(0);
  const bool has_decimals = rest.starts_with('.');
  if (has_decimals) rest.remove_prefix(1);
  if ((has_decimals && !take_whole_number(rest)) || !take(rest, ")")) return std::nullopt;
  found.whole = kind == "I";
  constexpr std::size_t most_fields = 200, widest = 40;
  // A number with a fraction needs its decimals in the format: (8F10) is none.
  if (found.whole == has_decimals || std::string_view{"FEDGI"}.find(kind) == std::string_view::npos)
    return std::nullopt;
  if (found.per_line < 1 || found.per_line > most_fields || found.width < 1 || found.width > widest)
    return std::nullopt;
  return found;
}

std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format, std::size_t most) {
  line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin < line.size() && fields.size() < most; begin += format.width)
    fields.push_back(trimmed(line.substr(begin, format.width)));
  return fields;
}

}  // namespace moat
