#include "structures/files/storey_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/check.hpp"
#include "structures/files/input_table.hpp"

namespace moat {
namespace {

// Finds the height of the storey under a floor, which stands on row `below`, or on the ground at 0.
Length height_of(const InputTable& table, std::size_t row, std::optional<std::size_t> below) {
  if (!table.has("elevation")) return table.positive<Length>(row, "height");
  const Length height = table.at<Length>(row, "elevation") - (below ? table.at<Length>(*below, "elevation") : Length{});
  if (!(height.si() > 0.0)) table.refuse(row, "elevation must be above the row below, or above 0 m.");
  constexpr double agree = 1e-3;  // m
  if (table.text(row, "height").empty()) return height;
  if (const Length given = table.at<Length>(row, "height"); std::abs((given - height).si()) > agree)
    table.refuse(
        row, "height is " + to_text(given.si()) + " m, but the elevations differ by " + to_text(height.si()) + " m.");
  return height;
}

StoreyRow floor_of(const InputTable& table, std::size_t row, const Outlines& outlines) {
  StoreyRow floor{.name = table.word(row, "name"), .mass = table.positive<Mass>(row, "mass")};
  if (table.has("inertia")) floor.rotary_inertia = table.positive<RotaryInertia>(row, "inertia");
  if (table.has("x_mass") || table.has("y_mass"))
    floor.centre_of_mass = {table.at<Length>(row, "x_mass"), table.at<Length>(row, "y_mass")};
  if (const std::string name = table.text(row, "outline"); !name.empty()) {
    const auto outline = outlines.find(name);
    if (outline == outlines.end())
      table.refuse(row,
                   "there is no outline " + quoted(name) +
                       (outlines.empty() ? ". Give them: read_storeys(file, read_outlines(\"outlines.csv\"))." : "."));
    floor.outline = outline->second;
  }
  return floor;
}

void put_storey(const InputTable& table, std::size_t row, StoreyRow& floor) {
  if (table.has("kx")) floor.stiffness_x = table.positive<Stiffness>(row, "kx");
  if (table.has("ky")) floor.stiffness_y = table.positive<Stiffness>(row, "ky");
  if (!table.has("k_rotation")) return;
  floor.rotational_stiffness = table.positive<Energy>(row, "k_rotation");
  floor.centre_of_rigidity = {table.at<Length>(row, "x_rigidity"), table.at<Length>(row, "y_rigidity")};
}

}  // namespace

Outlines read_outlines(const std::filesystem::path& file) {
  const InputTable table{read_text_file(file), {"name", "x [m]", "y [m]"}};
  Outlines outlines;
  for (std::size_t row = 0; row < table.size(); ++row)
    outlines[table.word(row, "name")].corners.push_back({table.at<Length>(row, "x"), table.at<Length>(row, "y")});
  for (const auto& [name, outline] : outlines) outline.check(Check{"read_outlines", file.native()}, name);
  return outlines;
}

StoreyTable read_storeys(const std::filesystem::path& file, const Outlines& outlines) {
  const InputTable table{read_text_file(file),
                         {"name", "mass [t]"},
                         {"height [m]", "elevation [m]", "inertia [t m2]", "x_mass [m]", "y_mass [m]", "x_rigidity [m]",
                          "y_rigidity [m]", "kx [kN/m]", "ky [kN/m]", "k_rotation [kN m]", "outline"}};
  table.require_unique("name");
  StoreyTable storeys{.source = table.source(), .notes = table.notes()};
  std::vector<std::size_t> rows(table.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (table.has("elevation"))
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return table.at<Length>(row, "elevation"); });
  const auto is = [&](std::size_t row, const char* name) { return upper_case(table.word(row, "name")) == name; };
  const auto has_no_storey = [&](std::size_t row) { return is(row, "BASE") || is(row, "GROUND"); };
  for (const std::size_t row : rows)
    if (row != rows.front() && has_no_storey(row))
      table.refuse(row, table.word(row, "name") + " must be the lowest row.");
  std::optional<std::size_t> below;
  for (const std::size_t row : rows) {
    if (has_no_storey(row)) {
      for (const char* column : {"height", "kx", "ky", "k_rotation", "x_rigidity", "y_rigidity"})
        if (!table.text(row, column).empty())
          table.refuse(row, table.word(row, "name") + " has no storey below it; leave " + column + " empty.");
      if (is(row, "BASE"))
        storeys.base = floor_of(table, row, outlines);
      else if (!table.text(row, "mass").empty())
        table.refuse(row, "the ground has no mass. Call the row base.");
    } else {
      storeys.floors.push_back(floor_of(table, row, outlines));
      const std::size_t place = storeys.floors.size();
      const std::string name = upper_case(storeys.floors.back().name);
      if (name.starts_with("FLOOR ") && is_number(name.substr(6)) &&
          parse_number(name.substr(6)).value != static_cast<double>(place))
        table.refuse(row, table.word(row, "name") + " is the floor in place " + std::to_string(place) +
                              " from below. Rows stand from the lowest up unless there is an elevation; floor 1 is the "
                              "first above base or ground.");
      storeys.floors.back().height = height_of(table, row, below);
      put_storey(table, row, storeys.floors.back());
    }
    below = row;
  }
  if (storeys.floors.empty()) refuse_file(file, "there is no floor in it.");
  return storeys;
}

StoreyTable with_eccentricity(StoreyTable storeys, double share_of_x, double share_of_y) {
  const Check check{"with_eccentricity", storeys.source};
  check.between("share_of_x", share_of_x, -0.5, 0.5, "1", "5 % is 0.05.");
  check.between("share_of_y", share_of_y, -0.5, 0.5, "1", "5 % is 0.05.");
  if (share_of_x == 0.0 && share_of_y == 0.0) return storeys;
  const auto move = [&](StoreyRow& row) {
    check.that(!row.outline.empty(), row.name + " has no outline.", "Give one: the eccentricity is a share of it.");
    const auto extent = [&](Length PlanPosition::*along) {
      const auto [low, high] = std::ranges::minmax(row.outline.corners, {}, along);
      return high.*along - low.*along;
    };
    row.centre_of_mass.x += share_of_x * extent(&PlanPosition::x);
    row.centre_of_mass.y += share_of_y * extent(&PlanPosition::y);
  };
  if (storeys.base) move(*storeys.base);
  std::ranges::for_each(storeys.floors, move);
  return storeys;
}

}  // namespace moat
