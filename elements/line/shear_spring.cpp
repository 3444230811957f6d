#include "elements/line/shear_spring.hpp"

#include <utility>

#include "elements/block/link_checks.hpp"
#include "materials/linear.hpp"

namespace moat {

void add(Model& model, ShearSpring spring) {
  add_link(model, "ShearSpring",
           {.name = std::move(spring.name),
            .first = spring.lower,
            .second = spring.upper,
            .deformation_quantity = "drift",
            .force_quantity = "storey_shear",
            .drawn_as = DrawnAs::storey},
           Linear{.stiffness = spring.stiffness});
}

}  // namespace moat
