// A table of numbers whose columns know their quantity, place and unit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace moat {

struct Column {
  std::string quantity;  ///< "time", "displacement", ...
  std::string where;     ///< "base", "storey 1", ...; empty for time
  std::string unit;      ///< SI symbol
  std::vector<double> values;
};

/// Columns of equal length.
struct Table {
  std::vector<Column> columns;

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

}  // namespace moat
