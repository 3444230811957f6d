// Animation frames of an analysis, for ParaView.
#pragma once

#include <filesystem>
#include <memory>

#include "model/model.hpp"
#include "output/recorders/step_observer.hpp"
#include "output/recorders/storey_shears.hpp"
#include "output/vtk/scene.hpp"

namespace moat {

/// Writes a frame at the start, then at the first grid time at or after each multiple of the interval:
/// frames/frame_000000.vtu ... and frames.pvd, which lists them by time, into a results folder, and beside them
/// moat.py, which draws them in ParaView: `paraview --script=moat.py`.
///
/// Without it open frames.pvd and apply Warp By Vector with `Displacement`. Point data, 3 components with x the
/// direction of shaking: `Displacement` (m), `Velocity` (m/s), `AbsoluteAcceleration` (m/s^2), and
/// `ContactForce` (N) at both ends of a gap, on the body there: draw it with the filter Glyph. Cell data: `Kind`
/// (CellKind as integer, names in the field data `KindNames`), `Deformation` (m), `Force` (N) and `InContact` (0 or 1)
/// of every element; of storeys `Drift` (m) and `StoreyShear` (N), of bearings `IsolatorForce` (N), of gaps `Opening`
/// (m) and `ImpactForce` (N). In plan a storey has a line at every corner of its floor: drift is that of the corner,
/// and drift, shear and forces of bearings are lengths of vectors. A field that a cell does not have is NaN, which
/// ParaView leaves out of colour ranges. A point that is fixed to the ground has the acceleration of the ground.
///
/// The .pvd is complete after every frame, so a run that stops early leaves a file that ParaView opens.
class FrameRecorder final : public StepObserver {
 public:
  /// folder: the results folder. interval: s, > 0. Throws InputError for another interval, and as vtk_files();
  /// FileError where the folder or frames.pvd cannot be written. start() and step() throw FileError where a frame
  /// cannot.
  FrameRecorder(const Model& model, const std::filesystem::path& folder, double interval);
  ~FrameRecorder() override;

  void start(const StepView& view) override;
  void step(const StepView& view) override;
  /// Reads the list of frames; the frames themselves lie in the folder.
  void archive(StateArchive& archive) override;

 private:
  void write(const StepView& view);

  struct Files;
  Scene scene_;
  StoreyShears storey_shears_;
  double interval_;
  double next_ = 0.0;
  std::unique_ptr<Files> files_;
};

}  // namespace moat
