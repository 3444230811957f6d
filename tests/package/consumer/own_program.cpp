// A program that computes with moat and keeps its own input and output: prints the number of impacts.
#include <iostream>
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main() {
  Model model;
  const NodeId mass = add(model, Node{.name = "mass", .mass = 500 * tonne});
  add(model, ShearSpring{.name = "spring", .lower = ground, .upper = mass, .stiffness = 20 * MN / m});
  add(model, Moat{.around = mass,
                  .clearance = 1 * mm,
                  .law = ExactHertzDamp{.stiffness = 2e9 * N / m_3_2, .restitution = 0.6}});
  std::cout << run_case(model, near_fault_pulse(), {.transient = {.end = 3 * s}}).impacts.size() << "\n";
}
