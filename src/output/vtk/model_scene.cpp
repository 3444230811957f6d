#include "output/vtk/model_scene.hpp"

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "output/vtk/scene_spread.hpp"

namespace moat {
namespace {

// Lengths in drawings only, m.
constexpr double slab_thickness = 0.4;
constexpr double bearing_height = 0.8;
constexpr double wall_thickness = 1.0;
constexpr double storey_inset = 0.3;

class SceneBuilder {
 public:
  explicit SceneBuilder(const Model& model) : model_{model}, spread_{spread_of_nodes(model)} {}

  Scene build() {
    if (model_.is_plan()) return build_in_plan();
    for (int i = 0; i < model_.nodes(); ++i)
      if (!model_.body(model_.node(i)).generalised) add_slab(model_.node(i));
    int number = 0;
    for (const auto& block : model_.blocks())
      for (std::size_t e = 0; e < block->size(); ++e, ++number) add_element(block->info(e), number);
    for (const Building& building : model_.buildings()) add_storeys_of_matrices(building);
    return std::move(scene_);
  }

 private:
  struct Place {
    double x, z, half_width;
    int node;
    PlanVector spread;
  };

  // The ground has no position of its own: it is drawn below, or beside, the node on it.
  Place place(NodeId id, NodeId other) const {
    const Body& body = model_.body(id == ground ? other : id);
    return {body.x, id == ground ? body.height - bearing_height : body.height, body.half_width,
            id == ground ? -1 : model_.place(id), spread_of(id == ground ? other : id)};
  }

  [[nodiscard]] PlanVector spread_of(NodeId body) const {
    return body == ground ? PlanVector{} : spread_[static_cast<std::size_t>(model_.place(body))];
  }

  // `spread` is taken from the node, or for a point of the ground from the body beside it.
  int point(double x, double z, int node, PlanVector spread) {
    scene_.points.push_back({.x = x, .y = 0.0, .z = z, .node = node, .spread = spread});
    return static_cast<int>(scene_.points.size()) - 1;
  }

  void add_slab(NodeId id) {
    const Place p = place(id, id);
    const double top = p.z, bottom = p.z - slab_thickness;
    scene_.cells.push_back(
        {CellKind::floor,
         std::string{model_.node_name(id)},
         {point(p.x - p.half_width, bottom, p.node, p.spread), point(p.x + p.half_width, bottom, p.node, p.spread),
          point(p.x + p.half_width, top, p.node, p.spread), point(p.x - p.half_width, top, p.node, p.spread)},
         -1});
  }

  void add_element(const ElementInfo& info, int number) {
    if (info.joined() == nullptr) joined_.insert({{info.first, info.second}, {info.second, info.first}});
    switch (info.drawn_as) {
      case DrawnAs::nothing:
        return;
      case DrawnAs::storey:
        return add_panel(CellKind::storey, info, number);
      case DrawnAs::bearing:
        return add_panel(CellKind::bearing, info, number);
      case DrawnAs::gap:
        return add_gap(info, number);
      case DrawnAs::other:
        return add_panel(CellKind::other, info, number);
    }
  }

  void add_panel(CellKind kind, const ElementInfo& info, int number) {
    Place low = place(info.first, info.second);
    const Place high = place(info.second, info.first);
    // The lowest storey of a fixed building stands on the ground, which is at height 0.
    if (kind == CellKind::storey && info.first == ground && low.z > 0.0) low.z = 0.0;
    const double half = std::max(0.1, std::min(low.half_width, high.half_width) - storey_inset);
    const double top = high.z - slab_thickness;
    scene_.cells.push_back(
        {kind,
         info.name,
         {point(low.x - half, low.z, low.node, low.spread), point(low.x + half, low.z, low.node, low.spread),
          point(high.x + half, top, high.node, high.spread), point(high.x - half, top, high.node, high.spread)},
         number,
         kind == CellKind::storey ? storey(info.first, info.second) : -1});
  }

  // Storeys that no element is drawn as: those of a building that is given by its matrix.
  void add_storeys_of_matrices(const Building& building) {
    NodeId below = building.base;
    for (const NodeId above : building.floors) {
      if (!joined_.contains({below, above}))
        add_panel(CellKind::storey,
                  {.name = "storey under " + std::string{model_.node_name(above)}, .first = below, .second = above},
                  -1);
      below = above;
    }
  }

