#include "output/recorders/constant_quantities.hpp"

#include <algorithm>

namespace moat {

std::set<std::string> constant_quantities(const Table& histories) {
  std::set<std::string> constant, changing;
  for (const Column& column : histories.columns) {
    const auto is_first = [&](double value) { return value == column.values.front(); };
    const bool stays =
        column.values.size() > 1 && column.values.front() != 0.0 && std::ranges::all_of(column.values, is_first);
    (stays ? constant : changing).insert(column.quantity);
  }
  std::erase_if(constant, [&](const std::string& quantity) { return changing.contains(quantity); });
  return constant;
}

}  // namespace moat
