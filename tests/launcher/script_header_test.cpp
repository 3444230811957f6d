#include "launcher/script_header.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

class ScriptHeader : public InSmallCheckout {
 protected:
  ScriptHeader() {
    package.work = folder / "the cache";
    write_text(package.build / "script_link.txt", "");
    fs::create_directories(package.build / "bin");
    install();
  }

  /// As a new version of the package would be, with an old date.
  void install() const {
    std::this_thread::sleep_for(std::chrono::milliseconds{20});  // longer than the clock of the file system ticks
    const fs::path launcher = package.build / "bin" / "moat";
    write_text(launcher, "");
    fs::last_write_time(launcher, fs::file_time_type::clock::now() - std::chrono::hours{1000});
  }

  Places package = places;
};

TEST_F(ScriptHeader, OfACheckoutIsTheOneBuiltWithTheLibrary) {
  const fs::path built = places.build / "script_header" / "moat.hpp.gch";
  Command compile{COMPILER};
  EXPECT_EQ(precompiled_header(places, compile), fs::path{}) << "a compiler that makes none";
  fs::create_directories(built.parent_path());
  write_text(built, "");
  EXPECT_EQ(precompiled_header(places, compile), built);
  EXPECT_EQ(compile.size(), 1u);
}

TEST_F(ScriptHeader, OfAPackageIsMadeOnceAndAgainAfterAnInstallation) {
  become_a_package();
  Command compile{COMPILER, "-isystem", places.root / "src"};
  const fs::path header = precompiled_header(package, compile);
  EXPECT_EQ(header.parent_path(), package.work / "script_header");
  EXPECT_EQ(compile[2], package.work / "script_header");
  const auto before = identity(header);
  EXPECT_EQ(identity(precompiled_header(package, compile)), before);
  install();
  EXPECT_NE(identity(precompiled_header(package, compile)), before);
}

}  // namespace
}  // namespace moat::launcher
