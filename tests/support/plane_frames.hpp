// Frames in the plane x-z, for tests.
#pragma once

#include <vector>

#include "base/units.hpp"
#include "structures/frame/frame.hpp"

namespace moat::testing {

/// Equal bays along x, a beam on every floor, and levels tied along x.
struct PlaneFrame {
  std::vector<Length> storeys;         ///< heights, from the lowest up
  Length bay;                          ///< span of a beam
  int bays;                            ///< >= 1
  std::vector<MemberSection> columns;  ///< of each storey, or one for all
  MemberSection beam;                  ///< of all floors
  Modulus E = 206 * units::GPa;        ///< of all members
  Feet feet = Feet::clamped;           ///< below the first storey
  bool base_is_level = false;          ///< the feet are a level that is tied too
};

/// Nodes are numbered from the lowest up, and from the left.
inline Frame plane_frame(const PlaneFrame& data) {
  Frame frame{.feet = data.feet, .motion = LevelMotion::along_x};
  Length z{};
  const int lines = data.bays + 1;
  for (int storey = 0; storey <= std::ssize(data.storeys); ++storey) {
    if (storey > 0) z += data.storeys[static_cast<std::size_t>(storey - 1)];
    if (storey > 0 || data.base_is_level) frame.levels.push_back({.height = z});
    for (int line = 0; line < lines; ++line) {
      frame.nodes.push_back({.x = line * data.bay, .z = z});
      const int number = static_cast<int>(frame.nodes.size());
      if (storey == 0) continue;
      const std::size_t section = data.columns.size() == 1 ? 0 : static_cast<std::size_t>(storey - 1);
      frame.members.push_back(
          {.from = number - lines, .to = number, .section = data.columns[section], .material = {data.E}});
      if (line > 0)
        frame.members.push_back({.from = number - 1, .to = number, .section = data.beam, .material = {data.E}});
    }
  }
  return frame;
}

/// Twelve storeys and three bays of 7 m in concrete; floors of 60 t, a roof of 50 t.
inline Frame frame_of_twelve_storeys() {
  using namespace units;
  PlaneFrame data{.storeys = std::vector<Length>(12, 3.5 * m),
                  .bay = 7 * m,
                  .bays = 3,
                  .columns = {},
                  .beam = RectangularSection{.b = 0.4 * m, .h = 0.7 * m, .shear_deformation = false},
                  .E = 30 * GPa};
  data.storeys[0] = 4.5 * m;
  for (const Length side : {0.8 * m, 0.7 * m, 0.6 * m})
    data.columns.insert(data.columns.end(), 4, RectangularSection{.b = side, .h = side, .shear_deformation = false});
  Frame frame = plane_frame(data);
  for (FrameLevel& level : frame.levels) level.mass = 60 * tonne;
  frame.levels.back().mass = 50 * tonne;
  return frame;
}

}  // namespace moat::testing
