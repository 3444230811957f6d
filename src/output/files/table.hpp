// A table of numbers whose columns know their quantity, place and unit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace moat {

/// One column of numbers.
struct Column {
  std::string quantity;        ///< "time", "displacement", ...
  std::string where;           ///< "base", "storey 1", ...; empty for time
  std::string unit;            ///< SI symbol
  std::vector<double> values;  ///< in that unit
  /// Names of the values, for example of records; empty, or one for each value. CSV files hold them instead of numbers.
  std::vector<std::string> labels{};
};

/// Columns of equal length.
struct Table {
  std::vector<Column> columns;  ///< of equal length

  /// Number of values of every column.
  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  /// The values of one column. Throws InputError for an unknown one, with the places that the quantity has.
  [[nodiscard]] const std::vector<double>& values(std::string_view quantity, std::string_view where = "") const;
};

/// The name of a column in files: `quantity [unit] where`, for example `displacement [m] base`; `time [s]` where there
/// is no place.
std::string column_name(const Column& column);

/// Throws InputError naming the first column whose length differs from that of the first one.
void require_equal_lengths(const Table& table);

}  // namespace moat
