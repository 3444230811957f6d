#include "motions/ground_span.hpp"

#include <algorithm>
#include <cmath>

#include "base/hermite.hpp"

namespace moat {

GroundSpan::GroundSpan(const GroundMotion& motion, double start, double end)
    : motion_{&motion}, start_{start}, end_{end} {
  constexpr double round_off = 1e-6;  // of an interval
  const double interval = motion.time_step();
  first_sample_ = static_cast<long>(std::floor(start / interval + round_off)) + 1;
  last_sample_ = static_cast<long>(std::ceil(end / interval - round_off)) - 1;
}

GroundBump GroundSpan::bump_at(double time, const GroundDeviation& now, const GroundDeviation& end) const {
  const double h = length(), x = (time - start_) / h;
  const HermiteCubic displacement{0.0, 0.0, end.displacement, end.velocity, h};
  const HermiteCubic velocity{0.0, 0.0, end.velocity, 0.0, h};
  const double at_start = motion_->acceleration_at(start_), at_end = motion_->acceleration_at(end_);
  const double deviation = motion_->acceleration_at(time) - (at_start + x * (at_end - at_start));
  return {.time = time,
          .fraction = x,
          .displacement = now.displacement - displacement.value(x),
          .velocity = now.velocity - displacement.rate(x),
          .velocity_alone = now.velocity - velocity.value(x),
          .acceleration = deviation - velocity.rate(x)};
}

GroundBump GroundSpan::bump_at_sample(long index) const {
  return bump_at(static_cast<double>(first_sample_ + index) * motion_->time_step());
}

double GroundSpan::largest_bump() const {
  double largest = 0.0;
  for (long i = 0; i < samples_inside(); ++i) largest = std::max(largest, std::abs(bump_at_sample(i).displacement));
  return largest;
}

GroundDeviation GroundSpan::deviation_at(double time) const {
  const double at_start = motion_->acceleration_at(start_);
  const double slope = (motion_->acceleration_at(end_) - at_start) / (end_ - start_);
  GroundDeviation sum;
  double before = start_, d0 = 0.0;
  const auto advance = [&](double after, double acceleration) {
    const double h = after - before, d1 = acceleration - (at_start + slope * (after - start_));
    sum.displacement_integral += h * (sum.displacement + h * (0.5 * sum.velocity + h * (d0 / 8.0 + d1 / 24.0)));
    sum.displacement += h * (sum.velocity + h * (d0 / 3.0 + d1 / 6.0));
    sum.velocity += 0.5 * h * (d0 + d1);
    before = after;
    d0 = d1;
  };
  const double interval = motion_->time_step();
  for (long sample = first_sample_; sample <= last_sample_; ++sample) {
    const double at_sample = static_cast<double>(sample) * interval;
    if (at_sample >= time) break;
    advance(at_sample, motion_->samples()[static_cast<std::size_t>(sample)]);
  }
  advance(time, motion_->acceleration_at(time));
  return sum;
}

}  // namespace moat
