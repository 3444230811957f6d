// Rubber bearings that soften under the axial force on them.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "elements/line/lead_rubber_bearing.hpp"
#include "materials/carrying.hpp"
#include "materials/plan/planar_rubber_under_weight.hpp"
#include "materials/rubber_under_weight.hpp"

namespace moat {

/// A lead-rubber or high-damping bearing whose post-yield stiffness falls under the axial force on it, with its largest
/// displacement so far, D; its strength does not:
///
///     k_2 = k_20 max(0.01, 1 - (N/P_cr(D))^2) for N > 0, else k_20         (RubberUnderWeight, AxialSoftening)
///
///     .isolation = Isolation{Isolator<SofteningRubber>{.name = "left", .law = bearing, .count = 6, .at = -6 * m}, ...}
///     .bearings = grid(4, 3, SofteningRubber{.bearing = LeadRubberBearing{...}, .rubber = RubberBearing{...}})
///
/// Everything is of one bearing; Isolator::count says how many stand side by side. With AxialForces N is that of the
/// instant; without them N is the weight on it, and only D changes. Reports `critical_load` [N], P_cr(D). Where N
/// exceeds it the run goes on with a warning; with AxialForces `bearing_unstable` says how often and when first.
struct SofteningRubber {
  static constexpr std::string_view name = "SofteningRubber";  ///< Reports call it so.
  static constexpr bool is_rubber = true;                      ///< It does not slide, and may pull.

  /// The law without axial force; name and nodes of a LeadRubberBearing do not count.
  std::variant<LeadRubberBearing, BearingDesign, Bilinear> bearing;
  RubberBearing rubber;  ///< Gives P_cr(D). On a line a rectangle moves along its width_x.
  Force weight{};        ///< > 0 N on one bearing; left out: its share of the building.

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const;
  [[nodiscard]] std::vector<Parameter> parameters() const;  ///< As given, without the weight.
  /// Under a weight that changes; `static_weight` > 0 N is that at rest.
  [[nodiscard]] RubberUnderWeight under_changing_weight(Force static_weight) const;
  /// Under a constant weight > 0 N.
  [[nodiscard]] Carrying<RubberUnderWeight> carrying(Force load) const {
    return {under_changing_weight(load), load.si()};
  }
};

/// The law of two components under a weight that changes; `static_weight` > 0 N is that at rest. Throws InputError for
/// a bad parameter.
PlanarRubberUnderWeight in_plan_under_changing_weight(const SofteningRubber& bearing, Force static_weight);

/// Under this weight, N, unless the bearing has a weight of its own.
inline Carrying<PlanarRubberUnderWeight> in_plan(const SofteningRubber& bearing, Force weight) {
  const Force carried = bearing.weight.si() > 0.0 ? bearing.weight : weight;
  return {in_plan_under_changing_weight(bearing, carried), carried.si()};
}

}  // namespace moat
