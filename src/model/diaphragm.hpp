// A rigid floor that moves in plan.
#pragma once

#include <array>
#include <string>

#include "base/plan_vector.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "model/node.hpp"
#include "model/plan_outline.hpp"

namespace moat {

/// The degrees of freedom of a diaphragm: displacements ux and uy of its centre of mass, and w = gyration * theta of
/// its rotation theta. Made by add(model, Diaphragm{...}).
///
/// All three are nodes, so that state.displacement(base.x) and every recorder know them. w is in m, its inertia is the
/// mass, and its force is moment / gyration; state.rotation(base) is theta.
struct DiaphragmId {
  /// Nodes of ux, uy and w.
  NodeId x{}, y{}, r{};

  [[nodiscard]] constexpr bool specified() const { return x.specified(); }  ///< Whether add() made it.
  /// Motions along x and y, and the rotation.
  [[nodiscard]] constexpr std::array<NodeId, 3> degrees_of_freedom() const { return {x, y, r}; }
  /// Stands for the whole floor where a Building or a recorder takes a node.
  constexpr operator NodeId() const { return x; }
  friend constexpr bool operator==(const DiaphragmId& a, const DiaphragmId& b) {
    return a.x == b.x && a.y == b.y && a.r == b.r;
  }
};

/// Sides along x and y.
struct PlanSize {
  /// > 0 m
  Length x{}, y{};
};

/// A rigid floor with three degrees of freedom: x to the right, y up in plan, rotation counter-clockwise, all relative
/// to the ground.
///
///        +----------------+
///        |        ^ uy    |      u_P = (ux - y theta, uy + x theta) at a point P
///        |   P    |       |      with the arm (x, y) from the centre of mass,
///        |     theta -> ux|      linear in theta
///        +----------------+
///
/// Positions are coordinates of the whole model. The rotary inertia is given, or it is that of a uniform rectangle of
/// `size`, m (Lx^2 + Ly^2)/12, or of the uniform `outline`. It belongs to the centre of mass, wherever that is.
struct Diaphragm {
  /// Unique in its model. Its degrees of freedom are the nodes "<name>:x", "<name>:y" and "<name>:r".
  std::string name;
  /// > 0 kg.
  Required<Mass> mass;
  /// > 0 kg m^2, at most the mass times the squared distance of the farthest corner of `outline`.
  RotaryInertia rotary_inertia{};
  /// > 0 m: sides of a uniform rectangle.
  PlanSize size{};
  PlanPosition centre_of_mass{};  ///< In coordinates of the whole model.
  /// The floor's edge: its corners report their displacements and accelerations, and can touch walls.
  PlanOutline outline{};
  /// At time zero, relative to the ground.
  PlanPosition initial_displacement{};
  Angle initial_rotation{};  ///< At time zero.
  /// Velocity of the centre of mass at time zero.
  Speed initial_velocity_x{}, initial_velocity_y{};
  Frequency initial_angular_velocity{};  ///< rad/s, at time zero.
  bool free = false;                     ///< Whether nothing need hold it, as Node::free.
  /// Above the ground: for drawings, drift ratios and PlanNeighbours.
  Length height{};
};

/// A diaphragm of a model, in SI.
struct PlacedDiaphragm {
  std::string name;             ///< Unique in its model.
  DiaphragmId id;               ///< Finds its degrees of freedom.
  double mass = 0.0;            ///< kg
  double gyration = 0.0;        ///< r = sqrt(J/m), m
  PlanVector centre_of_mass{};  ///< m
  PlanOutline outline{};        ///< The floor's edge.
  double height = 0.0;          ///< m

  /// The shares of (ux, uy, w) in the displacement of a point, m, along a direction.
  [[nodiscard]] std::array<double, 3> weights(PlanVector point, PlanVector direction) const {
    return {direction.x, direction.y, cross(point - centre_of_mass, direction) / gyration};
  }
};

/// Checks a diaphragm and returns its rotary inertia, kg m^2. Throws InputError.
double checked_rotary_inertia(const Diaphragm& diaphragm);

}  // namespace moat
