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

bool ForceBalance::holds(const WorstRow& worst, const Vector& residual, const NonlinearSystem& system) const {
  if (std::isnan(worst.residual)) return false;
  if (worst.residual <= tolerance_) return true;
  // Every residual beyond the tolerance must be negligible, and round-off.
  const Vector& scales = system.residual_scales();
  const double largest = scales.maxCoeff();
  for (int i = 0; i < static_cast<int>(residual.size()); ++i) {
    const double magnitude = std::abs(residual[i]);
    if (magnitude <= tolerance_ * scales[i]) continue;
    if (magnitude > loosest_by_round_off * largest || magnitude > system.round_off(i)) return false;
  }
  return true;
}

}  // namespace moat
