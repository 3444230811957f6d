// The law of a retaining wall, of any kind.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "elements/line/spring.hpp"
#include "elements/plan/plan_spring.hpp"
#include "model/model.hpp"

namespace moat {

/// Any law between the ground and the face of a wall: `BaberNoori`, `ImkBilinear`, one of the script's own. Reports
/// `wall_force` [N] and `wall_deformation` [m], and the quantities of the law.
class WallLaw {
 public:
  /// A copy of the law.
  template <ForceLaw Law>
  WallLaw(Law law)
      : on_line_{[law](Model& model, const std::string& name, NodeId face) {
          add(model, Spring<Law>{.name = name,
                                 .lower = ground,
                                 .upper = face,
                                 .law = law,
                                 .deformation_quantity = deformation,
                                 .force_quantity = force});
        }},
        in_plan_{[law](Model& model, const std::string& name, NodeId face, PlanVector direction) {
          add(model, PlanSpring<Law>{.name = name,
                                     .lower = PlanPoint{ground, {}},
                                     .upper = PlanPoint{face, {}},
                                     .direction = direction,
                                     .law = law,
                                     .deformation_quantity = deformation,
                                     .force_quantity = force});
        }} {}

  /// Adds the law of a wall of a model on a line.
  void add_to(Model& model, const std::string& name, NodeId face) const { on_line_(model, name, face); }
  /// Adds the law of a wall that moves in this direction, of length 1.
  void add_in_plan(Model& model, const std::string& name, NodeId face, PlanVector direction) const {
    in_plan_(model, name, face, direction);
  }

 private:
  static constexpr const char *deformation = "wall_deformation", *force = "wall_force";

  std::function<void(Model&, const std::string&, NodeId)> on_line_;
  std::function<void(Model&, const std::string&, NodeId, PlanVector)> in_plan_;
};

}  // namespace moat
