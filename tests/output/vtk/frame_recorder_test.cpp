#include "output/vtk/frame_recorder.hpp"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <map>
#include <string>
#include <thread>

#include "analyses/time_history/transient.hpp"
#include "elements/contact/corner_gap.hpp"
#include "output/vtk/model_scene.hpp"
#include "output_testing.hpp"
#include "recorders_testing.hpp"
#include "small_models.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing_output::HandMovedBuilding;
using testing_output::message_of;
using testing_output::parse_xml;
using testing_output::read_file;

class FrameRecorderTest : public testing_output::InFolder {
 protected:
  HandMovedBuilding building;
};

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const fs::path& path) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

TEST_F(FrameRecorderTest, FieldsReadBackUnchanged) {
  building.move(0.3, 0.12, -0.3);
  std::vector<RegimeChange> touch;
  building.state->change_regimes(touch);
  FrameRecorder recorder{building.model, folder, 0.1};
  recorder.start(building.move(1.0 / 3.0, 0.12, -0.3, 4.0, 8.0, 2.0));
  const Scene scene = scene_of(building.model);
  const auto grid = read_grid(folder / "frames/frame_000000.vtu");
  ASSERT_EQ(grid->GetNumberOfPoints(), std::ssize(scene.points));
  ASSERT_EQ(grid->GetNumberOfCells(), std::ssize(scene.cells));
  // By the index of the node; -1 is the ground.
  const std::map<std::string, std::map<int, double>> expected{
      {"Displacement", {{0, 0.12}, {1, -0.3}, {-1, 0.0}}},
      {"Velocity", {{0, 0.1 * 0.12}, {1, 0.1 * -0.3}, {-1, 0.0}}},
      {"AbsoluteAcceleration", {{0, 6.0}, {1, 10.0}, {-1, 2.0}}}};
  vtkCellData* cells = grid->GetCellData();
  vtkDataArray* contact_force = grid->GetPointData()->GetArray("ContactForce");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
    const ScenePoint& point = scene.points[static_cast<std::size_t>(i)];
    EXPECT_EQ(grid->GetPoint(i)[0], point.x);
    EXPECT_EQ(grid->GetPoint(i)[2], point.z);
    for (const auto& [name, of_node] : expected) {
      vtkDataArray* array = grid->GetPointData()->GetArray(name.c_str());
      ASSERT_EQ(array->GetNumberOfComponents(), 3);
      EXPECT_EQ(array->GetComponent(i, 0), of_node.at(point.node)) << name << i;
      EXPECT_EQ(array->GetComponent(i, 1), 0.0);
    }
  }

  // Each field belongs to one kind of cell.
  const std::map<std::string, CellKind> kind_of_field{{"Drift", CellKind::storey},
                                                      {"StoreyShear", CellKind::storey},
                                                      {"IsolatorForce", CellKind::bearing},
                                                      {"Opening", CellKind::gap},
                                                      {"ImpactForce", CellKind::gap}};
  auto* names = vtkStringArray::SafeDownCast(cells->GetAbstractArray("Name"));
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
    const SceneCell& cell = scene.cells[static_cast<std::size_t>(i)];
    const auto value = [&](const char* name) { return cells->GetArray(name)->GetComponent(i, 0); };
    EXPECT_EQ(grid->GetCellType(i), cell.kind == CellKind::gap ? VTK_LINE : VTK_QUAD);
    EXPECT_EQ(grid->GetCell(i)->GetPointId(1), cell.points[1]);
    EXPECT_EQ(names->GetValue(i), cell.name);
    EXPECT_EQ(value("Kind"), static_cast<double>(cell.kind));
    EXPECT_EQ(std::isnan(value("Force")), cell.element < 0) << cell.name;
    for (const auto& [name, kind] : kind_of_field)
      EXPECT_EQ(std::isnan(value(name.c_str())), cell.kind != kind) << name << " of " << cell.name;
    EXPECT_EQ(value("InContact"), cell.name == "moat right" ? 1.0 : 0.0) << cell.name;
    if (cell.kind == CellKind::storey) {
      EXPECT_DOUBLE_EQ(value("Drift"), -0.3 - 0.12);
      EXPECT_DOUBLE_EQ(value("StoreyShear"), 100.0 * (-0.3 - 0.12)) << "without the damper";
    }
    if (cell.kind == CellKind::bearing) {
      EXPECT_EQ(value("IsolatorForce"), value("Force"));
      EXPECT_DOUBLE_EQ(value("Deformation"), 0.12);
    }
    if (cell.kind != CellKind::gap) continue;
    const double force = value("ImpactForce");
    EXPECT_NEAR(value("Opening"), cell.name == "moat right" ? -0.02 : 0.22, 1e-12);
    EXPECT_EQ(force > 0.0, cell.name == "moat right");
    // At both ends of the gap, on the body there.
    EXPECT_EQ(contact_force->GetComponent(cell.points[0], 0), 0.0 - force);
    EXPECT_EQ(contact_force->GetComponent(cell.points[1], 0), force);
  }
  vtkFieldData* fields = grid->GetFieldData();
  EXPECT_EQ(fields->GetArray("TimeValue")->GetComponent(0, 0), 1.0 / 3.0);
  auto* kinds = vtkStringArray::SafeDownCast(fields->GetAbstractArray("KindNames"));
  EXPECT_EQ(kinds->GetValue(static_cast<int>(CellKind::floor)), "floor");
  EXPECT_EQ(kinds->GetValue(static_cast<int>(CellKind::other)), "other");
}

