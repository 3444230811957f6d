#include "elements/plan/rotation_link.hpp"

#include <utility>

#include "elements/block/link_block.hpp"
#include "materials/linear.hpp"
#include "materials/viscous.hpp"

namespace moat {
namespace {

// Two points of a body 1 m apart along x differ in their y displacements by theta times 1 m: a moment in N m is the
// force of a law with this deformation.
WeightedEnds rotation_of(const Model& model, NodeId lower, NodeId upper) {
  WeightedEnds ends;
  for (const auto& [body, sign] : {std::pair{lower, -1.0}, {upper, 1.0}})
    if (const PlacedDiaphragm* diaphragm = model.diaphragm_of(body))
      ends.add(model, diaphragm->id.r, sign / diaphragm->gyration);
  return ends;
}

Check check_bodies(const Model& model, std::string_view kind, const std::string& name, NodeId lower, NodeId upper) {
  const Check check = check_points(model, kind, name, "lower", PlanPoint{lower, {}}, "upper", PlanPoint{upper, {}});
  for (const NodeId body : {lower, upper})
    check.that(body == ground || model.diaphragm_of(body) != nullptr,
               "\"" + std::string{model.node_name(body)} + "\" does not turn.", "Give diaphragms, or `ground`.");
  return check;
}

template <class Law>
void add_link(Model& model, std::string_view kind, const std::string& name, NodeId lower, NodeId upper,
              const Law& law) {
  model.register_element(kind, name);
  model.block<LinkBlock<Law, WeightedEnds>>().add(
      {.name = name, .first = lower, .second = upper, .drawn_as = DrawnAs::nothing}, law,
      rotation_of(model, lower, upper));
}

}  // namespace

void add(Model& model, const RotationSpring& spring) {
  check_bodies(model, "RotationSpring", spring.name, spring.lower, spring.upper)
      .positive("stiffness", spring.stiffness.si(), "N m/rad");
  add_link(model, "RotationSpring", spring.name, spring.lower, spring.upper,
           Linear{.stiffness = Stiffness{spring.stiffness.si()}});
}

void add(Model& model, const RotationDamper& damper) {
  check_bodies(model, "RotationDamper", damper.name, damper.lower, damper.upper)
      .positive("damping", damper.damping.si(), "N m s/rad");
  add_link(model, "RotationDamper", damper.name, damper.lower, damper.upper,
           Viscous{.damping = DampingCoefficient{damper.damping.si()}});
}

}  // namespace moat
