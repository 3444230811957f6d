#include "report/sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/number_format.hpp"
#include "output/charts/chart_axis.hpp"
#include "output/charts/heat_map.hpp"
#include "report/charts/chart_columns.hpp"
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

struct Shape {
  std::string kind;  // of the style sheet
  std::string name;
  std::vector<ScenePoint> points;
  std::string colour{};  // of the style sheet if empty
  std::string remark{};  // behind its name
};

// How a scene is projected: seen from the side, or from above.
struct View {
  bool from_above;

  [[nodiscard]] PagePoint at_rest(const ScenePoint& point) const { return {point.x, from_above ? -point.y : -point.z}; }
  [[nodiscard]] PagePoint spread(const ScenePoint& point) const {
    return {point.spread.x, from_above ? -point.spread.y : 0.0};
  }
  [[nodiscard]] Terms motion(const ScenePoint& point) const {
    if (point.node < 0) return {};
    if (!point.on_diaphragm) return {{point.node, {point.direction.x, from_above ? -point.direction.y : 0.0}}};
    return {{point.node, {1.0, 0.0}}, {point.node + 1, {0.0, -1.0}}, {point.node + 2, {-point.arm.y, -point.arm.x}}};
  }
};

double peak_of(const CaseResult& result, std::string_view quantity, const std::string& where) {
  const auto found = std::ranges::find_if(
      result.peaks, [&](const Peak& each) { return each.quantity == quantity && each.where == where; });
  return found == result.peaks.end() ? 0.0 : found->value;
}

// Bearings under a weight that changes: brightness shows the smallest share of that at rest, and a cross those that
// lifted. Returns whether there are any.
bool add_weights(const CaseResult& result, std::vector<Shape>& shapes) {
  std::vector<Shape> crosses;
  bool any = false;
  for (Shape& shape : shapes) {
    const auto bearing = std::ranges::find(result.model.elements, shape.name, &ElementFacts::name);
    if (shape.kind != "bearing" || bearing == result.model.elements.end() || bearing->static_weight == 0.0) continue;
    any = true;
    const double share = peak_of(result, "smallest_bearing_compression", shape.name) / bearing->static_weight,
                 time = peak_of(result, "uplift_time", shape.name);
    shape.colour = viridis(std::clamp(share, 0.0, 1.0));
    shape.remark = ", at least " + to_significant(100.0 * share, 3) + " % of its weight at rest" +
                   (time > 0.0 ? ", lifted for " + to_significant(time, 3) + " s" : "");
    if (time == 0.0) continue;
    constexpr double size = 0.4;  // m
    for (const double slope : {1.0, -1.0}) {
      Shape& line = crosses.emplace_back(Shape{"lifted", shape.name, {shape.points[0], shape.points[0]}});
      for (const std::size_t end : {0, 1}) {
        const double away = end == 0 ? -size : size;
        line.points[end].x += away;
        line.points[end].y += slope * away;
      }
    }
  }
  std::ranges::move(crosses, std::back_inserter(shapes));
  return any;
}

// All cells, those behind first. From above walls, bases as areas, outlines of the floors above them, bearings as
// points that become lines when they deform, and gaps.
std::vector<Shape> shapes_of(const CaseResult& result, bool from_above) {
  std::vector<Shape> shapes;
  std::array kinds{std::pair{CellKind::wall, "wall"},   std::pair{CellKind::storey, "storey"},
                   std::pair{CellKind::other, "other"}, std::pair{CellKind::bearing, "bearing"},
                   std::pair{CellKind::floor, "floor"}, std::pair{CellKind::gap, "gap"}};
  if (from_above) std::swap(kinds[3], kinds[4]);
  for (const auto& [kind, name] : kinds)
    for (const SceneCell& cell : result.scene.cells) {
      if (cell.kind != kind) continue;
      Shape shape{name, cell.name, {}};
      for (const int point : cell.points) shape.points.push_back(result.scene.points[static_cast<std::size_t>(point)]);
      const ScenePoint& first = shape.points.front();
      if (from_above && kind != CellKind::gap && kind != CellKind::bearing) {
        // Floors and walls are prisms, whose lower and upper face lie above each other; another wall may have the same
        // name.
        const auto same = [&](const ScenePoint& other) { return other.x == first.x && other.y == first.y; };
        const bool flat = std::ranges::all_of(shape.points, [&](const ScenePoint& each) { return each.z == first.z; });
        const bool is_known = !shapes.empty() && shapes.back().name == cell.name && same(shapes.back().points[0]);
        if ((kind != CellKind::floor && kind != CellKind::wall) || !flat || is_known) continue;
        const auto is_base = [&](const DiaphragmFacts& each) { return each.is_base && each.name == cell.name; };
        if (kind == CellKind::floor && std::ranges::none_of(result.model.diaphragms, is_base)) shape.kind = "upper";
      }
      shapes.push_back(std::move(shape));
    }
  return shapes;
}

