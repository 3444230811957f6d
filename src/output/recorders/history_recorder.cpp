#include "output/recorders/history_recorder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "base/hermite.hpp"
#include "model/building.hpp"
#include "output/recorders/energy_columns.hpp"

namespace moat {
HistoryRecorder::HistoryRecorder(const Model& model, double interval, const EnergyLedger* ledger, bool inside_steps)
    : channels_{std::make_shared<const Channels>(model)},
      interval_{interval},
      ledger_{ledger},
      inside_steps_{inside_steps},
      in_plan_{model.is_plan()},
      weights_change_{
          std::ranges::any_of(model.buildings(), [](const Building& each) { return each.axial_forces.has_value(); })} {
  Check{"HistoryRecorder", ""}.positive("interval", interval, "s");
  // Some more for ground, gaps and energies.
  recorded_.columns.reserve(channels_->list().size() + channels_->list().size() / 8 + 16);
  recorded_.columns.push_back({"time", "", "s", {}});
  if (in_plan_) {
    recorded_.columns.push_back({"ground_acceleration_x", "ground", "m/s^2", {}});
    recorded_.columns.push_back({"ground_acceleration_y", "ground", "m/s^2", {}});
  } else {
    recorded_.columns.push_back({"ground_acceleration", "ground", "m/s^2", {}});
  }
  for (const Channel& channel : channels_->list())
    recorded_.columns.push_back(
        {std::string{channel.quantity}, std::string{channel.where}, std::string{channel.unit}, {}});
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    if (!model.blocks()[b]->kind().contacts) continue;
    for (std::size_t e = 0; e < model.blocks()[b]->size(); ++e) {
      gaps_.push_back({b, e});
      recorded_.columns.push_back({"opening", model.blocks()[b]->info(e).name, "m", {}});
    }
  }
  if (ledger_ != nullptr)
    for (const EnergyColumn& column : energy_columns(in_plan_, weights_change_))
      recorded_.columns.push_back({std::string{column.name} + "_energy", "structure", "J", {}});
}

void HistoryRecorder::add(const OfferedQuantities& quantities) {
  offered_ = &quantities;
  for (; offered_columns_ < quantities.list().size(); ++offered_columns_) {
    const OfferedQuantity& each = quantities.list()[offered_columns_];
    const bool is_new = std::ranges::none_of(recorded_.columns, [&](const Column& head) {
      return head.quantity == each.quantity && head.where == each.where;
    });
    Check{"QuantityRecorder", each.quantity}.that(
        is_new, "moat records a quantity of this name at \"" + each.where + "\" itself.", "Choose another name.");
    recorded_.columns.push_back({each.quantity, each.where, each.unit, {}});
  }
}

void HistoryRecorder::start(const StepView& view) {
  constexpr double coincident = 1e-9;  // of an interval
  next_ = static_cast<long>(std::ceil(view.state.time() / interval_ - coincident));
  take(view, true);
  if (std::abs(now_.time - next_time()) > coincident * interval_) return;
  add_row(now_);
  ++next_;
}

void HistoryRecorder::step(const StepView& view) {
  constexpr double coincident = 1e-9;  // of an interval
  const double time = view.state.time();
  const bool due = time >= next_time() - coincident * interval_;
  before_.values.swap(now_.values);
  before_.rates.swap(now_.rates);
  before_.energies.swap(now_.energies);
  before_.offered.swap(now_.offered);
  before_.time = now_.time;
  before_.ground_acceleration = now_.ground_acceleration;
  take(view, due || inside_steps_);
  for (; time >= next_time() - coincident * interval_; ++next_)
    add_row(std::abs(time - next_time()) <= coincident * interval_ ? now_ : between(view, next_time()));
}

void HistoryRecorder::event(const StepView& view, std::span<const RegimeChange>) { take(view, inside_steps_); }

