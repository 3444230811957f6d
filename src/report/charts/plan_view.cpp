#include "report/charts/plan_view.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "base/plan_vector.hpp"
#include "base/text/number_format.hpp"
#include "output/charts/chart_style.hpp"
#include "output/charts/svg_writer.hpp"
#include "report/charts/orbit.hpp"
#include "report/charts/round_factor.hpp"

namespace moat {
namespace {

using namespace chart_style;

constexpr int picture_width = 760, picture_height = 600;  // pixels
constexpr double margin = 70.0;

class Picture {
 public:
  Picture(const CaseResult& result, const DiaphragmFacts& base, const Orbit& orbit)
      : result_{result}, base_{base}, orbit_{orbit} {
    choose_factor();
    choose_scale();
  }

  std::string draw() {
    SvgWriter svg{picture_width, picture_height, "Plan of " + base_.name,
                  "Outline, walls, orbits of the corners and impacts of " + base_.name};
    svg.text({0.5 * picture_width, 24.0},
             "Plan of " + base_.name + ", displacements and clearances " + to_significant(factor_, 3) + " times larger",
             {.size = title_size, .anchor = Lettering::Anchor::middle, .bold = true});
    draw_walls(svg);
    draw_polygon(svg, base_.outline, {.colour = axis_line, .width = 1.5, .kind = axis_class});
    for (std::size_t i = 0; i < base_.outline.size(); ++i) {
      draw_orbit(svg, base_.outline[i], palette[0]);
      svg.text(pixel(base_.outline[i] + 0.06 * (base_.centre_of_mass - base_.outline[i])), std::to_string(i + 1),
               {.size = tick_size, .anchor = Lettering::Anchor::middle});
    }
    draw_orbit(svg, base_.centre_of_mass, palette[2]);
    draw_impacts(svg);
    return svg.finish();
  }

 private:
  [[nodiscard]] PlanVector arm(PlanVector point) const { return point - base_.centre_of_mass; }

  [[nodiscard]] bool hits_walls(const CornerFacts& corner) const {
    return corner.edge_is_wall && corner.body == base_.name;
  }

  void choose_factor() {
    constexpr double share_of_plan = 0.12;
    double size = 0.0, largest = 0.0;
    for (const PlanVector& corner : base_.outline) {
      size = std::max(size, 2.0 * length(arm(corner)));
      for (std::size_t row = 0; row < orbit_.rows(); ++row)
        largest = std::max(largest, length(orbit_.displacement(row, arm(corner))));
    }
    for (const CornerFacts& corner : result_.model.corners)
      if (hits_walls(corner)) largest = std::max(largest, corner.clearance);
    factor_ = largest > 0.0 ? round_factor(share_of_plan * size / largest) : 1.0;
  }

  // A wall, moved away so that its clearance is drawn larger; its ends go on as far.
  [[nodiscard]] std::pair<PlanVector, PlanVector> wall_ends(const CornerFacts& corner) const {
    const double away = (factor_ - 1.0) * corner.clearance;
    const PlanVector tangent = turned_left(corner.normal);
    return {corner.edge_begin + away * (corner.normal - tangent), corner.edge_end + away * (corner.normal + tangent)};
  }

  void choose_scale() {
    low_ = high_ = base_.outline.front();
    const auto include = [&](PlanVector point) {
      low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y)};
      high_ = {std::max(high_.x, point.x), std::max(high_.y, point.y)};
    };
    for (const PlanVector& corner : base_.outline)
      for (std::size_t row = 0; row < orbit_.rows(); ++row)
        include(corner + factor_ * orbit_.displacement(row, arm(corner)));
    for (const CornerFacts& corner : result_.model.corners) {
      if (!hits_walls(corner)) continue;
      include(wall_ends(corner).first);
      include(wall_ends(corner).second);
    }
    scale_ = std::min((picture_width - 2.0 * margin) / std::max(high_.x - low_.x, 1e-9),
                      (picture_height - 2.0 * margin) / std::max(high_.y - low_.y, 1e-9));
  }

  [[nodiscard]] Pixel pixel(PlanVector point) const {
    return {0.5 * picture_width + scale_ * (point.x - 0.5 * (low_.x + high_.x)),
            0.5 * picture_height + 12.0 - scale_ * (point.y - 0.5 * (low_.y + high_.y))};
  }

  void draw_polygon(SvgWriter& svg, const std::vector<PlanVector>& corners, const Stroke& stroke) const {
    for (std::size_t i = 0; i < corners.size(); ++i)
      svg.line(pixel(corners[i]), pixel(corners[(i + 1) % corners.size()]), stroke);
  }

  void draw_walls(SvgWriter& svg) const {
    std::set<std::tuple<std::string, double, double, double, double>> drawn;  // names and ends
    for (const CornerFacts& corner : result_.model.corners) {
      const PlanVector &from = corner.edge_begin, &to = corner.edge_end;
      if (!hits_walls(corner) || !drawn.insert({corner.edge, from.x, from.y, to.x, to.y}).second) continue;
      const auto [begin, end] = wall_ends(corner);
      svg.line(pixel(begin), pixel(end), {.colour = palette[black], .width = 3.0, .kind = black_line_class});
      svg.text(pixel(0.5 * (begin + end) + (14.0 / scale_) * corner.normal), corner.edge,
               {.size = tick_size,
                .anchor = Lettering::Anchor::middle,
                .upwards = std::abs(corner.normal.x) > std::abs(corner.normal.y)});
    }
  }

  void draw_orbit(SvgWriter& svg, PlanVector point, std::string_view colour) const {
    std::vector<Pixel> line;
    for (std::size_t row = 0; row < orbit_.rows(); ++row)
      line.push_back(pixel(point + factor_ * orbit_.displacement(row, arm(point))));
    svg.polyline(line, {.colour = colour, .width = 1.0});
  }

  void draw_impacts(SvgWriter& svg) const {
    for (const Impact& impact : result_.impacts) {
      const auto corner = std::ranges::find_if(result_.model.corners,
                                               [&](const CornerFacts& each) { return each.element == impact.where; });
      if (corner == result_.model.corners.end() || !hits_walls(*corner)) continue;
      const PlanVector at = corner->position + factor_ * orbit_.displacement_at(impact.start, arm(corner->position));
      svg.disc(pixel(at), 4.0, palette[1]);
      const Pixel place = pixel(at + (10.0 / scale_) * -1.0 * corner->normal);
      svg.text(place, to_fixed(impact.start, 2) + " s",
               {.size = 11.0,
                .anchor = corner->normal.x > 0.5    ? Lettering::Anchor::end
                          : corner->normal.x < -0.5 ? Lettering::Anchor::start
                                                    : Lettering::Anchor::middle});
    }
  }

  const CaseResult& result_;
  const DiaphragmFacts& base_;
  const Orbit& orbit_;
  double factor_ = 1.0, scale_ = 1.0;
  PlanVector low_, high_;
};

}  // namespace

std::vector<std::string> plan_views(const CaseResult& result) {
  constexpr std::size_t most = 3;
  std::vector<std::string> views;
  for (const DiaphragmFacts& base : result.model.diaphragms) {
    if (!base.is_base || base.outline.empty() || views.size() == most) continue;
    const std::optional<Orbit> orbit = orbit_of(base, result.histories);
    if (!orbit) continue;
    views.push_back(Picture{result, base, *orbit}.draw());
  }
  return views;
}

}  // namespace moat
