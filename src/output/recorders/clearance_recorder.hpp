// How near the gaps of a model came to closing.
#pragma once

#include <vector>

#include "output/files/case_result.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Keeps the smallest opening of every gap over continuous time: between two instants the cubic through indentations
/// and their rates counts. In plan an opening is the distance of a corner from its edge, also from an end of it.
class ClearanceRecorder final : public StepObserver {
 public:
  /// The model must be complete.
  explicit ClearanceRecorder(const Model& model);

  void start(const StepView& view) override { step(view); }
  void step(const StepView& view) override;
  void archive(StateArchive& archive) override { archive(gaps_, time_before_); }

  /// In the order of the elements.
  [[nodiscard]] std::vector<GapClearance> clearances() const;

 private:
  struct Gap {
    std::size_t block, element;
    double indentation, rate;  // at the last instant; negative while open
    double largest, time;
  };

  const Model* model_;
  std::vector<Gap> gaps_;
  double time_before_ = 0.0;
};

}  // namespace moat
