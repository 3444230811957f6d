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

}  // namespace moat
