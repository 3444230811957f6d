#include "output/files/building_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <set>

#include "base/text/number_format.hpp"
#include "base/text/utf8_text.hpp"
#include "output/files/engineering_unit.hpp"
#include "output/peaks/peak_groups.hpp"

namespace moat {
namespace {

bool is_of(const BuildingParts& building, const GapClearance& gap) {
  return std::ranges::find(building.gaps, gap.where, &GapOfBuilding::name) != building.gaps.end();
}

// An error that does not reach the last digit of the value is left to the tables of peaks.
std::string with_error(const PeakRow& row, const std::string& unit) {
  const std::size_t point = row.value.find('.');
  const double last_digit =
      point == std::string::npos
          ? 1.0
          : std::pow(10.0, static_cast<double>(point + 1) - static_cast<double>(row.value.size()));
  const bool is_visible = !row.error.empty() && std::stod(row.error) >= 0.5 * last_digit;
  return row.value + (is_visible ? " +- " + row.error : "") + " " + unit;
}

// The sides on which gaps of the building closed: "left and right".
std::string closed_sides(const CaseResult& result, const BuildingParts& building) {
  std::set<std::string> sides;
  for (const GapOfBuilding& gap : building.gaps)
    if (std::ranges::find(result.impacts, gap.name, &Impact::where) != result.impacts.end()) sides.insert(gap.side);
  constexpr std::size_t most = 2;
  if (sides.size() > most) return std::to_string(sides.size()) + " places";
  std::string text;
  for (const std::string& side : sides) text += (text.empty() ? "" : " and ") + side;
  return text;
}

BuildingCell gap_cell(const CaseResult& result, const BuildingParts& building) {
  const auto touches = std::ranges::count_if(result.impacts, [&](const Impact& impact) {
    return std::ranges::find(building.gaps, impact.where, &GapOfBuilding::name) != building.gaps.end();
  });
  if (building.gaps.empty()) return {};
  if (touches == 0) return {.value = "open"};
  return {.value = "closed, " + closed_sides(result, building),
          .more = std::to_string(touches) + (touches == 1 ? " impact" : " impacts")};
}

// The largest displacement of the wall at a gap, m; 0 where it is rigid.
double motion_of_wall(const CaseResult& result, const BuildingParts& building, const std::string& gap) {
  const auto found = std::ranges::find(building.gaps, gap, &GapOfBuilding::name);
  for (const Peak& peak : result.peaks)
    if (found != building.gaps.end() && peak.quantity == "displacement" && peak.where == found->wall)
      return peak.magnitude();
  return 0.0;
}

BuildingCell margin_cell(const CaseResult& result, const BuildingParts& building) {
  const GapClearance* least = nullptr;
  for (const GapClearance& gap : result.clearances)
    if (is_of(building, gap) && (least == nullptr || gap.left < least->left)) least = &gap;
  if (least == nullptr) return {};
  const PeakRow row = clearance_group({*least}).rows.front();
  std::string more = least->clearance > 0.0 ? to_significant(100.0 * least->left / least->clearance, 3) + " %" : "";
  // A gap that closed on a wall that gives way says little about the gap that is needed.
  constexpr double seen = 1e-3;  // m
  if (const double motion = motion_of_wall(result, building, least->where); least->left < 0.0 && motion > seen)
    more = "and the wall " + to_significant(100.0 * motion, 3) + " cm";
  return {.value = with_error(row, engineering_unit("m").symbol),
          .more = std::move(more),
          .where = least->where + " at " + row.time + " s"};
}

// The largest peak of the first of these quantities that the building has.
BuildingCell peak_cell(const CaseResult& result, const BuildingParts& building,
                       std::initializer_list<const char*> quantities) {
  const Peak* largest = nullptr;
  for (const char* quantity : quantities) {
    for (const Peak& peak : result.peaks)
      if (peak.quantity == quantity && building.places.contains(peak.where) &&
          (largest == nullptr || peak.magnitude() > largest->magnitude()))
        largest = &peak;
    if (largest != nullptr) break;
  }
  if (largest == nullptr) return {};
  Peak positive = *largest;
  positive.value = largest->magnitude();
  const PeakGroup group = group_peaks({positive}).front();
  const PeakRow& row = group.rows.front();
  const std::string value = with_error(row, group.unit);
  // Behind it a peak may have a mark.
  const std::string side = row.side.substr(0, std::min(row.side.find(", rocked"), row.side.size()));
  const bool is_element = !side.empty() && side != "left" && side != "right" && side != "rocked";
  return {.value = row.second.empty() ? value : row.second + " " + group.second_unit,
          .more = row.second.empty() ? "" : value,
          .where = (is_element ? side : row.where) + " at " + row.time + " s",
          .unsettled = std::ranges::any_of(result.error_bars.unsettled_peaks, [&](const Peak& each) {
            // The companion knows no ratios, but the drifts behind them.
            return each.where == largest->where && each.time == largest->time;
          })};
}

}  // namespace

BuildingTable building_table(const CaseResult& result) {
  constexpr std::size_t most_buildings = 20;
  const bool in_plan = !result.model.diaphragms.empty();
  BuildingTable table{{"gap", "margin", "isolators", "drift", "acceleration"}, {}};
  for (const BuildingParts& building : result.buildings) {
    if (table.rows.size() == most_buildings) break;
    if (building.is_body_beside_buildings) continue;
    const auto peak = [&](std::initializer_list<const char*> quantities) {
      return peak_cell(result, building, quantities);
    };
    table.rows.push_back(
        {building.name.empty() ? "building" : building.name,
         {gap_cell(result, building), margin_cell(result, building), peak({"isolator_deformation"}),
          in_plan ? peak({"corner_drift_ratio", "corner_drift"}) : peak({"drift_ratio", "drift"}),
          in_plan ? peak({"corner_acceleration", "absolute_acceleration"}) : peak({"absolute_acceleration"})}});
  }
  for (std::size_t i = table.headings.size(); i-- > 0;) {
    const auto is_empty = [i](const BuildingTable::Row& row) { return row.cells[i].value.empty(); };
    if (!std::ranges::all_of(table.rows, is_empty)) continue;
    const auto column = static_cast<std::ptrdiff_t>(i);
    table.headings.erase(table.headings.begin() + column);
    for (BuildingTable::Row& row : table.rows) row.cells.erase(row.cells.begin() + column);
  }
  return table;
}

std::string text_of(const BuildingTable& table) {
  if (table.headings.empty()) return "";
  std::vector<std::vector<std::string>> lines{{""}};
  lines.front().insert(lines.front().end(), table.headings.begin(), table.headings.end());
  for (const BuildingTable::Row& row : table.rows) {
    std::vector<std::string> values{row.name}, more{""}, places{""};
    for (const BuildingCell& cell : row.cells) {
      values.push_back(cell.value.empty() ? "-" : cell.value);
      more.push_back(cell.more);
      places.push_back(cell.where);
    }
    lines.insert(lines.end(), {values, more, places});
  }
  std::string text = in_columns(lines);
  if (text.find("+-") != std::string::npos) text += "  +- numerical error\n";
  return text;
}

}  // namespace moat
