#include "output/vtk/frames.hpp"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "analyses/time_history/transient.hpp"
#include "elements/contact/corner_gap.hpp"
#include "materials/impact/hertz_damp.hpp"
#include "output/vtk/frame_recorder.hpp"
#include "output_testing.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing_output::message_of;
using testing_output::parse_xml;
using testing_output::read_file;

class Frames : public testing_output::InFolder {};

/// A base on a bearing beside a wall, with one storey above it.
Scene small_scene() {
  Scene scene;
  scene.points = {{.x = -1.0, .z = 0.0, .node = 0},
                  {.x = 1.0, .z = 0.0, .node = 0},
                  {.x = -1.0, .z = 3.0, .node = 1},
                  {.x = 1.0, .z = 3.0, .node = 1},
                  {.x = -1.0, .z = -0.5, .node = -1},
                  {.x = -2.0, .z = 0.0, .node = -1},
                  {.x = -1.0, .z = -0.2, .node = 0, .weight = 0.25}};
  scene.cells = {{CellKind::storey, "storey 1", {0, 1, 3, 2}, 0, 0},
                 {CellKind::bearing, "bearing", {4, 6}, 1},
                 {CellKind::gap, "moat left", {5, 0}, 2},
                 {CellKind::wall, "wall left", {4, 5}, -1}};
  scene.storeys = {{NodeId{0}, NodeId{1}}};
  return scene;
}

struct Values {
  std::array<double, 2> u{0.1, -0.3}, v{1.0 / 3.0, 2.0}, a{4.0, 8.0};
  std::array<double, 3> deformation{0.01, 0.02, -0.003}, force{1e6, 2e6, -3e7}, in_contact{0.0, 0.0, 1.0};
  std::array<PlanVector, 3> contact_force{{{7.0, 7.0}, {8.0, 8.0}, {-3e7, 4e6}}};
  std::array<double, 1> shear{7e5};
  [[nodiscard]] FrameData data() const {
    return {u, v, a, deformation, force, in_contact, 2.0, 0.0, contact_force, shear};
  }
};

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const fs::path& path) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

