#include "output/files/peak_table.hpp"

#include <algorithm>
#include <vector>

#include "base/text/utf8_text.hpp"
#include "output/peaks/peak_groups.hpp"

namespace moat {
namespace {

std::string padding(std::size_t width, const std::string& text) {
  return std::string(width - std::min(width, characters_in(text)), ' ');
}

// The sign gives left or right; only an element among several is named.
std::string remark(const PeakRow& row) {
  return row.side.empty() || row.side == "left" || row.side == "right" ? "" : "   " + row.side;
}

// Beyond this number of places only the largest and the smallest are shown.
constexpr std::size_t most_places = 12;

// Keeps of too many places the one with the largest size and the one with the smallest.
void shorten(PeakGroup& group) {
  if (group.rows.size() <= most_places) return;
  const std::string count = std::to_string(group.rows.size());
  const auto [smallest, largest] = std::ranges::minmax(group.rows, {}, &PeakRow::size);
  group.rows = {largest, smallest};
  group.rows.front().where += " (largest of " + count + ")";
  group.rows.back().where += " (smallest of " + count + ")";
}

std::string table_of(std::vector<PeakGroup> groups, const std::string& heading) {
  std::ranges::for_each(groups, shorten);
  std::size_t where_width = 0, value_width = 0, error_width = 0, time_width = 0;
  for (const PeakGroup& group : groups) {
    for (const PeakRow& row : group.rows) {
      where_width = std::max(where_width, characters_in(row.where));
      value_width = std::max(value_width, row.value.size() + row.missing.size());
      error_width = std::max(error_width, row.error.size());
      time_width = std::max(time_width, row.time.size());
    }
  }
  const auto error_column = [&](const PeakRow& row) {
    if (error_width == 0) return std::string{};
    return (row.error.empty() ? "    " : " +- ") + row.error + padding(error_width, row.error);
  };
  // Aligned in its own group alone: others have no such column.
  const auto second_column = [](const PeakGroup& group, const PeakRow& row) {
    if (row.second.empty()) return std::string{};
    std::size_t width = 0;
    for (const PeakRow& each : group.rows) width = std::max(width, each.second.size());
    return "   " + padding(width, row.second) + row.second + " " + group.second_unit;
  };
  std::string text;
  for (const PeakGroup& group : groups) {
    const bool has_errors = !std::ranges::all_of(group.rows, &std::string::empty, &PeakRow::error);
    text += heading + group.quantity + " [" + group.unit + "]" + (has_errors ? ", +- numerical error\n" : "\n");
    for (const PeakRow& row : group.rows)
      text += "  " + row.where + padding(where_width + 2, row.where) + padding(value_width, row.value + row.missing) +
              row.value + std::string(row.missing.size(), ' ') + error_column(row) + second_column(group, row) +
              "   at " + padding(time_width, row.time) + row.time + " s" + remark(row) + "\n";
  }
  return text;
}

}  // namespace

std::string peak_table(const CaseResult& result) { return table_of(groups_of_tables(result, shorten), "peak "); }

std::string table_at_the_end(const std::vector<Peak>& isolators) { return table_of(group_peaks(isolators), ""); }

std::string clearance_table(const CaseResult& result) {
  return result.clearances.empty() ? "" : table_of({clearance_group(result.clearances)}, "");
}

}  // namespace moat
