// A model as ParaView draws it: points that move with nodes, and cells between them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/plan_vector.hpp"
#include "model/node.hpp"

namespace moat {

/// A corner of a drawn cell; z is up. On a line it moves with its node along x, the direction of shaking. In plan a
/// wall moves along its direction, and a point of a diaphragm by u_x - arm_y theta along x and u_y + arm_x theta along
/// y: `node` is then the first of the three of the diaphragm.
struct ScenePoint {
  double x = 0.0, y = 0.0, z = 0.0;  ///< m, undeformed
  int node = -1;                     ///< index; -1: fixed to the ground
  PlanVector direction{1.0, 0.0};    ///< of the node's motion
  bool on_diaphragm = false;         ///< moves with all three of a diaphragm
  PlanVector arm{};                  ///< from the centre of mass, over the diaphragm's gyration: theta times this is w
  /// m. A drawing with displacements f times larger moves the point (f - 1) times this (output/vtk/scene_spread.hpp).
  PlanVector spread{};
};

/// Written as the integer cell data `Kind`; the names are in the field data `KindNames`.
enum class CellKind { floor = 0, storey = 1, bearing = 2, gap = 3, wall = 4, other = 5 };

/// A drawn part of the model.
struct SceneCell {
  CellKind kind = CellKind::other;  ///< of the part
  std::string name;                 ///< of the element or floor
  /// Indices of 2 (line), 4 (quad, in order around it) or more (polygon) points.
  std::vector<int> points;
  int element = -1;  ///< index through all blocks; -1: none
  int storey = -1;   ///< index into Scene::storeys; -1: none
};

/// The model, drawn.
struct Scene {
  std::vector<ScenePoint> points;  ///< in the order of files
  std::vector<SceneCell> cells;    ///< in the order of files
  /// The bodies below and above each storey.
  std::vector<std::pair<NodeId, NodeId>> storeys{};
};

}  // namespace moat
