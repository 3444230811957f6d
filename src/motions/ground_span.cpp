#include "motions/ground_span.hpp"

#include <algorithm>
#include <cmath>

#include "base/hermite.hpp"

namespace moat {

void GroundSpan::find_line() {
  start_acceleration_ = motion_->acceleration_at(start_);
  slope_ = (motion_->acceleration_at(end_) - start_acceleration_) / length();
}

// Between two samples the deviation is linear.
void GroundSpan::Path::advance(double to, double acceleration_there) {
  const double h = to - time, d0 = acceleration, d1 = acceleration_there;
  sum.displacement_integral += h * (sum.displacement + h * (0.5 * sum.velocity + h * (d0 / 8.0 + d1 / 24.0)));
  sum.displacement += h * (sum.velocity + h * (d0 / 3.0 + d1 / 6.0));
  sum.velocity += 0.5 * h * (d0 + d1);
  time = to;
  acceleration = acceleration_there;
}

void GroundSpan::advance_to_sample(Path& path, long sample) const {
  const double time = static_cast<double>(sample) * motion_->time_step();
  path.advance(time, deviation_of(motion_->samples()[static_cast<std::size_t>(sample)], time));
}

GroundSpan::Path GroundSpan::path_to(double time) const {
  Path path{start_};
  const double interval = motion_->time_step();
  for (long sample = first_sample_; sample <= last_sample_ && static_cast<double>(sample) * interval < time; ++sample)
    advance_to_sample(path, sample);
  path.advance(time, deviation_of(motion_->acceleration_at(time), time));
  return path;
}

// A bump is an integral of kernel times deviation. At the middle of the step, where they are largest, the integrals of
// the magnitudes of the kernels are h^2/16 and h/2.
GroundSpan::BumpBounds GroundSpan::bump_bounds() const {
  double largest = 0.0;
  for (long sample = first_sample_; sample <= last_sample_; ++sample)
    largest = std::max(largest, std::abs(deviation_of(motion_->samples()[static_cast<std::size_t>(sample)],
                                                      static_cast<double>(sample) * motion_->time_step())));
  const double h = length();
  return {.displacement = largest * h * h / 16.0, .velocity = 0.5 * largest * h};
}

GroundBump GroundSpan::bump_at(const Path& path, const GroundDeviation& end) const {
  const double h = length(), x = (path.time - start_) / h;
  const HermiteCubic displacement{0.0, 0.0, end.displacement, end.velocity, h};
  const HermiteCubic velocity{0.0, 0.0, end.velocity, 0.0, h};
  return {.time = path.time,
          .fraction = x,
          .displacement = path.sum.displacement - displacement.value(x),
          .rate_of_displacement = path.sum.velocity - displacement.rate(x),
          .velocity = path.sum.velocity - velocity.value(x),
          .rate_of_velocity = path.acceleration - velocity.rate(x)};
}

}  // namespace moat
