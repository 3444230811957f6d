// The retaining walls beside an isolated base.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elements/contact/gap.hpp"
#include "materials/soil/hyperbolic_backfill.hpp"
#include "structures/wall_law.hpp"

namespace moat {

/// A cantilever wall as built: length units of the drawing, material of its concrete.
struct WallGeometry {
  /// > 0 m, above its base.
  Required<Length> height;
  /// > 0 m.
  Required<Length> thickness;
  /// > 0 m, the length of the wall along the building that a hit moves.
  Required<Length> width;
  /// E > 0 Pa.
  Required<decltype(units::N / (units::m * units::m))> youngs_modulus;
  /// > 0 kg/m^3.
  decltype(units::kg / (units::m * units::m * units::m)) density =
      2400.0 * units::kg / (units::m * units::m * units::m);
  /// 0 < share <= 1 of the inertia of the whole section; 0.3 to 0.5 where concrete has cracked.
  double cracked_share = 1.0;
  /// Stiffness of the base against rotation, > 0 N m; clamped if left out.
  Energy base_rotation{};
  /// Yield moment of the base, > 0 N m: the wall yields there; elastic if left out.
  Energy yield_moment{};
};

/// A wall that gives way: a mass on a spring and a dashpot, fixed to the ground, and soil behind it.
///
///     ///--[spring]--
///     ///--[dashpot]-[mass]  |<- clearance ->[ base ]
///     ///--[backfill]
struct FlexibleWall {
  /// > 0 kg that moves with the face of the wall.
  Required<Mass> mass;
  /// > 0 N/m of wall and soil behind it; or give `law`.
  Stiffness stiffness{};
  /// >= 0 N s/m. Without damping the wall rings after every hit, and small steps follow it; 2 ratio sqrt(k m) gives a
  /// damping ratio.
  DampingCoefficient damping{};
  /// > 0 N at the height of the hit: the wall yields there; elastic if left out.
  Force yield_force{};
  /// 0 <= ratio < 1, of the stiffness after yield.
  double hardening_ratio = 0.0;
  /// Soil behind the wall, which resists where the wall is pushed into it. Not in plan.
  std::optional<HyperbolicBackfill> backfill{};
  /// Any law instead of `stiffness` and `yield_force`.
  std::optional<WallLaw> law{};

  /// Throws InputError for a parameter outside its range, and for a wall with both or none of `stiffness` and `law`.
  void check(const Check& check) const;
  /// The law between the ground and the face, which has the damping of an elastic wall, and the dashpot beside others.
  [[nodiscard]] WallLaw acting_law() const;
  /// The damping coefficient of that dashpot, N s/m; 0 where the law has the damping.
  [[nodiscard]] DampingCoefficient dashpot() const {
    return law || yield_force.si() > 0.0 ? damping : DampingCoefficient{};
  }

  /// The wall hit at its top: k = 1/(h^3/(3 E I) + h^2/k_r) with I = share b t^3/12. The mass is 33/140 rho b t h of a
  /// clamped cantilever, or rho b t h/3 of a stiff wall that turns about its base where k_r is the softer part. The
  /// yield force is M_y/h. The frequency of a clamped cantilever comes out 1.5 % too high. Throws InputError for a
  /// value out of its range.
  static FlexibleWall from_geometry(const WallGeometry& geometry);
};

/// On which sides of the base a moat has a wall.
enum class Sides { left, right, both };

/// A moat: walls beside a node, at the same clearance.
///
///     wall |<- clearance ->[ around ]<- clearance ->| wall
///
/// Gaps "NAME left" and "NAME right", whose impact forces share the place NAME; a moat on one side alone is one gap
/// "<name>". The walls are fixed to the ground, or nodes "<name> left wall", "<name> right wall" or "<name> wall" on
/// springs where `wall` is given. Then `wall_force` [N] and `wall_deformation` [m] are reported too, and
/// `backfill_force` [N] and `soil_gap` [m] of "<name> left backfill" and so on where soil is behind.
template <ImpactLaw Law>
struct Moat {
  std::string name = "moat";  ///< Unique in its model.
  Required<NodeId> around;    ///< The floor that hits the walls.
  /// >= 0 m, on each side at rest; 0 is wall to wall.
  Required<Length> clearance;
  Law law;                             ///< Gives the force from the indentation.
  Sides sides = Sides::both;           ///< Where there are walls.
  std::optional<FlexibleWall> wall{};  ///< The wall is rigid if left out.
};

/// Adds a flexible wall whose face is `offset` to the right of the floor, and returns its node.
NodeId add_wall(Model& model, const FlexibleWall& wall, const std::string& name, NodeId around, Length offset);

/// One gap of a moat.
struct MoatGap {
  std::string name;         ///< "<name> left"
  MemberPoint left, right;  ///< The floor and the wall, or the wall and the floor.
};

/// The gaps on the sides of a moat, with their flexible walls added. Throws InputError for a moat without name, a node
/// that is not of the model, and as the walls would.
std::vector<MoatGap> moat_gaps(Model& model, const std::string& name, NodeId around, Length clearance, Sides sides,
                               const std::optional<FlexibleWall>& wall);

/// Throws InputError as the gaps and walls would.
template <ImpactLaw Law>
void add(Model& model, const Moat<Law>& moat) {
  for (const MoatGap& gap : moat_gaps(model, moat.name, moat.around, moat.clearance, moat.sides, moat.wall))
    add(model, Gap<Law>{.name = gap.name,
                        .place = moat.name,
                        .left = gap.left,
                        .right = gap.right,
                        .clearance = moat.clearance,
                        .law = moat.law});
}

}  // namespace moat
