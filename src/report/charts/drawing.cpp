#include "report/charts/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <vector>

#include "base/text/number_format.hpp"
#include "report/charts/motions_of_nodes.hpp"
#include "report/charts/round_factor.hpp"
#include "report/html.hpp"

namespace moat::html {
namespace {

// A point of the page: x to the right, y down.
struct PagePoint {
  double x, y;
};

std::string text_of(PagePoint point) { return to_significant(point.x, 7) + "," + to_significant(point.y, 7); }

// The way of a point as the page's script reads it: "3:1,0+5:0.2,-4" for u3 (1, 0) + u5 (0.2, -4).
using Terms = std::vector<std::pair<int, PagePoint>>;
std::string text_of(const Terms& terms) {
  if (terms.empty()) return "-";
  std::string text;
  for (const auto& [motion, way] : terms)
    text += (text.empty() ? "" : "+") + std::to_string(motion) + ":" + text_of(way);
  return text;
}

std::string_view class_of(CellKind kind) {
  switch (kind) {
    case CellKind::floor:
      return "floor";
    case CellKind::storey:
      return "storey";
    case CellKind::bearing:
      return "bearing";
    case CellKind::gap:
      return "gap";
    case CellKind::wall:
      return "wall";
    case CellKind::other:
      return "other";
  }
  return "other";
}

struct Shape {
  std::string kind;  // of the style sheet
  std::string name;
  std::vector<const ScenePoint*> points;
};

// How a scene is projected: seen from the side, or from above.
class View {
 public:
  explicit View(bool from_above) : from_above_{from_above} {}

  [[nodiscard]] PagePoint at_rest(const ScenePoint& point) const {
    return {point.x, from_above_ ? -point.y : -point.z};
  }
  [[nodiscard]] PagePoint spread(const ScenePoint& point) const {
    return {point.spread.x, from_above_ ? -point.spread.y : 0.0};
  }
  [[nodiscard]] Terms motion(const ScenePoint& point) const {
    if (point.node < 0 || point.weight == 0.0) return {};
    if (!point.on_diaphragm)
      return {{point.node, {point.weight * point.direction.x, from_above_ ? -point.weight * point.direction.y : 0.0}}};
    return {{point.node, {1.0, 0.0}}, {point.node + 1, {0.0, -1.0}}, {point.node + 2, {-point.arm.y, -point.arm.x}}};
  }

