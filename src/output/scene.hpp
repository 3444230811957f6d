// A model as ParaView draws it: points that move with nodes, and cells between them.
#pragma once

#include <string>
#include <vector>

namespace moat {

/// A corner of a drawn cell. It is displaced by weight * u of its node along x, the direction of shaking; z is up.
struct ScenePoint {
  double x = 0.0, y = 0.0, z = 0.0;  ///< m, undeformed
  int node = -1;                     ///< index into the spans of FrameData; -1: fixed to the ground
  double weight = 1.0;               ///< share of the node's motion, 0 (ground) to 1
};

/// Written as the integer cell data `Kind`; the names are in the field data `KindNames`.
enum class CellKind { floor = 0, storey = 1, bearing = 2, gap = 3, wall = 4, other = 5 };

struct SceneCell {
  CellKind kind = CellKind::other;
  std::string name;
  std::vector<int> points;  ///< indices of 2 (line) or 4 (quad, in order around it) points
  int element = -1;         ///< index into the per-element spans of FrameData; -1: none
};

struct Scene {
  std::vector<ScenePoint> points;
  std::vector<SceneCell> cells;
};

}  // namespace moat