TEST_F(Frames, ReadBackUnchanged) {
  const Values values;
  FrameWriter writer{folder, small_scene()};
  writer.write(0.0, FrameData{values.v, values.v, values.v, values.force, values.force, values.force, 0.0, 0.0,
                              values.contact_force, values.shear});
  writer.write(1.0 / 3.0, values.data());
  EXPECT_EQ(writer.frames(), 2);

  const auto grid = read_grid(folder / "frames" / "frame_000001.vtu");
  ASSERT_EQ(grid->GetNumberOfPoints(), 7);
  ASSERT_EQ(grid->GetNumberOfCells(), 4);
  EXPECT_EQ(grid->GetPoint(3)[0], 1.0);
  EXPECT_EQ(grid->GetPoint(3)[2], 3.0);
  EXPECT_EQ(grid->GetCellType(0), VTK_QUAD);
  EXPECT_EQ(grid->GetCellType(1), VTK_LINE);
  EXPECT_EQ(grid->GetCell(0)->GetPointId(2), 3);

  struct Expected {
    const char* name;
    std::array<double, 7> x;
  };
  const std::array<Expected, 3> expected{
      {{"Displacement", {0.1, 0.1, -0.3, -0.3, 0.0, 0.0, 0.25 * 0.1}},
       {"Velocity", {1.0 / 3.0, 1.0 / 3.0, 2.0, 2.0, 0.0, 0.0, 0.25 * (1.0 / 3.0)}},
       {"AbsoluteAcceleration", {4.0, 4.0, 8.0, 8.0, 2.0, 2.0, 0.25 * 4.0 + 0.75 * 2.0}}}};
  for (const Expected& field : expected) {
    vtkDataArray* array = grid->GetPointData()->GetArray(field.name);
    ASSERT_NE(vtkDoubleArray::SafeDownCast(array), nullptr) << field.name;
    ASSERT_EQ(array->GetNumberOfComponents(), 3);
    for (vtkIdType point = 0; point < 7; ++point) {
      EXPECT_EQ(array->GetComponent(point, 0), field.x[static_cast<std::size_t>(point)]) << field.name << point;
      EXPECT_EQ(array->GetComponent(point, 1), 0.0);
      EXPECT_EQ(array->GetComponent(point, 2), 0.0);
    }
  }

  // At both ends of the gap, on the body there.
  vtkDataArray* contact_force = grid->GetPointData()->GetArray("ContactForce");
  ASSERT_NE(vtkDoubleArray::SafeDownCast(contact_force), nullptr);
  for (vtkIdType point = 0; point < 7; ++point) {
    const double sign = point == 5 ? 1.0 : point == 0 ? -1.0 : 0.0;
    EXPECT_EQ(contact_force->GetComponent(point, 0), sign * -3e7) << point;
    EXPECT_EQ(contact_force->GetComponent(point, 1), sign * 4e6) << point;
    EXPECT_EQ(contact_force->GetComponent(point, 2), 0.0);
  }

  vtkCellData* cells = grid->GetCellData();
  const auto cell_value = [&](const char* name, vtkIdType cell) {
    return cells->GetArray(name)->GetComponent(cell, 0);
  };
  const std::array kinds{1, 2, 3, 4};
  for (vtkIdType cell = 0; cell < 4; ++cell) EXPECT_EQ(cell_value("Kind", cell), kinds[static_cast<std::size_t>(cell)]);
  for (vtkIdType cell = 0; cell < 3; ++cell) {
    EXPECT_EQ(cell_value("Deformation", cell), values.deformation[static_cast<std::size_t>(cell)]);
    EXPECT_EQ(cell_value("Force", cell), values.force[static_cast<std::size_t>(cell)]);
    EXPECT_EQ(cell_value("InContact", cell), values.in_contact[static_cast<std::size_t>(cell)]);
  }
  // Each field belongs to one kind of cell: storey 0, bearing 1, gap 2.
  struct OfOneKind {
    const char* name;
    vtkIdType cell;
    double value;
  };
  for (const OfOneKind& field :
       {OfOneKind{"Opening", 2, -0.003}, OfOneKind{"ImpactForce", 2, -3e7}, OfOneKind{"IsolatorForce", 1, 2e6},
        OfOneKind{"StoreyShear", 0, 7e5}, OfOneKind{"Drift", 0, -0.3 - 0.1}})
    for (vtkIdType cell = 0; cell < 4; ++cell)
      if (cell == field.cell)
        EXPECT_EQ(cell_value(field.name, cell), field.value) << field.name;
      else
        EXPECT_TRUE(std::isnan(cell_value(field.name, cell))) << field.name << cell;
  EXPECT_TRUE(std::isnan(cell_value("Deformation", 3)));
  EXPECT_TRUE(std::isnan(cell_value("Force", 3)));
  EXPECT_EQ(cell_value("InContact", 3), 0.0);
  EXPECT_EQ(vtkStringArray::SafeDownCast(cells->GetAbstractArray("Name"))->GetValue(2), "moat left");

  vtkFieldData* fields = grid->GetFieldData();
  EXPECT_EQ(fields->GetArray("TimeValue")->GetComponent(0, 0), 1.0 / 3.0);
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("KindNames"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(static_cast<int>(CellKind::floor)), "floor");
  EXPECT_EQ(names->GetValue(static_cast<int>(CellKind::bearing)), "bearing");
  EXPECT_EQ(names->GetValue(static_cast<int>(CellKind::other)), "other");
}

// The frames that frames.pvd lists, whose files must exist, at the times 0, 0.1, 0.2, ... s.
int listed_frames(const fs::path& folder) {
  const auto root = parse_xml(read_file(folder / "frames.pvd"));
  if (root == nullptr) throw Error{"frames.pvd is not XML"};
  EXPECT_STREQ(root->GetName(), "VTKFile");
  EXPECT_STREQ(root->GetAttribute("type"), "Collection");
  vtkXMLDataElement* list = root->FindNestedElementWithName("Collection");
  const int listed = list->GetNumberOfNestedElements();
  for (int i = 0; i < listed; ++i) {
    vtkXMLDataElement* entry = list->GetNestedElement(i);
    EXPECT_EQ(std::stod(entry->GetAttribute("timestep")), 0.1 * i);
    EXPECT_TRUE(fs::exists(folder / entry->GetAttribute("file"))) << entry->GetAttribute("file");
  }
  return listed;
}

TEST_F(Frames, CollectionListsEveryFrame) {
  const Values values;
  FrameWriter writer{folder, small_scene()};
  for (int i = 0; i < 12; ++i) writer.write(0.1 * i, values.data());
  EXPECT_EQ(listed_frames(folder), 12);
}

