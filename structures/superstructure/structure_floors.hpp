// Floors and base of a superstructure, checked.
#pragma once

#include "structures/superstructure/structure_system.hpp"

namespace moat {

/// Returns the bases that are there already.
std::vector<SystemFloor> existing_bases(const Model& model, const Superstructure& structure);

/// Adds them to a system that knows whether it is in plan. Throws InputError for heights that do not rise, a mass that
/// is not > 0, a rotary inertia that does not fit the outline, and floors that are not those of `condensed`.
void add_floors(const Superstructure& structure, const Check& check, StructureSystem& system);

}  // namespace moat
