#include "output/files/table.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace moat {

const std::vector<double>& Table::values(std::string_view quantity, std::string_view where) const {
  const auto found = std::ranges::find_if(
      columns, [&](const Column& each) { return each.quantity == quantity && each.where == where; });
  if (found != columns.end()) return found->values;
  std::string places;
  for (const Column& column : columns)
    if (column.quantity == quantity) places.append(places.empty() ? "" : ", ").append("\"" + column.where + "\"");
  throw InputError{"Table: there is no column \"" + std::string{quantity} + "\" of \"" + std::string{where} + "\". " +
                   (places.empty() ? "No column has this quantity." : "The quantity has columns of " + places + ".")};
}

std::string column_name(const Column& column) {
  return column.quantity + " [" + column.unit + "]" + (column.where.empty() ? "" : " " + column.where);
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