// The times of the frames that frames.pvd lists, whose files must exist, s.
std::vector<double> listed_times(const fs::path& folder) {
  const auto root = parse_xml(read_file(folder / "frames.pvd"));
  if (root == nullptr) throw Error{"frames.pvd is not XML"};
  EXPECT_STREQ(root->GetName(), "VTKFile");
  EXPECT_STREQ(root->GetAttribute("type"), "Collection");
  vtkXMLDataElement* list = root->FindNestedElementWithName("Collection");
  std::vector<double> times;
  for (int i = 0; i < list->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* entry = list->GetNestedElement(i);
    times.push_back(std::stod(entry->GetAttribute("timestep")));
    EXPECT_TRUE(fs::exists(folder / entry->GetAttribute("file"))) << entry->GetAttribute("file");
  }
  return times;
}

TEST_F(FrameRecorderTest, CollectionIsCompleteWhereTheRunIsKilled) {
  std::size_t most = 0;
  for (int i = 0; i < 20; ++i) {
    const fs::path run = folder / std::to_string(i);
    const pid_t child = ::fork();
    if (child == 0) {
      FrameRecorder recorder{building.model, run, 0.1};
      for (int frame = 0;; ++frame) recorder.step(building.move(0.1 * frame, 0.0, 0.0));
    }
    // The run is killed while it writes one of the frames behind this one, however slow the machine is.
    char frame_name[32];
    std::snprintf(frame_name, sizeof frame_name, "frames/frame_%06d.vtu", i);
    while (!fs::exists(run / frame_name)) std::this_thread::yield();
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::vector<double> times = listed_times(run);
    for (std::size_t frame = 0; frame < times.size(); ++frame)
      EXPECT_EQ(times[frame], 0.1 * static_cast<double>(frame));
    most = std::max(most, times.size());
    for (const auto& entry : fs::directory_iterator{run / "frames"})
      if (entry.path().extension() == ".vtu") {
        ASSERT_GT(read_grid(entry.path())->GetNumberOfPoints(), 8) << entry;
      }
  }
  EXPECT_GT(most, 10u);
}

TEST_F(FrameRecorderTest, AFileThatCannotBeWrittenIsAnError) {
  FrameRecorder recorder{building.model, folder, 0.1};
  // A folder of this name cannot be replaced by a file.
  fs::create_directories(folder / "frames/frame_000001.vtu/in the way");
  recorder.start(building.move(0.0, 0.0, 0.0));
  EXPECT_NE(message_of<FileError>([&] { recorder.step(building.move(1.0, 0.0, 0.0)); }).find("frame_000001.vtu"),
            std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "frames/frame_000000.vtu"));
  std::ofstream{folder / "file"} << "in the way";
  EXPECT_THROW((FrameRecorder{building.model, folder / "file", 0.1}), FileError);
}

