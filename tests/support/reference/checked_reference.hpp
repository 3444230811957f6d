// The independent reference, and how far its peaks can be trusted.
#pragma once

#include <vector>

#include "reference_history.hpp"

namespace moat::testing {

/// The reference with the estimate of its own error.
struct CheckedReference {
  ReferenceResult result;            ///< of the finer run
  std::vector<double> peak_changes;  ///< relative, from a run with twice the steps and 32 times the tolerance
  bool same_touches = true;          ///< both runs saw the same gaps touch in the same order
  double largest_change = 0.0;       ///< of the peaks that count; see `counting_peaks`

  [[nodiscard]] bool settled(double relative) const { return same_touches && largest_change <= relative; }
};

/// Runs the reference twice.
CheckedReference checked_reference(const PlainModel& model, const ReferenceOptions& options = {});

/// For each peak, whether it counts in comparisons: those of at least a thousandth of the largest peak of their
/// quantity in the model.
std::vector<bool> counting_peaks(const std::vector<ReferencePeak>& peaks);

}  // namespace moat::testing
