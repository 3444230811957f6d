#include "reference_history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "reference_peak.hpp"
#include "reference_system.hpp"

namespace moat::testing {
namespace {

// Dormand and Prince (1980), fifth order with an error estimate of fourth order.
constexpr int stages = 7;
constexpr std::array<double, stages> nodes{0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0};
constexpr std::array<std::array<double, 6>, stages> weights{
    {{},
     {1.0 / 5.0},
     {3.0 / 40.0, 9.0 / 40.0},
     {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
     {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
     {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
     {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0}}};
constexpr std::array<double, stages> error_weights{71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
                                                   -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};

constexpr long most_events = 1000000;

class History {
 public:
  History(const PlainModel& model, const ReferenceOptions& options);
  ReferenceResult run();

 private:
  using Margin = ReferenceSystem::Margin;

  [[nodiscard]] double ground_at(double within) const { return ground_start_ + ground_slope_ * within; }
  void begin_interval(std::size_t interval);
  void cross_interval(double length);
  double take_step(double room);
  void try_step(double h);
  [[nodiscard]] double error() const;
  [[nodiscard]] bool crossed();
  [[nodiscard]] double turn_beyond(double h) const;
  double locate(double h);
  void accept(double h);
  void balance();
  void change_regimes();

  const PlainModel& model_;
  ReferenceOptions options_;
  ReferenceSystem system_;
  std::size_t size_;
  double time_ = 0.0;                           // s, of the committed state
  double interval_start_ = 0.0, within_ = 0.0;  // s, of the current sample interval, and since then
  double ground_start_ = 0.0, ground_slope_ = 0.0;
  double next_step_ = 0.0, step_ = 0.0;  // s, step_ of the step being tried
  bool at_event_ = false;                // whether it ends at one
  long events_ = 0;
  std::vector<ReferenceSystem::Touch> touches_;
  ReferenceState start_, end_;  // committed, and of the step being tried
  std::array<std::vector<double>, stages> velocities_, accelerations_;
  std::vector<double> displacement_, velocity_;  // of a stage
  std::vector<double> largest_displacement_, largest_velocity_;
  std::vector<Margin> start_margins_, end_margins_;
  std::vector<ReferenceChannel> start_channels_, end_channels_;
  std::vector<ReferencePeakTracker> trackers_;
  ReferenceResult result_;
};

History::History(const PlainModel& model, const ReferenceOptions& options)
    : model_{model},
      options_{options},
      system_{model},
      size_{system_.size()},
      trackers_(system_.channel_names().size()) {
  for (ReferenceState* state : {&start_, &end_})
    for (auto* values : {&state->displacement, &state->velocity, &state->acceleration}) values->assign(size_, 0.0);
  for (int s = 0; s < stages; ++s) {
    velocities_[static_cast<std::size_t>(s)].assign(size_, 0.0);
    accelerations_[static_cast<std::size_t>(s)].assign(size_, 0.0);
  }
  displacement_.assign(size_, 0.0);
  velocity_.assign(size_, 0.0);
  // Below a micrometre errors are judged as there.
  largest_displacement_.assign(size_, 1e-6);
  largest_velocity_.assign(size_, 1e-5);
  for (std::size_t i = 0; i < size_; ++i) {
    start_.displacement[i] = model.nodes[i].displacement;
    start_.velocity[i] = model.nodes[i].velocity;
  }
}

ReferenceResult History::run() {
  const double dt = model_.motion.time_step;
  const auto intervals = static_cast<std::size_t>(std::llround(model_.end / dt));
  for (std::size_t i = 0; i < intervals; ++i) {
    begin_interval(i);
    cross_interval(dt);
  }
  result_.displacement = start_.displacement;
  result_.velocity = start_.velocity;
  // Channels of the same quantity and place share a peak.
  std::map<std::pair<std::string, std::string>, std::size_t> index;
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    const auto& [quantity, where] = system_.channel_names()[i];
    const auto [found, inserted] = index.try_emplace({quantity, where}, result_.peaks.size());
    if (inserted) result_.peaks.push_back({quantity, where, 0.0, 0.0});
    ReferencePeak& peak = result_.peaks[found->second];
    if (trackers_[i].magnitude > peak.value) {
      peak.value = trackers_[i].magnitude;
      peak.time = trackers_[i].time;
    }
  }
  return result_;
}

// The acceleration of the ground is linear in an interval and zero after the last sample.
void History::begin_interval(std::size_t interval) {
  const auto& samples = model_.motion.samples;
  const double dt = model_.motion.time_step;
  interval_start_ = time_ = static_cast<double>(interval) * dt;
  within_ = 0.0;
  const bool over = interval + 1 >= samples.size();
  ground_start_ = over ? 0.0 : samples[interval];
  ground_slope_ = over ? 0.0 : (samples[interval + 1] - samples[interval]) / dt;
  balance();
  if (interval > 0) return;
  // The first step, which the error then lets grow.
  next_step_ = 1e-3 * dt;
}

void History::balance() {
  system_.accelerations(start_.displacement.data(), start_.velocity.data(), ground_at(within_),
                        start_.acceleration.data());
  system_.margins(start_, start_margins_);
  system_.channels(start_, ground_at(within_), start_channels_);
}

void History::cross_interval(double length) {
  while (within_ < length) {
    const double room = length - within_;
    const double h = take_step(room);
    // The last step ends on the sample itself.
    within_ = h == room ? length : within_ + h;
    time_ = interval_start_ + within_;
    if (at_event_) change_regimes();
  }
}

// One accepted step of at most `room`; returns its length.
double History::take_step(double room) {
  const double longest = options_.largest_phase / std::max(system_.fastest(start_), 1e-3);
  double h = std::min(next_step_, longest);
  for (;;) {
    if (h >= room)
      h = room;
    else if (h > 0.5 * room)
      h = 0.5 * room;  // two equal steps instead of one and a sliver
    try_step(h);
    at_event_ = crossed();
    if (!at_event_) {
      const double turn = turn_beyond(h);
      if (turn > 0.0) {
        h *= turn;
        try_step(h);
        at_event_ = crossed();
      }
    }
    if (at_event_) h = locate(h);
    const double relative = error() / options_.tolerance;
    const double factor = std::clamp(0.9 * std::pow(std::max(relative, 1e-10), -0.2), 0.2, 2.0);
    if (relative > 1.0) {
      h *= std::min(factor, 0.7);
      continue;
    }
    accept(h);
    next_step_ = h * factor;
    // A step that was cut short by a sample says nothing about the next one.
    if (h == room) next_step_ = std::max(next_step_, std::min(longest, 2.0 * h));
    return h;
  }
}

void History::try_step(double h) {
  velocities_[0] = start_.velocity;
  accelerations_[0] = start_.acceleration;
  for (std::size_t s = 1; s < stages; ++s) {
    const bool last = s + 1 == stages;
    std::vector<double>& u = last ? end_.displacement : displacement_;
    std::vector<double>& v = last ? end_.velocity : velocity_;
    for (std::size_t i = 0; i < size_; ++i) {
      double du = 0.0, dv = 0.0;
      for (std::size_t k = 0; k < s; ++k) {
        du += weights[s][k] * velocities_[k][i];
        dv += weights[s][k] * accelerations_[k][i];
      }
      u[i] = start_.displacement[i] + h * du;
      v[i] = start_.velocity[i] + h * dv;
    }
    velocities_[s] = v;
    system_.accelerations(u.data(), v.data(), ground_at(within_ + nodes[s] * h), accelerations_[s].data());
  }
  end_.acceleration = accelerations_.back();
  step_ = h;
}

double History::error() const {
  double worst = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    double du = 0.0, dv = 0.0;
    for (std::size_t k = 0; k < stages; ++k) {
      du += error_weights[k] * velocities_[k][i];
      dv += error_weights[k] * accelerations_[k][i];
    }
    worst =
        std::max({worst, step_ * std::abs(du) / largest_displacement_[i], step_ * std::abs(dv) / largest_velocity_[i]});
  }
  return worst;
}

bool History::crossed() {
  system_.margins(end_, end_margins_);
  return std::any_of(end_margins_.begin(), end_margins_.end(), [](const Margin& margin) { return margin.value < 0.0; });
}

// Fraction of the step where a margin turns below zero although it is positive at the end; 0 if none does.
double History::turn_beyond(double h) const {
  double first = 0.0;
  for (std::size_t i = 0; i < end_margins_.size(); ++i) {
    const Margin &start = start_margins_[i], &end = end_margins_[i];
    if (!(start.rate < 0.0 && end.rate > 0.0)) continue;
    const HermiteCubic cubic{h, start.value, start.rate, end.value, end.rate};
    const double x = cubic.turn();
    if (cubic.at(x) < 0.0 && (first == 0.0 || x < first)) first = x;
  }
  return first;
}

// The step of length h ends beyond an event. Leaves the shortest such step as the trial step.
double History::locate(double h) {
  double before = 0.0, beyond = h;
  for (;;) {
    const double middle = 0.5 * (before + beyond);
    if (beyond - before < 1e-15 || middle == before || middle == beyond) break;
    try_step(middle);
    (crossed() ? beyond : before) = middle;
  }
  try_step(beyond);
  at_event_ = crossed();
  return beyond;
}

void History::change_regimes() {
  touches_.clear();
  system_.change_regimes(start_, touches_);
  for (const auto& touch : touches_)
    result_.touches.push_back({model_.gaps[touch.gap].name, time_, touch.approach_speed});
  if (++events_ > most_events) throw std::runtime_error{"The reference saw a million events: a contact chatters."};
  balance();
  next_step_ = 1e-5 / system_.fastest(start_);
}

void History::accept(double h) {
  system_.channels(end_, ground_at(within_ + h), end_channels_);
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    const ReferenceChannel &start = start_channels_[i], &end = end_channels_[i];
    // No cubic of a short step reaches farther than this.
    const double bound =
        std::max(std::abs(start.value), std::abs(end.value)) + 0.15 * h * (std::abs(start.rate) + std::abs(end.rate));
    if (bound > trackers_[i].magnitude) trackers_[i].add_step(time_, {h, start.value, start.rate, end.value, end.rate});
  }
  std::swap(start_channels_, end_channels_);
  std::swap(start_margins_, end_margins_);
  std::swap(start_, end_);
  for (std::size_t i = 0; i < size_; ++i) {
    largest_displacement_[i] = std::max(largest_displacement_[i], std::abs(start_.displacement[i]));
    largest_velocity_[i] = std::max(largest_velocity_[i], std::abs(start_.velocity[i]));
  }
}

}  // namespace

ReferenceResult reference_history(const PlainModel& model, const ReferenceOptions& options) {
  return History{model, options}.run();
}

std::vector<bool> counting_peaks(const std::vector<ReferencePeak>& peaks) {
  constexpr double least_share = 1e-3;
  std::map<std::string, double> largest;
  for (const ReferencePeak& peak : peaks) largest[peak.quantity] = std::max(largest[peak.quantity], peak.value);
  std::vector<bool> counts;
  for (const ReferencePeak& peak : peaks)
    counts.push_back(peak.value > 0.0 && peak.value >= least_share * largest[peak.quantity]);
  return counts;
}

CheckedReference checked_reference(const PlainModel& model, const ReferenceOptions& options) {
  const ReferenceResult coarse = reference_history(model, options);
  CheckedReference checked{.result = reference_history(model, {.largest_phase = options.largest_phase / 2.0,
                                                               .tolerance = options.tolerance / 32.0}),
                           .peak_changes = {}};
  const ReferenceResult& fine = checked.result;
  const std::vector<bool> counts = counting_peaks(fine.peaks);
  for (std::size_t i = 0; i < fine.peaks.size(); ++i) {
    const double value = fine.peaks[i].value;
    const double change = value > 0.0 ? std::abs(coarse.peaks[i].value / value - 1.0) : 0.0;
    checked.peak_changes.push_back(change);
    if (counts[i]) checked.largest_change = std::max(checked.largest_change, change);
  }
  checked.same_touches =
      std::equal(coarse.touches.begin(), coarse.touches.end(), fine.touches.begin(), fine.touches.end(),
                 [](const ReferenceTouch& a, const ReferenceTouch& b) { return a.gap == b.gap; });
  return checked;
}

}  // namespace moat::testing
