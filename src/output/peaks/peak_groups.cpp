#include "output/peaks/peak_groups.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"
#include "output/files/rounded_error.hpp"

namespace moat {
namespace {

// The decimals that a number as text has, with the point.
std::string_view decimals_of(std::string_view number) {
  const std::size_t point = number.find('.');
  return point == std::string_view::npos ? std::string_view{} : number.substr(point);
}

void align_points(std::vector<PeakRow>& rows) {
  std::string_view longest;
  for (const PeakRow& row : rows)
    if (decimals_of(row.value).size() > longest.size()) longest = decimals_of(row.value);
  const std::string zeros = "." + std::string(longest.empty() ? 0 : longest.size() - 1, '0');
  if (longest.empty()) return;
  for (PeakRow& row : rows) row.missing = zeros.substr(decimals_of(row.value).size());
}

}  // namespace

std::vector<PeakGroup> group_peaks(const std::vector<Peak>& peaks) {
  std::vector<PeakGroup> groups;
  std::vector<char> done(peaks.size(), 0);
  for (std::size_t first = 0; first < peaks.size(); ++first) {
    if (done[first] != 0) continue;
    const EngineeringUnit unit = engineering_unit(peaks[first].unit);
    std::vector<const Peak*> members;
    double largest = 0.0;
    for (std::size_t i = first; i < peaks.size(); ++i) {
      if (peaks[i].quantity != peaks[first].quantity || peaks[i].unit != peaks[first].unit) continue;
      done[i] = 1;
      members.push_back(&peaks[i]);
      largest = std::max(largest, std::abs(unit.per_si * peaks[i].value));
    }
    PeakGroup group{in_words(peaks[first].quantity), unit.symbol, {}};
    for (const Peak* peak : members) {
      const RoundedError error = rounded_error(unit.per_si * peak->error);
      const int decimals = std::min(decimals_for(largest), error.decimals);
      group.rows.push_back({peak->where,
                            with_decimals(rounded_to(unit.per_si * peak->value, decimals), std::max(decimals, 0)),
                            {},
                            error.text,
                            with_decimals(peak->time, 3),
                            peak->side});
    }
    align_points(group.rows);
    groups.push_back(std::move(group));
  }
  return groups;
}

PeakGroup clearance_group(const std::vector<GapClearance>& clearances) {
  std::vector<Peak> peaks;
  for (const GapClearance& gap : clearances) {
    const EngineeringUnit unit = engineering_unit("m");
    peaks.push_back({"clearance_left", gap.where, gap.left, "m", gap.time, gap.error,
                     "of " + to_significant(unit.per_si * gap.clearance, 4) + " " + unit.symbol});
  }
  return peaks.empty() ? PeakGroup{} : group_peaks(peaks).front();
}

}  // namespace moat
