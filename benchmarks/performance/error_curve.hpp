// Error against CPU time, and what a given error costs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace moat::performance {

/// One setting of a candidate, run.
struct CurvePoint {
  std::size_t setting = 0;
  double error = 0.0, seconds = 0.0;
};

/// The points that no other beats in both error and time, from the cheapest to the most exact.
std::vector<CurvePoint> lower_envelope(std::vector<CurvePoint> points);

/// What an error costs, between two neighbours on the envelope: time^(1 - share) of `cheaper` times time^share of
/// `dearer`, which is a straight line in a log-log chart.
struct ReadOff {
  std::size_t cheaper = 0, dearer = 0;  ///< settings
  double share = 0.0;
  bool always_better = false;  ///< no setting is that bad: the cheapest counts, and both settings are it

  /// Of the times of all settings.
  [[nodiscard]] double time(double of_cheaper, double of_dearer) const;
};

/// Empty if no point is that exact.
std::optional<ReadOff> read_off(const std::vector<CurvePoint>& envelope, double error);

}  // namespace moat::performance
