#include "checked_reference.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace moat::testing {

std::vector<bool> counting_peaks(const std::vector<ReferencePeak>& peaks) {
  constexpr double least_share = 1e-3;
  std::map<std::string, double> largest;
  for (const ReferencePeak& peak : peaks) largest[peak.quantity] = std::max(largest[peak.quantity], peak.value);
  std::vector<bool> counts;
  for (const ReferencePeak& peak : peaks)
    counts.push_back(peak.value > 0.0 && peak.value >= least_share * largest[peak.quantity]);
  return counts;
}

CheckedReference checked_reference(const PlainModel& model, const ReferenceOptions& options) {
  const ReferenceResult coarse = reference_history(model, options);
  CheckedReference checked{.result = reference_history(model, {.largest_phase = options.largest_phase / 2.0,
                                                               .tolerance = options.tolerance / 32.0}),
                           .peak_changes = {}};
  const ReferenceResult& fine = checked.result;
  const std::vector<bool> counts = counting_peaks(fine.peaks);
  for (std::size_t i = 0; i < fine.peaks.size(); ++i) {
    const double value = fine.peaks[i].value;
    const double change = value > 0.0 ? std::abs(coarse.peaks[i].value / value - 1.0) : 0.0;
    checked.peak_changes.push_back(change);
    if (counts[i]) checked.largest_change = std::max(checked.largest_change, change);
  }
  checked.same_touches =
      std::equal(coarse.touches.begin(), coarse.touches.end(), fine.touches.begin(), fine.touches.end(),
                 [](const ReferenceTouch& a, const ReferenceTouch& b) { return a.gap == b.gap; });
  return checked;
}

}  // namespace moat::testing
