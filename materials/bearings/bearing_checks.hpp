// Demand over capacity of bearings and dampers.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "base/plan_vector.hpp"
#include "materials/bearings/bearing_capacities.hpp"

namespace moat {

/// The motion and the forces of one bearing at one instant.
struct DemandAt {
  PlanVector displacement{};  ///< m, of its upper end against its lower end; y is 0 on a line
  double speed = 0.0;         ///< m/s, >= 0
  double force = 0.0;         ///< N, >= 0, along its deformation
  /// N, negative in tension; NaN where it is not known.
  double compression = std::numeric_limits<double>::quiet_NaN();
  /// N, at rest.
  double static_compression = std::numeric_limits<double>::quiet_NaN();
  double time = 0.0;  ///< s
};

/// One check of one bearing. The texts are literals.
struct BearingDemand {
  std::string_view check;  ///< "displacement", "stability" ...
  std::string_view unit;   ///< SI, of demand and capacity; "1" without dimension
  double demand = 0.0;     ///< NaN where the compression is not known
  /// NaN where it is not judged.
  double capacity = std::numeric_limits<double>::quiet_NaN();
  /// Says where the capacity is from: a code, or "given"; "not judged: no shear_capacity" where there is none.
  std::string_view source;
  double time = 0.0;  ///< s

  [[nodiscard]] double ratio() const { return demand / capacity; }  ///< NaN where it is not judged.
  /// The ratio, or the demand where it is not judged: by which the worst of the same checks is found.
  [[nodiscard]] double size() const { return std::isnan(capacity) ? demand : ratio(); }
};

/// Returns all checks of a bearing at an instant, always the same ones for the same capacities and rules.
///
/// | check | demand | limit by rules |
/// |---|---|---|
/// | displacement, displacement to the stop, stroke | abs(d) | |
/// | shear strain | d/T_r | EN 15129: 2.5 |
/// | shear strain at rest, EN | static_displacement/T_r | EN 1337-3: 1.0 |
/// | strain by compression | g_c, over A_r | AASHTO: 2.5 |
/// | strain by rotation, where given | g_r | |
/// | sum of strains | g_c + g_s + g_s,static + 0.5 g_r | AASHTO: 5.5 |
/// | sum of strains, EN | g_c + g_s + g_s,static + g_r, by formulas of EN 15129 | 7.0 |
/// | sum of strains at rest, AASHTO | g_c + g_s,static + g_r, of N and A at rest | 5.0 |
/// | sum of strains, MCE, AASHTO | g_c + g_s + 0.25 g_s,static | MCEER-11-0004: 9.0 |
/// | stability | N/P_cr(d); EN 15129: N/P_cr at rest | MCEER-11-0004: 1/1.1; ASCE 7-16: 1; EN 15129: 1/2 |
/// | stability, displaced | 0.7 d/a' + 2 N/P_cr for N > P_cr/4, else d/(0.7 a') | EN 15129: 1 |
/// | tension | -N | AASHTO and ASCE: 3 G A, cavitation; EN 15129: 2 G A |
/// | pressure at rest, pressure | N/slider_area | |
/// | speed, pressure times speed, force | abs(v), p abs(v), abs(F) | |
///
/// A given capacity goes before a limit. Limits are recalled, not read, as the formulas (RubberBearing): compare them
/// with the edition that governs your project. K_L and gamma_m of EN 15129 are 1; give strain_capacity for others.
std::vector<BearingDemand> demands(const BearingCapacities& capacities, CheckRules rules, const DemandAt& at);

/// The largest ratios of one bearing over many instants; demands of checks that are not judged. A ratio has the demand
/// and the capacity of its own instant: N and d are simultaneous.
class BearingChecks {
 public:
  /// capacities: checked. rules: as in demands().
  BearingChecks(const BearingCapacities& capacities, CheckRules rules) : capacities_{capacities}, rules_{rules} {}

  /// Takes an instant; the compression of the first one is that at rest.
  void take(DemandAt at);
  /// Behind the first instant: writes or reads the largest ratios. The texts stay.
  void archive(auto& archive) {
    archive(static_compression_);
    for (BearingDemand& each : largest_) archive(each.demand, each.capacity, each.time);
  }
  /// One for every check. Empty before the first instant.
  [[nodiscard]] const std::vector<BearingDemand>& largest() const { return largest_; }

 private:
  BearingCapacities capacities_;
  CheckRules rules_;
  double static_compression_ = 0.0;  // N
  std::vector<BearingDemand> largest_;
};

}  // namespace moat
