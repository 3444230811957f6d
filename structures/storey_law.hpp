// The law of a storey, of any kind.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "elements/line/storey.hpp"
#include "model/model.hpp"

namespace moat {

/// Any law for the storeys of a building: `YieldingStorey`, `BaberNoori`, one of the script's own.
class StoreyLaw {
 public:
  /// Keeps a copy of the law.
  template <ForceLaw Law>
  StoreyLaw(Law law)
      : initial_stiffness_{law.linear_stiffness(StiffnessStage::initial)},
        add_{[law = std::move(law)](Model& model, const std::string& name, NodeId lower, NodeId upper) {
          add(model, Storey<Law>{.name = name, .lower = lower, .upper = upper, .law = law});
        }} {}

  /// N/m.
  [[nodiscard]] double initial_stiffness() const { return initial_stiffness_; }
  /// Adds a storey with this law between two nodes. Throws InputError for a bad parameter.
  void add_to(Model& model, const std::string& name, NodeId lower, NodeId upper) const {
    add_(model, name, lower, upper);
  }

 private:
  double initial_stiffness_;
  std::function<void(Model&, const std::string& name, NodeId lower, NodeId upper)> add_;
};

}  // namespace moat
