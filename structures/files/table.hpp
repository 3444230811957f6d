// Tables of a building as CSV.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/parse_quantity.hpp"
#include "structures/files/text_rows.hpp"

namespace moat {

/// A column that a reader knows.
struct TableColumn {
  std::string name;    ///< in the header: "kx"
  std::string unit{};  ///< one that messages suggest: "kN/m"; empty for words and plain numbers
  bool required = false;
};

/// A table whose first line names its columns, in any order, with units in brackets:
///
///     name,kx [kN/m],mass [t]
///     floor 1,900e3,820
class Table {
 public:
  /// Reads the file and notes it (base/files_read.hpp). Columns that are not known are named in notes(). Throws
  /// FileError for a required column that is missing, a column without its unit, a column that is given twice, and a
  /// line with another count of fields than the first.
  Table(const std::filesystem::path& path, std::vector<TableColumn> columns);

  [[nodiscard]] std::size_t size() const { return rows_.size(); }  ///< Number of rows, without the header.
  [[nodiscard]] bool has(std::string_view column) const;           ///< Whether it has this column.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }  ///< Remarks, sentences.
  [[nodiscard]] std::string source() const { return file_of(file_).path; }        ///< Absolute path.
  [[nodiscard]] const std::filesystem::path& path() const { return file_.path; }  ///< As given.

  /// Returns the text of a field; empty where the column is missing.
  [[nodiscard]] std::string text(std::size_t row, std::string_view column) const;
  /// Returns the text of a field. Throws FileError for an empty one.
  [[nodiscard]] std::string word(std::size_t row, std::string_view column) const;
  /// Returns a quantity; nothing where the column is missing or its field is empty. Throws FileError for anything that
  /// is no number, and for a unit of another dimension.
  template <class Q>
  [[nodiscard]] std::optional<Q> find(std::size_t row, std::string_view column) const {
    if (text(row, column).empty()) return std::nullopt;
    return Q{si(row, column, Q::mass_exponent, Q::half_length_exponent, Q::time_exponent)};
  }
  /// Returns a quantity. Throws FileError likewise, and for a field that is empty or missing.
  template <class Q>
  [[nodiscard]] Q at(std::size_t row, std::string_view column) const {
    (void)word(row, column);
    return *find<Q>(row, column);
  }
  /// Returns a quantity that must be > 0. Throws FileError likewise, and for others.
  template <class Q>
  [[nodiscard]] Q positive(std::size_t row, std::string_view column) const {
    const Q value = at<Q>(row, column);
    if (!(value.si() > 0.0)) refuse(row, std::string{column} + " is " + text(row, column) + "; it must be > 0.");
    return value;
  }
  /// Throws FileError with file and line of a row.
  [[noreturn]] void refuse(std::size_t row, const std::string& problem) const;
  /// Throws FileError for a word of a column that two rows have, in capitals or not.
  void require_unique(std::string_view column) const;

 private:
  // Field of a row and unit in the header.
  struct Place {
    TableColumn column;
    std::size_t field;
    std::string unit;
  };
  void read_header(const TextRow& header, const std::vector<TableColumn>& columns);
  [[nodiscard]] const Place* find_place(std::string_view column) const;
  [[nodiscard]] double si(std::size_t row, std::string_view column, int mass, int half_length, int time) const;

  TextFile file_;
  std::vector<TableColumn> columns_;
  std::vector<TextRow> rows_;
  std::vector<Place> places_;
  std::vector<std::string> notes_;
};

}  // namespace moat
