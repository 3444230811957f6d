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

/// `points`: settings that differ in one thing, from the loosest to the tightest. Each error becomes the largest of its
/// own and all tighter ones, so that a setting which is exact by chance gains nothing.
std::vector<CurvePoint> with_lasting_errors(std::vector<CurvePoint> points);

/// The points that no other beats in both error and time, from the cheapest to the most exact.
std::vector<CurvePoint> lower_envelope(std::vector<CurvePoint> points);

/// What an error costs: time^(1 - share) of `looser` times time^share of `tighter`, which is a straight line in a
/// log-log chart.
struct ReadOff {
  std::size_t looser = 0, tighter = 0;  ///< settings
  double share = 0.0;
  bool always_better = false;  ///< no setting is that bad: the cheapest counts, and both settings are it

  /// Of the times of both.
  [[nodiscard]] double time(double of_looser, double of_tighter) const;
};

/// `points` as in with_lasting_errors. Between the first setting from which on all keep to the error and the one before
/// it, which does not. Empty if the tightest does not.
std::optional<ReadOff> read_off(const std::vector<CurvePoint>& points, double error);

}  // namespace moat::performance
