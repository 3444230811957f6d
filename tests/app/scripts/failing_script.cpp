// A script whose step does not converge: its spring has no force that is a number beyond 5 cm.
#include <moat.hpp>

#include <limits>

#include "elements/block/link_block.hpp"

using namespace moat;
using namespace moat::units;

struct Snapping {
  using State = NoState;

  Response evaluate(const State&, double deformation, double, State&) const {
    return {deformation > 0.05 ? std::numeric_limits<double>::quiet_NaN() : 0.0, 1.0, 0.0};
  }
  double stored_energy(const State&, double) const { return 0.0; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return 1.0; }
};

int main(int argc, char** argv) {
  Script script{argc, argv, "A spring that snaps"};
  const GroundMotion motion = script.motion(near_fault_pulse());
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne, .initial_velocity = 10 * cm / s});
  model.register_element("Spring", "snapping");
  model.block<LinkBlock<Snapping>>().add(
      {.name = "snapping", .place = "snapping", .first = ground, .second = body, .force_quantity = "pull"}, Snapping{});
  return script.run(model, motion);
}
