// The acceleration of the ground over time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/files_read.hpp"
#include "base/ground_vector.hpp"
#include "base/quantity.hpp"

namespace moat {

/// The file a motion was read from; without path for a motion made in the program.
using MotionFile = FileRead;

/// A component as it was read or made, before it became a part of a motion.
struct MotionComponent {
  std::string name;           ///< Outputs call it so.
  MotionFile file{};          ///< Where it was read.
  double scale_factor = 1.0;  ///< Factor of all its accelerations, since then.
};

/// The acceleration of the ground along x, and along y and z if given, sampled at a constant time step.
///
/// The acceleration is linear between samples. The ground is at rest before the first sample, which stands at
/// t = 0; after the last one, at t = duration(), the acceleration is zero. Positive acceleration points in the
/// direction of positive displacement of the model. A PlanMotion makes a motion of two horizontal components, with a
/// vertical one if given; with_vertical() adds it to a motion on a line. Velocity and displacement of the ground are
/// the exact integrals of the piecewise-linear component along x from rest, without any baseline correction.
///
///     const GroundMotion motion = read_motion("RSN1108_KOBE_KBU000.AT2").scaled_to_pga(0.4 * g);
class GroundMotion {
 public:
  /// name: how outputs and messages call the motion. time_step: from 1e-9 to 1e6 s. samples: at least two, all finite,
  /// of at most 1e6 m/s^2. notes: lines worth repeating in a report, for example the header of the file.
  /// Throws InputError naming the first sample outside that range.
  GroundMotion(std::string name, double time_step, std::vector<double> samples, std::vector<std::string> notes = {},
               MotionFile file = {});
  // All of these are defaults; compiled in the library, they cost no time in scripts.
  GroundMotion(const GroundMotion& other);                 ///< Makes a copy.
  GroundMotion(GroundMotion&& other) noexcept;             ///< Takes all of it.
  GroundMotion& operator=(const GroundMotion& other);      ///< Makes a copy.
  GroundMotion& operator=(GroundMotion&& other) noexcept;  ///< Takes all of it.
  ~GroundMotion();

  [[nodiscard]] const std::string& name() const { return name_; }                 ///< Outputs call it so.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }  ///< For reports.
  [[nodiscard]] const MotionFile& file() const { return file_; }                  ///< Where it was read.
  /// The factor of all accelerations since the motion was read or made; of several components that of the first.
  [[nodiscard]] double scale_factor() const { return scale_factor_; }
  /// This motion, or the components from which it was made: horizontal ones, then the vertical one.
  [[nodiscard]] std::vector<MotionComponent> components() const;
  /// s
  [[nodiscard]] double time_step() const { return time_step_; }
  /// Time of the last sample, (number of samples - 1) * time_step, s.
  [[nodiscard]] double duration() const { return duration_; }
  /// m/s^2
  [[nodiscard]] std::span<const double> samples() const { return samples_; }

  /// Ground acceleration at a time in s, in m/s^2; zero outside [0, duration()].
  [[nodiscard]] double acceleration_at(double time) const { return value_at(samples_, time); }

  /// Whether it has a component along y besides that along x. Made by PlanMotion (motions/plan_motion.hpp).
  [[nodiscard]] bool has_two_components() const { return !samples_y_.empty(); }
  /// m/s^2, as many as samples(); empty for one component.
  [[nodiscard]] std::span<const double> samples_y() const { return samples_y_; }
  /// m/s^2, upwards, as many as samples(); empty without a vertical component.
  [[nodiscard]] std::span<const double> samples_z() const { return samples_z_; }
  /// All components at a time in s, m/s^2; zero outside [0, duration()].
  [[nodiscard]] GroundVector components_at(double time) const {
    return {acceleration_at(time), samples_y_.empty() ? 0.0 : value_at(samples_y_, time),
            samples_z_.empty() ? 0.0 : value_at(samples_z_, time)};
  }

  /// Ground velocity at the samples, m/s.
  [[nodiscard]] std::vector<double> velocity() const;
  /// Ground displacement at the samples, m.
  [[nodiscard]] std::vector<double> displacement() const;

  /// Largest absolute value over continuous time from 0 to duration(), not only at the samples. Of two horizontal
  /// components the largest resultant; of velocity and displacement then that at the samples. The vertical one does not
  /// count.
  [[nodiscard]] Acceleration peak_acceleration() const;
  [[nodiscard]] Speed peak_velocity() const;       ///< Peak velocity of the ground.
  [[nodiscard]] Length peak_displacement() const;  ///< Peak displacement of the ground.

  /// Returns the motion with every acceleration multiplied by a finite factor. A note says so.
  [[nodiscard]] GroundMotion scaled_by(double factor) const;
  /// Returns the motion with its peak acceleration scaled to target > 0. Throws InputError if the motion is zero.
  [[nodiscard]] GroundMotion scaled_to_pga(Acceleration target) const;
  /// Returns the motion with other samples, for example filtered ones; `note` says how they were made. Throws
  /// InputError for several components.
  [[nodiscard]] GroundMotion with_samples(std::vector<double> samples, std::string note) const;

  /// Returns the motion with a second component, along y, m/s^2. `first` and `second` are the motions from which both
  /// were made. Throws InputError unless it has as many samples, all finite and of at most 1e6 m/s^2.
  [[nodiscard]] GroundMotion with_component_y(std::vector<double> samples, const GroundMotion& first,
                                              const GroundMotion& second) const;

  /// Returns the motion with a vertical component, upwards, m/s^2, for degrees of freedom that the ground lifts
  /// (GeneralisedCoordinate::ground_influence) and for axial forces of bearings. `made_of`, unless empty: the later
  /// components(). Throws InputError unless it has as many samples, all finite and of at most 1e6 m/s^2.
  /// with_vertical() and PlanMotion (motions/plan_motion.hpp) take a vertical motion with an interval of its own.
  [[nodiscard]] GroundMotion with_component_z(std::vector<double> samples,
                                              std::vector<MotionComponent> made_of = {}) const;

  /// One line: name, PGA, PGV, PGV/PGA, time step, duration, number of samples.
  [[nodiscard]] std::string description() const;

 private:
  [[nodiscard]] double value_at(const std::vector<double>& samples, double time) const {
    if (!(time >= 0.0 && time <= duration_)) return 0.0;
    const double position = time * samples_per_second_;
    const std::size_t before = std::min(static_cast<std::size_t>(position), samples.size() - 2);
    const double fraction = position - static_cast<double>(before);
    return samples[before] + fraction * (samples[before + 1] - samples[before]);
  }
  void check_samples(const std::vector<double>& samples, const std::string& prefix) const;
  [[nodiscard]] GroundMotion component_y() const { return {name_, time_step_, samples_y_}; }

  std::string name_;
  double time_step_;
  double samples_per_second_;
  double duration_;
  std::vector<double> samples_;
  std::vector<double> samples_y_{}, samples_z_{};  // empty without that component
  std::vector<std::string> notes_;
  MotionFile file_;
  double scale_factor_ = 1.0;
  std::vector<MotionComponent> components_{};  // empty for one component
};

/// One motion of several shocks, with rests between them in which the ground is still; of pairs in plan too.
///
///     joined({foreshock, main_shock, aftershock}, 20 * s)
///
/// From the last sample of one to the first of the next it takes `rest`, from 0 to 1e6 s, rounded up to whole
/// intervals; with 0 s these two samples are one, their sum. Throws InputError for no motion, a rest outside that
/// range, and motions whose interval or number of components is not that of the first.
GroundMotion joined(const std::vector<GroundMotion>& motions, Time rest);

}  // namespace moat
