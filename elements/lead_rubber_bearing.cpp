#include "elements/lead_rubber_bearing.hpp"

#include "elements/link_block.hpp"
#include "elements/link_checks.hpp"
#include "materials/bilinear.hpp"
#include "materials/located_bilinear.hpp"

namespace moat {

void add(Model& model, const LeadRubberBearing& bearing) {
  const Check check =
      check_link(model, "LeadRubberBearing", bearing.name, {"lower", bearing.lower}, {"upper", bearing.upper});
  const Bilinear law{.yield_force = bearing.yield_force,
                     .yield_displacement = bearing.yield_displacement,
                     .post_yield_stiffness = bearing.post_yield_stiffness};
  law.check(check);
  model.register_element("LeadRubberBearing", bearing.name);
  ElementInfo info{.name = bearing.name,
                   .kind = ElementKind::bearing,
                   .first = bearing.lower,
                   .second = bearing.upper,
                   .deformation_quantity = "isolator_deformation",
                   .force_quantity = "isolator_force"};
  if (bearing.locate_yield)
    model.block<LinkBlock<LocatedBilinear>>().add(std::move(info), LocatedBilinear{law});
  else
    model.block<LinkBlock<Bilinear>>().add(std::move(info), law);
}

}  // namespace moat
