#include "elements/lead_rubber_bearing.hpp"

#include "elements/link_block.hpp"
#include "elements/link_checks.hpp"
#include "materials/bilinear.hpp"

namespace moat {

void add(Model& model, const LeadRubberBearing& bearing) {
  const Check check =
      check_link(model, "LeadRubberBearing", bearing.name, {"lower", bearing.lower}, {"upper", bearing.upper});
  const Bilinear law{.yield_force = bearing.yield_force,
                     .yield_displacement = bearing.yield_displacement,
                     .post_yield_stiffness = bearing.post_yield_stiffness};
  law.check(check);
  model.register_element("LeadRubberBearing", bearing.name);
  model.block<LinkBlock<Bilinear>>().add({.name = bearing.name,
                                          .place = bearing.name,
                                          .kind = ElementKind::bearing,
                                          .first = bearing.lower,
                                          .second = bearing.upper,
                                          .deformation_quantity = "isolator_deformation",
                                          .force_quantity = "isolator_force"},
                                         law);
}

}  // namespace moat
