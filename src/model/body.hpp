// Bodies and their degrees of freedom.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/ground_vector.hpp"
#include "base/units.hpp"
#include "model/node.hpp"

namespace moat {

/// A body of a model: a name, a position and degrees of freedom. A Node is a body with one, a Diaphragm has three (x, y
/// and rotation), a GeneralisedBody any number, a Follower none of its own.
struct Body {
  std::string name;                        ///< Unique in its model.
  double x = 0.0, y = 0.0, height = 0.0;   ///< m, at rest
  double half_width = 0.0;                 ///< m, of a floor, in drawings
  NodeId first{};                          ///< of its nodes, which have successive indices
  int nodes = 1;                           ///< > 0: one for each of its degrees of freedom
  bool free = false;                       ///< whether nothing need hold it
  bool generalised = false;                ///< whether it is a GeneralisedBody
  bool follows = false;                    ///< whether it is a Follower, without degrees of freedom of its own
  std::optional<PlanVector> direction{};   ///< along which a node moves in plan, of length 1
  std::optional<std::size_t> diaphragm{};  ///< index into Model::diaphragms()
};

/// One generalised coordinate of a body.
struct GeneralisedCoordinate {
  std::string name;  ///< Unique in its body; the degree of freedom is "<body>:<name>".
  /// The displacement of the coordinate when the ground moves by 1 along x, y and z and nothing deforms.
  GroundVector ground_influence{};
  double initial_displacement = 0.0;  ///< m, relative to the ground
  double initial_velocity = 0.0;      ///< m/s
};

/// A body that moves in generalised coordinates q, for example the modes of a building:
///
///     M (q'' + iota a_g) + forces of elements = 0
///
/// Elements join its coordinates as they join nodes.
struct GeneralisedBody {
  std::string name;                                ///< Unique in its model.
  std::vector<GeneralisedCoordinate> coordinates;  ///< At least one.
  Eigen::MatrixXd mass;                            ///< kg, symmetric and positive definite, as large as coordinates.
  Length x{}, y{}, height{};                       ///< Position at rest.
  bool free = false;                               ///< Whether nothing need hold it, as Node::free.
};

/// The share of a degree of freedom in a displacement: weight times its own.
struct MotionShare {
  NodeId node;          ///< a degree of freedom, never the ground or a follower
  double weight = 0.0;  ///< 1
};

/// A node or diaphragm whose motion is that of degrees of freedom of other bodies, for example a floor of a building
/// that moves in modes, q, on its base, b:
///
///     u = sum of weight * u(node)          absolute acceleration = sum of weight * u''(node) + iota a_g
///
/// Elements act on it as on any other, and results are listed at it. Its mass is among those of the bodies that it
/// follows: it is given for results alone.
struct Follower {
  /// One list for a node; for a diaphragm those of ux, uy and w, in m.
  std::vector<std::vector<MotionShare>> shares;
  std::vector<GroundVector> ground_influence;  ///< iota of each.
};

}  // namespace moat
