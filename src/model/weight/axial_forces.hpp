// Axial forces of bearings that change.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/plan_vector.hpp"
#include "base/quantity.hpp"

namespace moat {

/// Where the concave or flat surface of a slider is.
enum class SlidingSurface : std::uint8_t {
  below,  ///< on the pedestal; the bearing moves with the building
  above,  ///< under the building; the bearing stays with the ground
};

/// Axial forces of bearings that follow overturning and vertical motion. Without them the weight is constant.
///
///            M ->                 N_i = sigma W_i + k_i (c_0 + c_x x_i + c_y y_i),   sum N_i (1, x_i, y_i) = (V, M)
///     [     base     ]            sigma = 1 + a_v/g
///      N_1   N_2   N_3            M = sum of h_j (-m_j a_j) and h_k P_k, and of displaced weights
///     ===o====o====o===
///
/// N > 0 is compression. The slab is rigid, each bearing a vertical spring k_i; N_i of a bearing that cannot pull is
/// never negative: it lifts. a_j are absolute accelerations of the base and the floors, m_j their masses and h_j their
/// heights above the level of the bearings; P_k are forces from outside the building (walls, neighbours, dampers to the
/// ground) at their heights. M is positive where it presses the bearings at +x (+y). There is no vertical degree of
/// freedom of a bearing and no impact at landing; rotary inertia of floors about horizontal axes is neglected.
///
/// Sources: Zayas, Low & Mahin (1987); Tsopelas, Constantinou & Reinhorn (1994), 3D-BASIS-ME.
struct AxialForces {
  /// How the weight at rest is shared.
  enum class Shares : std::uint8_t {
    balanced,  ///< so that vertical load and moments balance about the centre of mass
    equal,     ///< W/n for every bearing
  };
  /// The end of the run, or not, where the resultant of the weight leaves the bearings, so that no distribution exists.
  enum class Rocking : std::uint8_t {
    stops,      ///< the analysis ends with RockingError
    continues,  ///< the resultant stays at the edge of the bearings; later peaks are marked
  };

  /// Height of the base's centre of mass above the level of the bearings, >= 0 m; floors stand above it.
  Length base_height{};
  Shares shares = Shares::balanced;                        ///< Bearings with a weight of their own keep that.
  SlidingSurface sliding_surface = SlidingSurface::below;  ///< Where sliders with one surface have it.
  /// Whether weights act where they are: those of floors at their displacement relative to the base, and the bearings'
  /// forces at their displaced surfaces. False: text-book statics.
  bool displaced_weight = true;
  /// > 0 N: up to this tension one bearing that is no slider may pull, beyond with 5 % of its stiffness (cavitation of
  /// rubber: 3 G A, recalled from Kumar, Whittaker & Constantinou 2014). Left out: no bearing pulls.
  Force may_pull{};
  /// 0.01 to 1 s: period of one vertical mode in which the whole weight moves; left out: it moves with the ground.
  Time vertical_period{};
  double vertical_damping = 0.0;     ///< >= 0 and < 1, of that mode.
  Rocking rocking = Rocking::stops;  ///< Where the building rocks.
};

/// A bearing under a slab, among the details of its element.
struct BearingOnSlab {
  /// Where its axial force acts: 0, at a point of the building; 1, of the ground; between them for others.
  static constexpr double half_way = 0.5, by_surface = -1.0;

  PlanVector at{};                  ///< m
  double static_weight = 0.0;       ///< > 0 N
  double vertical_stiffness = 0.0;  ///< > 0 N/m, of all `count`; 0: every bearing has the same
  bool slides = false;              ///< cannot pull; its axial force acts at its sliding surface
  double acts_at = half_way;        ///< 0 to 1; by_surface: AxialForces::sliding_surface says it
  int count = 1;                    ///< of equal bearings side by side that share the axial force

  friend bool operator==(const BearingOnSlab&, const BearingOnSlab&) = default;
};

}  // namespace moat
