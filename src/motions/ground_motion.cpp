#include "motions/ground_motion.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "base/units.hpp"

namespace moat {
namespace {

/// Velocity and displacement at the time `time` after a sample, from the state at that sample and an acceleration
/// that starts at `acceleration` and grows at `slope`.
struct GroundState {
  double velocity = 0.0;
  double displacement = 0.0;

  [[nodiscard]] GroundState after(double time, double acceleration, double slope) const {
    return {velocity + time * (acceleration + time * slope / 2.0),
            displacement + time * (velocity + time * (acceleration / 2.0 + time * slope / 6.0))};
  }
};

/// Times strictly between 0 and `interval` at which velocity + acceleration t + slope t^2/2 vanishes.
/// Unused entries are 0.
std::array<double, 2> standstill_times(double velocity, double acceleration, double slope, double interval) {
  const double discriminant = acceleration * acceleration - 2.0 * slope * velocity;
  if (discriminant < 0.0) return {};
  // This form does not subtract nearly equal numbers, and it survives slope = 0 or acceleration = 0.
  const double sum = -(acceleration + std::copysign(std::sqrt(discriminant), acceleration));
  std::array<double, 2> times{};
  const double first = slope != 0.0 ? sum / slope : 0.0;
  const double second = sum != 0.0 ? 2.0 * velocity / sum : 0.0;
  if (first > 0.0 && first < interval) times[0] = first;
  if (second > 0.0 && second < interval) times[1] = second;
  return times;
}

void check_as_many(const GroundMotion& motion, const std::vector<double>& samples, const std::string& component) {
  const std::size_t count = motion.samples().size();
  Check{"GroundMotion", motion.name()}.that(samples.size() == count, "number of samples of the " + component,
                                            static_cast<double>(samples.size()), "1",
                                            "that of the component along x, " + std::to_string(count));
}

}  // namespace

GroundMotion::GroundMotion(const GroundMotion& other) = default;
GroundMotion::GroundMotion(GroundMotion&& other) noexcept = default;
GroundMotion& GroundMotion::operator=(const GroundMotion& other) = default;
GroundMotion& GroundMotion::operator=(GroundMotion&& other) noexcept = default;
GroundMotion::~GroundMotion() = default;

GroundMotion::GroundMotion(std::string name, double time_step, std::vector<double> samples,
                           std::vector<std::string> notes, MotionFile file)
    : name_{std::move(name)},
      time_step_{time_step},
      samples_per_second_{1.0 / time_step},
      duration_{samples.empty() ? 0.0 : static_cast<double>(samples.size() - 1) * time_step},
      samples_{std::move(samples)},
      notes_{std::move(notes)},
      file_{std::move(file)} {
  constexpr double shortest = 1e-9, longest = 1e6;  // s
  const Check check{"GroundMotion", name_};
  check.between("time step", time_step_, shortest, longest, "s", "Give the interval between two samples.");
  check.that(samples_.size() >= 2, "number of samples", static_cast<double>(samples_.size()), "1", ">= 2",
             "Give the acceleration at the beginning and at the end of at least one time step.");
  check_samples(samples_, "");
}

void GroundMotion::check_samples(const std::vector<double>& samples, const std::string& prefix) const {
  constexpr double largest = 1e6;  // m/s^2
  const Check check{"GroundMotion", name_};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (std::abs(samples[i]) <= largest) continue;
    const std::string sample = prefix + "sample " + std::to_string(i) + " (counted from 0)";
    check.finite(sample, samples[i], "m/s^2", "Repair the record before using it.");
    check.between(sample, samples[i], -largest, largest, "m/s^2", "Check the unit of the record.");
  }
}

std::vector<MotionComponent> GroundMotion::components() const {
  if (!components_.empty()) return components_;
  return {{name_, file_, scale_factor_}};
}

