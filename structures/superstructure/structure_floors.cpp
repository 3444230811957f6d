#include "structures/superstructure/structure_floors.hpp"

#include <algorithm>
#include <cmath>

#include "structures/frame/constraints.hpp"
#include "structures/superstructure/condensed_rows.hpp"

namespace moat {
namespace {

// Checks a floor or the base.
SystemFloor checked(const Check& check, const std::string& name, const auto& part, Length height, bool in_plan) {
  check.positive(name + " mass", part.mass);
  SystemFloor result{.height = height.si(),
                     .mass = part.mass.si(),
                     .centre_of_mass = part.centre_of_mass.si(),
                     .outline = part.outline,
                     .half_width = part.half_width.si()};
  if (!in_plan) return result;
  result.rotary_inertia = checked_rotary_inertia({.name = name,
                                                  .mass = part.mass,
                                                  .rotary_inertia = part.rotary_inertia,
                                                  .centre_of_mass = part.centre_of_mass,
                                                  .outline = part.outline});
  double farthest = 0.0;
  for (std::size_t i = 0; i < part.outline.size(); ++i)
    farthest = std::max(farthest, length(part.outline.corner(i) - result.centre_of_mass));
  constexpr double least = 0.05, most = 1.2;  // shares of the farthest corner's distance
  check.that(
      farthest == 0.0 || (result.gyration() > least * farthest && result.gyration() < most * farthest),
      "rotary inertia of " + name + " gives a radius of " + to_text(result.gyration()) + " m; is its unit t m^2?",
      "The farthest corner of its outline is " + to_text(farthest) + " m away.");
  return result;
}

// Matrices are about the centres of mass with which they were condensed.
void compare(const Check& check, std::size_t number, const SystemFloor& floor, const Level& level, bool in_plan) {
  constexpr double round_off = 1e-3;  // m
  const double apart = in_plan ? length(floor.centre_of_mass - level.centre_of_mass) : 0.0;
  check.that(std::abs(floor.height - level.height) <= round_off && apart <= round_off,
             "floor " + std::to_string(number) + " has another height or centre of mass than the condensed level at " +
                 to_text(level.height) + " m, (" + to_text(level.centre_of_mass.x) + ", " +
                 to_text(level.centre_of_mass.y) + ") m.",
             "Give those, or leave floors out.");
}

}  // namespace

std::vector<SystemFloor> existing_bases(const Model& model, const Superstructure& structure) {
  std::vector<SystemFloor> bases;
  for (const DiaphragmId& each : structure.on) {
    model.require_node(each, Check{"Superstructure", structure.name}, "on");
    if (const PlacedDiaphragm* base = model.diaphragm_of(each))
      bases.push_back({.mass = base->mass,
                       .rotary_inertia = base->mass * base->gyration * base->gyration,
                       .centre_of_mass = base->centre_of_mass});
    else
      bases.push_back({.mass = model.mass(each)});
  }
  return bases;
}

void add_floors(const Superstructure& structure, const Check& check, StructureSystem& system) {
  const std::vector<Level> levels = structure.condensed ? levels_of_floors(*structure.condensed) : std::vector<Level>{};
  std::vector<SuperstructureFloor> floors = structure.floors;
  if (floors.empty())
    for (const Level& level : levels)
      floors.push_back({.height = Length{level.height},
                        .mass = Mass{level.mass},
                        .rotary_inertia = RotaryInertia{level.rotary_inertia},
                        .centre_of_mass = {Length{level.centre_of_mass.x}, Length{level.centre_of_mass.y}},
                        .outline = level.outline});
  check.that(!floors.empty(), "floors is empty.", "Give one for each floor, from the lowest up.");
  for (const SuperstructureFloor& floor : floors) {
    const std::size_t i = system.floors.size();
    const std::string number = "floor " + std::to_string(i + 1);
    const std::string name = structure.floors.empty() ? levels[i].name : number;
    SystemFloor& added = system.floors.emplace_back(checked(check, name, floor, floor.height, system.in_plan));
    // Rows of a table count as other floors do.
    added.name = structure.storeys ? number : name;
    if (i < levels.size()) added.tower = levels[i].tower;
    const int lower = level_below(system.floors, i);
    const double below = lower < 0 ? 0.0 : system.floors[static_cast<std::size_t>(lower)].height;
    check.that(
        added.height > below,
        "heights must rise: " + name + " at " + to_text(added.height) + " m is not above " + to_text(below) + " m.",
        "Give heights above the base or the ground, from the lowest floor up.");
  }
  for (std::size_t i = 0; i < std::min(levels.size(), floors.size()); ++i)
    compare(check, i + 1, system.floors[i], levels[i], system.in_plan);
  if (structure.base) system.bases = {checked(check, "base", *structure.base, Length{}, system.in_plan)};
}

}  // namespace moat
