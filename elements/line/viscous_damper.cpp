#include "elements/line/viscous_damper.hpp"

#include <utility>

#include "elements/block/link_checks.hpp"
#include "materials/viscous.hpp"

namespace moat {

void add(Model& model, ViscousDamper damper) {
  add_link(
      model, "ViscousDamper",
      {.name = std::move(damper.name), .first = damper.lower, .second = damper.upper, .drawn_as = DrawnAs::nothing},
      Viscous{.damping = damper.damping});
}

}  // namespace moat
