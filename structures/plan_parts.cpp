#include "structures/plan_parts.hpp"

#include <algorithm>

namespace moat {

std::vector<PlanPosition> grid_points(const Check& check, const std::string& field, int along_x, int along_y,
                                      const PlanOutline& outline) {
  check.that(along_x >= 1 && along_y >= 1,
             field + ": a grid of " + std::to_string(along_x) + " by " + std::to_string(along_y) + " points.",
             "Give at least 1 in each direction.");
  PlanPosition low = outline.corners.front(), high = low;
  for (const PlanPosition& corner : outline.corners) {
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  const auto between = [](Length from, Length to, int i, int count) {
    return count == 1 ? 0.5 * (from + to) : from + static_cast<double>(i) / (count - 1) * (to - from);
  };
  std::vector<PlanPosition> points;
  for (int j = 0; j < along_y; ++j)
    for (int i = 0; i < along_x; ++i)
      points.push_back({between(low.x, high.x, i, along_x), between(low.y, high.y, j, along_y)});
  return points;
}

std::vector<ColumnLine> PlanColumns::lines(const Check& check, const PlanOutline& outline) const {
  if (!is_grid_) return lines_;
  std::vector<ColumnLine> lines;
  for (const PlanPosition& at : grid_points(check, "columns", grid_.along_x, grid_.along_y, outline))
    lines.push_back({at, grid_.item});
  return lines;
}

PlanBearings::PlanBearings(std::vector<Placed> list) : list_{std::move(list)} {}
PlanBearings::PlanBearings(std::initializer_list<Placed> list) : list_{list} {}
PlanBearings::PlanBearings(const PlanBearings& other) = default;
PlanBearings::PlanBearings(PlanBearings&& other) noexcept = default;
PlanBearings& PlanBearings::operator=(const PlanBearings& other) = default;
PlanBearings& PlanBearings::operator=(PlanBearings&& other) noexcept = default;
PlanBearings::~PlanBearings() = default;

std::vector<PlanBearings::Placed> PlanBearings::placed(const Check& check, const PlanOutline& outline) const {
  if (along_x_ == 0 && along_y_ == 0) return list_;
  std::vector<Placed> bearings;
  for (const PlanPosition& at : grid_points(check, "bearings", along_x_, along_y_, outline))
    bearings.push_back(list_.front().moved_to(at));
  return bearings;
}

}  // namespace moat