TEST_F(FrameRecorderTest, WritesAFrameAtTheStartAndThenAtItsInterval) {
  for (const int steps : {50, 10}) {  // a shorter list takes the place of a longer one
    FrameRecorder recorder{building.model, folder, 0.1};
    recorder.start(building.move(0.0, 0.0, 0.0));
    for (int i = 1; i <= steps; ++i) recorder.step(building.move(0.04 * i, 0.0, 0.0));
  }
  // 0, then the first steps at or after 0.1, 0.2, 0.3 and 0.4 s.
  EXPECT_EQ(listed_times(folder), (std::vector<double>{0.0, 0.12, 0.2, 0.32, 0.4}));
}

TEST_F(FrameRecorderTest, GoesOnBehindTheFramesBefore) {
  StateArchive archive;
  FrameRecorder killed{building.model, folder, 0.1};
  killed.start(building.move(0.0, 0.0, 0.0));
  killed.archive(archive);
  const std::string state = archive.take();
  const auto go_on = [&] {
    StateArchive saved{state};
    FrameRecorder recorder{building.model, folder, 0.1};
    recorder.archive(saved);
    recorder.step(building.move(0.1, 0.0, 0.0));
  };
  go_on();
  EXPECT_EQ(listed_times(folder), (std::vector<double>{0.0, 0.1}));
  fs::remove(folder / "frames/frame_000000.vtu");  // while that of 0.1 s stays
  EXPECT_NE(message_of<FileError>(go_on).find("frame_000000.vtu: this frame from before the checkpoint is not there"),
            std::string::npos);
  EXPECT_TRUE(listed_times(folder).empty());
}

TEST_F(FrameRecorderTest, RefusesAnIntervalBeforeItWritesAnything) {
  EXPECT_EQ(message_of<InputError>([&] { FrameRecorder(building.model, folder / "new", -1.0); }),
            "FrameRecorder: interval = -1 s is not allowed; it must be > 0 s and finite. Check its sign and its unit.");
  EXPECT_FALSE(fs::exists(folder / "new"));
}

TEST_F(FrameRecorderTest, ForcesOfCornersPushThemBackAndAgainstTheirSlide) {
  using namespace units;
  Model model;
  const DiaphragmId slab = add(model, Diaphragm{.name = "slab",
                                                .mass = 800 * tonne,
                                                .outline = rectangle(20 * m, 12 * m),
                                                .initial_velocity_x = 0.6 * m / s,
                                                .initial_velocity_y = 0.6 * m / s});
  add(model, CornerGap<HertzDamp>{.name = "corner",
                                  .corner = PlanPoint{slab, {10 * m, 6 * m}},
                                  .edge_of = ground,
                                  .edge_begin = PlanPosition{10.01 * m, -8 * m},
                                  .edge_end = PlanPosition{10.01 * m, 8 * m},
                                  .law = {.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                                  .friction = 0.4});
  Transient analysis{model, testing::still_ground(0.1 * units::s, 5 * units::ms)};
  FrameRecorder recorder{model, folder, 0.005};
  analysis.attach(recorder);
  analysis.run();
  int pushed = 0;
  for (const auto& entry : fs::directory_iterator{folder / "frames"}) {
    const auto grid = read_grid(entry.path());
    vtkDataArray* forces = grid->GetPointData()->GetArray("ContactForce");
    vtkDataArray* normal = grid->GetCellData()->GetArray("Force");
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
      vtkCell* cell = grid->GetCell(i);
      if (cell->GetNumberOfPoints() != 2 || !(normal->GetComponent(i, 0) > 0.0)) continue;
      const double force = normal->GetComponent(i, 0);
      const vtkIdType corner = cell->GetPointId(0), wall = cell->GetPointId(1);
      EXPECT_DOUBLE_EQ(forces->GetComponent(corner, 0), -force);
      EXPECT_DOUBLE_EQ(forces->GetComponent(corner, 1), -0.4 * force);
      EXPECT_DOUBLE_EQ(forces->GetComponent(wall, 0), force);
      EXPECT_DOUBLE_EQ(forces->GetComponent(wall, 1), 0.4 * force);
      ++pushed;
    }
  }
  EXPECT_GT(pushed, 3);
}

}  // namespace
}  // namespace moat
