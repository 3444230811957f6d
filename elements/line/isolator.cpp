#include "elements/line/isolator.hpp"

namespace moat {

ElementInfo isolator_info(const std::string& name, NodeId lower, NodeId upper) {
  return {.name = name,
          .first = lower,
          .second = upper,
          .deformation_quantity = "isolator_deformation",
          .force_quantity = "isolator_force",
          .isolates = true,
          .drawn_as = DrawnAs::bearing};
}

}  // namespace moat
