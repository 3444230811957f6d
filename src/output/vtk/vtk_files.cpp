#include "output/vtk/vtk_files.hpp"

#include "base/loaded_library.hpp"

namespace moat {

VtkFiles& vtk_files() {
  using Make = VtkFiles* (*)();
  static VtkFiles* const files = reinterpret_cast<Make>(
      loaded_function("libmoat_vtk.so", "moat_vtk_files", "Frames and tables for ParaView need VTK",
                      "Install libvtk9.1, and build or install moat again; everything but the files for ParaView is "
                      "computed without it."))();
  return *files;
}

}  // namespace moat
