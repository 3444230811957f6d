// The building of a design sheet, out of its model.
#pragma once

#include <string>

#include "design/sheet_inputs.hpp"
#include "model/model.hpp"

namespace moat {

/// Returns a SheetBuilding with the facts of a model in plan: weight of base and floors (mass times g), heights of
/// floors above the base, sides of the base along x and y. It also has the places of the isolators, distance from the
/// centre of mass to their centre, and the period on a fixed base (fixed_base_period()). Floors of all buildings on
/// this base count.
///
///     SheetBuilding building = sheet_building_of(model, BearingDesign{...});
///     building.bounds = bounds;
///     building.clearance = gap;
///
/// isolation: all isolators together, nominal. base: the name of the base. Throws InputError for a model without a
/// building in plan on this base, for a base without outline, and for one without isolators.
SheetBuilding sheet_building_of(const Model& model, const SheetIsolation& isolation, const std::string& base = "base");

}  // namespace moat
