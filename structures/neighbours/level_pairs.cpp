#include "structures/neighbours/level_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/number_format.hpp"

namespace moat {
namespace {

double height_of(const Model& model, NodeId level) { return level == ground ? 0.0 : model.body(level).height; }

std::vector<double> heights_of(const Model& model, const Check& check, const BuildingLevels& building) {
  std::vector<double> heights;
  for (const NodeId level : building.levels) {
    model.require_node(level, check, "a level of \"" + building.name + "\"");
    heights.push_back(height_of(model, level));
    if (heights.size() == 1) continue;
    const NodeId below = building.levels[heights.size() - 2];
    check.that(heights.back() > heights[heights.size() - 2],
               "heights must rise: \"" + std::string{model.body_name(below)} + "\" at " +
                   to_text(heights[heights.size() - 2]) + " m, \"" + std::string{model.body_name(level)} + "\" at " +
                   to_text(heights.back()) + " m.",
               "Give .height to nodes and diaphragms, storey_height to buildings, and floors from the lowest up.");
  }
  return heights;
}

std::string at_height(double height) { return " at " + to_fixed(height, 2) + " m"; }

// Finds the pairs of two buildings.
class Pairing {
 public:
  Pairing(const Model& model, const Check& check, const BuildingLevels& first, const BuildingLevels& second,
          Length slab)
      : model_{model},
        sides_{{{first, heights_of(model, check, first)}, {second, heights_of(model, check, second)}}},
        slab_{slab.si()} {}

  LevelPairs find() {
    pair_floors();
    for (const bool of_first : {true, false}) pair_with_columns(of_first);
    std::ranges::stable_sort(found_.pairs, {}, &LevelPair::height);
    return std::move(found_);
  }

 private:
  struct Side {
    const BuildingLevels& building;
    std::vector<double> heights;
    std::vector<bool> has_partner = std::vector<bool>(heights.size(), false);

    [[nodiscard]] NodeId level(std::size_t i) const { return building.levels[i]; }
  };

  void pair_floors() {
    constexpr double round_off = 1e-9;  // m
    auto& [first, second] = sides_;
    for (std::size_t i = 0; i < first.heights.size(); ++i)
      for (std::size_t j = 0; j < second.heights.size(); ++j) {
        const double a = first.heights[i], b = second.heights[j];
        if (std::abs(a - b) > slab_ + round_off) continue;
        first.has_partner[i] = second.has_partner[j] = true;
        const NodeId one = first.level(i), other = second.level(j);
        if (one == other) continue;  // the ground of both, or a base that both stand on
        if (one == ground || other == ground)
          note_ground(one == ground ? other : one, one == ground ? first : second);
        else
          found_.pairs.push_back({.floor = i, .other = j, .height = 0.5 * (a + b)});
      }
  }

  void pair_with_columns(bool of_first) {
    const Side &own = sides_[of_first ? 0 : 1], &other = sides_[of_first ? 1 : 0];
    for (std::size_t i = 0; i < own.heights.size(); ++i) {
      if (own.has_partner[i]) continue;
      const double height = own.heights[i];
      const auto above = std::ranges::upper_bound(other.heights, height);
      if (above == other.heights.begin() || above == other.heights.end()) continue;
      const auto upper = static_cast<std::size_t>(above - other.heights.begin());
      if (own.level(i) == ground) {
        note_ground(other.level(upper), own);
        continue;
      }
      const double lower = other.heights[upper - 1];
      found_.pairs.push_back({.of_first = of_first,
                              .floor = i,
                              .other = upper,
                              .share = (height - lower) / (other.heights[upper] - lower),
                              .height = height});
    }
  }

  void note_ground(NodeId level, const Side& fixed) {
    found_.notes.push_back("\"" + std::string{model_.body_name(level)} + "\"" + at_height(height_of(model_, level)) +
                           " faces the foundations of " + fixed.building.title(model_) +
                           ", between which there is no gap. Give a moat where they can touch.");
  }

  const Model& model_;
  std::array<Side, 2> sides_;
  double slab_;  // m
  LevelPairs found_;
};

}  // namespace

std::string BuildingLevels::title(const Model& model) const {
  return "\"" + (name.empty() ? std::string{model.body_name(levels.back())} : name) + "\"";
}

std::string BuildingLevels::storey_name(std::size_t storey) const {
  return (name.empty() ? "" : name + " ") + "storey " + std::to_string(storey);
}

LevelPairs pairs_of_levels(const Model& model, const Check& check, const BuildingLevels& first,
                           const BuildingLevels& second, Length slab) {
  check.not_negative("slab", slab, "Give the thickness of slabs: levels within it meet each other.");
  // A base, or the ground, may be that of both.
  for (std::size_t i = 0; i < first.levels.size(); ++i)
    for (std::size_t j = 0; j < second.levels.size(); ++j)
      check.that(i + j == 0 || first.levels[i] != second.levels[j],
                 first.title(model) + " and " + second.title(model) + " have a common floor.", "Give two buildings.");
  return Pairing{model, check, first, second, slab}.find();
}

std::string no_pair(const Model& model, const BuildingLevels& first, const BuildingLevels& second) {
  return "no floor of " + first.title(model) + " or " + second.title(model) +
         " is at the height of a floor or a column of the other.";
}

MemberPoint point_of_column(const BuildingLevels& building, std::size_t upper, double share) {
  const NodeId above = building.levels[upper];
  if (share == 1.0) return above;
  const NodeId below = building.levels[upper - 1];
  if (below == ground) return {above, ground, 1.0 - share};
  return {below, above, share};
}

}  // namespace moat
