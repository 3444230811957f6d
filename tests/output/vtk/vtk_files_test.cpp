#include "output/vtk/vtk_files.hpp"

#include <vtkAbstractArray.h>
#include <vtkDoubleArray.h>
#include <vtkTable.h>
#include <vtkXMLTableReader.h>

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include "output_testing.hpp"

namespace moat {
namespace {

class VtkTables : public testing_output::InFolder {
 protected:
  // The table in a file of the folder, as VTK reads it.
  vtkSmartPointer<vtkTable> table_in(const std::string& name) const {
    vtkNew<vtkXMLTableReader> reader;
    reader->SetFileName((folder / name).c_str());
    reader->Update();
    return reader->GetOutput();
  }
};

TEST_F(VtkTables, ReadsBackUnchanged) {
  Table table{{{"time", "", "s", {}}, {"absolute_acceleration", "floor 5", "m/s^2", {}}}};
  for (int i = 0; i < 5000; ++i) {
    table.columns[0].values.push_back(0.005 * i);
    table.columns[1].values.push_back(std::sin(0.1 * i) / 3.0);
  }
  vtk_files().write_table(table, folder / "histories.vtt");

  const auto read = table_in("histories.vtt");
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

TEST_F(VtkTables, KeepsNamesMissingValuesAndEmptyTables) {
  const std::string name = "a \"<&>\" ü";
  vtk_files().write_table(Table{{{"drift", name, "m", {-0.0, NAN, INFINITY}}}}, folder / "a.vtt");
  const auto read = table_in("a.vtt");
  EXPECT_EQ(read->GetColumnName(0), "drift [m] " + name);
  EXPECT_TRUE(std::isnan(read->GetValue(1, 0).ToDouble()));
  EXPECT_EQ(read->GetValue(2, 0).ToDouble(), INFINITY);

  vtk_files().write_table(Table{{{"drift", "bell\a", "m", {1.0}}}}, folder / "c.vtt");
  EXPECT_STREQ(table_in("c.vtt")->GetColumnName(0), "drift [m] bell?");

  vtk_files().write_table(Table{{{"time", "", "s", {}}}}, folder / "b.vtt");
  EXPECT_EQ(table_in("b.vtt")->GetNumberOfRows(), 0);
}

TEST_F(VtkTables, RefusesTwoColumnsOfOneName) {
  const Table table{{{"drift", "storey 1", "m", {0.0}}, {"drift", "storey 1", "m", {1.0}}}};
  EXPECT_EQ(testing_output::message_of<InputError>([&] { vtk_files().write_table(table, folder / "histories.vtt"); }),
            "Table: two columns are named \"drift [m] storey 1\". Give them different places.");
}

TEST_F(VtkTables, NamesTheFileItCannotWriteAndTheCause) {
  const Table table{{{"time", "", "s", std::vector<double>(100000)}}};
  const auto error_of = [&](const std::filesystem::path& path) {
    return testing_output::message_of<FileError>([&] { vtk_files().write_table(table, path); });
  };
  EXPECT_EQ(error_of(folder / "missing/a.vtt"),
            (folder / "missing/a.vtt").string() +
                ": cannot be written completely (No such file or directory). Check "
                "that the folder exists, may be written to, and that the disk is not "
                "full.");
  // As on a full disk, a file longer than 100 kB fails.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{100000, before.rlim_max};
  const auto old_action = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  ::testing::internal::CaptureStderr();
  const std::string full = error_of(folder / "a.vtt");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "the library prints nothing";
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_action);
  EXPECT_NE(full.find("a.vtt: cannot be written completely (File too large)"), std::string::npos) << full;
  EXPECT_TRUE(std::filesystem::is_empty(folder)) << "nothing unfinished is left";
}

}  // namespace
}  // namespace moat