  int storey(NodeId below, NodeId above) {
    const auto [found, is_new] = storeys_.try_emplace({below, above}, static_cast<int>(scene_.storeys.size()));
    if (is_new) scene_.storeys.emplace_back(below, above);
    return found->second;
  }

  // A gap has its right node first and its left node second.
  void add_gap(const ElementInfo& info, int number) {
    const bool wall_right = info.first == ground, wall_left = info.second == ground;
    const Place right = place(info.first, info.second), left = place(info.second, info.first);
    const double height = info.member_ends() != nullptr ? info.member_ends()->height : wall_right ? left.z : right.z;
    const double level = height - 0.5 * slab_thickness;
    const double left_face = wall_left ? right.x - right.half_width - info.offset : left.x + left.half_width;
    const double right_face = wall_right ? left.x + left.half_width + info.offset : right.x - right.half_width;
    const PlanVector clearance{info.offset, 0.0};
    const PlanVector left_spread = wall_left ? right.spread - clearance : left.spread;
    const PlanVector right_spread = wall_right ? left.spread + clearance : right.spread;
    scene_.cells.push_back(
        {CellKind::gap,
         info.name,
         {point(left_face, level, left.node, left_spread), point(right_face, level, right.node, right_spread)},
         number});
    if (wall_left) add_wall(info.name, left_face - wall_thickness, left_face, level, left_spread);
    if (wall_right) add_wall(info.name, right_face, right_face + wall_thickness, level, right_spread);
  }

  void add_wall(const std::string& gap, double from, double to, double level, PlanVector spread) {
    const double bottom = level - 0.5 * slab_thickness - bearing_height, top = level + slab_thickness;
    scene_.cells.push_back({CellKind::wall,
                            gap + " wall",
                            {point(from, bottom, -1, spread), point(to, bottom, -1, spread), point(to, top, -1, spread),
                             point(from, top, -1, spread)},
                            -1});
  }

  // In plan floors are extruded outlines, walls stand along their edges, bearings and contacts are lines.
  Scene build_in_plan() {
    for (const PlacedDiaphragm& diaphragm : model_.diaphragms()) add_floor(diaphragm);
    for (const Building& building : model_.buildings()) add_storeys_in_plan(building);
    int number = 0;
    for (const auto& block : model_.blocks())
      for (std::size_t e = 0; e < block->size(); ++e, ++number) {
        const ElementInfo& info = block->info(e);
        if (info.corner_pair() != nullptr)
          add_corner(info, *info.corner_pair(), number);
        else if (info.acts_in_two_directions())
          add_bearing(info, info.plan_places()->second, number);
      }
    return std::move(scene_);
  }

  // A point of the body of a node, of the ground for another.
  int plan_point(PlanVector at, double z, NodeId body, PlanVector spread) {
    ScenePoint point{.x = at.x, .y = at.y, .z = z, .node = body == ground ? -1 : model_.place(body), .spread = spread};
    const PlacedDiaphragm* diaphragm = body == ground ? nullptr : model_.diaphragm_of(body);
    if (diaphragm != nullptr) {
      point.on_diaphragm = true;
      point.node = model_.place(diaphragm->id.x);
      point.arm = (at - diaphragm->centre_of_mass) / diaphragm->gyration;
    } else if (body != ground) {
      point.direction = *model_.body(body).direction;
    }
    scene_.points.push_back(point);
    return static_cast<int>(scene_.points.size()) - 1;
  }

  // One spread for each corner.
  void add_prism(CellKind kind, const std::string& name, const std::vector<PlanVector>& corners,
                 const std::vector<PlanVector>& spreads, double bottom, double top, NodeId body) {
    std::vector<int> low, high;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      low.push_back(plan_point(corners[i], bottom, body, spreads[i]));
      high.push_back(plan_point(corners[i], top, body, spreads[i]));
    }
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      scene_.cells.push_back({kind, name, {low[i], low[next], high[next], high[i]}, -1});
    }
    for (std::vector<int>* face : {&low, &high}) {
      if (count == 3) face->push_back(face->back());  // a triangle as a quad
      scene_.cells.push_back({kind, name, *face, -1});
    }
  }