GroundMotion GroundMotion::with_component_y(std::vector<double> samples, const GroundMotion& first,
                                            const GroundMotion& second) const {
  check_as_many(*this, samples, "component along y");
  check_samples(samples, "component along y, ");
  GroundMotion motion = *this;
  motion.samples_y_ = std::move(samples);
  motion.file_ = first.file_;
  motion.scale_factor_ = first.scale_factor_;
  motion.components_ = {{first.name_, first.file_, first.scale_factor_},
                        {second.name_, second.file_, second.scale_factor_}};
  return motion;
}

GroundMotion GroundMotion::with_component_z(std::vector<double> samples, std::vector<MotionComponent> made_of) const {
  check_as_many(*this, samples, "vertical component");
  check_samples(samples, "vertical component, ");
  GroundMotion motion = *this;
  motion.samples_z_ = std::move(samples);
  if (made_of.empty()) return motion;
  motion.file_ = made_of.front().file;
  motion.scale_factor_ = made_of.front().scale_factor;
  motion.components_ = std::move(made_of);
  return motion;
}

std::vector<double> GroundMotion::velocity() const {
  std::vector<double> result(samples_.size());
  for (std::size_t i = 1; i < samples_.size(); ++i)
    result[i] = result[i - 1] + time_step_ * (samples_[i - 1] + samples_[i]) / 2.0;
  return result;
}

std::vector<double> GroundMotion::displacement() const {
  std::vector<double> result(samples_.size());
  GroundState state;
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    state = state.after(time_step_, samples_[i - 1], (samples_[i] - samples_[i - 1]) / time_step_);
    result[i] = state.displacement;
  }
  return result;
}

Acceleration GroundMotion::peak_acceleration() const {
  double peak = 0.0;
  if (has_two_components()) {
    // Between samples the vector moves on a straight line: its length is largest at an end.
    for (std::size_t i = 0; i < samples_.size(); ++i) peak = std::max(peak, std::hypot(samples_[i], samples_y_[i]));
    return Acceleration{peak};
  }
  for (const double sample : samples_) peak = std::max(peak, std::abs(sample));
  return Acceleration{peak};
}

Speed GroundMotion::peak_velocity() const {
  double peak = 0.0;
  if (has_two_components()) {
    const std::vector<double> x = velocity(), y = component_y().velocity();
    for (std::size_t i = 0; i < x.size(); ++i) peak = std::max(peak, std::hypot(x[i], y[i]));
    return Speed{peak};
  }
  double velocity = 0.0;
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const double first = samples_[i - 1];
    const double last = samples_[i];
    if (first * last < 0.0) {
      const double time_of_zero = time_step_ * first / (first - last);
      peak = std::max(peak, std::abs(velocity + time_of_zero * first / 2.0));
    }
    velocity += time_step_ * (first + last) / 2.0;
    peak = std::max(peak, std::abs(velocity));
  }
  return Speed{peak};
}

Length GroundMotion::peak_displacement() const {
  double peak = 0.0;
  if (has_two_components()) {
    const std::vector<double> x = displacement(), y = component_y().displacement();
    for (std::size_t i = 0; i < x.size(); ++i) peak = std::max(peak, std::hypot(x[i], y[i]));
    return Length{peak};
  }
  GroundState state;
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const double acceleration = samples_[i - 1];
    const double slope = (samples_[i] - acceleration) / time_step_;
    for (const double time : standstill_times(state.velocity, acceleration, slope, time_step_))
      peak = std::max(peak, std::abs(state.after(time, acceleration, slope).displacement));
    state = state.after(time_step_, acceleration, slope);
    peak = std::max(peak, std::abs(state.displacement));
  }
  return Length{peak};
}

GroundMotion GroundMotion::scaled_by(double factor) const {
  Check{"GroundMotion", name_}.finite("scale factor", factor, "1");
  std::vector<double> scaled = samples_;
  for (double& sample : scaled) sample *= factor;
  GroundMotion motion = *this;
  motion.samples_ = std::move(scaled);
  for (double& sample : motion.samples_y_) sample *= factor;
  for (double& sample : motion.samples_z_) sample *= factor;
  motion.check_samples(motion.samples_, "");
  motion.check_samples(motion.samples_y_, "component along y, ");
  motion.check_samples(motion.samples_z_, "vertical component, ");
  motion.notes_.push_back("accelerations multiplied by " + to_text(factor));
  motion.scale_factor_ *= factor;
  for (MotionComponent& component : motion.components_) component.scale_factor *= factor;
  return motion;
}

