#include "output/peak_trackers.hpp"

#include <algorithm>
#include <cmath>

namespace moat {
namespace {

// Two numbers in one register of any x86-64 and arm64 processor.
using Pair = double __attribute__((vector_size(16), aligned(8), may_alias));

}  // namespace

PeakTrackers::PeakTrackers(std::size_t count)
    : magnitudes_(count, 0.0), times_(count, 0.0), values_(count, 0.0), rises_(count, 0.0), rises_before_(count, 0.0) {}

void PeakTrackers::add(double time, const double* values) {
  constexpr std::size_t at_once = 4, half = 2;
  // What may be a peak: larger than all before, a turn, or a rise after a standstill.
  const auto notable = [&](std::size_t i) {
    const Pair value = *reinterpret_cast<const Pair*>(values + i);
    const Pair magnitude = *reinterpret_cast<const Pair*>(&magnitudes_[i]);
    const Pair last_rise = *reinterpret_cast<const Pair*>(&rises_[i]);
    const Pair rise = value - *reinterpret_cast<const Pair*>(&values_[i]);
    return (value > magnitude) | (-value > magnitude) | (last_rise * rise < 0.0) | ((last_rise == 0.0) & (rise != 0.0));
  };
  std::size_t i = 0;
  for (; i + at_once <= size(); i += at_once) {
    const auto any = notable(i) | notable(i + half);
    if ((any[0] | any[1]) == 0) continue;
    for (std::size_t k = i; k < i + at_once; ++k) look(k, time, values[k]);
  }
  for (; i < size(); ++i) look(i, time, values[i]);

  rises_before_.swap(rises_);
  for (i = 0; i < size(); ++i) {
    rises_[i] = values[i] - values_[i];
    values_[i] = values[i];
  }
  time_before_ = time_;
  time_ = time;
  count_ = std::min(count_ + 1, 3);
}

void PeakTrackers::restart(double time, const double* values) {
  count_ = 0;
  add(time, values);
}

void PeakTrackers::keep(std::size_t i, double time, double value) {
  if (std::abs(value) <= magnitudes_[i]) return;
  magnitudes_[i] = std::abs(value);
  times_[i] = time;
}

void PeakTrackers::look(std::size_t i, double time, double value) {
  keep(i, time, value);
  const double last_rise = rises_[i], rise = value - values_[i];
  // Two equal samples with the turn between them are a vertex too; more of them are a plateau.
  const bool turns = count_ >= 2 && last_rise * rise < 0.0;
  const bool turned_between = count_ >= 3 && last_rise == 0.0 && rises_before_[i] * rise < 0.0;
  if (!turns && !turned_between) return;
  const double before = time_ - time_before_, after = time - time_;
  if (before <= 0.0 || after <= 0.0) return;
  const double slope_before = last_rise / before, slope_after = rise / after;
  const double curvature = (slope_after - slope_before) / (before + after);
  const double slope = (slope_before * after + slope_after * before) / (before + after);
  const double shift = -0.5 * slope / curvature;
  keep(i, time_ + shift, values_[i] + 0.5 * slope * shift);
}

}  // namespace moat
