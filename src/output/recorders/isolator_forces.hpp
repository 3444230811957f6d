// The force of all isolators of a building together.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/plan_vector.hpp"
#include "output/files/case_result.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Follows the sum of the isolators' forces at the base of every Building, without impacts and dampers, which
/// `total_base_shear` has too. Peaks are the largest magnitudes at the ends of steps: `total_isolator_force` [N], in
/// plan `total_isolator_force_x` and `total_isolator_force_y`, at "base" or "<name> base".
class IsolatorForces final : public StepObserver {
 public:
  /// The model must outlive it.
  explicit IsolatorForces(const Model& model);

  void start(const StepView& view) override { step(view); }
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange>) override { step(view); }

  void archive(StateArchive& archive) override {
    for (Sum& sum : sums_) archive(sum.largest, sum.time_of_x, sum.time_of_y);
  }
  [[nodiscard]] std::vector<Peak> peaks() const;  ///< Peaks of every building on isolators, so far.

 private:
  struct Part {
    std::size_t block, element;
    bool in_two_directions;
    PlanVector direction;  // of the force of an element that acts along one
  };
  struct Sum {
    std::string where;
    std::vector<Part> parts{};
    PlanVector largest{};  // N
    double time_of_x = 0.0, time_of_y = 0.0;
  };
  std::vector<Sum> sums_;
  bool is_plan_;
};

}  // namespace moat
