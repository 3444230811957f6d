// Lead-rubber bearings under a building.
#pragma once

#include <string_view>
#include <vector>

#include "materials/bilinear.hpp"
#include "model/model.hpp"

namespace moat {

/// Lead-rubber bearings as a designer specifies them. A building knows the weight on them; in plan every bearing gets
/// its share of it, so that the numbers are those of the building:
///
///     .isolation = BearingDesign{.strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 15 * mm}
///     .bearings = grid(4, 3, BearingDesign{...})
struct BearingDesign {
  static constexpr std::string_view name = "BearingDesign";  ///< Reports call it so.

  /// W > 0 N: of everything the bearings carry; that of the building if left out.
  Force weight{};
  /// Q_d > 0 N: the force at zero displacement after yielding, of the lead cores.
  Force characteristic_strength{};
  /// 0 < Q_d/W < 1, in place of characteristic_strength; 6 % is 0.06.
  double strength_ratio = 0.0;
  /// T > 0 s: of the rigid building on the post-yield stiffness.
  Required<Time> isolation_period;
  /// d_y > 0 m.
  Required<Length> yield_displacement;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const;
  [[nodiscard]] std::vector<Parameter> parameters() const;  ///< As given, without the weight.
  /// post_yield_stiffness = W/g (2 pi / T)^2 and yield_force = Q_d + post_yield_stiffness d_y. load: W > 0 N.
  [[nodiscard]] Bilinear carrying(Force load) const;
};

/// The lead-rubber bearings (LRB) of a building taken together: bilinear hysteresis with kinematic
/// hardening (materials/bilinear.hpp). Yields and unloadings are located.
///
///      [ base ] -> u          F_y at d_y, then post_yield_stiffness;
///     ====LRB====             initial stiffness F_y / d_y
///     ////ground////
///
/// Reports `isolator_force` [N] and `isolator_deformation` [m] under its name, positive to the right.
struct LeadRubberBearing {
  std::string name = "bearings";  ///< Unique in its model.
  NodeId lower = ground;          ///< The node below, or `ground`.
  /// The node above. A ShearBuilding sets it; give it when you add a bearing yourself.
  NodeId upper{};
  /// F_y > 0 N.
  Required<Force> yield_force;
  /// d_y > 0 m.
  Required<Length> yield_displacement;
  /// 0 <= post_yield_stiffness < F_y / d_y, N/m.
  Required<Stiffness> post_yield_stiffness;

  /// Bearings of a design with its weight. Throws InputError for a value that is not positive.
  static LeadRubberBearing from_design(const BearingDesign& design);
};

/// Throws InputError for a bad parameter, unknown, missing or equal nodes, or a name that is taken.
void add(Model& model, const LeadRubberBearing& bearing);

}  // namespace moat
