// The fields of a frame, computed from the state of the model.
#pragma once

#include <vector>

#include "output/vtk/frames.hpp"
#include "output/vtk/scene.hpp"

namespace moat {

/// A field with its values at all points or cells of a scene.
struct FrameField {
  const char* name;            ///< in ParaView
  std::vector<double> values;  ///< three for each point, or one for each cell
};

/// The fields that change from frame to frame, as FrameWriter describes them.
struct FrameFields {
  double time;                        ///< s
  std::vector<FrameField> of_points;  ///< vectors
  std::vector<FrameField> of_cells;   ///< numbers
};

/// The scene must be valid, and the spans of `data` as long as it needs.
FrameFields fields_of(const Scene& scene, double time, const FrameData& data);

}  // namespace moat
