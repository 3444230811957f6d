#include "elements/line/viscous_damper.hpp"

#include <utility>

#include "elements/line/link_block.hpp"
#include "elements/line/link_checks.hpp"
#include "materials/viscous.hpp"

namespace moat {

void add(Model& model, ViscousDamper damper) {
  const Check check = check_link(model, "ViscousDamper", damper.name, {"lower", damper.lower}, {"upper", damper.upper});
  const Viscous law{.damping = damper.damping};
  law.check(check);
  model.register_element("ViscousDamper", damper.name);
  model.block<LinkBlock<Viscous>>().add(
      {.name = std::move(damper.name), .first = damper.lower, .second = damper.upper, .drawn_as = DrawnAs::nothing},
      law);
}

}  // namespace moat