 private:
  bool from_above_;
};

// Seen from the side, all cells: those behind first.
std::vector<Shape> elevation_shapes(const Scene& scene) {
  std::vector<Shape> shapes;
  for (const CellKind kind :
       {CellKind::wall, CellKind::storey, CellKind::other, CellKind::bearing, CellKind::floor, CellKind::gap})
    for (const SceneCell& cell : scene.cells) {
      if (cell.kind != kind) continue;
      Shape shape{std::string{class_of(kind)}, cell.name, {}};
      for (const int point : cell.points) shape.points.push_back(&scene.points[static_cast<std::size_t>(point)]);
      shapes.push_back(std::move(shape));
    }
  return shapes;
}

// Seen from above: walls, the bases as areas, the outlines of the floors above them, gaps.
std::vector<Shape> plan_shapes(const CaseResult& result) {
  std::vector<Shape> walls, bases, floors, gaps;
  for (const SceneCell& cell : result.scene.cells) {
    std::vector<const ScenePoint*> points;
    for (const int point : cell.points) points.push_back(&result.scene.points[static_cast<std::size_t>(point)]);
    if (cell.kind == CellKind::gap) gaps.push_back({"gap", cell.name, points});
    if (cell.kind != CellKind::floor && cell.kind != CellKind::wall) continue;
    const bool flat = std::ranges::all_of(points, [&](const ScenePoint* each) { return each->z == points[0]->z; });
    if (!flat) continue;
    const auto is_base = [&](const DiaphragmFacts& each) { return each.is_base && each.name == cell.name; };
    std::vector<Shape>& list = cell.kind == CellKind::wall                             ? walls
                               : std::ranges::any_of(result.model.diaphragms, is_base) ? bases
                                                                                       : floors;
    // Lower and upper face of a prism lie above each other; another wall may have the same name.
    const auto lies_above = [&](const ScenePoint& other) { return other.x == points[0]->x && other.y == points[0]->y; };
    if (!list.empty() && list.back().name == cell.name && lies_above(*list.back().points[0])) continue;
    list.push_back({&list == &floors ? "upper" : std::string{class_of(cell.kind)}, cell.name, points});
  }
  for (std::vector<Shape>* list : {&bases, &floors, &gaps}) walls.insert(walls.end(), list->begin(), list->end());
  return walls;
}

std::string svg_of(const Shape& shape, const View& view) {
  std::string points, spreads, motions;
  bool spreads_out = false, moves = false;
  for (const ScenePoint* each : shape.points) {
    const char* between = points.empty() ? "" : " ";
    const PagePoint spread = view.spread(*each);
    const Terms motion = view.motion(*each);
    spreads_out = spreads_out || spread.x != 0.0 || spread.y != 0.0;
    moves = moves || !motion.empty();
    points += between + text_of(view.at_rest(*each));
    spreads += between + text_of(spread);
    motions += between + text_of(motion);
  }
  const std::string element = shape.points.size() == 2 ? "polyline" : "polygon";
  std::string svg = "<" + element + " class=\"" + shape.kind + "\" data-name=\"" + escaped(shape.name) +
                    "\" points=\"" + points + "\"";
  if (spreads_out) svg += " data-spread=\"" + spreads + "\"";
  if (moves) svg += " data-move=\"" + motions + "\"";
  return svg + "><title>" + escaped(shape.name) + "</title></" + element + ">\n";
}

// The ways of the corners of the bases, and of their centres of mass.
std::string orbits(const CaseResult& result, const View& view) {
  std::string svg;
  for (const DiaphragmFacts& base : result.model.diaphragms) {
    const auto of_base = std::ranges::find_if(result.scene.cells, [&](const SceneCell& cell) {
      return cell.kind == CellKind::floor && cell.name == base.name;
    });
    if (!base.is_base || of_base == result.scene.cells.end()) continue;
    ScenePoint centre = result.scene.points[static_cast<std::size_t>(of_base->points.front())];
    std::vector<PlanVector> places = base.outline;
    places.push_back(base.centre_of_mass);
    for (const PlanVector& place : places) {
      centre.x = place.x;
      centre.y = place.y;
      centre.arm = (place - base.centre_of_mass) / base.gyration;
      svg += "<polyline class=\"orbit\" data-at=\"" + text_of(view.at_rest(centre)) + "\" data-spread=\"" +
             text_of(view.spread(centre)) + "\" data-move=\"" + text_of(view.motion(centre)) + "\"/>\n";
    }
  }
  return svg;
}

std::string view_box(const std::vector<Shape>& shapes, const View& view) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  PagePoint low{infinite, infinite}, high{-infinite, -infinite};
  for (const Shape& shape : shapes)
    for (const ScenePoint* each : shape.points) {
      const PagePoint at = view.at_rest(*each);
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
  const double border = 0.03 * std::max(high.x - low.x, high.y - low.y);
  return text_of({low.x - border, low.y - border}) + "," +
         text_of({high.x - low.x + 2.0 * border, high.y - low.y + 2.0 * border});
}

// So that the largest displacement is a visible part of the drawing.
double exaggeration(const CaseResult& result, const std::vector<Shape>& shapes, const View& view) {
  constexpr double visible = 0.06;
  double left = std::numeric_limits<double>::infinity(), right = -left, largest = 0.0;
  for (const Shape& shape : shapes)
    for (const ScenePoint* each : shape.points) {
      left = std::min(left, view.at_rest(*each).x);
      right = std::max(right, view.at_rest(*each).x);
    }
  for (const NodeMotion& motion : motions_of_nodes(result))
    if (motion.column != nullptr)
      for (const double value : motion.column->values) largest = std::max(largest, std::abs(motion.factor * value));
  return largest > 0.0 ? round_factor(visible * (right - left) / largest) : 1.0;
}

std::string controls(double factor) {
  std::string html =
      "<div class=\"controls\" hidden>\n<button type=\"button\" name=\"play\">Play</button>\n"
      "<button type=\"button\" name=\"next\">Next impact</button>\n"
      "<input type=\"range\" name=\"time\" aria-label=\"time\">\n<output>0 s</output>\n<label>Speed <select "
      "name=\"speed\">";
  for (const char* speed : {"0.01", "0.1", "0.25", "1", "4"})
    html += std::string{"<option"} + (std::string_view{speed} == "1" ? " selected" : "") + " value=\"" + speed + "\">" +
            speed + " x</option>";
  html += "</select></label>\n<label>Displacements <select name=\"exaggeration\">";
  std::vector<double> factors{1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0};
  if (std::ranges::find(factors, factor) == factors.end()) factors.push_back(factor);
  for (const double each : factors)
    html += std::string{"<option"} + (each == factor ? " selected" : "") + " value=\"" + to_significant(each, 6) +
            "\">" + to_significant(each, 6) + " x</option>";
  return html +
         "</select></label>\n<label><input type=\"checkbox\" name=\"stop\" checked> Stop at impacts</label>\n</div>\n";
}

}  // namespace

std::string drawing_section(const CaseResult& result) {
  if (result.scene.cells.empty() || result.histories.rows() < 2) return "";
  const bool in_plan = !result.model.diaphragms.empty();
  const View view{in_plan};
  const std::vector<Shape> shapes = in_plan ? plan_shapes(result) : elevation_shapes(result.scene);
  if (shapes.empty()) return "";
  const std::string kind = in_plan ? "Plan" : "Elevation";
  std::string html = "<h2>Motion</h2>\n<figure class=\"drawing\">\n<svg viewBox=\"" + view_box(shapes, view) +
                     "\" role=\"img\" aria-label=\"" + kind + " of the model\">\n";
  for (const Shape& shape : shapes) html += svg_of(shape, view);
  if (in_plan) html += orbits(result, view);
  return html + "</svg>\n" + controls(exaggeration(result, shapes, view)) + "<figcaption data-true-scale=\"" + kind +
         ", to scale.\" data-exaggerated=\"" + kind +
         ", displacements and gaps drawn {} times larger: bodies touch here when they touch in the model.\">" + kind +
         " at rest, to scale.</figcaption>\n</figure>\n";
}

}  // namespace moat::html
