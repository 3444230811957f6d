// The file of one frame, as VTK's unstructured grid.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "output/frames.hpp"
#include "output/scene.hpp"
#include "output/vtk_xml.hpp"

namespace moat {

/// A frame in memory: the parts of all frames that are equal are formatted once, and the others change from frame to
/// frame at their place.
class FrameImage {
 public:
  /// The scene must be valid.
  explicit FrameImage(const Scene& scene);
  FrameImage(const FrameImage&) = delete;
  FrameImage& operator=(const FrameImage&) = delete;

  /// The spans of `data` must be as long as the scene needs.
  void fill(double time, const FrameData& data);
  /// The file.
  [[nodiscard]] const std::vector<std::string_view>& pieces() const { return pieces_; }

 private:
  void draw();
  void declare();
  [[nodiscard]] double drift(const SceneCell& cell) const;

  const Scene& scene_;
  std::vector<double> corners_, displacement_, velocity_, acceleration_, contact_force_;  // three per point
  std::vector<std::int64_t> connectivity_, offsets_;
  std::vector<std::uint8_t> types_;
  std::vector<std::int32_t> kinds_, in_contact_;  // these and the next ones: one per cell
  std::vector<double> deformation_, force_, opening_, impact_force_, isolator_force_, drift_, storey_shear_;
  std::string names_, kind_names_;
  std::vector<double> time_;
  VtkXml file_{"UnstructuredGrid"};
  std::vector<std::string_view> pieces_;
};

}  // namespace moat
