#include "output/files/peak_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "output/peaks/peak_groups.hpp"
#include "output/recorders/constant_quantities.hpp"

namespace moat {
namespace {

std::size_t letters(const std::string& text) {
  // Continuation bytes of UTF-8 take no room on the screen.
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padding(std::size_t width, const std::string& text) {
  return std::string(width - std::min(width, letters(text)), ' ');
}

// The sign gives left or right; only an element among several is named.
std::string remark(const PeakRow& row) {
  return row.side.empty() || row.side == "left" || row.side == "right" ? "" : "   " + row.side;
}

// Beyond this number of places only the largest and the smallest are shown.
constexpr std::size_t most_places = 12;

std::string among(const char* which, std::size_t count) {
  return std::string{" ("} + which + " of " + std::to_string(count) + ")";
}

// Entries of the same key together; of too many the one with the largest size and the one with the smallest.
template <class Entry, class Key, class Size>
std::vector<Entry> shortened(const std::vector<Entry>& entries, const Key& key_of, const Size& size_of) {
  std::map<std::decay_t<decltype(key_of(entries.front()))>, std::vector<const Entry*>> groups;
  for (const Entry& entry : entries) groups[key_of(entry)].push_back(&entry);
  std::vector<Entry> kept;
  for (const Entry& entry : entries) {
    const std::vector<const Entry*>& group = groups[key_of(entry)];
    if (group.size() <= most_places) {
      kept.push_back(entry);
    } else if (&entry == group.front()) {
      const auto [smallest, largest] =
          std::ranges::minmax_element(group, [&](const Entry* a, const Entry* b) { return size_of(*a) < size_of(*b); });
      kept.insert(kept.end(), {**largest, **smallest});
      kept[kept.size() - 2].where += among("largest", group.size());
      kept.back().where += among("smallest", group.size());
    }
  }
  return kept;
}

std::pair<std::string, std::string> quantity_of(const Peak& peak) { return {peak.quantity, peak.unit}; }
double magnitude_of(const Peak& peak) { return peak.magnitude(); }

std::string table_of(const std::vector<PeakGroup>& groups, const std::string& heading) {
  std::size_t where_width = 0, value_width = 0, error_width = 0, time_width = 0;
  for (const PeakGroup& group : groups) {
    for (const PeakRow& row : group.rows) {
      where_width = std::max(where_width, letters(row.where));
      value_width = std::max(value_width, row.value.size() + row.missing.size());
      error_width = std::max(error_width, row.error.size());
      time_width = std::max(time_width, row.time.size());
    }
  }
  const auto error_column = [&](const PeakRow& row) {
    if (error_width == 0) return std::string{};
    return (row.error.empty() ? "    " : " +- ") + row.error + padding(error_width, row.error);
  };
  std::string text;
  for (const PeakGroup& group : groups) {
    text += heading + group.quantity + " [" + group.unit + "]\n";
    for (const PeakRow& row : group.rows)
      text += "  " + row.where + padding(where_width + 2, row.where) + padding(value_width, row.value + row.missing) +
              row.value + std::string(row.missing.size(), ' ') + error_column(row) + "   at " +
              padding(time_width, row.time) + row.time + " s" + remark(row) + "\n";
  }
  return text;
}

}  // namespace

std::string peak_table(const CaseResult& result) {
  const std::set<std::string> constant = constant_quantities(result.histories);
  std::vector<Peak> peaks = result.peaks;
  std::erase_if(peaks, [&](const Peak& peak) { return constant.contains(peak.quantity); });
  return table_of(group_peaks(shortened(peaks, quantity_of, magnitude_of)), "peak ");
}

std::string table_at_the_end(const std::vector<Peak>& isolators) {
  return isolators.empty() ? "" : table_of(group_peaks(shortened(isolators, quantity_of, magnitude_of)), "");
}

std::string clearance_table(const CaseResult& result) {
  if (result.clearances.empty()) return "";
  const auto all_together = [](const GapClearance&) { return 0; };
  return table_of(
      {clearance_group(shortened(result.clearances, all_together, [](const GapClearance& gap) { return gap.left; }))},
      "");
}

}  // namespace moat
