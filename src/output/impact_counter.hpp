// The number of impacts.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <utility>

#include "output/step_observer.hpp"

namespace moat {

/// Counts the contacts that ImpactRecorder lists, without their energies, which cost a third of an analysis.
class ImpactCounter final : public StepObserver {
 public:
  void start(const StepView& view) override;
  void step(const StepView&) override {}
  void event(const StepView& view, std::span<const RegimeChange> changes) override;

  /// Number of touches so far.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::set<std::pair<std::size_t, std::size_t>> touching_;  // block, element
  std::size_t count_ = 0;
};

}  // namespace moat
