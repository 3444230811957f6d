#include "materials/bearings/bearing_checks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace moat {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view guide = "AASHTO Guide Specifications for Seismic Isolation Design", en_15129 = "EN 15129",
                           mceer = "MCEER-11-0004", asce = "ASCE 7-16", given = "given",
                           no_limit = "not judged: no limit in these rules";

// A limit of rules, and its source; without one the reason.
struct Limit {
  double value = none;
  std::string_view source;
};

// The capacity, or else the limit.
template <class Q>
Limit capacity(const std::optional<Q>& capacity, Limit limit) {
  return capacity ? Limit{Quantity{*capacity}.si(), given} : limit;
}

class List {
 public:
  explicit List(double time) : time_{time} {}
  void add(std::string_view check, std::string_view unit, double demand, Limit limit) {
    if (std::isnan(demand)) limit = {none, "not judged: the axial force is not known"};
    demands_.push_back({check, unit, demand, limit.value, limit.source, time_});
  }
  std::vector<BearingDemand> take() { return std::move(demands_); }

 private:
  double time_;
  std::vector<BearingDemand> demands_;
};

void add_strains(const BearingCapacities& bearing, CheckRules rules, const DemandAt& at, List& list) {
  const RubberBearing& rubber = *bearing.rubber;
  const bool en = rules == CheckRules::en, aashto = rules == CheckRules::aashto;
  const StrainFormula formula = en ? StrainFormula::en_15129 : StrainFormula::mceer;
  const Length d_x{at.displacement.x}, d_y{at.displacement.y};
  const auto by_compression = [&](double compression, double overlap) {
    return rubber.strain_by_compression(formula, Force{compression}, overlap);
  };
  const double shear = rubber.strain_by_shear(d_x, d_y),
               static_shear = rubber.strain_by_shear(bearing.static_displacement),
               compressed = by_compression(at.compression, rubber.overlap(d_x, d_y)),
               rotated = rubber.strain_by_rotation(formula, bearing.static_rotation_x, bearing.static_rotation_y);
  list.add("shear strain", "1", shear,
           capacity(bearing.shear_capacity, en ? Limit{2.5, en_15129} : Limit{none, "not judged: no shear_capacity"}));
  if (en) list.add("shear strain at rest", "1", static_shear, {1.0, "EN 1337-3"});
  list.add("strain by compression", "1", compressed, aashto ? Limit{2.5, guide} : Limit{none, no_limit});
  if (rotated > 0.0) list.add("strain by rotation", "1", rotated, {none, no_limit});
  const Limit of_sum = en       ? Limit{7.0, en_15129}
                       : aashto ? Limit{5.5, guide}
                                : Limit{none, "not judged: no strain_capacity"};
  list.add("sum of strains", "1", compressed + shear + static_shear + (en ? 1.0 : 0.5) * rotated,
           capacity(bearing.strain_capacity, of_sum));
  if (!aashto) return;
  list.add("sum of strains at rest", "1", by_compression(at.static_compression, 1.0) + static_shear + rotated,
           {5.0, guide});
  list.add("sum of strains, MCE", "1", compressed + shear + 0.25 * static_shear, {9.0, mceer});
}

void add_stability(const BearingCapacities& bearing, CheckRules rules, const DemandAt& at, List& list) {
  const RubberBearing& rubber = *bearing.rubber;
  if (rules == CheckRules::en) {
    const double share = at.compression / rubber.buckling_load_en_15129().si(),
                 moved = length(at.displacement) / rubber.smallest_width().si();
    list.add("stability", "1", share, {0.5, en_15129});
    list.add("stability, displaced", "1", share > 0.25 ? 0.7 * moved + 2.0 * share : moved / 0.7, {1.0, en_15129});
  } else {
    const Force critical = rubber.critical_load(Length{at.displacement.x}, Length{at.displacement.y});
    list.add("stability", "1", at.compression / critical.si(),
             rules == CheckRules::aashto ? Limit{1.0 / 1.1, mceer}
             : rules == CheckRules::asce ? Limit{1.0, asce}
                                         : Limit{none, no_limit});
  }
}

Limit limit_of_tension(const BearingCapacities& bearing, CheckRules rules) {
  if (!bearing.rubber || rules == CheckRules::none) return {none, "not judged: no tension_capacity"};
  const double shear_force = (bearing.rubber->shear_modulus.value() * bearing.rubber->area()).si();
  return rules == CheckRules::en ? Limit{2.0 * shear_force, en_15129} : Limit{3.0 * shear_force, "cavitation at 3 G A"};
}

}  // namespace

std::vector<BearingDemand> demands(const BearingCapacities& bearing, CheckRules rules, const DemandAt& at) {
  List list{at.time};
  const double moved = length(at.displacement);
  if (bearing.stroke)
    list.add("stroke", "m", moved, capacity(bearing.stroke, {}));
  else
    list.add("displacement", "m", moved,
             capacity(bearing.displacement_capacity, {none, "not judged: no displacement_capacity"}));
  if (bearing.stop) list.add("displacement to the stop", "m", moved, capacity(bearing.stop, {}));
  if (bearing.rubber) {
    add_strains(bearing, rules, at, list);
    add_stability(bearing, rules, at, list);
  }
  if (bearing.rubber || bearing.tension_capacity)
    list.add("tension", "N", std::max(0.0 - at.compression, 0.0),
             capacity(bearing.tension_capacity, limit_of_tension(bearing, rules)));
  if (bearing.slider_area) {
    const double area = bearing.slider_area->si(), pressure = at.compression / area;
    const Limit limit = capacity(bearing.pressure_capacity, {none, "not judged: no pressure_capacity"});
    list.add("pressure at rest", "Pa", at.static_compression / area, limit);
    list.add("pressure", "Pa", pressure, limit);
    list.add("pressure times speed", "W/m^2", std::max(pressure, 0.0) * at.speed,
             capacity(bearing.pressure_speed_capacity, {none, "not judged: no pressure_speed_capacity"}));
  }
  if (bearing.slider_area || bearing.stroke || bearing.speed_capacity)
    list.add("speed", "m/s", at.speed, capacity(bearing.speed_capacity, {none, "not judged: no speed_capacity"}));
  if (bearing.stroke || bearing.force_capacity)
    list.add("force", "N", at.force, capacity(bearing.force_capacity, {none, "not judged: no force_capacity"}));
  return list.take();
}

void BearingChecks::take(DemandAt at) {
  if (largest_.empty()) static_compression_ = at.compression;
  at.static_compression = static_compression_;
  const std::vector<BearingDemand> now = demands(capacities_, rules_, at);
  if (largest_.empty()) {
    largest_ = now;
    return;
  }
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i].size() > largest_[i].size()) largest_[i] = now[i];
}

}  // namespace moat
