#include "output/files/csv_writer.hpp"

#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include "output/files/file_io.hpp"
#include "output/files/table_columns.hpp"
#include "output/recorders/impact_columns.hpp"

namespace moat {
namespace {

void append_text(std::string& out, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

void append_number(std::string& out, double value) {
  std::array<char, 32> digits;  // the longest shortest form of a double has 24 characters
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out.append(digits.data(), end);
}

}  // namespace

void write_csv(const Table& table, const std::filesystem::path& path) {
  require_equal_lengths(table);
  std::string out, next;
  const char* separator = "";
  for (const Column& column : table.columns) {
    next += separator;
    append_text(next, column.labels.empty() ? column_name(column) : column.quantity);
    separator = ",";
  }
  next += '\n';
  std::size_t row = 0;
  write_file(path, [&]() -> std::string_view {
    constexpr std::size_t most = 1 << 20;  // of a long table, which may leave no memory for a second one as text
    out.swap(next);
    next.clear();
    for (; row < table.rows() && out.size() < most; ++row) {
      for (const Column& column : table.columns) {
        if (column.labels.empty())
          append_number(out, column.values[row]);
        else
          append_text(out, column.labels[row]);
        out += ',';
      }
      out.back() = '\n';
    }
    return out;
  });
}

void write_csv(const std::vector<Impact>& impacts, const std::filesystem::path& path) {
  std::string out = "where";
  const std::vector<ImpactColumn> columns = columns_of(impacts);
  const bool in_plan = are_in_plan(impacts);
  for (const ImpactName& name : impact_names_in_plan)
    if (in_plan) out.append(",").append(name.name);
  for (const ImpactColumn& column : columns)
    out.append(",").append(column.name).append(" [").append(column.unit).append("]");
  out += '\n';
  for (const Impact& impact : impacts) {
    append_text(out, impact.where);
    for (const ImpactName& name : impact_names_in_plan) {
      if (!in_plan) break;
      out += ',';
      append_text(out, impact.*name.value);
    }
    for (const ImpactColumn& column : columns) {
      out += ',';
      append_number(out, impact.*column.value);
    }
    out += '\n';
  }
  write_file(path, out);
}

}  // namespace moat
