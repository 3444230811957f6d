// Estimates of contact stiffness from geometry and material.
#pragma once

#include "base/required.hpp"
#include "base/units.hpp"
#include "materials/contact/estimate.hpp"

namespace moat {

/// Concrete of the bodies that hit each other.
struct Concrete {
  Modulus youngs_modulus = 30.0 * units::GPa;                 ///< E > 0 Pa.
  double poissons_ratio = 0.2;                                ///< 0 <= nu < 0.5.
  Density density = 2500.0 * units::kg / (1.0 * units::m_3);  ///< > 0 kg/m^3.
};

/// Where the mass of a slab is, along the direction of the hit.
enum class SlabMass {
  spread,      ///< evenly, as in a floor
  in_middle,   ///< at half the length
  at_far_end,  ///< at the end away from the hit
};

/// A slab that is hit at its edge.
///
///     hit -> [ contact_width |   length   ]     thickness is vertical, width across the hit
struct SlabAlongHit {
  Required<Length> length;     ///< L > 0 m, in the direction of the hit.
  Required<Length> width;      ///< b > 0 m.
  Required<Length> thickness;  ///< t > 0 m.
  /// 0 < b_c <= b, m: the width of the hit. The whole edge if left out.
  Length contact_width{};
  SlabMass mass = SlabMass::spread;  ///< Where its mass is.
  Concrete material{};               ///< Concrete of the slab.
};

/// Returns the stiffness between the edge of a slab and its centre of mass, N/m:
///
///     1/k = ln(b/b_c)/(2 E t) + L/(n E b t)    n = 3, 2, 1 for a mass that is spread, in the middle, at the far end
///
/// The load spreads at 45 degrees from the width b_c, which holds for b_c > t and b - b_c <= 2 L. `low` and `high` are
/// those of n = 1 and n = 3. Throws InputError for a parameter outside its range. Source: bar theory.
Estimate<Stiffness> axial_stiffness_of_slab(const SlabAlongHit& slab);

/// Returns the time that a wave needs to the far end of a bare slab and back, s: 2 L/c, c = sqrt(E/rho). The slab may
/// be taken as rigid beside a contact, or as a spring in series with it (in_series()), where the contact lasts three
/// times as long; beyond, it acts as a dashpot rho c A. Throws InputError for a parameter outside its range.
Time wave_return_time(const SlabAlongHit& slab);

/// The edge of a slab that hits a wall or another slab.
struct SlabEdge {
  Required<Mass> mass;       ///< > 0 kg of the floor.
  Mass wall_mass{};          ///< > 0 kg of the body that is hit; a plane if left out.
  Concrete material{};       ///< Concrete of the slab.
  Concrete wall_material{};  ///< Concrete of the body that is hit.
};

/// Returns the Hertz stiffness of spheres that have the masses of the bodies, divided by 4, N/m^1.5:
///
///     k = (4/3) E* sqrt(R),  1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2,  1/R = 1/R_1 + 1/R_2,
///     R_i = (3 m_i/(4 pi rho_i))^(1/3)
///
/// No floor is a sphere, and faces are uneven: `high` is k itself, an upper bound, and `low` a tenth of it. Throws
/// InputError for a parameter outside its range. `source` has the reasons for the quarter.
Estimate<HertzStiffness> contact_stiffness_of_slab_edge(const SlabEdge& edge);

/// A rounded vertical edge of height `thickness` that is pressed against a wall.
struct VerticalEdge {
  Required<Length> thickness;  ///< t > 0 m, the length of the line of contact.
  Concrete material{};         ///< Concrete of both bodies.
};

/// Returns the stiffness of a line of contact, N/m: k = (pi/4) E* t, which does not depend on the radius of the edge.
/// `high` is this value, an upper bound for an even line, and `low` a tenth of it. Throws InputError for a parameter
/// outside its range.
Estimate<Stiffness> contact_stiffness_of_vertical_edge(const VerticalEdge& edge);

/// Columns that a slab hits between two floors.
struct ColumnHit {
  Required<Length> height;      ///< h > 0 m, between its ends.
  Required<Length> depth;       ///< > 0 m, of the section in the direction of the hit.
  Required<Length> width;       ///< > 0 m, of the section across it.
  double share = 0.5;           ///< 0 < share < 1: the place of the hit, from the lower end, over h.
  double cracked_share = 0.35;  ///< 0 < share <= 1 of the inertia of the whole section.
  bool clamped = true;          ///< Whether both ends are clamped; else pinned.
  int count = 1;                ///< >= 1, equal columns that are hit together.
  Concrete material{};          ///< Concrete of the columns.
};

/// Returns the bending stiffness of columns at the place of the hit, N/m, with a = share h and b = h - a:
///
///     k = count 3 E I h^3/(a^3 b^3) clamped,  count 3 E I h/(a^2 b^2) pinned
///
/// `low` holds for pinned ends, `high` for clamped ends without cracks. Throws InputError for a parameter outside its
/// range. Source: beam theory.
Estimate<Stiffness> stiffness_of_column_hit(const ColumnHit& column);

/// A wall that is hit on a part of its width.
struct HitOnWall {
  Required<Length> contact_width;  ///< 0 < b_c <= width, m.
  Required<Length> height;         ///< h > 0 m, of the hit above the base of the wall.
  Required<Length> width;          ///< b > 0 m, of the wall.
};

/// Returns the width of a cantilever wall that resists a hit, m: b_c + 2.2 h, at most b. A force at the free edge of a
/// long cantilever plate moves it by 0.158 F h^2/D (nu = 0.2), from which the width follows. Throws InputError for a
/// parameter outside its range.
Length effective_wall_width(const HitOnWall& hit);

}  // namespace moat
