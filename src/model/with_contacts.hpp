// A model with changed contacts.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace moat {

/// How all contacts of a model differ in a copy of it. The default changes nothing.
struct ContactChange {
  double stiffness_factor = 1.0;    ///< > 0, of the stiffness of the law.
  double restitution_change = 0.0;  ///< -1 to 1, added to the restitution of the law.
  double clearance_factor = 1.0;    ///< >= 0, of the free distance at rest.
  double soil_factor = 1.0;         ///< > 0, of the stiffnesses and the capacity of soil behind walls.
};

/// The parameters that with_contacts() can change in a model.
struct ChangeableParameters {
  bool stiffness = false;    ///< Whether the law of a contact has one.
  bool restitution = false;  ///< Whether the law of a contact has one.
  bool clearance = false;    ///< Whether a gap is open at rest.
  bool soil = false;         ///< Whether there is soil behind a wall.
  /// Names of the laws of contacts that have neither stiffness nor restitution, each once: laws of a script without
  /// fields of these names.
  std::vector<std::string> unchanged_laws{};
};

/// Looks at all contacts and all soil of a model.
ChangeableParameters changeable_parameters(const Model& model);

/// Returns a copy of the model in which all contacts are changed together: gaps on a line, corners in plan, gaps
/// between neighbours.
///
///     const Model softer = with_contacts(model, {.stiffness_factor = 1.0 / 3.0});
///
/// Stiffness and restitution are those of the law: k and e, of BilinearImpact with the same d_m; KelvinByDampingRatio
/// gets the damping ratio that delivers the changed restitution. A restitution stays between 0.001 and 1. A law without
/// the parameter stays as it is. Gaps that the initial displacements close keep their clearance; in plan the edge moves
/// along its normal. Soil (FlexibleWall::backfill) has K_max, K_ur and F_ult times the factor. All else is the same, so
/// that the default change gives the same results in every bit.
///
/// Throws InputError for a factor or a change outside its range, for one that changes nothing in this model, and where
/// a law refuses a changed parameter.
Model with_contacts(const Model& model, const ContactChange& change);

/// Returns the restitutions of all laws of contacts, ascending, each once.
std::vector<double> restitutions_of_contacts(const Model& model);

}  // namespace moat
