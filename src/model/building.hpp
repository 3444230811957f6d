// A building among the nodes of a model.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/places.hpp"
#include "model/body.hpp"
#include "model/node.hpp"
#include "model/weight/axial_forces.hpp"

namespace moat {

class Model;

/// An element, by its place in a model.
struct ElementId {
  std::size_t block = 0;    ///< index into Model::blocks()
  std::size_t element = 0;  ///< index in that block

  friend bool operator==(const ElementId&, const ElementId&) = default;
};

/// A share of the force of an element.
struct ForceShare {
  ElementId element;    ///< with one component
  double weight = 0.0;  ///< 1, or the arm of a moment in m
};

/// A result of a storey that is a sum over displacements of nodes and forces of elements: a drift, a shear, a moment.
struct StoreyResult {
  std::string quantity;                      ///< "storey_shear"
  std::string place;                         ///< "storey 1"
  std::string unit;                          ///< "N"
  std::vector<MotionShare> displacements{};  ///< Weights in the unit of the result per m.
  std::vector<ForceShare> forces{};          ///< Weights in the unit of the result per N.
};

/// The share of the mass that moves in a mode of a building held at its base: (Q' M R)^2 and its part of R' M R, along
/// x and y and about the base's centre of mass.
struct ParticipatingMass {
  double period = 0.0;                      ///< s
  double x = 0.0, y = 0.0, rotation = 0.0;  ///< 1
};

/// A building: floors above each other, on a base or on the ground. Periods, charts and reports use it; it has no
/// effect on forces. A ShearBuilding adds one itself; add one when you build from nodes and elements:
///
///     add(model, Building{.base = base, .floors = {floor_1, floor_2}});
///
/// The sum of mass times absolute acceleration over its nodes, and those of buildings on its base, is the force of
/// isolators and impacts together (`total_base_shear`). The sum of the maxima of its terms is the design value that
/// many papers quote (`sum_of_floor_inertia_maxima`). Both are listed at "base", or at "<name> base".
struct Building {
  /// Put before "base" in results; needed where a model has several buildings.
  std::string name{};
  /// The floor on the isolators; `ground` for a fixed building.
  NodeId base = ground;
  /// From the lowest up.
  Places<NodeId, floors_remedy> floors{};
  /// Slabs that carry its floors too and move apart from `base`. Isolators of all of them are its isolators, and its
  /// base shear is that of all together; drifts of the lowest storey are relative to `base`.
  std::vector<NodeId> slabs{};
  /// Whether its base is a base or slab of another building, such as a podium with two towers. The other one counts its
  /// inertia.
  bool shares_base = false;
  /// How the weight on its isolators changes, for laws of friction under a changing weight; left out: it is constant.
  std::optional<AxialForces> axial_forces{};
  /// Results besides those that every building has.
  std::vector<StoreyResult> storey_results{};
  /// Masses that take part in its modes, held at its base; none where they are not known.
  std::vector<ParticipatingMass> modes{};

  /// By its number in names: floor(1) is the lowest. Throws InputError outside 1 to the number of floors.
  [[nodiscard]] NodeId floor(int number) const { return floors.numbered(number, Check{"Building", name}, "floor"); }
  /// Base, unless that is the ground or another building's, slabs and floors.
  [[nodiscard]] std::vector<NodeId> nodes() const;
  [[nodiscard]] NodeId top() const { return floors.empty() ? base : floors.back(); }  ///< The highest floor.
  /// Where its base shear is listed.
  [[nodiscard]] std::string base_name() const { return name.empty() ? "base" : name + " base"; }
};

/// The nodes whose inertia the isolators of a building carry: its own, and those of buildings on its base. Empty for
/// one that shares the base of another.
std::vector<NodeId> carried_nodes(const Model& model, const Building& building);

/// The isolators of every building: elements that separate one of its nodes from the ground (ElementInfo::isolates).
std::vector<std::vector<ElementId>> isolators_of(const Model& model, std::span<const Building> buildings);

/// The number of a part, 0, 1, ..., for every node by its Model::place(): two nodes have the same one if elements other
/// than contacts lead from one to the other, without passing the ground.
std::vector<int> connected_parts(const Model& model);

/// The buildings of a model, and every connected part in which there is none, as a building with the name of its first
/// node. Its base is the first of its nodes on isolators.
std::vector<Building> all_buildings(const Model& model);

/// Returns the names of single bodies on the ground beside the buildings of a model, walls for example; none for a
/// model without buildings.
std::vector<std::string> bodies_beside_buildings(const Model& model);

}  // namespace moat
