#include "output/peak_groups.hpp"

#include <algorithm>
#include <cmath>

#include "output/engineering_unit.hpp"

namespace moat {

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
    for (const Peak* peak : members)
      group.rows.push_back(
          {peak->where, with_decimals(unit.per_si * peak->value, decimals_for(largest)), with_decimals(peak->time, 3)});
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace moat
