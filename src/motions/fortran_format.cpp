#include "motions/fortran_format.hpp"

#include <algorithm>
#include <regex>
#include <string>

#include "motions/text_file.hpp"

namespace moat {

std::optional<FortranFormat> find_fortran_format(std::string_view line) {
  static const std::regex format{R"(FORMAT *= *\( *([0-9]{0,3}) *([FEDGI])([0-9]{1,2})(\.[0-9]{1,2})? *\))"};
  const std::string capitals = upper_case(line);
  std::smatch match;
  if (!std::regex_search(capitals, match, format)) return std::nullopt;
  FortranFormat found;
  if (match[1].length() > 0) found.per_line = std::stoul(match[1]);
  found.width = std::stoul(match[3]);
  found.whole = match[2] == "I";
  constexpr std::size_t most_fields = 200, widest = 40;
  // A number with a fraction needs its decimals in the format: (8F10) is none.
  if (found.whole == match[4].matched) return std::nullopt;
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
