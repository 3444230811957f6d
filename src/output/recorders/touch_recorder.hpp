// The touches of a run.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "output/recorders/step_observer.hpp"

namespace moat {

/// The beginning of an impact.
struct Touch {
  std::string where{};          ///< name of the gap
  double time = 0.0;            ///< s
  double approach_speed = 0.0;  ///< m/s; <= 0 if the bodies did not approach
};

/// Lists the touches of the contacts that ImpactRecorder lists, without their energies, which cost a third of an
/// analysis.
class TouchRecorder final : public StepObserver {
 public:
  void start(const StepView& view) override;
  void step(const StepView&) override {}
  void event(const StepView& view, std::span<const RegimeChange> changes) override;

  /// In the order of time.
  [[nodiscard]] const std::vector<Touch>& touches() const { return touches_; }

 private:
  void add(const StepView& view, std::size_t block, std::size_t element, double time);

  std::set<std::pair<std::size_t, std::size_t>> touching_;  // block, element
  std::vector<Touch> touches_;
};

}  // namespace moat
