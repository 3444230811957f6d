// Tables for ParaView.
#pragma once

#include <filesystem>

#include "output/table.hpp"

namespace moat {

/// Writes a VTK XML table (.vtt, 64-bit floats, raw binary) whose columns are named as in the CSV file. In ParaView
/// open it and plot with the filter Plot Data, the time column as x axis. Throws InputError where columns differ in
/// length or two have the same name, FileError where the file cannot be written.
void write_vtt(const Table& table, const std::filesystem::path& path);

}  // namespace moat
