#include "output/peak_trackers.hpp"

#include <algorithm>

namespace moat {
namespace {

// Two numbers in one register of any x86-64 and arm64 processor.
using Pair = double __attribute__((vector_size(16), aligned(8), may_alias));

}  // namespace

PeakTrackers::PeakTrackers(std::size_t count)
    : magnitudes_(count, 0.0),
      times_(count, 0.0),
      values_before_(count, 0.0),
      rates_before_(count, 0.0),
      start_values_(count, 0.0),
      start_rates_(count, 0.0),
      earlier_rates_(count, 0.0) {
  notable_.reserve(count);
}

void PeakTrackers::find_notable(const double* values, const double* rates) {
  constexpr std::size_t at_once = 4, half = 2;
  const auto notable = [&](std::size_t i) {
    const Pair value = *reinterpret_cast<const Pair*>(values + i);
    const Pair magnitude = *reinterpret_cast<const Pair*>(&magnitudes_[i]);
    const Pair turn = *reinterpret_cast<const Pair*>(&rates_before_[i]) * *reinterpret_cast<const Pair*>(rates + i);
    return (value > magnitude) | (-value > magnitude) | (turn < 0.0);
  };
  std::size_t i = 0;
  for (; i + at_once <= size(); i += at_once) {
    const auto any = notable(i) | notable(i + half);
    if ((any[0] | any[1]) == 0) continue;
    for (std::size_t k = i; k < i + at_once; ++k) notable_.push_back(k);
  }
  for (; i < size(); ++i) notable_.push_back(i);
}

void PeakTrackers::add_bend(std::size_t i, double time) {
  const double from_start = time - start_time_, to_end = time_before_ - time, step = time_before_ - start_time_;
  if (from_start <= 0.0 || to_end <= 0.0) return;
  const double earlier_step = start_time_ - earlier_time_;
  const double curvature = earlier_step > 0.0 ? (start_rates_[i] - earlier_rates_[i]) / earlier_step : 0.0;
  const double forward = start_values_[i] + from_start * (start_rates_[i] + 0.5 * curvature * from_start);
  const double backward = values_before_[i] - to_end * (rates_before_[i] - 0.5 * curvature * to_end);
  keep(i, time, (to_end * forward + from_start * backward) / step);
}

void PeakTrackers::remember(double time, const double* values, const double* rates) {
  earlier_rates_.swap(start_rates_);
  earlier_time_ = start_time_;
  start_values_.swap(values_before_);
  start_rates_.swap(rates_before_);
  start_time_ = time_before_;
  std::copy(values, values + size(), values_before_.begin());
  std::copy(rates, rates + size(), rates_before_.begin());
  time_before_ = time;
  known_ = true;
}

}  // namespace moat
