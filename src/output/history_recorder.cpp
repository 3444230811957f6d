#include "output/history_recorder.hpp"

#include "base/check.hpp"

#include <array>

namespace moat {
namespace {

struct EnergyColumn {
  const char* quantity;
  double EnergyBalance::*value;
};

constexpr std::array energy_columns{
    EnergyColumn{"input_energy", &EnergyBalance::input},         EnergyColumn{"kinetic_energy", &EnergyBalance::kinetic},
    EnergyColumn{"strain_energy", &EnergyBalance::strain},       EnergyColumn{"viscous_energy", &EnergyBalance::viscous},
    EnergyColumn{"hysteretic_energy", &EnergyBalance::hysteretic}, EnergyColumn{"impact_energy", &EnergyBalance::impact}};

}  // namespace

HistoryRecorder::HistoryRecorder(const Model& model, double interval, const EnergyLedger* ledger)
    : channels_{model}, interval_{interval}, ledger_{ledger} {
  Check{"HistoryRecorder", ""}.positive("interval", interval, "s");
  table_.columns.push_back({"time", "", "s", {}});
  table_.columns.push_back({"ground_acceleration", "ground", "m/s^2", {}});
  for (const Channel& channel : channels_.list())
    table_.columns.push_back({channel.quantity, channel.where, channel.unit, {}});
  if (ledger_ != nullptr)
    for (const EnergyColumn& column : energy_columns) table_.columns.push_back({column.quantity, "structure", "J", {}});
}

void HistoryRecorder::start(const StepView& view) {
  next_ = static_cast<long>(view.model.state().time / interval_);
  record(view);
}

void HistoryRecorder::step(const StepView& view) {
  // Steps that end at an event lie between grid times; a regular table skips them, peaks do not.
  if (view.on_grid && view.model.state().time >= static_cast<double>(next_) * interval_ * (1.0 - 1e-12)) record(view);
}

void HistoryRecorder::record(const StepView& view) {
  channels_.sample(view, values_);
  table_.columns[0].values.push_back(view.model.state().time);
  table_.columns[1].values.push_back(view.ground_acceleration);
  for (std::size_t i = 0; i < values_.size(); ++i) table_.columns[i + 2].values.push_back(values_[i]);
  if (ledger_ != nullptr) {
    const EnergyBalance balance = ledger_->totals(view.model);
    for (std::size_t i = 0; i < energy_columns.size(); ++i)
      table_.columns[2 + values_.size() + i].values.push_back(balance.*energy_columns[i].value);
  }
  while (static_cast<double>(next_) * interval_ <= view.model.state().time * (1.0 + 1e-12)) ++next_;
}

}  // namespace moat
