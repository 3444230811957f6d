#include "solvers/force_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moat {

WorstRow ForceBalance::worst_row(const Vector& residual, const NonlinearSystem& system) {
  const Vector& scales = system.residual_scales();
  WorstRow worst;
  for (int i = 0; i < static_cast<int>(residual.size()); ++i) {
    const double magnitude = std::abs(residual[i]);
    // A division for every row would take longer than the rest of the loop.
    if (magnitude <= worst.residual * scales[i]) continue;
    // No comparison with NaN is true.
    if (!std::isfinite(magnitude)) return no_number(residual);
    worst = {magnitude / scales[i], i};
  }
  return worst;
}

WorstRow ForceBalance::no_number(const Vector& residual) {
  const auto bad = std::find_if_not(residual.begin(), residual.end(), [](double r) { return std::isfinite(r); });
  return {std::numeric_limits<double>::quiet_NaN(),
          bad == residual.end() ? 0 : static_cast<int>(bad - residual.begin())};
}

bool ForceBalance::holds(const WorstRow& worst, const Vector& residual, const NonlinearSystem& system) {
  if (std::isnan(worst.residual)) return false;
  const double largest = std::max(largest_, system.residual_scales().maxCoeff());
  if (worst.residual > tolerance_ && !is_round_off(residual, system, largest)) return false;
  largest_ = largest;
  return true;
}

// Whether every residual beyond the tolerance is negligible beside the largest scale and within the round-off of its
// row.
bool ForceBalance::is_round_off(const Vector& residual, const NonlinearSystem& system, double largest) const {
  const Vector& scales = system.residual_scales();
  for (int i = 0; i < static_cast<int>(residual.size()); ++i) {
    const double magnitude = std::abs(residual[i]);
    if (magnitude <= tolerance_ * scales[i]) continue;
    if (magnitude > loosest_by_round_off * largest || magnitude > system.round_off(i)) return false;
  }
  return true;
}

}  // namespace moat