GroundMotion GroundMotion::with_samples(std::vector<double> samples, std::string note) const {
  Check{"GroundMotion", name_}.that(!has_two_components() && samples_z_.empty(), "it has several components already.",
                                    "Change the samples of each before they become a PlanMotion.");
  std::vector<std::string> notes = notes_;
  notes.push_back(std::move(note));
  GroundMotion motion{name_, time_step_, std::move(samples), std::move(notes), file_};
  motion.scale_factor_ = scale_factor_;
  return motion;
}

GroundMotion GroundMotion::scaled_to_pga(Acceleration target) const {
  const Check check{"GroundMotion", name_};
  check.positive("target PGA", target, "Give it as, for example, 0.4 * g.");
  const double peak = peak_acceleration().si();
  check.that(peak > 0.0, "a motion that is zero everywhere cannot be scaled to a peak acceleration.",
             "Check the file or the parameters it was made from.");
  return scaled_by(target.si() / peak);
}

std::string GroundMotion::description() const {
  const double acceleration = peak_acceleration().si();
  const double speed = peak_velocity().si();
  std::string text = name_ + (has_two_components() ? ": two components, resultant PGA " : ": PGA ") +
                     to_fixed(acceleration / standard_gravity, 4) + " g, PGV " + to_fixed(100.0 * speed, 2) +
                     " cm/s, PGV/PGA ";
  text += acceleration > 0.0 ? to_fixed(speed / acceleration, 4) + " s" : "undefined";
  text += ", time step " + to_text(time_step_) + " s, duration " + to_text(duration_) + " s, ";
  return text + std::to_string(samples_.size()) + " samples";
}

GroundMotion joined(const std::vector<GroundMotion>& motions, Time rest) {
  constexpr double round_off = 1e-9, longest_rest = 1e6;  // 1, s
  const Check check{"joined", ""};
  check.that(!motions.empty(), "there is no motion.", "Give the shocks in their order.");
  check.between("rest", rest.si(), 0.0, longest_rest, "s", "Give the time between two shocks.");
  const double interval = motions.front().time_step();
  const auto rests = static_cast<std::size_t>(std::ceil(rest.si() / interval * (1.0 - round_off)));
  std::string name;
  std::vector<std::string> notes;
  std::vector<double> x, y, z;
  bool vertical = false;
  std::size_t start = 0;
  for (const GroundMotion& each : motions) {
    const Check its{"joined", each.name()};
    its.that(std::abs(each.time_step() - interval) <= round_off * interval, "time step", each.time_step(), "s",
             "that of the first motion, " + to_text(interval) + " s",
             "Make a GroundMotion of samples at that interval; accelerations are linear between samples.");
    its.that(each.has_two_components() == motions.front().has_two_components(),
             "some of the motions have two components and others one.",
             "Give a PlanMotion for each shock, or for none.");
    name += (name.empty() ? "" : ", then ") + each.name();
    notes.push_back("from " + to_text(static_cast<double>(start) * interval) + " s on: " + each.description());
    notes.insert(notes.end(), each.notes().begin(), each.notes().end());
    const std::size_t count = each.samples().size();
    vertical = vertical || !each.samples_z().empty();
    for (auto [all, samples] :
         {std::pair{&x, each.samples()}, std::pair{&y, each.samples_y()}, std::pair{&z, each.samples_z()}}) {
      all->resize(start + count, 0.0);
      for (std::size_t i = 0; i < samples.size(); ++i) (*all)[start + i] += samples[i];
    }
    start += count - 1 + rests;
  }
  GroundMotion motion{std::move(name), interval, std::move(x), std::move(notes)};
  if (motions.front().has_two_components()) motion = motion.with_component_y(std::move(y), motion, motion);
  return vertical ? motion.with_component_z(std::move(z)) : motion;
}

}  // namespace moat
