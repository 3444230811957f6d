#include "structures/facing_corners.hpp"

#include <algorithm>
#include <cmath>

namespace moat {
namespace {

// An edge whose other body is on its left.
struct Edge {
  PlanPosition begin, end;

  [[nodiscard]] PlanVector along() const { return (end.si() - begin.si()) / size(); }
  [[nodiscard]] double size() const { return length(end.si() - begin.si()); }
  /// Distance of a point from its line, m; positive on the left.
  [[nodiscard]] double distance(PlanVector point) const { return cross(along(), point - begin.si()); }
  /// Position of a point along it, m.
  [[nodiscard]] double position(PlanVector point) const { return dot(along(), point - begin.si()); }
};

// Returns an edge with the free space on its left: inside walls around a space, outside a solid body.
Edge edge_of(const PlanOutline& outline, std::size_t i, bool solid) {
  const PlanPosition &a = outline.corners[i], &b = outline.corners[(i + 1) % outline.size()];
  return solid ? Edge{b, a} : Edge{a, b};
}

// Whether a corner points out of the body: convex for a solid one, reflex for walls around a space.
bool points_out(const PlanOutline& outline, std::size_t i, bool solid) {
  const PlanVector before = outline.corner(i) - outline.corner(i + outline.size() - 1),
                   after = outline.corner(i + 1) - outline.corner(i);
  return (cross(before, after) > 0.0) == solid;
}

// Whether both faces at a corner lead away from an edge, or along it: another corner of the body is nearer to it
// otherwise.
bool faces(const PlanOutline& outline, std::size_t i, const Edge& edge) {
  constexpr double parallel = 1e-6;
  const auto leads_away = [&](PlanVector to) {
    const PlanVector way = to - outline.corner(i);
    return cross(edge.along(), way) >= -parallel * length(way);
  };
  return leads_away(outline.corner(i + 1)) && leads_away(outline.corner(i + outline.size() - 1));
}

bool within_reach(const Edge& edge, PlanVector point, double reach) {
  const double distance = edge.distance(point), position = edge.position(point);
  return distance > -same_place && distance <= reach && position >= -reach && position <= edge.size() + reach;
}

bool outlines_cross(const PlanOutline& a, const PlanOutline& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      const PlanVector p = a.corner(i), q = a.corner(i + 1), r = b.corner(j), s = b.corner(j + 1);
      const auto side = [](PlanVector from, PlanVector to, PlanVector point) { return cross(to - from, point - from); };
      if (side(p, q, r) * side(p, q, s) <= 0.0 && side(r, s, p) * side(r, s, q) <= 0.0 &&
          std::max(side(p, q, r) * side(p, q, s), side(r, s, p) * side(r, s, q)) < 0.0)
        return true;
    }
  return false;
}

// An outline without its border, so that others may touch it.
PlanOutline core_of(const PlanOutline& outline) { return offset_outwards(outline, Length{-2.0 * same_place}); }

void add_corners(std::vector<FacingCorner>& list, const PlanOutline& outline, bool solid, const PlanOutline& other,
                 bool other_solid, double reach, bool of_first) {
  for (std::size_t e = 0; e < other.size(); ++e) {
    const Edge edge = edge_of(other, e, other_solid);
    for (std::size_t i = 0; i < outline.size(); ++i)
      if (points_out(outline, i, solid) && faces(outline, i, edge) && within_reach(edge, outline.corner(i), reach))
        list.push_back({of_first, outline.corners[i], "corner " + std::to_string(i + 1), e, edge.begin, edge.end, 1.0});
  }
}

// Points along a face that is parallel to a wall, with their tributary shares.
void add_points(std::vector<FacingCorner>& list, const PlanOutline& outline, const PlanOutline& walls,
                const Facing& facing) {
  for (std::size_t e = 0; e < walls.size(); ++e) {
    const Edge wall = edge_of(walls, e, false);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Edge face = edge_of(outline, i, false);
      constexpr double parallel = 1e-6;
      if (dot(face.along(), wall.along()) < 0.0 || std::abs(cross(face.along(), wall.along())) > parallel ||
          !within_reach(wall, face.begin.si(), facing.reach.si()) ||
          !within_reach(wall, face.end.si(), facing.reach.si()))
        continue;
      const int count = facing.points_per_face;
      for (int k = 0; k < count; ++k) {
        const double x = static_cast<double>(k) / (count - 1);
        const bool at_end = k == 0 || k == count - 1;
        const std::size_t corner = k == 0 ? i : (i + 1) % outline.size();
        list.push_back({true,
                        {(1.0 - x) * face.begin.x + x * face.end.x, (1.0 - x) * face.begin.y + x * face.end.y},
                        at_end ? "corner " + std::to_string(corner + 1)
                               : "point " + std::to_string(k + 1) + " of edge " + std::to_string(i + 1),
                        e,
                        wall.begin,
                        wall.end,
                        (at_end ? 0.5 : 1.0) / (count - 1)});
      }
    }
  }
}

}  // namespace

