#include "analyses/case/case_assumptions.hpp"

#include <algorithm>
#include <array>

#include "model/building.hpp"

namespace moat {
namespace {

// Assumptions of every result.
constexpr std::array general_assumptions{
    "Displacements and velocities are relative to the ground, accelerations absolute; positive to the right.",
    "A peak is the value of largest magnitude over continuous time, with its sign, also between steps and on both "
    "sides of an event. Forces and deformations of springs are positive where the upper end moves to the right, "
    "those of gaps where they are compressed.",
    "clearance_left is the smallest opening of a gap over continuous time; negative: the two sides indented each "
    "other by so much.",
    "total_base_shear is the force of isolators and impacts together; sum_of_floor_inertia_maxima adds the "
    "maxima of mass times absolute acceleration of base and floors, which are not simultaneous.",
    "Energies are in the frame of the ground: input is the work of the ground's inertia forces on relative motion.",
    "storey_shear is the elastic force of the columns, without that of the storey's damping; overturning_moment is the "
    "moment of the elastic forces on all floors above a storey about its lower floor."};

// Assumptions of results in plan, in place of those above.
constexpr std::array plan_assumptions{
    "Floors are rigid and move in plan: x to the right, y up, rotation counter-clockwise, displacements and velocities "
    "relative to the ground, accelerations absolute. The flexibility of floors and the height of contacts are left "
    "out.",
    "Displacements are linear in rotations.",
    "Resultants are those of simultaneous components; corner_displacement, corner_acceleration and corner_drift are "
    "resultants at the corners of the outlines, their peaks the largest of all corners.",
    "A peak is the value of largest magnitude over continuous time, with its sign, also between steps and on both "
    "sides of an event. impact_force and indentation are positive where a contact is compressed; friction_force acts "
    "along the edge, with the normal turned by +90 degrees.",
    "clearance_left is the smallest opening of a gap over continuous time; negative: the two sides indented each "
    "other by so much.",
    "total_base_shear and total_base_torque, about the origin, are those of bearings and impacts together.",
    "storey_shear_x, _y are elastic forces of columns, without damping; storey_torque is their torque about the centre "
    "of "
    "mass of the base, or of the lowest floor; overturning_moment_x, _y, named by the direction of the forces, are "
    "moments of the elastic forces on all floors above a storey about its lower floor.",
    "Contacts are points: corners with a normal law each, and Coulomb friction with an elastic grip before it slides.",
    "Energies are in the frame of the ground: input is the work of the ground's inertia forces on relative motion."};

// An assumption of buildings in plan without axial forces.
constexpr const char* weight_is_constant =
    "Vertical motion, rocking, uplift and the coupling of bearings with their vertical force are left out.";

}  // namespace

std::vector<std::string> assumptions_of(const Model& model) {
  if (!model.is_plan()) return {general_assumptions.begin(), general_assumptions.end()};
  std::vector<std::string> list;
  const std::vector<Building>& buildings = model.buildings();
  if (std::ranges::none_of(buildings, [](const Building& each) { return each.axial_forces.has_value(); }))
    list.emplace_back(weight_is_constant);
  else
    for (const Building& building : buildings)
      if (!building.axial_forces && !building.shares_base)
        list.push_back("\"" + building.name + "\": " + weight_is_constant);
  list.insert(list.end(), plan_assumptions.begin(), plan_assumptions.end());
  return list;
}

}  // namespace moat
