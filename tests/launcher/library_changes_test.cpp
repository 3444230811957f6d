#include "launcher/library.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

class LibraryChanges : public InSmallCheckout {
 protected:
  LibraryChanges() {
    std::istringstream folders{LIBRARY_FOLDERS};
    for (std::string name; folders >> name;) fs::create_directories(places.root / name / "inside");
    for (const char* name : {"cmake", ".git/logs"}) fs::create_directories(places.root / name);
    write_text(places.root / "CMakePresets.json", "");
    write_text(places.root / ".git/logs/HEAD", "");
    for (const char* name : {"src", "script_header"}) fs::create_directories(places.build / name);
    for (const char* name :
         {"build.ninja", ".ninja_log", "CMakeCache.txt", "src/libmoat.so", "script_header/moat.hpp.gch"})
      write_text(places.build / name, "");
    write_stamp();
  }
  void write_stamp() const {
    tick();
    write_text(stamp, "");
    tick();
  }
  // Longer than the clock of the file system does.
  static void tick() { std::this_thread::sleep_for(std::chrono::milliseconds{20}); }
  [[nodiscard]] bool may_have_changed() const { return library_may_have_changed(places, stamp); }

  const fs::path stamp = folder / "stamp";
};

TEST_F(LibraryChanges, AreNoneAtFirstAndWithoutAStampAlways) {
  EXPECT_FALSE(may_have_changed());
  fs::remove(stamp);
  EXPECT_TRUE(may_have_changed());
}

TEST_F(LibraryChanges, AreSeenInEveryFolderOfTheLibrary) {
  std::istringstream folders{LIBRARY_FOLDERS " cmake"};
  for (std::string name; folders >> name;) {
    const fs::path file = places.root / name / "new.hpp", deeper = places.root / name / "inside" / "new.hpp";
    for (const fs::path& each : {file, deeper}) {
      if (!fs::exists(each.parent_path())) continue;
      write_text(each, "first");
      EXPECT_TRUE(may_have_changed()) << "new: " << each;
      write_stamp();
      EXPECT_FALSE(may_have_changed()) << each;
      write_text(each, "second");
      EXPECT_TRUE(may_have_changed()) << "changed: " << each;
      fs::remove(each);
      write_stamp();
    }
  }
}

TEST_F(LibraryChanges, AreSeenInCommitAndBuild) {
  for (const fs::path& file : {places.root / ".git/logs/HEAD", places.root / "CMakeLists.txt",
                               places.build / "build.ninja", places.build / ".ninja_log"}) {
    write_text(file, "another");
    EXPECT_TRUE(may_have_changed()) << file;
    write_stamp();
  }
  for (const char* file : {"src/libmoat.so", "script_header/moat.hpp.gch"}) {
    fs::remove(places.build / file);
    EXPECT_TRUE(may_have_changed()) << file << " went away";
    write_stamp();
  }
}

TEST_F(LibraryChanges, AreNotThoseOfOtherFiles) {
  write_text(folder / "study" / "tower.cpp", "");
  write_text(places.root / "README.md", "");
  EXPECT_FALSE(may_have_changed());
}

}  // namespace
}  // namespace moat::launcher
