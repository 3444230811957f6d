#include "output/vtk_table.hpp"

#include <span>
#include <string>
#include <string_view>
#include <unordered_set>

#include "base/error.hpp"
#include "output/file_io.hpp"
#include "output/table_columns.hpp"
#include "output/vtk_xml.hpp"

namespace moat {

void write_vtt(const Table& table, const std::filesystem::path& path) {
  require_equal_lengths(table);
  VtkXml file{"Table"};
  file.xml("<Table>\n<Piece NumberOfCols=\"" + std::to_string(table.columns.size()) + "\" NumberOfRows=\"" +
           std::to_string(table.rows()) + "\">\n<RowData>\n");
  std::unordered_set<std::string> names;
  for (const Column& column : table.columns) {
    const auto [name, is_new] = names.insert(column_name(column));
    // Readers keep only the last of two arrays with one name.
    if (!is_new) throw InputError{"Table: two columns are named \"" + *name + "\". Give them different places."};
    file.array({*name}, std::span{column.values});
  }
  file.xml("</RowData>\n</Piece>\n</Table>\n");
  write_file(path, file.finish());
}

}  // namespace moat
