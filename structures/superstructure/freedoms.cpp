#include "structures/superstructure/freedoms.hpp"

#include <algorithm>
#include <array>

namespace moat {
namespace {

constexpr std::array directions{std::pair{FloorDirection::x, "x"}, std::pair{FloorDirection::y, "y"},
                                std::pair{FloorDirection::rotation, "rotation"}};

int position_of(const Check& check, const std::vector<Freedom>& given, const Freedom& wanted) {
  const auto found = std::ranges::find(given, wanted);
  check.that(
      found != given.end(), "the matrix has no " + wanted.name() + ".",
      "Give every floor from the lowest up, in plan x, y and rotation of each; rows of all slabs of a base, or none.");
  return static_cast<int>(found - given.begin());
}

}  // namespace

std::string Freedom::name() const {
  const std::string place = floor > 0  ? "floor " + std::to_string(floor)
                            : slab > 1 ? "slab " + std::to_string(slab)
                                       : "base";
  return place + " " + directions[static_cast<std::size_t>(direction)].second;
}

FreedomOrder FreedomOrder::with_base() const {
  FreedomOrder order = *this;
  order.with_base_ = true;
  return order;
}

std::vector<Freedom> FreedomOrder::list(const Check& check, std::string_view field, int size, int floors) const {
  const std::string has = std::string{field} + " has " + std::to_string(size) + " rows";
  if (!rows_.empty()) {
    check.that(static_cast<int>(rows_.size()) == size,
               "freedoms lists " + std::to_string(rows_.size()) + " entries; " + has + ".",
               "Give a floor and a direction for each row.");
    return rows_;
  }
  const int per_floor = of_floor_ == Freedoms::x ? 1 : 3;
  check.that(size > 0 && size % per_floor == 0, has + "; x_y_rotation needs a multiple of 3.",
             "Give .freedoms as the matrix has them: per_floor(Freedoms::x), or a list.");
  const int levels = size / per_floor, lowest = with_base_ && levels != floors ? 0 : 1;
  std::vector<Freedom> list;
  for (int level = 0; level < levels; ++level)
    for (int k = 0; k < per_floor; ++k)
      list.push_back({lowest + (order_ == FloorOrder::bottom_up ? level : levels - 1 - level),
                      directions[static_cast<std::size_t>(k)].first});
  return list;
}

std::vector<Freedom> freedoms_named(const Check& check, const std::vector<std::string>& names) {
  std::vector<Freedom> list;
  for (const std::string& name : names) {
    Freedom freedom{-1};
    for (int number = 0; number <= static_cast<int>(names.size()); ++number)
      for (const auto& [direction, word] : directions)
        for (const Freedom& each : {Freedom{number, direction}, Freedom{0, direction, std::max(number, 1)}})
          if (each.name() == name) freedom = each;
    check.that(freedom.floor >= 0, "the row \"" + name + "\" is no freedom of a floor.",
               "Name rows \"floor 1 x\", \"floor 1 y\", \"floor 1 rotation\", \"base x\"; or leave the names out.");
    list.push_back(freedom);
  }
  return list;
}

std::vector<int> positions_of(const Check& check, const std::vector<Freedom>& given, int floors, bool in_plan) {
  for (const Freedom& freedom : given) {
    check.that(std::ranges::count(given, freedom) == 1, "the freedom " + freedom.name() + " is given twice.",
               "Every row of the matrix has its own.");
    check.that(freedom.floor >= 0 && freedom.floor <= floors,
               "floors has " + std::to_string(floors) + (floors == 1 ? " entry" : " entries") + ", the matrix has " +
                   freedom.name() + ".",
               "Give one of .floors for each floor, from the lowest up.");
  }
  std::vector<int> positions;
  for (int floor = 1; floor <= floors; ++floor)
    for (int k = 0; k < (in_plan ? 3 : 1); ++k)
      positions.push_back(position_of(check, given, {floor, directions[static_cast<std::size_t>(k)].first}));
  return positions;
}

std::vector<int> positions_of_base(const Check& check, const std::vector<Freedom>& given, int slabs, bool in_plan) {
  std::vector<int> positions;
  for (int slab = 1; slab <= slabs; ++slab)
    for (int k = 0; k < (in_plan ? 3 : 1); ++k)
      positions.push_back(position_of(check, given, {0, directions[static_cast<std::size_t>(k)].first, slab}));
  return positions;
}

}  // namespace moat