std::vector<FacingCorner> corners_facing_walls(const Check& check, const PlanOutline& outline, const PlanOutline& walls,
                                               const Facing& facing, const std::string& inner) {
  walls.check(check, "walls");
  check.positive("reach", facing.reach);
  check.that(facing.points_per_face == 0 || facing.points_per_face >= 3, "points_per_face", facing.points_per_face, "1",
             "0, or >= 3", "Two points of a face are its corners: give .share = Share::per_face.");
  const PlanOutline inside = core_of(outline);
  for (std::size_t i = 0; i < outline.size(); ++i)
    check.that(walls.contains(inside.corner(i)),
               "overlap at rest: corner " + std::to_string(i + 1) + " of " + inner + ", at (" +
                   to_text(outline.corner(i).x) + ", " + to_text(outline.corner(i).y) + ") m, is not inside the walls.",
               "Give walls around the outline, or along it for wall to wall.");
  check.that(!outlines_cross(inside, walls), "overlap at rest: the outline of " + inner + " crosses the walls.",
             "Give walls around the outline, or along it for wall to wall.");
  std::vector<FacingCorner> list;
  if (facing.points_per_face > 0) {
    add_points(list, outline, walls, facing);
  } else {
    add_corners(list, outline, true, walls, false, facing.reach.si(), true);
    add_corners(list, walls, false, outline, true, facing.reach.si(), false);
  }
  if (facing.share == Share::per_face && facing.points_per_face == 0) {
    for (std::size_t e = 0; e < walls.size(); ++e) {
      const auto count =
          std::ranges::count_if(list, [&](const FacingCorner& each) { return each.of_first && each.edge == e; });
      check.that(count <= 2,
                 std::to_string(count) + " corners of " + inner + " face wall " + std::to_string(e + 1) +
                     ", which has its law per face.",
                 "Give .points_per_face, or .share = Share::per_corner.");
    }
    for (FacingCorner& each : list) each.share = 0.5;
  }
  check.that(!list.empty(), "no corner of " + inner + " is within reach of a wall.",
             "Give a longer .reach (now " + to_text(facing.reach.si()) + " m) or other walls.");
  return list;
}

std::vector<FacingCorner> corners_facing_each_other(const Check& check, const PlanOutline& first,
                                                    const PlanOutline& second, Length reach, const std::string& names) {
  check.positive("reach", reach);
  const auto inside = [](const PlanOutline& a, const PlanOutline& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (b.contains(a.corner(i))) return true;
    return false;
  };
  const PlanOutline core = core_of(first);
  check.that(!inside(core, second) && !inside(second, core) && !outlines_cross(core, second),
             "overlap at rest: the outlines of " + names + " cross each other.",
             "Move one of them away, until they touch at most.");
  std::vector<FacingCorner> list;
  add_corners(list, first, true, second, true, reach.si(), true);
  add_corners(list, second, true, first, true, reach.si(), false);

  // The face of a corner that is parallel to the edge it can hit; without length if there is none.
  const auto face_of = [&](const FacingCorner& each) {
    const PlanOutline& own = each.of_first ? first : second;
    const Edge edge{each.begin, each.end};
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Edge face = edge_of(own, i, false);
      const bool at_corner =
          length(own.corner(i) - each.at.si()) == 0.0 || length(own.corner(i + 1) - each.at.si()) == 0.0;
      constexpr double parallel = 1e-6;
      if (at_corner && std::abs(cross(face.along(), edge.along())) < parallel && dot(face.along(), edge.along()) > 0.0)
        return face.size();
    }
    return 0.0;
  };
  std::vector<FacingCorner> kept;
  for (const FacingCorner& each : list) {
    const double own = face_of(each);
    const bool doubled = own > 0.0 && std::ranges::any_of(list, [&](const FacingCorner& other) {
                           if (other.of_first == each.of_first) return false;
                           const double others = face_of(other);
                           const Edge edge{each.begin, each.end};
                           constexpr double opposite = 0.01;  // of the shorter face
                           if (others == 0.0 || std::abs(edge.position(each.at.si()) - edge.position(other.at.si())) >
                                                    opposite * std::min(own, others))
                             return false;
                           // Both stand at ends of faces that face each other: the corner of the other one must lie on
                           // this edge.
                           if (std::abs(edge.distance(other.at.si())) > 1e-6 * own) return false;
                           constexpr double equal = 1e-6;
                           return std::abs(own - others) <= equal * own ? !each.of_first : own > others;
                         });
    if (!doubled) kept.push_back(each);
  }
  return kept;
}

std::vector<FacingCorner> columns_facing_floor(const Check& check, const std::vector<PlanPosition>& columns,
                                               const PlanOutline& around, const PlanOutline& floor, Length reach,
                                               const std::string& storey, const std::string& floor_name) {
  check.positive("reach", reach);
  const std::string kind = columns.empty() ? "corner " : "column ";
  const std::vector<PlanPosition>& points = columns.empty() ? around.corners : columns;
  const PlanOutline core = core_of(floor);
  for (std::size_t i = 0; i < points.size(); ++i)
    check.that(!core.contains(points[i].si()),
               "overlap at rest: " + kind + std::to_string(i + 1) + " of \"" + storey + "\", at (" +
                   to_text(points[i].x.si()) + ", " + to_text(points[i].y.si()) + ") m, is inside \"" + floor_name +
                   "\".",
               "Move one of the buildings away, until they touch at most.");
  std::vector<FacingCorner> list;
  if (columns.empty()) {
    add_corners(list, around, true, floor, true, reach.si(), true);
    return list;
  }
  constexpr double row = 1.0 + 2.0 * same_place;  // m, of columns along a facade
  for (std::size_t e = 0; e < floor.size(); ++e) {
    const Edge edge = edge_of(floor, e, true);
    const PlanVector towards = -turned_left(edge.along());
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (const PlanVector at = columns[i].si();
          within_reach(edge, at, reach.si()) && !around.contains(at + row * towards))
        list.push_back({true, columns[i], kind + std::to_string(i + 1), e, edge.begin, edge.end, 1.0});
  }
  return list;
}

}  // namespace moat
