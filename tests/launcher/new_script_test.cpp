#include "launcher/new_script.hpp"

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

}  // namespace
}  // namespace moat::launcher
