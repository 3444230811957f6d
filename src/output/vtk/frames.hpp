// Animation frames for ParaView.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "output/vtk/scene.hpp"

namespace moat {

/// The state of a model at one time, SI units. The three node spans have one value per node of the scene, the
/// three element spans one per element, storey_shear one per storey; they are only read during FrameWriter::write.
struct FrameData {
  std::span<const double> node_displacement;           ///< m, relative to the ground
  std::span<const double> node_velocity;               ///< m/s, relative to the ground
  std::span<const double> node_absolute_acceleration;  ///< m/s^2
  std::span<const double> deformation;                 ///< m; of a gap its opening, negative while indented
  std::span<const double> force;                       ///< N
  std::span<const double> in_contact;                  ///< 1 in contact, 0 not
  double ground_acceleration = 0.0;                    ///< m/s^2, of points fixed to the ground, along x
  double ground_acceleration_y = 0.0;                  ///< along y; 0 on a line
  /// N, one per element: of a contact on the body of the first point of its cell, the left one or the corner; friction
  /// included. Empty: none are drawn.
  std::span<const PlanVector> contact_force{};
  std::span<const double> storey_shear{};  ///< N, of all elements between the same floors
};

/// Writes frames/frame_000000.vtu ... and frames.pvd, which lists them by time, into a results folder, and beside them
/// moat.py, which draws them in ParaView: `paraview --script=moat.py`.
///
/// Without it open frames.pvd and apply Warp By Vector with `Displacement`. Point data, 3 components with x the
/// direction of shaking: `Displacement` (m), `Velocity` (m/s), `AbsoluteAcceleration` (m/s^2), and
/// `ContactForce` (N) at both ends of a gap, on the body there: draw it with the filter Glyph. Cell data: `Kind`
/// (CellKind as integer, names in the field data `KindNames`), `Deformation` (m), `Force` (N) and `InContact` (0 or 1)
/// of every element; of storeys `Drift` (m) and `StoreyShear` (N), of bearings `IsolatorForce` (N), of gaps `Opening`
/// (m) and `ImpactForce` (N). In plan a storey has a line at every corner of its floor: drift is that of the corner,
/// and drift, shear and forces of bearings are lengths of vectors. A field that a cell does not have is NaN, which
/// ParaView leaves out of colour ranges. A point of weight w shows w times the motion of its node; its absolute
/// acceleration is w times that of the node plus (1 - w) times that of the ground.
///
/// The .pvd is complete after every frame, so a run that stops early leaves a file that ParaView opens.
class FrameWriter {
 public:
  /// Creates `folder`/frames and an empty `folder`/frames.pvd. Throws InputError where a cell has neither 2 nor 4
  /// or more points, a point does not exist, an index is below -1, or a weight lies outside 0 to 1, and as vtk_files();
  /// FileError where the folder or the file cannot be written.
  FrameWriter(const std::filesystem::path& folder, Scene scene);
  ~FrameWriter();
  FrameWriter(FrameWriter&&) noexcept;
  FrameWriter& operator=(FrameWriter&&) noexcept;

  /// Writes one frame at `time`, s, which must be later than that of the frame before. Throws InputError where it is
  /// not, and where a span is shorter than the scene needs; FileError where the frame cannot be written.
  void write(double time, const FrameData& data);

  /// Number of frames written.
  [[nodiscard]] int frames() const;

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

}  // namespace moat
