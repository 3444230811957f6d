// The acceleration of the ground over time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/quantity.hpp"

namespace moat {

/// The file a motion was read from.
struct MotionFile {
  std::string path{};    ///< absolute; empty for a motion made in the program
  std::string sha256{};  ///< of its content: 64 hexadecimal digits
};

/// The horizontal acceleration of the ground, sampled at a constant time step.
///
/// The acceleration is linear between samples. The ground is at rest before the first sample, which stands at
/// t = 0; after the last one, at t = duration(), the acceleration is zero. Positive acceleration points in the
/// direction of positive displacement of the model. Velocity and displacement of the ground are the exact integrals
/// of this piecewise-linear function from rest, without any baseline correction.
///
///     const GroundMotion motion = read_peer_at2("RSN1108_KOBE_KBU000.AT2").scaled_to_pga(0.4 * g);
class GroundMotion {
 public:
  /// name: how outputs and messages call the motion. time_step: from 1e-9 to 1e6 s. samples: at least two, all finite,
  /// of at most 1e6 m/s^2. notes: lines worth repeating in a report, for example the header of the file.
  /// Throws InputError naming the first sample outside that range.
  GroundMotion(std::string name, double time_step, std::vector<double> samples, std::vector<std::string> notes = {},
               MotionFile file = {});

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] const MotionFile& file() const { return file_; }
  /// The factor of all accelerations since the motion was read or made.
  [[nodiscard]] double scale_factor() const { return scale_factor_; }
  /// s
  [[nodiscard]] double time_step() const { return time_step_; }
  /// Time of the last sample, (number of samples - 1) * time_step, s.
  [[nodiscard]] double duration() const { return duration_; }
  /// m/s^2
  [[nodiscard]] std::span<const double> samples() const { return samples_; }

  /// Ground acceleration at a time in s, in m/s^2; zero outside [0, duration()].
  [[nodiscard]] double acceleration_at(double time) const {
    if (!(time >= 0.0 && time <= duration_)) return 0.0;
    const double position = time * samples_per_second_;
    const std::size_t before = std::min(static_cast<std::size_t>(position), samples_.size() - 2);
    const double fraction = position - static_cast<double>(before);
    return samples_[before] + fraction * (samples_[before + 1] - samples_[before]);
  }

  /// Ground velocity at the samples, m/s.
  [[nodiscard]] std::vector<double> velocity() const;
  /// Ground displacement at the samples, m.
  [[nodiscard]] std::vector<double> displacement() const;

  /// Largest absolute value over continuous time from 0 to duration(), not only at the samples.
  [[nodiscard]] Acceleration peak_acceleration() const;
  [[nodiscard]] Speed peak_velocity() const;
  [[nodiscard]] Length peak_displacement() const;

  /// The same motion with every acceleration multiplied by a finite factor. A note says so.
  [[nodiscard]] GroundMotion scaled_by(double factor) const;
  /// The same motion with its peak acceleration scaled to target > 0. Throws InputError if the motion is zero.
  [[nodiscard]] GroundMotion scaled_to_pga(Acceleration target) const;
  /// The same motion with other samples, for example filtered ones; `note` says how they were made.
  [[nodiscard]] GroundMotion with_samples(std::vector<double> samples, std::string note) const;

  /// One line: name, PGA, PGV, PGV/PGA, time step, duration, number of samples.
  [[nodiscard]] std::string description() const;

 private:
  std::string name_;
  double time_step_;
  double samples_per_second_;
  double duration_;
  std::vector<double> samples_;
  std::vector<std::string> notes_;
  MotionFile file_;
  double scale_factor_ = 1.0;
};

}  // namespace moat