void HistoryRecorder::take(const StepView& view, bool with_energies) {
  now_.time = view.state.time();
  now_.ground_acceleration = view.ground_acceleration.horizontal();
  for (std::vector<double>* each : {&now_.values, &now_.rates}) each->reserve(channels_->list().size() + gaps_.size());
  if (sampled_ != nullptr) {
    now_.values = sampled_->last().values;
    now_.rates = sampled_->last().rates;
  } else {
    channels_->sample(view, now_.values, now_.rates);
  }
  for (const auto& [b, e] : gaps_) {
    const ElementResult result = view.state.elements(b).results()[e];
    now_.values.push_back(0.0 - result.deformation);  // not -0 where bodies touch at rest
    now_.rates.push_back(-result.rate);
  }
  if (offered_ != nullptr) offered_->sample(view, now_.offered);
  if (ledger_ == nullptr || !with_energies) return;
  const EnergyBalance balance = ledger_->totals(view.state);
  now_.energies.clear();
  for (const EnergyColumn& column : energy_columns(in_plan_, weights_change_))
    now_.energies.push_back(balance.*column.value);
}

const HistoryRecorder::Sample& HistoryRecorder::between(const StepView& view, double time) {
  const double step = now_.time - before_.time, x = (time - before_.time) / step;
  const auto linear = [x](double first, double last) { return first + x * (last - first); };
  inside_.time = time;
  inside_.ground_acceleration = {linear(before_.ground_acceleration.x, now_.ground_acceleration.x),
                                 linear(before_.ground_acceleration.y, now_.ground_acceleration.y)};
  inside_.values.resize(now_.values.size());
  for (std::size_t i = 0; i < now_.values.size(); ++i) {
    const HermiteCubic cubic{before_.values[i], before_.rates[i], now_.values[i], now_.rates[i], step};
    // The openings of gaps follow the channels.
    const bool is_channel = i < channels_->list().size();
    const double value = cubic.is_smooth() ? cubic.value(x) : linear(before_.values[i], now_.values[i]);
    inside_.values[i] = is_channel ? channels_->value_inside(view, i, x, value) : value;
  }
  inside_.energies = now_.energies;
  if (before_.energies.size() == now_.energies.size())
    for (std::size_t i = 0; i < now_.energies.size(); ++i)
      inside_.energies[i] = linear(before_.energies[i], now_.energies[i]);
  inside_.offered = now_.offered;
  for (std::size_t i = 0; i < now_.offered.size(); ++i)
    inside_.offered[i] = linear(before_.offered[i], now_.offered[i]);
  return inside_;
}

void HistoryRecorder::reserve(double duration) {
  constexpr double most = 1 << 23;  // numbers in all columns
  const double rows = std::min(duration / interval_ + 2.0, most / static_cast<double>(recorded_.columns.size()));
  for (Column& column : recorded_.columns) column.values.reserve(static_cast<std::size_t>(rows));
}

double HistoryRecorder::fit(double duration, double bytes) {
  constexpr double bytes_per_value = 500.0 / 45.0;
  const double needed = (duration / interval_ + 1.0) * static_cast<double>(recorded_.columns.size()) * bytes_per_value;
  if (needed <= bytes) return 0.0;
  // 1, 2, 5, 10, 20 ... times, so that equal runs seldom differ with the memory that happens to be free.
  constexpr std::array steps{2.0, 2.5, 2.0};
  double factor = 1.0;
  for (std::size_t i = 0; factor * bytes < needed; ++i) factor *= steps[i % steps.size()];
  interval_ *= factor;
  return needed;
}

void HistoryRecorder::add_row(const Sample& sample) {
  // Before the row: without memory for it all columns keep one length.
  for (Column& each : recorded_.columns)
    if (each.values.size() == each.values.capacity()) each.values.reserve(2 * each.values.size() + 1);
  auto column = recorded_.columns.begin();
  const auto add = [&](double value) { (column++)->values.push_back(value); };
  add(sample.time);
  add(sample.ground_acceleration.x);
  if (in_plan_) add(sample.ground_acceleration.y);
  std::ranges::for_each(sample.values, add);
  if (ledger_ != nullptr) std::ranges::for_each(sample.energies, add);
  std::ranges::for_each(sample.offered, add);
}

}  // namespace moat
