// Tables of a building as CSV.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parse_quantity.hpp"
#include "base/text/rows.hpp"

namespace moat {

/// A table whose first line names its columns, in any order, with units in brackets:
///
///     name,kx [kN/m],mass [t]
///     floor 1,900e3,820
class InputTable {
 public:
  /// `required`, `optional`: columns that the reader knows, as messages suggest them, "name" or "kx [kN/m]"; a file may
  /// have other units. Columns that are not known are named in notes(). Throws FileError for a required column that is
  /// missing, a column without its unit, a column that is given twice, and a line with another count of fields than the
  /// first.
  InputTable(Rows rows, const std::vector<std::string>& required, const std::vector<std::string>& optional = {});

  [[nodiscard]] std::size_t size() const { return rows_.list.size(); }  ///< Number of rows, without the header.
  /// Whether the file has it.
  [[nodiscard]] bool has(std::string_view column) const { return named(column).field.has_value(); }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }  ///< Remarks, sentences.
  [[nodiscard]] std::string source() const { return file_of(rows_.file).path; }   ///< Absolute path.

  /// Returns the text of a field; empty where the column is missing.
  [[nodiscard]] std::string text(std::size_t row, std::string_view column) const;
  /// Returns the text of a field. Throws FileError for an empty one.
  [[nodiscard]] std::string word(std::size_t row, std::string_view column) const;
  /// Returns a quantity. Throws FileError for a field that is empty, missing or no number, and for a unit of another
  /// dimension.
  template <class Q>
  [[nodiscard]] Q at(std::size_t row, std::string_view column) const {
    return Q{si(row, column, Q::mass_exponent, Q::half_length_exponent, Q::time_exponent)};
  }
  /// Returns a quantity that must be > 0. Throws FileError likewise, and for others.
  template <class Q>
  [[nodiscard]] Q positive(std::size_t row, std::string_view column) const {
    const Q value = at<Q>(row, column);
    if (!(value.si() > 0.0)) refuse(row, std::string{column} + " is " + text(row, column) + "; it must be > 0.");
    return value;
  }
  /// Throws FileError with file and line of a row.
  [[noreturn]] void refuse(std::size_t row, const std::string& problem) const {
    rows_.refuse(rows_.list[row], problem);
  }
  /// Throws FileError for a word of a column that two rows have, in capitals or not.
  void require_unique(std::string_view column) const;

 private:
  struct Column {
    std::string text, name;                 // "kx [kN/m]", "kx"
    std::optional<std::size_t> field = {};  // of a row; none where the file does not have the column
    std::string unit = {};                  // in the file
  };
  [[nodiscard]] const Column& named(std::string_view column) const;
  [[nodiscard]] double si(std::size_t row, std::string_view column, int mass, int half_length, int time) const;

  Rows rows_;
  std::vector<Column> columns_;
  std::vector<std::string> notes_;
};

}  // namespace moat
