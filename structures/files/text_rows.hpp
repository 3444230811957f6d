// Rows of a text file: its lines, cut into fields.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/text_file.hpp"

namespace moat {

/// A line of a text file.
struct TextRow {
  std::size_t line_number = 0;        ///< from 1
  std::string text{};                 ///< whole
  std::vector<std::string> fields{};  ///< without blanks at both ends, and without quotes around them
};

/// The lines of a text file but for blank lines and comments, which begin with #, % or //.
struct TextRows {
  std::vector<TextRow> rows{};  ///< at least one
  char separator = ' ';         ///< of fields; ' ' stands for any blanks and tabs
};

/// Cuts a file. Its last line has a semicolon, or else a tab, or else a comma between fields, or else blanks; the first
/// ones may be words. Throws FileError for a file without such lines.
TextRows rows_of(const TextFile& file);
/// Cuts a file likewise, at a separator.
TextRows rows_of(const TextFile& file, char separator);

/// Returns a field as a number. Throws FileError naming the line and the field for anything else, and a decimal comma.
double number_in(const TextFile& file, const TextRow& row, std::size_t field);

/// Whether a field is a number.
bool is_number(const std::string& field);

}  // namespace moat
