#include "elements/line/shear_spring.hpp"

#include <utility>

#include "elements/line/link_block.hpp"
#include "elements/line/link_checks.hpp"
#include "materials/linear.hpp"

namespace moat {

void add(Model& model, ShearSpring spring) {
  const Check check = check_link(model, "ShearSpring", spring.name, {"lower", spring.lower}, {"upper", spring.upper});
  const Linear law{.stiffness = spring.stiffness};
  law.check(check);
  model.register_element("ShearSpring", spring.name);
  model.block<LinkBlock<Linear>>().add({.name = std::move(spring.name),
                                        .first = spring.lower,
                                        .second = spring.upper,
                                        .deformation_quantity = "drift",
                                        .force_quantity = "storey_shear",
                                        .drawn_as = DrawnAs::storey},
                                       law);
}

}  // namespace moat
