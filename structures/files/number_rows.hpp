// Numbers of a text file in rows and columns.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "structures/files/text_rows.hpp"

namespace moat {

/// The numbers of a file: equally many in every line, behind the name of the row where all lines begin with one. The
/// first line may be words.
struct NumberRows {
  Eigen::MatrixXd values{};
  std::vector<std::string> row_names{};  ///< empty where the file has none
  std::optional<TextRow> heading{};      ///< the first line, where it is words
  char separator = ' ';                  ///< as TextRows::separator

  /// Returns the fields of the heading, without the corner above names of rows.
  [[nodiscard]] std::vector<std::string> column_names() const;
  /// Whether the heading may be a sentence: it stands in one field, or blanks separate fields.
  [[nodiscard]] bool is_heading_of_words() const;
};

/// Throws FileError naming file and line: no numbers, a field that is none, another count than in the first line.
NumberRows number_rows_of(const TextFile& file, const TextRows& rows);

/// "1 number", "2 numbers"
std::string counted(std::size_t count, const std::string& one);

}  // namespace moat
