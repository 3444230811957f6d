// Frames of elastic beams, columns and walls in space.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "base/required.hpp"
#include "structures/frame/finite_elements.hpp"

namespace moat {

/// The section of a member in its local axes.
///
///         y                        Local x runs along the member. Local y lies in the plane of x and the reference
///         ^                        direction: z of the building; x of the building for vertical members. Local z is
///      +--|--+                     x cross y.
///      |  |  |  h
///   z <---+  |      x towards      I_z bends in the plane x-y: a beam vertically, a column along x of the building.
///      |     |      the reader     I_y bends in the plane x-z: a beam horizontally, a column along y of the building.
///      +-----+
///         b
struct MemberSection {
  Required<Area> area;     ///< > 0 m^2.
  SecondMoment I_y{};      ///< >= 0 m^4; 0: no stiffness in bending.
  SecondMoment I_z{};      ///< >= 0 m^4.
  SecondMoment torsion{};  ///< J >= 0 m^4 of Saint-Venant: the torque is G J / L for a twist of 1.
  Area shear_area_y{};     ///< >= 0 m^2, for shear along local y (with I_z); 0: no deformation in shear.
  Area shear_area_z{};     ///< >= 0 m^2, for shear along local z (with I_y); 0 likewise.
};

/// A rectangle, h along local y, b along local z. A wall is a column whose h or b is its length; beams reach it with
/// offsets of half of this length.
///
///     A = b h,  I_z = b h^3/12,  I_y = h b^3/12,  shear areas 5/6 A,
///     J = s t^3 (1/3 - 0.21 t/s (1 - t^4/(12 s^4))),  s >= t: the two sides
///
/// J is within 0.5 % of the series of Saint-Venant (Young & Budynas, Roark's Formulas for Stress and Strain).
struct RectangularSection {
  Required<Length> b;             ///< > 0 m, along local z.
  Required<Length> h;             ///< > 0 m, along local y.
  bool shear_deformation = true;  ///< false: shear areas of 0.

  operator MemberSection() const;  ///< Computes the properties.
};

/// An elastic material.
struct ElasticMaterial {
  Required<Modulus> E;         ///< > 0 Pa.
  double poisson = 0.2;        ///< > -1, <= 0.5: 0.2 for concrete, 0.3 for steel; without effect where G is given.
  std::optional<Modulus> G{};  ///< > 0 Pa; E / (2 (1 + poisson)) if left out.
  Density density{};           ///< >= 0 kg/m^3.
};

/// Motions of an end of a member, in local axes, that it does not pass on to its node.
struct EndReleases {
  bool x = false, y = false, z = false;     ///< Translations: no axial force, no shear.
  bool rx = false, ry = false, rz = false;  ///< Rotations: no torque, no bending moments.
};

/// The way from a node to the end of the flexible part of a member, along the axes of the building. It is rigid.
struct RigidOffset {
  Length x{}, y{}, z{};  ///< Any length.
};

/// A straight elastic member (Euler-Bernoulli, or Timoshenko with shear areas). L is the length between its offsets.
///
///     EA/L,  GJ/L,  and in each plane of bending, with phi = 12 EI / (G A_s L^2),
///     EI / (L^3 (1 + phi)) [12, 6L, -12, 6L; ., (4+phi) L^2, -6L, (2-phi) L^2; ., ., 12, -6L; ., ., ., (4+phi) L^2]
struct FrameMember {
  std::string name{};                      ///< "member 7" in the order of the list if left out.
  Required<NodeName> from, to;             ///< Different nodes at different places.
  MemberSection section;                   ///< In local axes.
  ElasticMaterial material;                ///< One material over the whole length.
  std::array<double, 3> reference{};       ///< Direction in the local plane x-y; zeros for the one of MemberSection.
  RigidOffset offset_from{}, offset_to{};  ///< From the nodes inwards.
  EndReleases releases_from{}, releases_to{};  ///< At the ends of the flexible part.
};

/// A frame of elastic members, condensed to the motions of its levels. Forces in members are not computed.
///
///     const Frame frame{.nodes = {{.name = 1}, {.name = 2, .z = 4 * m}, ...},
///                       .members = {{.from = 1, .to = 2, .section = RectangularSection{.b = 0.5 * m, .h = 0.5 * m},
///                                    .material = {.E = 30 * GPa}}, ...},
///                       .levels = {{.height = 4 * m, .mass = 60 * tonne}}};
///     const CondensedStructure matrices = frame.condensed();
///
/// Members with a density give half of the mass of their flexible part to each of their nodes, along x and y: vertical
/// inertia is left out. Nodes that belong to no level are condensed.
struct Frame {
  std::string name{};                         ///< Messages call it so.
  std::vector<FrameNode> nodes{};             ///< At least two.
  std::vector<FrameMember> members{};         ///< At least one.
  std::vector<FrameLevel> levels{};           ///< From the lowest up, with the masses of the floors.
  Feet feet = Feet::clamped;                  ///< Feet that belong to a level move with it in plan.
  std::vector<NodeName> foot_nodes{};         ///< All nodes within 1 mm of the lowest height if left out.
  LevelMotion motion = LevelMotion::in_plan;  ///< How all levels move.
  Vanishing masses = Vanishing::refuse;       ///< Where nodes that belong to no level have none.

  /// Assembles nodes and matrices, six motions for each node. Throws InputError for a bad parameter.
  [[nodiscard]] FiniteElements finite_elements() const;
  /// Throws InputError for a bad parameter, and as condensed(FiniteElements) does.
  [[nodiscard]] CondensedStructure condensed() const;
};

}  // namespace moat
