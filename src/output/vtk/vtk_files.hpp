// Files for ParaView, written by VTK.
#pragma once

#include <filesystem>

#include "output/files/table.hpp"
#include "output/vtk/frame_fields.hpp"
#include "output/vtk/scene.hpp"

namespace moat {

/// The writers of VTK. They use no compressor, which would take four times as long for a tenth of the size. Both
/// replace a file as write_file() does, and throw FileError where it cannot be written.
class VtkFiles {
 public:
  virtual ~VtkFiles() = default;
  /// Writes a table (.vtt, 64-bit floats) whose columns are named as in the CSV file. In ParaView open it and plot with
  /// the filter Plot Data, the time column as x axis. Throws InputError where columns differ in length or two have the
  /// same name.
  virtual void write_table(const Table& table, const std::filesystem::path& path) = 0;
  /// Writes an unstructured grid (.vtu). The scene must be valid.
  virtual void write_frame(const Scene& scene, const FrameFields& fields, const std::filesystem::path& path) = 0;
};

/// They lie in a library of their own, which the first call loads: a program that writes no such file has nothing of
/// VTK in it. Throws InputError where it cannot be loaded.
VtkFiles& vtk_files();

}  // namespace moat
