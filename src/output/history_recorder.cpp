#include "output/history_recorder.hpp"

#include "base/check.hpp"

#include <array>

namespace moat {
namespace {

struct EnergyColumn {
  const char* quantity;
  double EnergyBalance::*value;
};

constexpr std::array energy_columns{EnergyColumn{"input_energy", &EnergyBalance::input},
                                    EnergyColumn{"kinetic_energy", &EnergyBalance::kinetic},
                                    EnergyColumn{"strain_energy", &EnergyBalance::strain},
                                    EnergyColumn{"viscous_energy", &EnergyBalance::viscous},
                                    EnergyColumn{"hysteretic_energy", &EnergyBalance::hysteretic},
                                    EnergyColumn{"impact_energy", &EnergyBalance::impact}};

}  // namespace

HistoryRecorder::HistoryRecorder(const Model& model, double interval, const EnergyLedger* ledger)
    : channels_{model}, interval_{interval}, ledger_{ledger} {
  Check{"HistoryRecorder", ""}.positive("interval", interval, "s");
  heads_.push_back({"time", "", "s", {}});
  heads_.push_back({"ground_acceleration", "ground", "m/s^2", {}});
  for (const Channel& channel : channels_.list()) heads_.push_back({channel.quantity, channel.where, channel.unit, {}});
  if (ledger_ != nullptr)
    for (const EnergyColumn& column : energy_columns) heads_.push_back({column.quantity, "structure", "J", {}});
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
  if (pieces_.empty() || pieces_.back().size() == rows_per_piece * heads_.size()) {
    pieces_.emplace_back();
    pieces_.back().reserve(rows_per_piece * heads_.size());
  }
  std::vector<double>& piece = pieces_.back();
  piece.push_back(view.model.state().time);
  piece.push_back(view.ground_acceleration);
  piece.insert(piece.end(), values_.begin(), values_.end());
  if (ledger_ != nullptr) {
    const EnergyBalance balance = ledger_->totals(view.model);
    for (const EnergyColumn& column : energy_columns) piece.push_back(balance.*column.value);
  }
  while (static_cast<double>(next_) * interval_ <= view.model.state().time * (1.0 + 1e-12)) ++next_;
}

Table HistoryRecorder::table() const {
  Table table{heads_};
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    std::vector<double>& values = table.columns[i].values;
    if (!pieces_.empty()) values.reserve((pieces_.size() - 1) * rows_per_piece + pieces_.back().size() / heads_.size());
    for (const std::vector<double>& piece : pieces_)
      for (std::size_t k = i; k < piece.size(); k += heads_.size()) values.push_back(piece[k]);
  }
  return table;
}

}  // namespace moat
