// The largest magnitude of a quantity of which only samples are known.
#pragma once

#include <cmath>

namespace moat::performance {

/// Follows one quantity through instants at unequal distances and keeps its largest magnitude over
/// continuous time: where neighbouring samples turn, the vertex of the parabola through three of them counts.
/// Quantities may jump at events; restart() keeps the parabola from reaching across.
class ParabolaPeak {
 public:
  void add(double time, double value) {
    keep(time, value);
    const double last_rise = rise_, rise = value - middle_;
    // Two equal samples with the turn between them are a vertex too; more of them are a plateau.
    const bool turns = count_ >= 2 && last_rise * rise < 0.0;
    const bool turned_between = count_ >= 3 && last_rise == 0.0 && rise_before_ * rise < 0.0;
    if (turns || turned_between) keep_vertex(time, value);
    rise_before_ = last_rise;
    rise_ = rise;
    first_ = middle_;
    first_time_ = middle_time_;
    middle_ = value;
    middle_time_ = time;
    if (count_ < 3) ++count_;
  }

  /// The value just after an event; the past is not used for interpolation any more.
  void restart(double time, double value) {
    count_ = 0;
    add(time, value);
  }

  [[nodiscard]] double magnitude() const { return magnitude_; }
  [[nodiscard]] double time() const { return time_; }

 private:
  void keep(double time, double value) {
    if (std::abs(value) <= magnitude_) return;
    magnitude_ = std::abs(value);
    time_ = time;
  }

  void keep_vertex(double time, double value) {
    const double before = middle_time_ - first_time_, after = time - middle_time_;
    if (before <= 0.0 || after <= 0.0) return;
    const double slope_before = (middle_ - first_) / before, slope_after = (value - middle_) / after;
    const double curvature = (slope_after - slope_before) / (before + after);
    const double slope = (slope_before * after + slope_after * before) / (before + after);
    const double shift = -0.5 * slope / curvature;
    keep(middle_time_ + shift, middle_ + 0.5 * slope * shift);
  }

  double magnitude_ = 0.0, time_ = 0.0;
  double first_ = 0.0, middle_ = 0.0, first_time_ = 0.0, middle_time_ = 0.0;
  double rise_ = 0.0, rise_before_ = 0.0;  // between the last two samples, and the two before
  int count_ = 0;
};

}  // namespace moat::performance
