// The library with VTK is loaded where a script writes files for ParaView, and nowhere else.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing::ProgramResult;
using testing::text_of;

class VtkLibrary : public testing::InTemporaryFolder {
 protected:
  // With a variable of the dynamic loader.
  ProgramResult run_with(const char* variable, const std::string& value, const std::string& program,
                         const std::vector<std::string>& arguments) const {
    setenv(variable, value.c_str(), 1);
    const ProgramResult result = testing::run_program(program, arguments, folder);
    unsetenv(variable);
    return result;
  }
  // Whether the loader, which lists every library, reports the one of VTK's writers.
  bool loads_vtk(const std::string& program, const std::vector<std::string>& arguments) const {
    const ProgramResult result = run_with("LD_DEBUG", "files", program, arguments);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.errors.find("libmoat.so"), std::string::npos) << result.errors;
    return result.errors.find("libvtkIOXML") != std::string::npos;
  }
};

TEST_F(VtkLibrary, IsAmongThoseOfAScriptThatWroteFramesAlone) {
  EXPECT_TRUE(loads_vtk(FIRST_TOUR, {"--end", "0.1 s", "--quiet", "--out", "out"}));
  EXPECT_TRUE(fs::exists(folder / "out/frames/frame_000000.vtu"));
  EXPECT_FALSE(loads_vtk(STUDY_SCRIPT, {"--quiet", "--out", "none"}));
  EXPECT_TRUE(fs::exists(folder / "none/report.html"));
}

TEST_F(VtkLibrary, IsNamedWhereItIsMissing) {
  fs::create_directory(folder / "alone");
  fs::copy(LIBRARY, folder / "alone");
  const std::string alone = (folder / "alone").string();
  const ProgramResult frames = run_with("LD_LIBRARY_PATH", alone, FIRST_TOUR, {"--end", "0.1 s", "--out", "out"});
  EXPECT_EQ(frames.exit_code, 1);
  EXPECT_NE(frames.errors.find("moat: error: Frames and tables for ParaView need VTK: " + alone + "/libmoat_vtk.so"),
            std::string::npos)
      << frames.errors;
  EXPECT_NE(frames.errors.find("Install libvtk9.1"), std::string::npos) << frames.errors;
  // All but the table for ParaView is there.
  const ProgramResult table =
      run_with("LD_LIBRARY_PATH", alone, FIRST_TOUR, {"--end", "0.1 s", "--frame-interval", "0 s", "--out", "table"});
  EXPECT_EQ(table.exit_code, 1);
  EXPECT_NE(table.errors.find("Left out: frames, histories.vtt."), std::string::npos) << table.errors;
  EXPECT_NE(text_of(folder / "table/summary.json").find("Install libvtk9.1"), std::string::npos);
}

}  // namespace
}  // namespace moat
