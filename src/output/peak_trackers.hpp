// The largest magnitudes of many quantities between samples.
#pragma once

#include <cstddef>
#include <vector>

namespace moat {

/// Many PeakTrackers that see the same instants: the same peaks to the last bit, several quantities at a time. Nearly
/// all samples of nearly all quantities are neither larger than everything before nor behind a turn, and of those only
/// the last value and rise are kept.
class PeakTrackers {
 public:
  explicit PeakTrackers(std::size_t count);

  /// One value per quantity.
  void add(double time, const double* values);
  /// The values just after an event; the past is not used for interpolation any more.
  void restart(double time, const double* values);

  [[nodiscard]] std::size_t size() const { return magnitudes_.size(); }
  [[nodiscard]] double magnitude(std::size_t i) const { return magnitudes_[i]; }
  [[nodiscard]] double time(std::size_t i) const { return times_[i]; }

 private:
  void look(std::size_t i, double time, double value);
  void keep(std::size_t i, double time, double value);

  std::vector<double> magnitudes_, times_;
  // Of the last sample, and its rise since the one before; that one's rise too.
  std::vector<double> values_, rises_, rises_before_;
  double time_before_ = 0.0, time_ = 0.0;  // of the last two samples
  int count_ = 0;
};

}  // namespace moat
