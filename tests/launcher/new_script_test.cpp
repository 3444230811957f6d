#include "launcher/commands.hpp"

#include <gtest/gtest.h>

#include "launcher/stop.hpp"
#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

class NewScript : public InSmallCheckout {
 protected:
  NewScript() { write_text(places.root / "examples" / "starter.cpp", "Script script{argc, argv, \"starter\"};\n"); }

  std::string refusal(const std::string& file) const {
    try {
      new_script(places, file);
    } catch (const Stop& stop) {
      EXPECT_EQ(stop.exit_code, exit_usage);
      return stop.what();
    }
    return "was written";
  }

  std::string printed_for(const std::filesystem::path& file) const {
    ::testing::internal::CaptureStderr();
    new_script(places, file);
    return ::testing::internal::GetCapturedStderr();
  }
};

TEST_F(NewScript, BearsItsOwnName) {
  printed_for(folder / "tower.cpp");
  EXPECT_EQ(text_of(folder / "tower.cpp"), "Script script{argc, argv, \"tower\"};\n");
  printed_for(folder / "a \"big\" one.cpp");
  EXPECT_EQ(text_of(folder / "a \"big\" one.cpp"), "Script script{argc, argv, \"a \\\"big\\\" one\"};\n");
}

TEST_F(NewScript, NeedsNoEnding) {
  EXPECT_NE(printed_for(folder / "bridge").find("Wrote " + (folder / "bridge.cpp").string()), std::string::npos);
  EXPECT_EQ(text_of(folder / "bridge.cpp"), "Script script{argc, argv, \"bridge\"};\n");
}

TEST_F(NewScript, IsSuggestedToRunByACommandThatCanBeCopied) {
  const std::string file = folder / "a b.cpp";
  EXPECT_NE(printed_for(file).find("./moat run '" + file + "'\n"), std::string::npos);
}

TEST_F(NewScript, IsRefusedWithTheReason) {
  EXPECT_NE(refusal("tower.txt").find("does not end in .cpp"), std::string::npos);
  EXPECT_NE(refusal("-x.cpp").find("./moat new ./-x.cpp"), std::string::npos);
  EXPECT_NE(refusal(folder / "no" / "tower.cpp").find("There is no folder " + (folder / "no").string()),
            std::string::npos);
  printed_for(folder / "tower.cpp");
  EXPECT_NE(refusal(folder / "tower.cpp").find("exists already"), std::string::npos);
  std::filesystem::create_symlink(folder / "nowhere", folder / "link.cpp");
  EXPECT_NE(refusal(folder / "link.cpp").find("exists already"), std::string::npos);
}

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
