#include "output/vtk_xml.hpp"

#include <vtkDoubleArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkXMLTableReader.h>

#include <array>

#include "output/file_io.hpp"
#include "output_testing.hpp"

namespace moat {
namespace {

class VtkXmlFile : public testing_output::InFolder {};

TEST_F(VtkXmlFile, IsReadByVtkWithTheDataOfTheMomentItIsWritten) {
  std::array<double, 6> vectors{};
  const std::array<std::int32_t, 2> numbers{7, -8};
  const std::string texts{"one\0two", 8};
  VtkXml file{"Table"};
  file.xml("<Table><Piece NumberOfCols=\"3\" NumberOfRows=\"2\"><RowData>\n");
  file.array({"vectors \"<&>\"", 3}, std::span<const double>{vectors});
  file.array({"numbers"}, std::span<const std::int32_t>{numbers});
  file.texts({"texts"}, texts);
  file.xml("</RowData></Piece></Table>\n");
  const std::vector<std::string_view> pieces = file.finish();
  vectors = {1.0, 2.0, 3.0, 4.0, 5.0, 1.0 / 3.0};
  write_file(folder / "a.vtt", pieces);

  vtkNew<vtkXMLTableReader> reader;
  reader->SetFileName((folder / "a.vtt").c_str());
  reader->Update();
  vtkTable* read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfColumns(), 3);
  ASSERT_EQ(read->GetNumberOfRows(), 2);
  auto* triples = vtkDoubleArray::SafeDownCast(read->GetColumnByName("vectors \"<&>\""));
  ASSERT_NE(triples, nullptr);
  EXPECT_EQ(triples->GetNumberOfComponents(), 3);
  EXPECT_EQ(triples->GetComponent(1, 2), 1.0 / 3.0);
  EXPECT_EQ(read->GetValueByName(1, "numbers").ToInt(), -8);
  EXPECT_EQ(vtkStringArray::SafeDownCast(read->GetColumnByName("texts"))->GetValue(1), "two");
}

}  // namespace
}  // namespace moat
