// Histories of all channels.
#pragma once

#include "output/channels.hpp"
#include "output/energy_ledger.hpp"
#include "output/table.hpp"

namespace moat {

/// Keeps time, ground acceleration and every channel at a constant interval: at the first grid time of the
/// analysis at or after each multiple of it. With a ledger also the energies, at place "structure".
class HistoryRecorder final : public StepObserver {
 public:
  /// interval: s, > 0. ledger: must outlive the recorder and be attached before it; may be null.
  HistoryRecorder(const Model& model, double interval, const EnergyLedger* ledger = nullptr);

  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView&, std::span<const RegimeChange>) override {}
  void finish(const StepView&) override {}

  [[nodiscard]] Table table() const;

 private:
  void record(const StepView& view);

  Channels channels_;
  double interval_;
  const EnergyLedger* ledger_;
  long next_ = 0;
  std::vector<double> values_;
  std::vector<Column> heads_;  // without values
  // Rows one after the other, in pieces, so that a long history is not copied while it grows.
  static constexpr std::size_t rows_per_piece = 256;
  std::vector<std::vector<double>> pieces_;
};

}  // namespace moat
