#include "structures/neighbours/plan_neighbours.hpp"

#include "base/text/number_format.hpp"
#include "structures/facing_corners.hpp"

namespace moat {
namespace {

const PlacedDiaphragm& with_outline(const Model& model, const Check& check, NodeId level) {
  model.require_node(level, check, "a floor");
  const PlacedDiaphragm* floor = model.diaphragm_of(level);
  check.that(floor != nullptr, "\"" + std::string{model.body_name(level)} + "\" is no diaphragm.",
             "Give Neighbours for buildings on a line.");
  check.that(!floor->outline.empty(), "the diaphragm \"" + floor->name + "\" has no outline.",
             "Give Diaphragm::outline: its corners and edges hit the neighbour.");
  return *floor;
}

// The pairs of one floor and the floor or the columns of the other building that it meets.
class PairsOfFloor {
 public:
  PairsOfFloor(const Model& model, const Check& check, const PlanNeighbours& neighbours, const LevelPair& pair)
      : model_{model}, check_{check}, neighbours_{neighbours}, pair_{pair} {}

  [[nodiscard]] std::vector<CornerPlace> find() const { return pair_.is_at_column() ? at_columns() : at_corners(); }
  /// "hospital floor 1 and old storey 2"
  [[nodiscard]] std::string names() const {
    return floor().name + " and " + (pair_.is_at_column() ? other().storey_name(pair_.other) : above().name);
  }

 private:
  [[nodiscard]] const BuildingLevels& own() const { return pair_.of_first ? neighbours_.first : neighbours_.second; }
  [[nodiscard]] const BuildingLevels& other() const { return pair_.of_first ? neighbours_.second : neighbours_.first; }
  [[nodiscard]] const PlacedDiaphragm& floor() const { return with_outline(model_, check_, own().levels[pair_.floor]); }
  [[nodiscard]] const PlacedDiaphragm& above() const {
    return with_outline(model_, check_, other().levels[pair_.other]);
  }

  [[nodiscard]] CornerPlace place(const FacingCorner& each, const PlanPoint& point, const std::string& corner_of,
                                  const PlacedDiaphragm& edge_of) const {
    const std::string corner = corner_of + " " + each.corner,
                      edge = edge_of.name + " edge " + std::to_string(each.edge + 1);
    return {.name = neighbours_.name + " " + corner + " " + edge,
            .place = neighbours_.name,
            .corner = point,
            .edge_of = edge_of.id,
            .edge_begin = each.begin,
            .edge_end = each.end,
            .friction = neighbours_.friction,
            .corner_name = corner,
            .edge_name = edge};
  }

  [[nodiscard]] std::vector<CornerPlace> at_corners() const {
    const PlacedDiaphragm &a = floor(), &b = above();
    std::vector<CornerPlace> pairs;
    for (const FacingCorner& each : corners_facing_each_other(check_, a.outline, b.outline, neighbours_.reach,
                                                              "\"" + a.name + "\" and \"" + b.name + "\"")) {
      const PlacedDiaphragm &with_corner = each.of_first ? a : b, &with_edge = each.of_first ? b : a;
      pairs.push_back(place(each, PlanPoint{with_corner.id, each.at}, with_corner.name, with_edge));
    }
    return pairs;
  }

  [[nodiscard]] std::vector<CornerPlace> at_columns() const {
    const std::string storey = other().storey_name(pair_.other);
    const std::vector<PlanPosition> columns =
        pair_.other <= other().columns.size() ? other().columns[pair_.other - 1] : std::vector<PlanPosition>{};
    const MemberPoint column = point_of_column(other(), pair_.other, pair_.share);
    std::vector<CornerPlace> pairs;
    for (const FacingCorner& each : columns_facing_floor(check_, columns, above().outline, floor().outline,
                                                         neighbours_.reach, storey, floor().name))
      pairs.push_back(place(each, PlanPoint{column.node, each.at, column.other, column.share}, storey, floor()));
    return pairs;
  }

  const Model& model_;
  const Check& check_;
  const PlanNeighbours& neighbours_;
  const LevelPair& pair_;
};

LevelPairs pairs_of(const Model& model, const Check& check, const PlanNeighbours& neighbours) {
  const BuildingLevels &first = neighbours.first, &second = neighbours.second;
  if (first.levels.size() == 1 && second.levels.size() == 1) return {.pairs = {LevelPair{}}, .notes = {}};
  LevelPairs found = pairs_of_levels(model, check, first, second, neighbours.slab);
  check.that(!found.pairs.empty(), no_pair(model, first, second),
             "Check their heights; the ground meets nothing: give a PlanMoat around a base.");
  return found;
}

}  // namespace

NeighbourGaps add(Model& model, const PlanNeighbours& neighbours) {
  const Check check{"PlanNeighbours", neighbours.name};
  check.that(!neighbours.name.empty(), "neighbours have no name.", "Give .name, or leave it out: \"neighbours\".");
  const AnyImpactLaw& law = neighbours.law;
  LevelPairs found = pairs_of(model, check, neighbours);
  NeighbourGaps gaps{.names = {}, .notes = std::move(found.notes)};
  std::size_t columns = 0;
  for (const LevelPair& pair : found.pairs) {
    const PairsOfFloor of_floor{model, check, neighbours, pair};
    const std::vector<CornerPlace> places = of_floor.find();
    if (places.empty())
      gaps.notes.push_back(of_floor.names() + " at " + to_fixed(pair.height, 2) +
                           " m have no corner or column within reach of an edge of the other.");
    const AnyImpactLaw& acting = pair.is_at_column() && neighbours.column_law ? *neighbours.column_law : law;
    for (const CornerPlace& each : places) {
      acting.add_in_plan(model, each);
      gaps.names.push_back(each.name);
    }
    columns += pair.is_at_column() ? places.size() : 0;
  }
  check.that(!gaps.names.empty(),
             "no corner of " + neighbours.first.value().title(model) + " and " +
                 neighbours.second.value().title(model) + " is within reach of the other.",
             "Give a longer .reach (now " + to_text(neighbours.reach.si()) + " m).");
  if (columns > 0 && !neighbours.column_law) gaps.notes.push_back(note_on_columns(neighbours.name, columns));
  for (const std::string& note : gaps.notes) model.add_note(note);
  return gaps;
}

}  // namespace moat
