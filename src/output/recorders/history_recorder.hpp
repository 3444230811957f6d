// Histories of all channels.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "output/files/table.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "output/recorders/channels.hpp"
#include "output/recorders/energy_ledger.hpp"
#include "output/recorders/offered_quantities.hpp"

namespace moat {

/// Keeps time, ground acceleration, every channel and the opening of every gap (negative while indented) at the
/// multiples of a constant interval, from the first at or after the start on. A row that falls inside a step is
/// interpolated: channels by the cubic through value and rate at both ends (forces of laws that are not linear by the
/// law itself), everything else linearly. With a ledger the energies too, at place "structure", then the quantities
/// that recorders offer. At an event a row has the values before it.
class HistoryRecorder final : public StepObserver {
 public:
  /// interval: s, > 0. ledger: must outlive the recorder and be attached before it; may be null. inside_steps: rows may
  /// fall inside steps, so that energies are needed at every step.
  HistoryRecorder(const Model& model, double interval, const EnergyLedger* ledger = nullptr, bool inside_steps = false);

  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange> changes) override;
  void archive(StateArchive& archive) override {
    archive(interval_, next_, before_, now_);
    for (Column& column : recorded_.columns) archive(column.values);
  }

  /// Before the start: adds columns for these quantities, which must outlive the recorder; called again, for those
  /// listed since. Throws InputError for one that has a column already.
  void add(const OfferedQuantities& quantities);

  /// Before the start: channels are those that these peaks sample, which must outlive the recorder and be attached
  /// before it. Otherwise they are sampled a second time.
  void share_samples_of(const PeakRecorder& peaks) {
    sampled_ = &peaks;
    channels_ = peaks.channels();
  }
  /// Before the start: room for the rows of so many seconds, up to 64 MB. More may come.
  void reserve(double duration);
  /// Before the start: takes a multiple of the interval where the rows of so many seconds, with the files that are made
  /// of them, would need more bytes (500 for a row of 45 columns). Returns the bytes that the rows at the first
  /// interval would need; 0 if they fit.
  double fit(double duration, double bytes);
  [[nodiscard]] double interval() const { return interval_; }  ///< s

  /// All columns, from the start to the last recorded time.
  [[nodiscard]] const Table& table() const { return recorded_; }
  /// Behind the end: returns all columns, which the recorder then no longer has.
  [[nodiscard]] Table take_table() { return std::exchange(recorded_, {}); }

 private:
  // Everything at one instant.
  struct Sample {
    double time = 0.0;
    PlanVector ground_acceleration{};
    std::vector<double> values, rates, energies, offered;

    void archive(auto& archive) { archive(time, ground_acceleration, values, rates, energies, offered); }
  };

  void take(const StepView& view, bool with_energies);
  void add_row(const Sample& sample);
  [[nodiscard]] const Sample& between(const StepView& view, double time);
  [[nodiscard]] double next_time() const { return static_cast<double>(next_) * interval_; }

  std::shared_ptr<const Channels> channels_;
  std::vector<std::pair<std::size_t, std::size_t>> gaps_;  // block and element
  double interval_;
  const EnergyLedger* ledger_;
  bool inside_steps_;
  bool in_plan_, weights_change_;
  const PeakRecorder* sampled_ = nullptr;
  const OfferedQuantities* offered_ = nullptr;
  std::size_t offered_columns_ = 0;
  long next_ = 0;  // multiple of the interval
  Sample before_, now_, inside_;
  Table recorded_;
};

}  // namespace moat
