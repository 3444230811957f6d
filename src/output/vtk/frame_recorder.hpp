// Frames of an analysis.
#pragma once

#include <filesystem>
#include <vector>

#include "model/model.hpp"
#include "output/recorders/step_observer.hpp"
#include "output/recorders/storey_shears.hpp"
#include "output/vtk/frames.hpp"
#include "output/vtk/scene.hpp"

namespace moat {

/// Writes a frame at the start, then at the first grid time at or after each multiple of the interval.
class FrameRecorder final : public StepObserver {
 public:
  /// folder: the results folder. interval: s, > 0.
  FrameRecorder(const Model& model, const std::filesystem::path& folder, double interval);

  void start(const StepView& view) override;
  void step(const StepView& view) override;

 private:
  void write(const StepView& view);

  FrameRecorder(const Model& model, const std::filesystem::path& folder, double interval, Scene scene);

  StoreyShears storey_shears_;
  FrameWriter writer_;
  double interval_;
  double next_ = 0.0;
  std::vector<double> displacement_, velocity_, acceleration_, deformation_, force_, in_contact_;
  std::vector<PlanVector> contact_force_;
};

}  // namespace moat