// From the side: a line on which storeys and bearings stand, a little wider than these.
void add_ground(const CaseResult& result, std::vector<Shape>& shapes) {
  constexpr double beyond = 0.1;  // of the width
  for (const SceneCell& cell : result.scene.cells) {
    if (cell.kind == CellKind::wall || cell.kind == CellKind::gap || cell.kind == CellKind::floor) continue;
    std::vector<ScenePoint> feet;
    for (const int point : cell.points)
      if (const ScenePoint& each = result.scene.points[static_cast<std::size_t>(point)]; each.node < 0)
        feet.push_back(each);
    if (feet.size() != 2) continue;
    const double more = beyond * (feet[1].x - feet[0].x);
    feet[0].x -= more;
    feet[1].x += more;
    // Behind the walls of a moat.
    shapes.insert(shapes.begin(), {"ground", "ground", feet});
  }
}

// The corners of the bases and their centres of mass, whose ways the page's script draws.
void add_orbits(const CaseResult& result, std::vector<Shape>& shapes) {
  for (const DiaphragmFacts& base : result.model.diaphragms) {
    const auto of_base =
        std::ranges::find_if(shapes, [&](const Shape& each) { return each.kind == "floor" && each.name == base.name; });
    if (!base.is_base || of_base == shapes.end()) continue;
    ScenePoint point = of_base->points.front();
    std::vector<PlanVector> places = base.outline;
    places.push_back(base.centre_of_mass);
    for (const PlanVector& place : places) {
      point.x = place.x;
      point.y = place.y;
      point.arm = (place - base.centre_of_mass) / base.gyration;
      shapes.push_back({"orbit", base.name, {point}});
    }
  }
}

std::string svg_of(const Shape& shape, const View& view) {
  std::string points, spreads, motions;
  bool spreads_out = false, moves = false;
  for (const ScenePoint& each : shape.points) {
    const char* between = points.empty() ? "" : " ";
    const PagePoint spread = view.spread(each);
    const Terms motion = view.motion(each);
    spreads_out = spreads_out || spread.x != 0.0 || spread.y != 0.0;
    moves = moves || !motion.empty();
    points += between + text_of(view.at_rest(each));
    spreads += between + text_of(spread);
    motions += between + text_of(motion);
  }
  const std::string element = shape.points.size() <= 2 ? "polyline" : "polygon";
  std::string svg = "<" + element + " class=\"" + shape.kind + "\" data-name=\"" + escaped(shape.name) +
                    "\" points=\"" + points + "\"";
  if (spreads_out) svg += " data-spread=\"" + spreads + "\"";
  if (moves) svg += " data-move=\"" + motions + "\"";
  if (!shape.colour.empty()) svg += " style=\"stroke:" + shape.colour + "\"";
  return svg + "><title>" + escaped(shape.name + shape.remark) + "</title></" + element + ">\n";
}

// Upper left and lower right corner at rest.
std::pair<PagePoint, PagePoint> bounds_of(const std::vector<Shape>& shapes, const View& view) {
  PagePoint low = view.at_rest(shapes.front().points.front()), high = low;
  for (const Shape& shape : shapes)
    for (const ScenePoint& each : shape.points) {
      const PagePoint at = view.at_rest(each);
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
  return {low, high};
}

// So that the largest displacement is a visible part of a drawing of this width.
double exaggeration(const CaseResult& result, double width) {
  constexpr double visible = 0.06;
  double largest = 0.0;
  for (const NodeMotion& motion : motions_of_nodes(result))
    if (motion.column != nullptr)
      for (const double value : motion.column->values) largest = std::max(largest, std::abs(motion.factor * value));
  return largest > 0.0 && width > 0.0 ? std::max(1.0, round_number_below(visible * width / largest)) : 1.0;
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
  std::vector<Shape> shapes = shapes_of(result, in_plan);
  if (shapes.empty()) return "";
  const bool weights_change = in_plan && add_weights(result, shapes);
  if (in_plan)
    add_orbits(result, shapes);
  else
    add_ground(result, shapes);
  const auto [low, high] = bounds_of(shapes, view);
  const double border = 0.03 * std::max(high.x - low.x, high.y - low.y);
  const std::string kind = in_plan ? "Plan" : "Elevation";
  std::string html = "<h2>Motion</h2>\n<figure class=\"drawing\">\n<svg viewBox=\"" +
                     text_of({low.x - border, low.y - border}) + "," +
                     text_of({high.x - low.x + 2.0 * border, high.y - low.y + 2.0 * border}) +
                     "\" role=\"img\" aria-label=\"" + kind + " of the model\">\n";
  for (const Shape& shape : shapes) html += svg_of(shape, view);
  return html + "</svg>\n" + controls(exaggeration(result, high.x - low.x)) + "<figcaption data-true-scale=\"" + kind +
         ", to scale.\" data-exaggerated=\"" + kind +
         ", displacements and gaps drawn {} times larger: bodies touch here when they touch in the model.\">" + kind +
         " at rest, to scale.</figcaption>\n</figure>\n" +
         (weights_change ? "<p>Bearings are bright while they carry their weight at rest or more, the darker the less "
                           "they carried at least, and crossed where they lifted.</p>\n"
                         : "");
}

}  // namespace moat::html
