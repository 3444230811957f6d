// Numbers printed in the paper or computed by others, from the CSV files beside this one.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace moat::paper {

using PrintedRow = std::map<std::string, std::string>;

/// The rows of a file in this folder, by the names of its header; lines that begin with # are comments.
/// Throws FileError if there is no such file.
std::vector<PrintedRow> printed_table(const std::string& file);

/// An entry as a number. Throws Error naming it if it is none.
double number(const PrintedRow& row, const std::string& column);

}  // namespace moat::paper
