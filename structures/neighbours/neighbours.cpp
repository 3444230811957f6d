#include "structures/neighbours/neighbours.hpp"

#include <algorithm>

#include "base/text/number_format.hpp"

namespace moat {

Length Clearance::at(const Check& check, double height) const {
  for (std::size_t i = 1; i < list_.size(); ++i)
    check.that(list_[i].height > list_[i - 1].height,
               "clearance: heights must rise: " + to_text(list_[i - 1].height.si()) + " m, " +
                   to_text(list_[i].height.si()) + " m.",
               "Give the list from the lowest up.");
  if (list_.size() == 1) return list_.front().clearance;
  const double lowest = list_.front().height.si(), highest = list_.back().height.si();
  constexpr double round_off = 1e-9;  // m, of heights that are sums
  check.that(height >= lowest - round_off && height <= highest + round_off,
             "clearance: the list reaches from " + to_text(lowest) + " to " + to_text(highest) +
                 " m, and a gap is at " + to_text(height) + " m.",
             "Give entries below and above all gaps.");
  height = std::clamp(height, lowest, highest);
  const auto above = std::ranges::lower_bound(list_, Length{height}, {}, &ClearanceAt::height);
  if (above == list_.begin()) return above->clearance;
  const ClearanceAt &low = *std::prev(above), &high = *above;
  return low.clearance +
         (height - low.height.si()) / (high.height - low.height).si() * (high.clearance - low.clearance);
}

std::string note_on_columns(const std::string& name, std::size_t columns) {
  return name + ": " + std::to_string(columns) +
         (columns == 1 ? " gap is that of a floor against a column" : " gaps are those of floors against columns") +
         ", with the law of slabs. A column is softer than a slab, and its shear is not checked: give .column_law.";
}

NeighbourGaps add(Model& model, const Neighbours& neighbours) {
  const Check check{"Neighbours", neighbours.name};
  check.that(!neighbours.name.empty(), "neighbours have no name.", "Give .name, or leave it out: \"neighbours\".");
  check.that(!model.is_plan(), "the model moves in plan.", "Give PlanNeighbours.");
  const BuildingLevels &left = neighbours.left, &right = neighbours.right;
  const AnyImpactLaw& law = neighbours.law;
  LevelPairs found = pairs_of_levels(model, check, left, right, neighbours.slab);
  check.that(!found.pairs.empty(), no_pair(model, left, right),
             "Check their heights; the ground meets nothing: give a Moat around a base.");
  NeighbourGaps gaps{.names = {}, .notes = std::move(found.notes)};
  std::size_t columns = 0;
  for (const LevelPair& pair : found.pairs) {
    const BuildingLevels &own = pair.of_first ? left : right, &other = pair.of_first ? right : left;
    const MemberPoint floor = own.levels[pair.floor], met = point_of_column(other, pair.other, pair.share);
    const std::string met_name =
        pair.is_at_column() ? other.storey_name(pair.other) : std::string{model.body_name(met.node)};
    gaps.names.push_back(neighbours.name + ": " + std::string{model.body_name(floor.node)} + " - " + met_name + " at " +
                         to_fixed(pair.height, 2) + " m");
    columns += pair.is_at_column() ? 1 : 0;
    const AnyImpactLaw& acting = pair.is_at_column() && neighbours.column_law ? *neighbours.column_law : law;
    acting.add_on_line(model, {.name = gaps.names.back(),
                               .place = neighbours.name,
                               .left = pair.of_first ? floor : met,
                               .right = pair.of_first ? met : floor,
                               .clearance = neighbours.clearance.at(check, pair.height)});
  }
  if (columns > 0 && !neighbours.column_law) gaps.notes.push_back(note_on_columns(neighbours.name, columns));
  for (const std::string& note : gaps.notes) model.add_note(note);
  return gaps;
}

}  // namespace moat
