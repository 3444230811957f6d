#include "output/files/table_columns.hpp"

#include "base/error.hpp"

namespace moat {

std::string column_name(const Column& column) {
  std::string name = column.quantity + " [" + column.unit + "]";
  if (!column.where.empty()) name += " " + column.where;
  return name;
}

void require_equal_lengths(const Table& table) {
  for (const Column& column : table.columns) {
    if (!column.labels.empty() && column.labels.size() != column.values.size())
      throw InputError{"Table: column \"" + column_name(column) + "\" has " + std::to_string(column.labels.size()) +
                       " labels for " + std::to_string(column.values.size()) +
                       " values. Give one label for every value, or none."};
    if (column.values.size() != table.rows())
      throw InputError{"Table: column \"" + column_name(column) + "\" has " + std::to_string(column.values.size()) +
                       " values, the first column has " + std::to_string(table.rows()) +
                       ". Every column needs one value per row."};
  }
}

}  // namespace moat
