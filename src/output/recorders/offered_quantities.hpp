// The quantities of all recorders that offer some, and their peaks.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "output/files/case_result.hpp"
#include "output/recorders/quantity_recorder.hpp"

namespace moat {

/// A list that several recorders share.
class OfferedQuantities {
 public:
  /// The recorder must outlive the list. Throws InputError for an empty name, unit, or a quantity that is listed.
  void add(const QuantityRecorder& recorder);

  /// In the order of values.
  [[nodiscard]] const std::vector<OfferedQuantity>& list() const { return list_; }
  /// values := all quantities at the committed state.
  void sample(const StepView& view, std::vector<double>& values) const;

 private:
  struct Source {
    const QuantityRecorder* recorder;
    std::size_t first, count;
  };

  std::vector<Source> sources_;
  std::vector<OfferedQuantity> list_;
};

/// Keeps the value of largest magnitude of every offered quantity at the ends of steps, on both sides of events. Values
/// that are infinite or no number are counted and left out.
class OfferedPeaks final : public StepObserver {
 public:
  /// The list must outlive the recorder and be complete when the analysis starts.
  explicit OfferedPeaks(const OfferedQuantities& quantities) : quantities_{&quantities} {}

  void start(const StepView& view) override { step(view); }
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange>) override { step(view); }

  void archive(StateArchive& archive) override { archive(largest_); }
  /// One for every quantity. The value is not a number where no value was finite.
  [[nodiscard]] std::vector<Peak> peaks() const;
  /// One for every quantity with values that are not finite.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  // The largest value of one quantity.
  struct Largest {
    double value = std::numeric_limits<double>::quiet_NaN(), time = 0.0;
    long not_finite = 0;               // number of values
    double first_not_finite_at = 0.0;  // s
  };

  const OfferedQuantities* quantities_;
  std::vector<double> values_;
  std::vector<Largest> largest_;
};

}  // namespace moat
