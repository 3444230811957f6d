#include "elements/isolator.hpp"

namespace moat {

ElementInfo isolator_info(const std::string& name, NodeId lower, NodeId upper) {
  static const Label deformation{"isolator_deformation"}, force{"isolator_force"};
  return {.name = name,
          .first = lower,
          .second = upper,
          .deformation_quantity = deformation,
          .force_quantity = force,
          .isolates = true,
          .drawn_as = DrawnAs::bearing};
}

}  // namespace moat
