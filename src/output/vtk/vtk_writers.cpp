// VTK's writers: the library libmoat_vtk.so, which output/vtk/vtk_files.cpp loads where a file of VTK is wanted.

#include <SMP/Common/vtkSMPToolsAPI.h>  // vtkSMPTools.h of VTK 9.1 is not C++20
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLTableWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.hpp"
#include "base/text/utf8_text.hpp"
#include "output/files/file_io.hpp"
#include "output/vtk/vtk_files.hpp"

namespace moat {
namespace {

constexpr std::array kind_names{"floor", "storey", "bearing", "gap", "wall", "other"};

void prepare(vtkXMLWriter& writer, vtkDataObject& data) {
  writer.SetInputData(&data);
  // Debian's ParaView refuses data behind the XML, VTK's default, since libexpat refuses bytes that are no XML.
  writer.SetDataModeToBinary();
  writer.SetCompressorTypeToNone();
  // VTK prints errors that nobody observes.
  const vtkNew<vtkCallbackCommand> silent;
  writer.AddObserver(vtkCommand::ErrorEvent, silent);
  writer.GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silent);
}

/// Returns the errno where the writer fails, else 0.
int run(vtkXMLWriter& writer) {
  const bool done = writer.Write() != 0;
  const auto code = static_cast<int>(writer.GetErrorCode());
  if (code == vtkErrorCode::OutOfDiskSpaceError) return ENOSPC;
  // Codes of VTK's own begin there.
  if (code > vtkErrorCode::FirstVTKErrorCode || (code == 0 && !done)) return EIO;
  return code;
}

/// The array points to the values, which VTK only reads.
vtkNew<vtkDoubleArray> array_of(const std::vector<double>& values, int components) {
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(components);
  array->SetArray(const_cast<double*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
  return array;
}

void add_fields(vtkFieldData& to, const std::vector<FrameField>& fields, int components) {
  for (const FrameField& field : fields) {
    const auto array = array_of(field.values, components);
    array->SetName(field.name);
    to.AddArray(array);
  }
}

void add_texts(vtkFieldData& to, const char* name, const auto& owners, const auto& text_of) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  // A text ends at its first zero byte.
  for (const auto& owner : owners) array->InsertNextValue(text_of(owner));
  to.AddArray(array);
}

/// Readers keep only the last of two arrays with one name.
void require_different_names(const Table& table) {
  std::vector<const Column*> columns;
  for (const Column& column : table.columns) columns.push_back(&column);
  const auto names = [](const Column* column) { return std::tie(column->quantity, column->where, column->unit); };
  std::ranges::sort(columns, {}, names);
  if (const auto twin = std::ranges::adjacent_find(columns, {}, names); twin != columns.end())
    throw InputError{"Table: two columns are named \"" + column_name(**twin) + "\". Give them different places."};
}

/// Writes the columns of a table one after the other in place of the arrays of its input, which would take 1.6 kB each.
class ColumnsWriter final : public vtkXMLTableWriter {
 public:
  static ColumnsWriter* New() { VTK_STANDARD_NEW_BODY(ColumnsWriter); }

  const Column* next = nullptr;

 protected:
  void WriteArrayInline(vtkAbstractArray*, vtkIndent indent, const char*, int) override {
    const auto array = array_of(next->values, 1);
    // VTK writes names as they are.
    array->SetName(escaped_for_xml(column_name(*next++)).c_str());
    vtkXMLTableWriter::WriteArrayInline(array, indent);
  }
};

class VtkWriters final : public VtkFiles {
 public:
  // One thread: VTK would start one for every processor, and read their number for every array.
  VtkWriters() {
    auto& threads = vtk::detail::smp::vtkSMPToolsAPI::GetInstance();
    for (const char* backend : {"STDThread", "Sequential"}) {
      threads.SetBackend(backend);
      threads.Initialize(1);
    }
  }

  void write_table(const Table& table, const std::filesystem::path& path) override {
    require_equal_lengths(table);
    require_different_names(table);
    vtkNew<vtkTable> data;
    // One array in all places, without a name: VTK compares names, and makes room for one more array at each.
    vtkNew<vtkDoubleArray> any;
    any->SetNumberOfTuples(static_cast<vtkIdType>(table.rows()));
    data->GetRowData()->AllocateArrays(static_cast<int>(table.columns.size()));
    for (std::size_t i = 0; i < table.columns.size(); ++i) data->GetRowData()->AddArray(any);
    vtkNew<ColumnsWriter> writer;
    writer->next = table.columns.data();
    prepare(*writer, *data);
    write_file(path, [&](const std::string& unfinished) {
      writer->SetFileName(unfinished.c_str());
      return run(*writer);
    });
  }

  void write_frame(const Scene& scene, const FrameFields& fields, const std::filesystem::path& path) override {
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const ScenePoint& point : scene.points) points->InsertNextPoint(point.x, point.y, point.z);
    grid->SetPoints(points);
    vtkNew<vtkIntArray> kinds;
    kinds->SetName("Kind");
    std::vector<vtkIdType> ends;
    for (const SceneCell& cell : scene.cells) {
      ends.assign(cell.points.begin(), cell.points.end());
      grid->InsertNextCell(ends.size() == 2   ? VTK_LINE
                           : ends.size() == 4 ? VTK_QUAD
                                              : VTK_POLYGON,
                           static_cast<vtkIdType>(ends.size()), ends.data());
      kinds->InsertNextValue(static_cast<int>(cell.kind));
    }
    grid->GetCellData()->AddArray(kinds);
    add_texts(*grid->GetCellData(), "Name", scene.cells, [](const SceneCell& cell) { return cell.name.c_str(); });
    add_texts(*grid->GetFieldData(), "KindNames", kind_names, [](const char* name) { return name; });
    const std::vector<FrameField> time{{"TimeValue", {fields.time}}};
    add_fields(*grid->GetFieldData(), time, 1);
    add_fields(*grid->GetPointData(), fields.of_points, 3);
    add_fields(*grid->GetCellData(), fields.of_cells, 1);
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    prepare(*writer, *grid);
    // VTK hands a file to the system in some 200 pieces, which would take a fifth of the time of a small frame.
    writer->WriteToOutputStringOn();
    if (run(*writer) != 0) throw std::bad_alloc{};
    write_file(path, writer->GetOutputString());
  }
};

}  // namespace
}  // namespace moat

extern "C" moat::VtkFiles* moat_vtk_files() {
  static moat::VtkWriters writers;
  return &writers;
}