TEST_F(Frames, CollectionIsCompleteWhereTheRunIsKilled) {
  int most = 0;
  for (int i = 0; i < 20; ++i) {
    const fs::path run = folder / std::to_string(i);
    fs::create_directories(run);
    const pid_t child = ::fork();
    if (child == 0) {
      const Values values;
      FrameWriter writer{run, small_scene()};
      for (int frame = 0;; ++frame) writer.write(0.1 * frame, values.data());
    }
    while (!fs::exists(run / "moat.py")) std::this_thread::yield();  // the last file that is made before the frames
    std::this_thread::sleep_for(std::chrono::milliseconds{i});
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    most = std::max(most, listed_frames(run));
    for (const auto& entry : fs::directory_iterator{run / "frames"})
      if (entry.path().extension() == ".vtu") {
        ASSERT_EQ(read_grid(entry.path())->GetNumberOfPoints(), 7) << entry;
      }
  }
  EXPECT_GT(most, 10);
}

TEST_F(Frames, AFileThatCannotBeWrittenIsAnError) {
  const Values values;
  FrameWriter writer{folder, small_scene()};
  // A folder of this name cannot be replaced by a file.
  fs::create_directories(folder / "frames/frame_000001.vtu/in the way");
  writer.write(0.0, values.data());
  EXPECT_NE(message_of<FileError>([&] { writer.write(1.0, values.data()); }).find("frame_000001.vtu"),
            std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "frames/frame_000000.vtu"));
}

TEST_F(Frames, StartingAgainReplacesALongerCollection) {
  const Values values;
  {
    FrameWriter writer{folder, small_scene()};
    for (int frame = 0; frame < 50; ++frame) writer.write(frame, values.data());
  }
  FrameWriter writer{folder, small_scene()};
  writer.write(0.5, values.data());
  const auto root = parse_xml(read_file(folder / "frames.pvd"));
  ASSERT_NE(root, nullptr);
  EXPECT_EQ(root->FindNestedElementWithName("Collection")->GetNumberOfNestedElements(), 1);
}

TEST_F(Frames, RefusesWhatDoesNotFitTheScene) {
  const auto writer_of = [&](auto change) {
    Scene scene = small_scene();
    change(scene);
    return message_of<InputError>([&] { FrameWriter{folder, scene}; });
  };
  EXPECT_EQ(writer_of([](Scene& scene) {
              scene.cells[1].points = {0, 1, 2};
            }),
            "Scene cell \"bearing\": number of points = 3 is not allowed; it must be 2 (line), 4 (quad) or "
            "more (polygon).");
  EXPECT_EQ(writer_of([](Scene& scene) {
              scene.cells[1].points = {0, 7};
            }),
            "Scene cell \"bearing\": point = 7 is not allowed; it must be the index of one of the 7 points of the "
            "scene.");
  EXPECT_NE(writer_of([](Scene& scene) { scene.points[2].node = -2; }).find("node = -2"), std::string::npos);
  EXPECT_NE(writer_of([](Scene& scene) { scene.points[2].weight = 1.5; }).find("weight = 1.5"), std::string::npos);

  const Values values;
  FrameWriter writer{folder, small_scene()};
  FrameData data = values.data();
  data.force = data.force.first(2);
  EXPECT_EQ(message_of<InputError>([&] { writer.write(0.0, data); }),
            "FrameData: force has 2 values, the scene needs 3. Give one value per node, element or storey.");
  data = values.data();
  data.node_velocity = {};
  EXPECT_THROW(writer.write(0.0, data), InputError);
  writer.write(1.0, values.data());
  EXPECT_THROW(writer.write(1.0, values.data()), InputError);
  EXPECT_THROW(writer.write(std::nan(""), values.data()), InputError);
  EXPECT_EQ(writer.frames(), 1);
}

TEST_F(Frames, ForcesOfCornersPushThemBackAndAgainstTheirSlide) {
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
  Transient analysis{model, GroundMotion{"still", 0.005, std::vector<double>(21, 0.0)}};
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

TEST_F(Frames, ReportsAFolderThatCannotBeMade) {
  std::ofstream{folder / "frames"} << "in the way";
  EXPECT_THROW((FrameWriter{folder, small_scene()}), FileError);
}

}  // namespace
}  // namespace moat
