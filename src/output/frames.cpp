#include "output/frames.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <vector>

#include "base/check.hpp"
#include "base/error.hpp"
#include "output/classic_locale.hpp"
#include "output/file_io.hpp"
#include "output/results_folder.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

constexpr std::array kind_names{"floor", "storey", "bearing", "gap", "wall", "other"};
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view collection_start =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n<Collection>\n";
constexpr std::string_view collection_end = "</Collection>\n</VTKFile>\n";

/// The .pvd file. Each entry goes over the closing tags together with new ones in a single write.
class Collection {
 public:
  explicit Collection(const fs::path& path) : path_{path} {
    write_file(path, std::string{collection_start}.append(collection_end));
    end_ = collection_start.size();
    file_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    file_.open(path, std::ios::in | std::ios::out | std::ios::binary);
    require_good();
  }

  void append(double time, const std::string& file_name) {
    std::array<char, 32> digits;
    const auto digits_end = std::to_chars(digits.data(), digits.data() + digits.size(), time).ptr;
    std::string entry = "<DataSet timestep=\"" + std::string(digits.data(), digits_end) + "\" part=\"0\" file=\"" +
                        file_name + "\"/>\n";
    const std::size_t length = entry.size();
    entry += collection_end;
    file_.seekp(static_cast<std::streamoff>(end_));
    file_.write(entry.data(), static_cast<std::streamsize>(entry.size()));
    file_.flush();
    require_good();
    end_ += length;
  }

 private:
  void require_good() const {
    if (!file_) throw FileError{path_.string() + ": cannot be written. Check the folder's rights and the disk space."};
  }

  fs::path path_;
  std::array<char, 1024> buffer_;
  std::fstream file_;
  std::size_t end_ = 0;
};

vtkDoubleArray* add(vtkDataSetAttributes* data, const char* name, int components, std::size_t count) {
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(static_cast<vtkIdType>(count));
  values->FillValue(0.0);
  data->AddArray(values);
  return values;  // owned by the grid from here on
}

/// Checks the scene; returns how many nodes and elements it refers to.
std::pair<std::size_t, std::size_t> check_scene(const Scene& scene) {
  int last_node = -1;
  int last_element = -1;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const ScenePoint& point = scene.points[i];
    const Check check{"Scene point", std::to_string(i)};
    check.finite("x", point.x, "m");
    check.finite("y", point.y, "m");
    check.finite("z", point.z, "m");
    check.between("weight", point.weight, 0.0, 1.0, "1");
    check.that(point.node >= -1, "node", point.node, "1", "the index of a node, or -1 for the ground");
    last_node = std::max(last_node, point.node);
  }
  for (const SceneCell& cell : scene.cells) {
    const Check check{"Scene cell", cell.name};
    check.that(cell.points.size() == 2 || cell.points.size() == 4, "number of points",
               static_cast<double>(cell.points.size()), "1", "2 (line) or 4 (quad)");
    for (const int point : cell.points)
      check.that(point >= 0 && static_cast<std::size_t>(point) < scene.points.size(), "point", point, "1",
                 "the index of one of the " + std::to_string(scene.points.size()) + " points of the scene");
    check.that(cell.element >= -1, "element", cell.element, "1", "the index of an element, or -1 for none");
    last_element = std::max(last_element, cell.element);
  }
  return {static_cast<std::size_t>(last_node + 1), static_cast<std::size_t>(last_element + 1)};
}

void require_length(std::string_view name, std::span<const double> values, std::size_t needed) {
  if (values.size() < needed)
    throw InputError{"FrameData: " + std::string{name} + " has " + std::to_string(values.size()) +
                     " values, the scene needs " + std::to_string(needed) + ". Give one value per node or element."};
}

}  // namespace

struct FrameWriter::Files {
  Files(const fs::path& folder_, Scene scene_)
      : scene{std::move(scene_)}, folder{folder_ / results_file::frames_folder} {
    std::tie(nodes, elements) = check_scene(scene);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError{folder.string() + ": cannot be created (" + error.message() + ")."};
    collection = std::make_unique<Collection>(folder_ / results_file::frames);
    build_grid();
    writer->SetInputData(grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToNone();
    writer->WriteToOutputStringOn();
  }

  void build_grid() {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const ScenePoint& point : scene.points) points->InsertNextPoint(point.x, point.y, point.z);
    grid->SetPoints(points);

    vtkNew<vtkIntArray> kinds;
    kinds->SetName("Kind");
    vtkNew<vtkStringArray> names;
    names->SetName("Name");
    for (const SceneCell& cell : scene.cells) {
      const std::vector<vtkIdType> ids(cell.points.begin(), cell.points.end());
      grid->InsertNextCell(ids.size() == 2 ? VTK_LINE : VTK_QUAD, static_cast<vtkIdType>(ids.size()), ids.data());
      kinds->InsertNextValue(static_cast<int>(cell.kind));
      names->InsertNextValue(cell.name);
    }
    displacement = add(grid->GetPointData(), "Displacement", 3, scene.points.size());
    velocity = add(grid->GetPointData(), "Velocity", 3, scene.points.size());
    acceleration = add(grid->GetPointData(), "AbsoluteAcceleration", 3, scene.points.size());
    grid->GetCellData()->AddArray(kinds);
    grid->GetCellData()->AddArray(names);
    deformation = add(grid->GetCellData(), "Deformation", 1, scene.cells.size());
    force = add(grid->GetCellData(), "Force", 1, scene.cells.size());
    opening = add(grid->GetCellData(), "Opening", 1, scene.cells.size());
    vtkNew<vtkIntArray> contact;
    contact->SetName("InContact");
    contact->SetNumberOfValues(static_cast<vtkIdType>(scene.cells.size()));
    grid->GetCellData()->AddArray(contact);
    in_contact = contact;

    vtkNew<vtkDoubleArray> time;
    time->SetName("TimeValue");
    time->SetNumberOfValues(1);
    grid->GetFieldData()->AddArray(time);
    time_value = time;
    vtkNew<vtkStringArray> kind_list;
    kind_list->SetName("KindNames");
    for (const char* name : kind_names) kind_list->InsertNextValue(name);
    grid->GetFieldData()->AddArray(kind_list);
  }

