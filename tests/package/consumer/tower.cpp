// An input script in a project with CMakeLists.txt.
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "A mass on a spring"};
  Model model;
  const NodeId mass = add(model, Node{.name = "mass", .mass = 500 * tonne});
  add(model, ShearSpring{.name = "spring", .lower = ground, .upper = mass, .stiffness = 20 * MN / m});
  return script.run(model, near_fault_pulse());
}
