// A model as results list it: plain values that outlive it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/element_details.hpp"

namespace moat {

class Model;

/// A node, for files and pictures.
struct NodeFacts {
  std::string name;                   ///< unique in its model
  double mass = 0.0;                  ///< kg
  double x = 0.0;                     ///< m, of drawings
  double height = 0.0;                ///< m, of drawings
  double initial_displacement = 0.0;  ///< m
  double initial_velocity = 0.0;      ///< m/s
};

/// A parameter of a law.
struct ParameterFacts {
  std::string name;    ///< as scripts write it: "stiffness"
  double value = 0.0;  ///< in SI units
  std::string unit;    ///< SI symbol
};

/// An element, for files and pictures.
struct ElementFacts {
  std::string name;                        ///< unique in its model
  std::string kind;                        ///< "storey", "bearing", "gap" or "other"
  std::string law;                         ///< name of the law; empty where it is not known
  std::string first, second;               ///< names of the nodes or diaphragms it joins; "ground" for the ground
  std::vector<ParameterFacts> parameters;  ///< of its law
  /// The other node of an end between two nodes.
  std::string first_other{}, second_other{};
  /// The share of the way to it.
  double first_share = 0.0, second_share = 0.0;
  /// The ends at rest, m, of a spring in plan, and the direction of its force, zero for one that acts in both.
  std::optional<PlanPlaces> plan_places{};
  /// Where its peaks are listed together with those of others; its name if it is listed alone.
  std::string place{};
  double static_weight = 0.0;  ///< N, on a bearing of a building with AxialForces at rest; else 0
};

/// A floor in plan.
struct DiaphragmFacts {
  std::string name;                   ///< unique in its model
  double gyration = 0.0;              ///< m
  PlanVector centre_of_mass{};        ///< m
  std::vector<PlanVector> outline{};  ///< corners, m
  bool is_base = false;               ///< the lowest floor of its building
};

/// A corner that can hit an edge.
struct CornerFacts : CornerPair {
  std::string element{};      ///< the contact
  std::string body{};         ///< the diaphragm of the corner
  double clearance = 0.0;     ///< m
  bool edge_is_wall = false;  ///< of the ground, or of a wall; else of another floor
};

/// The whole model, for files and pictures.
struct ModelFacts {
  std::vector<NodeFacts> nodes;        ///< in the order of the model
  std::vector<ElementFacts> elements;  ///< in the order of the model
  // In plan.
  std::vector<DiaphragmFacts> diaphragms{};  ///< in plan
  std::vector<CornerFacts> corners{};        ///< in plan
};

/// All nodes and elements of a model with their parameters.
ModelFacts facts_of(const Model& model);

}  // namespace moat