  void fill(double time, const FrameData& data) {
    double* u = displacement->GetPointer(0);
    double* v = velocity->GetPointer(0);
    double* a = acceleration->GetPointer(0);
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      const ScenePoint& point = scene.points[i];
      const bool fixed = point.node < 0;
      const auto node = static_cast<std::size_t>(fixed ? 0 : point.node);
      const double w = fixed ? 0.0 : point.weight;
      u[3 * i] = fixed ? 0.0 : w * data.node_displacement[node];
      v[3 * i] = fixed ? 0.0 : w * data.node_velocity[node];
      a[3 * i] = fixed ? data.ground_acceleration
                       : w * data.node_absolute_acceleration[node] + (1.0 - w) * data.ground_acceleration;
    }
    for (std::size_t i = 0; i < scene.cells.size(); ++i) {
      const SceneCell& cell = scene.cells[i];
      const bool has_element = cell.element >= 0;
      const auto element = static_cast<std::size_t>(has_element ? cell.element : 0);
      const auto id = static_cast<vtkIdType>(i);
      deformation->SetValue(id, has_element ? data.deformation[element] : no_value);
      force->SetValue(id, has_element ? data.force[element] : no_value);
      opening->SetValue(id, has_element && cell.kind == CellKind::gap ? data.deformation[element] : no_value);
      in_contact->SetValue(id, has_element && data.in_contact[element] != 0.0 ? 1 : 0);
    }
    time_value->SetValue(0, time);
    // The writer computes ranges, which VTK caches by modification time.
    for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{displacement, velocity, acceleration, deformation,
                                                                    force, opening, in_contact, time_value})
      array->Modified();
  }

  Scene scene;
  fs::path folder;
  std::size_t nodes = 0;
  std::size_t elements = 0;
  std::unique_ptr<Collection> collection;  // null once finished
  int count = 0;
  double last_time = -std::numeric_limits<double>::infinity();

  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  vtkDoubleArray* displacement = nullptr;
  vtkDoubleArray* velocity = nullptr;
  vtkDoubleArray* acceleration = nullptr;
  vtkDoubleArray* deformation = nullptr;
  vtkDoubleArray* force = nullptr;
  vtkDoubleArray* opening = nullptr;
  vtkIntArray* in_contact = nullptr;
  vtkDoubleArray* time_value = nullptr;
};

FrameWriter::FrameWriter(const fs::path& folder, Scene scene)
    : files_{std::make_unique<Files>(folder, std::move(scene))} {}
FrameWriter::~FrameWriter() = default;
FrameWriter::FrameWriter(FrameWriter&&) noexcept = default;
FrameWriter& FrameWriter::operator=(FrameWriter&&) noexcept = default;

void FrameWriter::write(double time, const FrameData& data) {
  const ClassicLocale classic;
  Files& files = *files_;
  if (!files.collection) throw InputError{"FrameWriter: write() after finish(). Make a new FrameWriter."};
  Check{"FrameWriter", ""}.that(std::isfinite(time) && time > files.last_time, "time", time, "s",
                                "finite and later than the frame before (" + to_text(files.last_time) + " s)");
  require_length("node_displacement", data.node_displacement, files.nodes);
  require_length("node_velocity", data.node_velocity, files.nodes);
  require_length("node_absolute_acceleration", data.node_absolute_acceleration, files.nodes);
  require_length("deformation", data.deformation, files.elements);
  require_length("force", data.force, files.elements);
  require_length("in_contact", data.in_contact, files.elements);

  files.fill(time, data);
  std::array<char, 32> name;
  std::snprintf(name.data(), name.size(), "frame_%06d.vtu", files.count);
  const fs::path path = files.folder / name.data();
  if (files.writer->Write() == 0) throw FileError{path.string() + ": VTK could not encode the frame."};
  write_file(path, files.writer->GetOutputString());
  files.collection->append(time, std::string{results_file::frames_folder} + "/" + name.data());
  files.last_time = time;
  ++files.count;
}

void FrameWriter::finish() { files_->collection.reset(); }

int FrameWriter::frames() const { return files_->count; }

}  // namespace moat
