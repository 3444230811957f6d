// The fields of a frame, computed from the state of an analysis.
#pragma once

#include <span>
#include <vector>

#include "output/recorders/step_observer.hpp"
#include "output/vtk/scene.hpp"

namespace moat {

/// A field with its values at all points or cells of a scene.
struct FrameField {
  const char* name;            ///< in ParaView
  std::vector<double> values;  ///< three for each point, or one for each cell
};

/// The fields that change from frame to frame, as FrameRecorder describes them.
struct FrameFields {
  double time;                        ///< s
  std::vector<FrameField> of_points;  ///< vectors
  std::vector<FrameField> of_cells;   ///< numbers
};

/// Returns the fields of a scene of the model. storey_shears: N, one for each of its storeys.
FrameFields fields_of(const Scene& scene, const StepView& view, std::span<const double> storey_shears);

}  // namespace moat
