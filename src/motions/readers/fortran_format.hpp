// Numbers in the columns of a Fortran format.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace moat {

/// A format of equal fields, such as (8F10.5) or (10I8).
struct FortranFormat {
  std::size_t per_line = 1;
  std::size_t width = 0;  ///< of one field, characters
  bool whole = false;     ///< I: whole numbers
};

/// The format in "... Format= (8F10.5)", in capitals or small letters; nothing where there is none that is known. Known
/// are F, E, D, G and I with a width of 1 to 40 and 1 to 200 fields on a line.
std::optional<FortranFormat> find_fortran_format(std::string_view line);

/// The fields of a line, without blanks around them: as many as the line has columns for, up to `most`.
std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format, std::size_t most);

}  // namespace moat
