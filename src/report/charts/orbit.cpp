#include "report/charts/orbit.hpp"

#include <algorithm>

#include "report/charts/chart_columns.hpp"

namespace moat {

PlanVector Orbit::displacement_at(double time, PlanVector arm) const {
  const auto& times = time_.values;
  const auto after = static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
  if (after == 0) return displacement(0, arm);
  if (after >= times.size()) return displacement(times.size() - 1, arm);
  const double span = times[after] - times[after - 1], share = span > 0.0 ? (time - times[after - 1]) / span : 0.0;
  return (1.0 - share) * displacement(after - 1, arm) + share * displacement(after, arm);
}

std::optional<Orbit> orbit_of(const DiaphragmFacts& diaphragm, const Table& histories) {
  const std::vector<const Column*> times = columns_of(histories, "time");
  const Column* const x = column_of(columns_of(histories, "displacement_x"), diaphragm.name);
  const Column* const y = column_of(columns_of(histories, "displacement_y"), diaphragm.name);
  const Column* const rotation = column_of(columns_of(histories, "rotation"), diaphragm.name);
  if (times.empty() || x == nullptr || y == nullptr || rotation == nullptr) return std::nullopt;
  return Orbit{*times.front(), *x, *y, *rotation};
}

}  // namespace moat
