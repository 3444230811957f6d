#include "model/plan_outline.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace moat {
namespace {

std::string corner_name(std::size_t i) { return "corner " + std::to_string(i + 1); }

// Whether the segments a-b and c-d have a point in common.
bool segments_meet(PlanVector a, PlanVector b, PlanVector c, PlanVector d) {
  const auto side = [](PlanVector p, PlanVector q, PlanVector r) { return cross(q - p, r - p); };
  const auto between = [](PlanVector p, PlanVector q, PlanVector r) {
    return std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
           r.y <= std::max(p.y, q.y);
  };
  const double a_side = side(c, d, a), b_side = side(c, d, b), c_side = side(a, b, c), d_side = side(a, b, d);
  if (((a_side > 0.0) != (b_side > 0.0)) && ((c_side > 0.0) != (d_side > 0.0)) && a_side != 0.0 && b_side != 0.0 &&
      c_side != 0.0 && d_side != 0.0)
    return true;
  return (a_side == 0.0 && between(c, d, a)) || (b_side == 0.0 && between(c, d, b)) ||
         (c_side == 0.0 && between(a, b, c)) || (d_side == 0.0 && between(a, b, d));
}

}  // namespace

double PlanOutline::area() const {
  double twice = 0.0;
  for (std::size_t i = 0; i < size(); ++i) twice += cross(corner(i) - corner(0), corner(i + 1) - corner(0));
  return 0.5 * twice;
}

PlanVector PlanOutline::centroid() const {
  PlanVector sum;
  for (std::size_t i = 0; i < size(); ++i) {
    const PlanVector a = corner(i) - corner(0), b = corner(i + 1) - corner(0);
    sum += cross(a, b) * (a + b);
  }
  return corner(0) + sum / (6.0 * area());
}

double PlanOutline::gyration_squared() const {
  const PlanVector centre = centroid();
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    const PlanVector a = corner(i) - centre, b = corner(i + 1) - centre;
    sum += cross(a, b) * (dot(a, a) + dot(a, b) + dot(b, b));
  }
  return sum / (12.0 * area());
}

bool PlanOutline::contains(PlanVector point) const {
  bool inside = false;
  for (std::size_t i = 0; i < size(); ++i) {
    const PlanVector a = corner(i), b = corner(i + 1), edge = b - a, to_point = point - a;
    const double along = std::clamp(dot(to_point, edge) / dot(edge, edge), 0.0, 1.0);
    if (length(to_point - along * edge) <= same_place) return true;
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

void PlanOutline::check(const Check& check, std::string_view field) const {
  const std::string name{field};
  check.that(size() >= 3, name + " has " + std::to_string(size()) + " corners.", "Give at least three.");
  for (std::size_t i = 0; i < size(); ++i) {
    check.finite(name + " " + corner_name(i) + " x", corners[i].x);
    check.finite(name + " " + corner_name(i) + " y", corners[i].y);
    for (std::size_t j = 0; j < i; ++j)
      check.that(length(corner(i) - corner(j)) > same_place,
                 name + " " + corner_name(j) + " and " + corner_name(i) + " are at the same place, (" +
                     to_text(corner(i).x) + ", " + to_text(corner(i).y) + ") m.",
                 "Leave one of them out; the last corner is not the first again.");
  }
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = i + 1; j < size(); ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j + 1 == size());
      if (neighbours) continue;
      check.that(!segments_meet(corner(i), corner(i + 1), corner(j), corner(j + 1)),
                 name + " crosses itself: the edges from " + corner_name(i) + " and from " + corner_name(j) + " meet.",
                 "Give the corners in their order around the polygon.");
    }
  }
  check.that(area() > 0.0, name + " is clockwise.", "Give the corners counter-clockwise, in reverse order.");
}

PlanOutline rectangle(Length x, Length y, PlanPosition centre) {
  const Length a = 0.5 * x, b = 0.5 * y;
  return {{{centre.x - a, centre.y - b},
           {centre.x + a, centre.y - b},
           {centre.x + a, centre.y + b},
           {centre.x - a, centre.y + b}}};
}

PlanPosition turned(PlanPosition point, Angle angle, PlanPosition centre) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Length x = point.x - centre.x, y = point.y - centre.y;
  return {centre.x + c * x - s * y, centre.y + s * x + c * y};
}

PlanOutline turned(const PlanOutline& outline, Angle angle, PlanPosition centre) {
  PlanOutline result;
  for (const PlanPosition& corner : outline.corners) result.corners.push_back(turned(corner, angle, centre));
  return result;
}

PlanOutline offset_outwards(const PlanOutline& outline, Length distance) {
  const auto outward = [&](std::size_t edge) {
    const PlanVector along = outline.corner(edge + 1) - outline.corner(edge);
    return -turned_left(along) / length(along);
  };
  PlanOutline result;
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    // The corner p moves so that n.(p' - p) = distance for the normals of both of its edges.
    const PlanVector before = outward(i + count - 1), after = outward(i);
    const PlanVector shift = distance.si() / (1.0 + dot(before, after)) * (before + after);
    const PlanVector p = outline.corner(i) + shift;
    result.corners.push_back({Length{p.x}, Length{p.y}});
  }
  return result;
}

}  // namespace moat
