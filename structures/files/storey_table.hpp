// Storeys and outlines of a building from tables.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "model/plan_outline.hpp"

namespace moat {

/// A floor, and the storey below it. Quantities whose columns are missing are zero.
struct StoreyRow {
  /// Name of the floor.
  std::string name{};
  Length height{};                    ///< > 0 m, of the storey below the floor
  Mass mass{};                        ///< > 0 kg, of the floor
  RotaryInertia rotary_inertia{};     ///< > 0 kg m^2, of the floor about its centre of mass
  PlanPosition centre_of_mass{};      ///< of the floor
  PlanPosition centre_of_rigidity{};  ///< of the storey
  /// > 0 N/m, of the storey.
  Stiffness stiffness_x{}, stiffness_y{};
  Energy rotational_stiffness{};  ///< > 0 N m/rad, of the storey about its centre of rigidity
  PlanOutline outline{};          ///< of the floor
};

/// The storeys of a building.
struct StoreyTable {
  std::optional<StoreyRow> base{};   ///< the floor on the bearings, which has no storey; none on the ground
  std::vector<StoreyRow> floors{};   ///< from the lowest up
  std::string source{};              ///< path of the file
  std::vector<std::string> notes{};  ///< remarks about the file, sentences
};

/// Polygons by their names.
using Outlines = std::map<std::string, PlanOutline>;

/// Reads a CSV table of corners, counter-clockwise: `name,x [m],y [m]`. All rows with a name are an outline.
///
/// Throws FileError naming file and line, InputError for a polygon that is none (PlanOutline::check).
Outlines read_outlines(const std::filesystem::path& file);

/// Reads a CSV table of storeys. Units stand in brackets behind the names of the columns, which have any order; a unit
/// may be any of its dimension (base/parse_quantity.hpp; m2 is m^2). name and mass are required, and height or
/// elevation.
///
/// | column | meaning |
/// |---|---|
/// | `name` | of the floor; unique |
/// | `height [m]` | of the storey below the floor; rows stand from the lowest up |
/// | `elevation [m]` | of the floor; then the rows may have any order |
/// | `mass [t]`, `inertia [t m2]` | of the floor, and about its centre of mass |
/// | `x_mass [m]`, `y_mass [m]` | centre of mass of the floor |
/// | `x_rigidity [m]`, `y_rigidity [m]` | centre of rigidity of the storey below |
/// | `kx [kN/m]`, `ky [kN/m]`, `k_rotation [kN m]` | stiffness of the storey below, about its centre of rigidity |
/// | `outline` | name of an outline |
///
/// A lowest row `base` has the mass on the bearings; `ground` has none. Neither has a storey. Where it is missing,
/// elevations count from 0.
///
/// Throws FileError naming file, line, column and remedy; also for a "floor 3" that is not the third from below.
StoreyTable read_storeys(const std::filesystem::path& file, const Outlines& outlines = {});

/// All centres of mass, of the base too, moved along x and y by these shares of the extent of their outlines there:
/// accidental eccentricity. ASCE 7 takes 5 % of the plan dimension across the motion. Throws InputError for a share
/// outside -0.5 to 0.5, and unless both are 0 for a row without outline.
StoreyTable with_eccentricity(StoreyTable storeys, double share_of_x, double share_of_y);

}  // namespace moat
