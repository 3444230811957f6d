// Characteristic periods of isolated buildings.
#pragma once

#include <vector>

#include "model/building.hpp"
#include "model/model.hpp"
#include "output/files/case_result.hpp"

namespace moat {

/// The characteristic periods of every building of a model, and of every body beside them (all_buildings()), by name:
///
/// - "fixed base": first period of the superstructure with the floors on isolators held;
/// - "isolation, rigid building": 2 pi sqrt(M / sum of post-yield stiffness) (Zhao, Liu & Li 2017, Eq. 33, with
///   the mass of all floors and the base);
/// - "first mode, post-yield bearings" and "first mode, initial bearings": eigenvalues of the whole building;
/// - "first mode" alone for a building without isolators.
///
/// With several buildings each name starts with that of the building. Free bodies have no period and are
/// left out. Only the first `most_buildings` are computed.
std::vector<NamedPeriod> characteristic_periods(const Model& model, std::size_t most_buildings = 8);

/// Returns the first period, s, of these degrees of freedom, which ascend, with all others held; infinite if they are
/// free, 0 if there are none.
double first_period(const SparseMatrix& stiffness, const SparseMatrix& mass, const std::vector<int>& nodes);

/// Returns the first period, s, of a building and those on its base, in the initial state, with all floors on isolators
/// held; on a line and in plan. 0 where nothing is left to move.
double fixed_base_period(const Model& model, const Building& building);

}  // namespace moat
