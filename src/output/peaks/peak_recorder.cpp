#include "output/peaks/peak_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace moat {
namespace {

Peak peak_of(std::string_view quantity, std::string_view where, double value, std::string_view unit, double time) {
  return {std::string{quantity}, std::string{where}, value, std::string{unit}, time};
}

}  // namespace

PeakRecorder::PeakRecorder(const Model& model)
    : model_{&model},
      channels_{std::make_shared<const Channels>(model)},
      peaks_{channels_->list().size(), model.is_plan()} {
  for (std::size_t i = 0; i < channels_->list().size(); ++i)
    if (channels_->list()[i].quantity == "bearing_compression") smallest_.push_back({.channel = i});
}

void PeakRecorder::start(const StepView& view) { step(view); }

void PeakRecorder::step(const StepView& view) {
  sample(view);
  peaks_.add([&](std::size_t channel, double fraction, double turned) {
    return channels_->value_inside(view, channel, fraction, turned);
  });
  keep_smallest(true);
  if (model_->is_plan()) add_slide_begins(view.state);
}

// Over continuous time, as PeakTrackers.
void PeakRecorder::keep_smallest(bool at_end_of_step) {
  const CommonInstant &from = peaks_.start(), &to = peaks_.last();
  for (Smallest& each : smallest_) {
    const std::size_t i = each.channel;
    each.keep(to.time, to.values[i]);
    const double step = to.time - from.time;
    if (!at_end_of_step || step <= 0.0 || !(from.rates[i] < 0.0 && to.rates[i] > 0.0)) continue;
    const HermiteCubic cubic{from.values[i], from.rates[i], to.values[i], to.rates[i], step};
    // The cubic of a bearing that cannot pull may fall below zero.
    const double turned = cubic.value(cubic.turn());
    const bool pulls = from.values[i] < 0.0 && to.values[i] < 0.0;
    if (cubic.is_smooth()) each.keep(from.time + cubic.turn() * step, pulls ? turned : std::max(turned, 0.0));
  }
}

void PeakRecorder::finish(const StepView& view) {
  uplifts_.clear();
  for (const WeightOnBearings& weight : view.state.weights()) {
    for (const WeightOnBearings::Bearing& bearing : weight.bearings()) {
      const std::string& name = model_->blocks()[bearing.element.block]->info(bearing.element.element).name;
      if (bearing.instabilities > 0)
        uplifts_.push_back(
            {"bearing_unstable", name, static_cast<double>(bearing.instabilities), "1", bearing.first_unstable});
      if (bearing.uplifts == 0) continue;
      const double time = view.state.time();
      uplifts_.push_back({"uplift_time", name, bearing.uplift_time, "s", time});
      uplifts_.push_back({"uplifts", name, static_cast<double>(bearing.uplifts), "1", time});
      uplifts_.push_back({"uplift_deficit", name, bearing.largest_deficit, "N", time});
    }
    if (weight.rocking_time() > 0.0)
      uplifts_.push_back({"rocking_time", weight.building(), weight.rocking_time(), "s", weight.first_rocking()});
  }
}

void PeakRecorder::sample(const StepView& view) {
  CommonInstant& next = peaks_.next();
  next.time = view.state.time();
  channels_->sample(view, next.values, next.rates);
}

// Where a corner began to slide inside the step, the rates of its friction and of the accelerations jump.
void PeakRecorder::add_slide_begins(const AnalysisState& state) {
  const double start = peaks_.start().time, end = peaks_.last().time;
  for (std::size_t b = 0; b < model_->blocks().size(); ++b) {
    if (!std::isfinite(state.elements(b).shortest_contact())) continue;
    for (std::size_t e = 0; e < model_->blocks()[b]->size(); ++e) {
      const double fraction = state.elements(b).contact(e).slide_begin;
      if (std::isnan(fraction)) continue;
      for (const std::size_t channel : channels_->bent_by(*model_, {.block = b, .element = e}))
        peaks_.add_bend(channel, start + fraction * (end - start));
    }
  }
}

void PeakRecorder::event(const StepView& view, std::span<const RegimeChange>) {
  sample(view);
  peaks_.restart();
  keep_smallest(false);
}

std::vector<Peak> PeakRecorder::peaks() const {
  std::vector<Peak> peaks;
  peaks.reserve(peaks_.size() + peaks_.size() / 4);  // drift ratios follow
  std::vector<std::size_t> channel_of_peak;
  // Only places that channels share are looked up.
  std::set<std::string_view> shared;
  for (const Channel& channel : channels_->list())
    if (channel.where != channel.place) shared.insert({channel.where, channel.place});
  std::map<std::pair<std::string_view, std::string_view>, std::size_t> index;
  for (std::size_t i = 0; i < peaks_.size(); ++i) {
    const Channel& channel = channels_->list()[i];
    std::size_t at = peaks.size();
    if (shared.contains(channel.place)) at = index.try_emplace({channel.quantity, channel.place}, at).first->second;
    if (at == peaks.size()) {
      peaks.push_back(peak_of(channel.quantity, channel.place, 0.0, channel.unit, 0.0));
      channel_of_peak.push_back(i);
    }
    Peak& peak = peaks[at];
    if (peaks_.magnitude(i) > peak.magnitude()) {
      peak.value = peaks_.value(i);
      peak.time = peaks_.time(i);
      channel_of_peak[at] = i;
    }
  }
  for (std::size_t i = 0; i < peaks.size(); ++i) peaks[i].side = side_of(channel_of_peak[i], peaks[i]);
  // Bearings that share a place, each by its own name.
  for (std::size_t i = 0; i < peaks_.size(); ++i) {
    const Channel& channel = channels_->list()[i];
    const bool of_bearing = channel.quantity == "isolator_deformation" || channel.quantity == "isolator_force" ||
                            channel.quantity == "bearing_compression";
    if (of_bearing && channel.where != channel.place && !index.contains({channel.quantity, channel.where}))
      peaks.push_back(peak_of(channel.quantity, channel.where, peaks_.value(i), channel.unit, peaks_.time(i)));
  }
  for (const Smallest& each : smallest_) {
    const Channel& channel = channels_->list()[each.channel];
    peaks.push_back(peak_of("smallest_bearing_compression", channel.where, each.value, channel.unit, each.time));
  }
  peaks.insert(peaks.end(), uplifts_.begin(), uplifts_.end());
  // In plan the maxima of two directions make no sum, and coupled masses have no inertia of a floor alone.
  if (model_->is_plan() || !model_->mass_matrix().is_diagonal()) return peaks;
  for (const Building& building : model_->buildings()) {
    if (building.shares_base) continue;
    Peak sum{"sum_of_floor_inertia_maxima", building.base_name(), 0.0, "N", 0.0};
    for (const NodeId node : carried_nodes(*model_, building)) {
      const std::size_t acceleration = Channels::of_node(*model_, node) + 2;
      sum.value += model_->mass(node) * peaks_.magnitude(acceleration);
      // The maxima are not simultaneous; the last of them completes the sum.
      sum.time = std::max(sum.time, peaks_.time(acceleration));
    }
    peaks.push_back(sum);
  }
  return peaks;
}

std::string PeakRecorder::side_of(std::size_t channel, const Peak& peak) const {
  const Channel& of_peak = channels_->list()[channel];
  if (peak.value == 0.0) return "";
  if (of_peak.where != of_peak.place) return std::string{of_peak.where};
  if (of_peak.of_gap || model_->is_plan()) return "";
  return peak.value > 0.0 ? "right" : "left";
}

}  // namespace moat
