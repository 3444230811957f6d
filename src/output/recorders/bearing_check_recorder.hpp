// The largest demand over capacity of bearings and dampers.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "materials/bearings/bearing_checks.hpp"
#include "output/files/case_result.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Checks bearings and dampers at every instant of an analysis against capacities by their names, or by those of their
/// types:
///
///     BearingCheckRecorder checks{CheckRules::aashto,
///                                 {{"LRB700", {.rubber = RubberBearing{...}, .displacement_capacity = 0.5 * m}},
///                                  {"dampers", {.stroke = 0.5 * m, .force_capacity = 1 * MN}}}};
///     return script.run(model, motion, {&checks});
///
/// The run then writes bearing_checks.csv, and the report has a section. Capacities under the name of a bearing go
/// before those of its type. They are those of one bearing: forces of an Isolator are divided by its count. Instants
/// are ends of steps and both sides of events; the first one is that at rest. Checks with an axial force need
/// AxialForces of the building.
class BearingCheckRecorder final : public StepObserver {
 public:
  /// Throws InputError for capacities outside their ranges.
  BearingCheckRecorder(CheckRules rules, std::map<std::string, BearingCapacities> capacities);

  /// Throws InputError for a name that is neither an element's nor a type's.
  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange>) override { step(view); }

  void archive(StateArchive& archive) override {
    for (Bearing& bearing : bearings_) bearing.checks.archive(archive);
  }
  /// One for every check of every bearing, in the order of the model.
  [[nodiscard]] std::vector<BearingCheckRow> rows() const;

 private:
  struct Bearing {
    std::size_t block, element;
    double count;  // of bearings that the element stands for
    std::string name, type;
    BearingChecks checks;
  };

  CheckRules rules_;
  std::map<std::string, BearingCapacities> capacities_;
  std::vector<Bearing> bearings_;
};

}  // namespace moat
