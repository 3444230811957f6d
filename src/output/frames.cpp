#include "output/frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/check.hpp"
#include "base/error.hpp"
#include "embedded/paraview_script.hpp"
#include "output/file_io.hpp"
#include "output/frame_image.hpp"
#include "output/results_folder.hpp"
#include "output/vtk_collection.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

/// How many nodes and elements a scene refers to.
struct SceneNeeds {
  std::size_t nodes, elements;
};

SceneNeeds check_scene(const Scene& scene) {
  int last_node = -1;
  int last_element = -1;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const ScenePoint& point = scene.points[i];
    const std::string number = std::to_string(i);
    const Check check{"Scene point", number};
    check.finite("x", point.x, "m");
    check.finite("y", point.y, "m");
    check.finite("z", point.z, "m");
    check.between("weight", point.weight, 0.0, 1.0, "1");
    check.that(point.node >= -1, "node", point.node, "1", "the index of a node, or -1 for the ground");
    last_node = std::max(last_node, point.on_diaphragm ? point.node + 2 : point.node);
  }
  for (const SceneCell& cell : scene.cells) {
    const Check check{"Scene cell", cell.name};
    check.that(cell.points.size() == 2 || cell.points.size() >= 4, "number of points",
               static_cast<double>(cell.points.size()), "1", "2 (line), 4 (quad) or more (polygon)");
    for (const int point : cell.points)
      check.that(point >= 0 && static_cast<std::size_t>(point) < scene.points.size(), "point", point, "1",
                 "the index of one of the " + std::to_string(scene.points.size()) + " points of the scene");
    check.that(cell.storey >= -1 && cell.storey < static_cast<int>(scene.storeys.size()), "storey", cell.storey, "1",
               "the index of one of the " + std::to_string(scene.storeys.size()) + " storeys of the scene, or -1");
    check.that(cell.element >= -1, "element", cell.element, "1", "the index of an element, or -1 for none");
    last_element = std::max(last_element, cell.element);
  }
  return {static_cast<std::size_t>(last_node + 1), static_cast<std::size_t>(last_element + 1)};
}

template <class Value>
void require_length(std::string_view name, std::span<const Value> values, std::size_t needed) {
  if (values.size() < needed)
    throw InputError{"FrameData: " + std::string{name} + " has " + std::to_string(values.size()) +
                     " values, the scene needs " + std::to_string(needed) +
                     ". Give one value per node, element or storey."};
}

}  // namespace

struct FrameWriter::Files {
  Files(const fs::path& folder_, Scene scene_)
      : scene{std::move(scene_)}, folder{folder_ / results_file::frames_folder} {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError{folder.string() + ": cannot be created (" + error.message() + ")."};
    collection = std::make_unique<VtkCollection>(folder_ / results_file::frames);
    write_file(folder_ / results_file::paraview_script, embedded::paraview_script);
  }

  Scene scene;
  SceneNeeds needs = check_scene(scene);
  FrameImage image{scene};
  fs::path folder;
  std::unique_ptr<VtkCollection> collection;  // null once finished
  int count = 0;
  double last_time = -std::numeric_limits<double>::infinity();
};

FrameWriter::FrameWriter(const fs::path& folder, Scene scene)
    : files_{std::make_unique<Files>(folder, std::move(scene))} {}
FrameWriter::~FrameWriter() = default;
FrameWriter::FrameWriter(FrameWriter&&) noexcept = default;
FrameWriter& FrameWriter::operator=(FrameWriter&&) noexcept = default;

void FrameWriter::write(double time, const FrameData& data) {
  Files& files = *files_;
  if (!files.collection) throw InputError{"FrameWriter: write() after finish(). Make a new FrameWriter."};
  Check{"FrameWriter", ""}.that(std::isfinite(time) && time > files.last_time, "time", time, "s",
                                "finite and later than the frame before (" + to_text(files.last_time) + " s)");
  require_length("node_displacement", data.node_displacement, files.needs.nodes);
  require_length("node_velocity", data.node_velocity, files.needs.nodes);
  require_length("node_absolute_acceleration", data.node_absolute_acceleration, files.needs.nodes);
  require_length("deformation", data.deformation, files.needs.elements);
  require_length("force", data.force, files.needs.elements);
  require_length("in_contact", data.in_contact, files.needs.elements);
  if (!data.contact_force.empty()) require_length("contact_force", data.contact_force, files.needs.elements);
  require_length("storey_shear", data.storey_shear, files.scene.storeys.size());

  files.image.fill(time, data);
  std::array<char, 32> name;
  std::snprintf(name.data(), name.size(), "frame_%06d.vtu", files.count);
  write_unlisted_file(files.folder / name.data(), files.image.pieces());
  files.collection->append(time, std::string{results_file::frames_folder} + "/" + name.data());
  files.last_time = time;
  ++files.count;
}

void FrameWriter::finish() { files_->collection.reset(); }

int FrameWriter::frames() const { return files_->count; }

}  // namespace moat
