#include "output/vtk_table.hpp"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkTable.h>
#include <vtkXMLTableWriter.h>

#include <algorithm>
#include <set>
#include <string>

#include "base/error.hpp"
#include "output/classic_locale.hpp"
#include "output/file_io.hpp"
#include "output/table_columns.hpp"

namespace moat {

void write_vtt(const Table& table, const std::filesystem::path& path) {
  const ClassicLocale classic;
  require_equal_lengths(table);
  vtkNew<vtkTable> vtk_table;
  std::set<std::string> names;
  for (const Column& column : table.columns) {
    const std::string name = column_name(column);
    // VTK keeps only the last of two arrays with one name.
    if (!names.insert(name).second)
      throw InputError{"Table: two columns are named \"" + name + "\". Give them different places."};
    vtkNew<vtkDoubleArray> values;
    values->SetName(name.c_str());
    values->SetNumberOfValues(static_cast<vtkIdType>(column.values.size()));
    std::copy(column.values.begin(), column.values.end(), values->GetPointer(0));
    vtk_table->AddColumn(values);
  }
  vtkNew<vtkXMLTableWriter> writer;
  writer->SetInputData(vtk_table);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  // Written by write_file, which says why a file cannot be written.
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) throw FileError{path.string() + ": VTK could not encode the table."};
  write_file(path, writer->GetOutputString());
}

}  // namespace moat
