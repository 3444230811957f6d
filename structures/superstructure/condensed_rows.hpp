// Rows of a condensed model beside those of its floors: a level at the feet, and motions that are kept.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "structures/superstructure/structure_system.hpp"

namespace moat {

/// Returns the superstructure with its storeys as a condensed model, and with the base that these or a level at the
/// feet describe, where none is given. Throws InputError where storeys and a condensed model are given.
Superstructure with_condensed_rows(const Superstructure& structure);

/// Returns the levels above the feet.
std::vector<Level> levels_of_floors(const CondensedStructure& condensed);

/// Adds names and rigid motions of the motions that are kept to a system that has those of its floors, in m and rad.
void add_kept_motions(const CondensedStructure& condensed, StructureSystem& system);

/// Throws InputError where masses couple a level at the feet with others, or where it has mass and is not the base.
void check_base_level(const Superstructure& structure, const Check& check, const StructureSystem& system);

/// Returns the stiffness without the rows of a level at the feet. Rigid motion of this level and of all others, the
/// columns of `rigid` in m and rad, must strain nothing: throws InputError where it does.
Eigen::MatrixXd condensed_stiffness(const CondensedStructure& condensed, const Check& check,
                                    const Eigen::MatrixXd& rigid, StructureSystem& system);

/// Replaces matrices by all modes together, relative to the base, which are the same system: motions that are kept
/// belong to no floor, and they are the last `kept` rows. `shapes` are those of all modes.
void move_in_all_modes(const Eigen::MatrixXd& shapes, Eigen::Index kept, StructureSystem& system);

}  // namespace moat
