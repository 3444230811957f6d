#include "output/vtk_table.hpp"

#include <vtkAbstractArray.h>
#include <vtkDoubleArray.h>
#include <vtkTable.h>
#include <vtkXMLTableReader.h>

#include <cmath>
#include <vector>

#include "output_testing.hpp"

namespace moat {
namespace {

class VtkTable : public testing_output::InFolder {};

TEST_F(VtkTable, ReadsBackUnchanged) {
  Table table{{{"time", "", "s", {}}, {"absolute_acceleration", "floor 5", "m/s^2", {}}}};
  for (int i = 0; i < 5000; ++i) {
    table.columns[0].values.push_back(0.005 * i);
    table.columns[1].values.push_back(std::sin(0.1 * i) / 3.0);
  }
  write_vtt(table, folder / "histories.vtt");

  vtkNew<vtkXMLTableReader> reader;
  reader->SetFileName((folder / "histories.vtt").c_str());
  reader->Update();
  vtkTable* read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfColumns(), 2);
  ASSERT_EQ(read->GetNumberOfRows(), 5000);
  EXPECT_STREQ(read->GetColumnName(0), "time [s]");
  EXPECT_STREQ(read->GetColumnName(1), "absolute_acceleration [m/s^2] floor 5");
  for (vtkIdType column = 0; column < 2; ++column) {
    auto* values = vtkDoubleArray::SafeDownCast(read->GetColumn(column));
    ASSERT_NE(values, nullptr);
    for (vtkIdType row = 0; row < 5000; ++row)
      ASSERT_EQ(values->GetValue(row),
                table.columns[static_cast<std::size_t>(column)].values[static_cast<std::size_t>(row)]);
  }
}

TEST_F(VtkTable, KeepsNamesMissingValuesAndEmptyTables) {
  const std::string name = "a \"<&>\" ü";
  write_vtt(Table{{{"drift", name, "m", {-0.0, NAN, INFINITY}}}}, folder / "a.vtt");
  vtkNew<vtkXMLTableReader> reader;
  reader->SetFileName((folder / "a.vtt").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetColumnName(0), "drift [m] " + name);
  EXPECT_TRUE(std::isnan(reader->GetOutput()->GetValue(1, 0).ToDouble()));
  EXPECT_EQ(reader->GetOutput()->GetValue(2, 0).ToDouble(), INFINITY);

  write_vtt(Table{{{"time", "", "s", {}}}}, folder / "b.vtt");
  vtkNew<vtkXMLTableReader> empty;
  empty->SetFileName((folder / "b.vtt").c_str());
  empty->Update();
  EXPECT_EQ(empty->GetOutput()->GetNumberOfRows(), 0);
}

TEST_F(VtkTable, RefusesTwoColumnsOfOneName) {
  const Table table{{{"drift", "storey 1", "m", {0.0}}, {"drift", "storey 1", "m", {1.0}}}};
  EXPECT_EQ(testing_output::message_of<InputError>([&] { write_vtt(table, folder / "histories.vtt"); }),
            "Table: two columns are named \"drift [m] storey 1\". Give them different places.");
}

TEST_F(VtkTable, NamesTheFileItCannotWrite) {
  EXPECT_THROW(write_vtt(Table{{{"time", "", "s", {0.0}}}}, folder / "missing" / "a.vtt"), FileError);
}

}  // namespace
}  // namespace moat