  void add_floor(const PlacedDiaphragm& diaphragm) {
    std::vector<PlanVector> corners;
    for (std::size_t i = 0; i < diaphragm.outline.size(); ++i) corners.push_back(diaphragm.outline.corner(i));
    if (corners.empty()) {
      const double half = diaphragm.gyration;
      for (const PlanVector& way : {PlanVector{-1, -1}, PlanVector{1, -1}, PlanVector{1, 1}, PlanVector{-1, 1}})
        corners.push_back(diaphragm.centre_of_mass + half * way);
    }
    add_prism(CellKind::floor, diaphragm.name, corners, std::vector(corners.size(), spread_of(diaphragm.id.x)),
              diaphragm.height - slab_thickness, diaphragm.height, diaphragm.id.x);
  }

  // A line at every corner of the floor above, where columns could stand.
  void add_storeys_in_plan(const Building& building) {
    NodeId below = building.base;
    for (const NodeId above : building.floors) {
      const PlacedDiaphragm* floor = model_.diaphragm_of(above);
      if (floor == nullptr) continue;
      for (std::size_t i = 0; i < floor->outline.size(); ++i) {
        const PlanVector corner = floor->outline.corner(i);
        scene_.cells.push_back({CellKind::storey,
                                "storey under " + floor->name,
                                {plan_point(corner, height_of(below), below, spread_of(above)),
                                 plan_point(corner, floor->height - slab_thickness, above, spread_of(above))},
                                -1,
                                storey(below, above)});
      }
      below = above;
    }
  }

  double height_of(NodeId body) const {
    const PlacedDiaphragm* diaphragm = model_.diaphragm_of(body);
    return diaphragm != nullptr ? diaphragm->height : 0.0;
  }

  void add_bearing(const ElementInfo& info, PlanVector at, int number) {
    const double top = height_of(info.second) - slab_thickness;
    const double bottom = info.first == ground ? top - bearing_height : height_of(info.first);
    scene_.cells.push_back({info.isolates ? CellKind::bearing : CellKind::other,
                            info.name,
                            {plan_point(at, bottom, info.first, spread_of(info.second)),
                             plan_point(at, top, info.second, spread_of(info.second))},
                            number});
  }

  // The line from a corner to the edge, and the edge as a wall unless it is that of a floor.
  void add_corner(const ElementInfo& info, const CornerPair& pair, int number) {
    const double height = info.member_ends() != nullptr ? info.member_ends()->height
                                                        : height_of(info.second != ground ? info.second : info.first);
    const double level = height - 0.5 * slab_thickness;
    const PlanVector corner_spread = spread_of(info.second);
    const bool is_wall = model_.diaphragm_of(info.first) == nullptr;
    const PlanVector clearance = info.offset * pair.normal, along = turned_left(clearance);
    const PlanVector edge_spread = is_wall ? corner_spread + clearance : spread_of(info.first);
    scene_.cells.push_back({CellKind::gap,
                            info.name,
                            {plan_point(pair.position, level, info.second, corner_spread),
                             plan_point(pair.position + clearance, level, info.first, edge_spread)},
                            number});
    const std::string& wall = pair.edge;
    const bool is_new =
        drawn_walls_.insert({wall, pair.edge_begin.x, pair.edge_begin.y, pair.edge_end.x, pair.edge_end.y}).second;
    if (!is_wall || !is_new) return;
    const PlanVector outwards = wall_thickness * pair.normal;
    // The ends of a wall go on as far as it moves away, so that walls still meet.
    const PlanVector begin_spread = edge_spread - along, end_spread = edge_spread + along;
    add_prism(CellKind::wall, wall,
              {pair.edge_begin, pair.edge_end, pair.edge_end + outwards, pair.edge_begin + outwards},
              {begin_spread, end_spread, end_spread, begin_spread}, level - 0.5 * slab_thickness - bearing_height,
              level + slab_thickness, info.first);
  }

  const Model& model_;
  const std::vector<PlanVector> spread_;  // of nodes
  Scene scene_;
  std::set<std::tuple<std::string, double, double, double, double>> drawn_walls_;  // names and ends
  std::map<std::pair<NodeId, NodeId>, int> storeys_;
  std::set<std::pair<NodeId, NodeId>> joined_;  // by elements
};

}  // namespace

Scene scene_of(const Model& model) { return SceneBuilder{model}.build(); }

}  // namespace moat
