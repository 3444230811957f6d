#include "analyses/modes/torsion.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/check.hpp"

namespace moat {
namespace {

struct Bearings {
  std::vector<PlanPosition> positions;
  PlanVector centre;  // of their stiffness, m
};

Bearings bearings_under(const Model& model, DiaphragmId base) {
  Bearings bearings;
  double sum = 0.0;
  for (const auto& block : model.blocks()) {
    for (std::size_t e = 0; e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      if (!info.acts_in_two_directions() || !info.isolates || info.second != base.x) continue;
      const PlanVector at = info.plan_places()->second;
      const double stiffness = block->linear_stiffness(e, StiffnessStage::post_yield);
      bearings.positions.push_back({Length{at.x}, Length{at.y}});
      bearings.centre += stiffness * at;
      sum += stiffness;
    }
  }
  if (sum > 0.0) bearings.centre = bearings.centre / sum;
  return bearings;
}

PlanVector centre_of_mass(const Model& model, const Building& building) {
  PlanVector moment;
  double mass = 0.0;
  for (const NodeId node : carried_nodes(model, building)) {
    const PlacedDiaphragm* floor = model.diaphragm_of(node);
    if (floor == nullptr) continue;
    moment += floor->mass * floor->centre_of_mass;
    mass += floor->mass;
  }
  return moment / mass;
}

double peak_of(const std::vector<Peak>& peaks, std::string_view quantity, std::string_view where) {
  const auto found =
      std::ranges::find_if(peaks, [&](const Peak& peak) { return peak.quantity == quantity && peak.where == where; });
  return found == peaks.end() ? 0.0 : found->magnitude();
}

// The extent of an outline, and its largest distance from a point, along an axis.
struct Extent {
  double side, farthest;
};
Extent extent_of(const PlanOutline& outline, double from, double PlanVector::*axis) {
  double low = outline.corner(0).*axis, high = low;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    low = std::min(low, outline.corner(i).*axis);
    high = std::max(high, outline.corner(i).*axis);
  }
  return {high - low, std::max(high - from, from - low)};
}

}  // namespace

TorsionalAmplification torsional_amplification(Length y, Length eccentricity, Length b, Length d, double period_ratio) {
  const Check check{"torsional_amplification", ""};
  check.positive("y", y);
  check.not_negative("eccentricity", eccentricity);
  check.positive("b", b);
  check.positive("d", d);
  check.that(period_ratio >= 1.0, "period_ratio", period_ratio, "1", ">= 1");
  constexpr double least = 1.15;
  const double formula =
      1.0 + y.si() / (period_ratio * period_ratio) * 12.0 * eccentricity.si() / (b.si() * b.si() + d.si() * d.si());
  return {formula, std::max(formula, least)};
}

double torsional_period_ratio(const std::vector<PlanPosition>& bearings, Length gyration) {
  const Check check{"torsional_period_ratio", ""};
  check.that(!bearings.empty(), "no bearings are given.");
  check.positive("gyration", gyration);
  double sum = 0.0;
  for (const PlanPosition& at : bearings) sum += dot(at.si(), at.si());
  return std::max(std::sqrt(sum / static_cast<double>(bearings.size())) / gyration.si(), 1.0);
}

std::vector<BuildingTorsion> torsion_of(const Model& model, const std::vector<Peak>& peaks) {
  std::vector<BuildingTorsion> list;
  for (const Building& building : model.buildings()) {
    const PlacedDiaphragm* base = model.diaphragm_of(building.base);
    if (base == nullptr || base->outline.empty() || building.shares_base || !building.slabs.empty()) continue;
    const Bearings bearings = bearings_under(model, base->id);
    if (bearings.positions.empty()) continue;
    const PlanVector shift = centre_of_mass(model, building) - bearings.centre;
    const Extent x = extent_of(base->outline, bearings.centre.x, &PlanVector::x),
                 y = extent_of(base->outline, bearings.centre.y, &PlanVector::y);
    BuildingTorsion torsion{.where = base->name,
                            .corner = peak_of(peaks, "corner_displacement", base->name),
                            .centre = peak_of(peaks, "displacement", base->name),
                            .eccentricity = length(shift)};
    std::vector<PlanPosition> arms;
    for (const PlanPosition& at : bearings.positions)
      arms.push_back({at.x - Length{bearings.centre.x}, at.y - Length{bearings.centre.y}});
    torsion.period_ratio = torsional_period_ratio(arms, Length{std::sqrt((x.side * x.side + y.side * y.side) / 12.0)});
    // A motion along y turns the building about an eccentricity along x, and the other way round.
    for (const auto& [extent, eccentricity] : {std::pair{x, shift.x}, std::pair{y, shift.y}}) {
      const TorsionalAmplification amplification =
          torsional_amplification(Length{extent.farthest}, Length{std::abs(eccentricity)}, Length{x.side},
                                  Length{y.side}, torsion.period_ratio);
      torsion.of_formula = std::max(torsion.of_formula, amplification.of_formula);
      torsion.of_code = std::max(torsion.of_code, amplification.of_code);
    }
    list.push_back(std::move(torsion));
  }
  return list;
}

}  // namespace moat
