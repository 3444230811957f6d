#include "paper/printed_table.hpp"

#include <fstream>
#include <sstream>

#include "base/error.hpp"

namespace moat::paper {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream{line};
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

std::vector<PrintedRow> printed_table(const std::string& file) {
  const std::string path = std::string{MOAT_PAPER_DATA} + "/" + file;
  std::ifstream stream{path};
  if (!stream) throw FileError{path + ": cannot be read. It belongs to the source of the benchmarks."};
  std::vector<std::string> header;
  std::vector<PrintedRow> rows;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> cells = cells_of(line);
    if (header.empty()) {
      header = cells;
      continue;
    }
    PrintedRow& row = rows.emplace_back();
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = i < cells.size() ? cells[i] : "";
  }
  return rows;
}

double number(const PrintedRow& row, const std::string& column) {
  const auto found = row.find(column);
  try {
    if (found != row.end()) return std::stod(found->second);
  } catch (const std::exception&) {
  }
  throw Error{"The column " + column + " of a printed table is missing or not a number."};
}

}  // namespace moat::paper
