// Rows of a text file: its lines, cut into fields.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "base/text/text_file.hpp"

namespace moat {

/// A line of a text file.
struct Row {
  std::size_t line_number = 0;        ///< from 1
  std::string text{};                 ///< whole
  std::vector<std::string> fields{};  ///< without blanks at both ends, and without quotes around them
};

/// The lines of a text file but for blank lines and comments, which begin with #, % or //.
struct Rows {
  TextFile file;
  std::vector<Row> list{};  ///< at least one, before take_heading()
  char separator = ' ';     ///< of fields; ' ' stands for any blanks and tabs

  /// Left out, the separator is a semicolon, or else a tab, or else a comma of the last line, or else blanks; the first
  /// lines may be words. Throws FileError for a file without lines.
  Rows(TextFile text, std::optional<char> separator_of_fields = {});
  /// Removes the first row and returns it. Throws FileError where it has a number: such a file has no heading.
  Row take_heading();
  /// Returns a field as a number. Throws FileError for anything else, also for a decimal comma.
  [[nodiscard]] double number(const Row& row, std::size_t field) const;
  /// Throws FileError naming the file.
  [[noreturn]] void refuse(const std::string& problem) const { refuse_file(file.path, problem); }
  /// Throws FileError naming the file and the line.
  [[noreturn]] void refuse(const Row& row, const std::string& problem) const {
    refuse_line(file.path, row.line_number, problem);
  }
};

/// Numbers, equally many in every row, behind the name of the row where all rows begin with one.
struct NumberRows {
  Eigen::MatrixXd values{};
  std::vector<std::string> row_names{};  ///< empty where the file has none
  std::optional<Row> heading{};          ///< the first row, where it is words
};

/// Throws FileError naming file and line: no numbers, a field that is none, another count than in the first row.
NumberRows numbers_of(const Rows& rows);

/// Whether a field is a number.
bool is_number(const std::string& field);

/// "1 number", "2 numbers"
std::string counted(std::integral auto count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

}  // namespace moat
