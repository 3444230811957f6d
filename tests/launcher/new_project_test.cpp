#include "launcher/new_project.hpp"

#include <gtest/gtest.h>

#include "launcher/stop.hpp"
#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

class NewProject : public InSmallCheckout {
 protected:
  NewProject() {
    std::filesystem::create_directories(places.root / "examples" / "project");
    const std::filesystem::path from = std::filesystem::path{MOAT_SOURCE_DIR} / "examples";
    for (const char* file : {"starter.cpp", "project/CMakeLists.txt", "project/README.md"})
      std::filesystem::copy_file(from / file, places.root / "examples" / file);
  }
  std::string refusal(const std::filesystem::path& project) const {
    try {
      new_project(places, project);
    } catch (const Stop& stop) {
      EXPECT_EQ(stop.exit_code, exit_usage);
      return stop.what();
    }
    return "was written";
  }
};

TEST_F(NewProject, BearsItsOwnNameEverywhere) {
  new_project(places, folder / "my_tower-2");
  const std::filesystem::path project = folder / "my_tower-2";
  EXPECT_NE(text_of(project / "CMakeLists.txt").find("moat_add_script(my_tower-2.cpp)"), std::string::npos);
  EXPECT_NE(text_of(project / "my_tower-2.cpp").find("Script script{argc, argv, \"my_tower-2\"};"), std::string::npos);
  EXPECT_NE(text_of(project / "README.md").find("build/my_tower-2"), std::string::npos);
  for (const char* file : {"CMakeLists.txt", "my_tower-2.cpp", "README.md"})
    EXPECT_EQ(text_of(project / file).find("starter"), std::string::npos) << file;
}

TEST_F(NewProject, IsRefusedWithTheReason) {
  EXPECT_NE(refusal(folder / "my tower").find("use letters, digits, - and _"), std::string::npos);
  EXPECT_NE(refusal("-x").find("cannot be the name"), std::string::npos);
  EXPECT_NE(refusal(folder / "no" / "tower").find("There is no folder"), std::string::npos);
  EXPECT_NE(refusal(folder / "study").find("exists already"), std::string::npos);
}

}  // namespace
}  // namespace moat::launcher
