#include "structures/plan_parts.hpp"

#include <algorithm>

#include "structures/static_weights.hpp"

namespace moat {
namespace {

// The points of a grid over an outline, row by row. Throws InputError, naming `field`, for counts below 1.
std::vector<PlanPosition> grid_points(const Check& check, const std::string& field, int along_x, int along_y,
                                      const PlanOutline& outline) {
  check.that(along_x >= 1 && along_y >= 1,
             field + ": a grid of " + std::to_string(along_x) + " by " + std::to_string(along_y) + " points.",
             "Give at least 1 in each direction.");
  const auto [west, east] = std::ranges::minmax(outline.corners, {}, &PlanPosition::x);
  const auto [south, north] = std::ranges::minmax(outline.corners, {}, &PlanPosition::y);
  const auto between = [](Length from, Length to, int i, int count) {
    return count == 1 ? 0.5 * (from + to) : from + static_cast<double>(i) / (count - 1) * (to - from);
  };
  std::vector<PlanPosition> points;
  for (int j = 0; j < along_y; ++j)
    for (int i = 0; i < along_x; ++i)
      points.push_back({between(west.x, east.x, i, along_x), between(south.y, north.y, j, along_y)});
  return points;
}

}  // namespace

std::vector<ColumnLine> PlanColumns::lines(const Check& check, const PlanOutline& outline) const {
  if (const auto* lines = std::get_if<std::vector<ColumnLine>>(&form_)) return *lines;
  const auto& grid = std::get<Grid<StoreyColumn>>(form_);
  std::vector<ColumnLine> lines;
  for (const PlanPosition& at : grid_points(check, "columns", grid.along_x, grid.along_y, outline))
    lines.push_back({at, grid.item});
  return lines;
}

std::vector<PlanBearings::Placed> PlanBearings::placed(const Check& check, const PlanOutline& outline) const {
  if (along_x_ == 0 && along_y_ == 0) return list_;
  std::vector<Placed> bearings;
  for (const PlanPosition& at : grid_points(check, "bearings", along_x_, along_y_, outline)) {
    bearings.push_back(list_.front());
    bearings.back().at = at;
  }
  return bearings;
}

void PlanBearings::add_under(Model& model, const Check& check, const std::string& prefix, DiaphragmId floor,
                             const PlanOutline& outline, Force weight_of_building,
                             const std::optional<AxialForces>& axial_forces, PlanVector centre_of_mass) const {
  const std::vector<Placed> bearings = placed(check, outline);
  std::vector<Force> weights;
  if (axial_forces) {
    std::vector<BearingPlace> places;
    for (const Placed& bearing : bearings)
      places.push_back({bearing.at.si(), bearing.weight, bearing.vertical_stiffness});
    weights = static_weights(check, *axial_forces, places, weight_of_building, centre_of_mass, true);
  }
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const Placed& bearing = bearings[i];
    const std::string numbered = "bearing " + std::to_string(i + 1);
    const std::string& name = bearing.name.empty() ? numbered : bearing.name;
    check.not_negative("weight of " + name, bearing.weight);
    std::optional<BearingOnSlab> on_slab;
    if (axial_forces)
      on_slab = BearingOnSlab{.at = bearing.at.si(), .vertical_stiffness = bearing.vertical_stiffness.si()};
    const Force weight = axial_forces                ? weights[i]
                         : bearing.weight.si() > 0.0 ? bearing.weight
                                                     : weight_of_building / static_cast<double>(bearings.size());
    bearing.add_to(model, {prefix + name, prefix + (bearing.type.empty() ? "bearings" : bearing.type)}, floor,
                   bearing.at, weight, on_slab);
  }
}

}  // namespace moat
