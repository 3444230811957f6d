#include "launcher/library.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "launcher/process.hpp"
#include "launcher/stop.hpp"
#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

class BringUpToDate : public InSmallCheckout {
 protected:
  BringUpToDate() {
    write_text(places.build / "build.ninja",
               "rule copy\n  command = cp $in $out\nrule fail\n  command = echo the reason why; false\n"
               "build library: copy ../../src/source\nbuild broken: fail\n");
    write_text(places.root / "src" / "source", "first");
    write_text(places.build / "packages_are_installed", "");
    std::istringstream folders{"cmake " LIBRARY_FOLDERS};
    for (std::string name; folders >> name;) std::filesystem::create_directories(places.root / name);
  }
  const Part library{.what = "the library", .targets = {"library"}};
};

TEST_F(BringUpToDate, BuildsWhatHasChanged) {
  bring_up_to_date(places, library);
  EXPECT_EQ(text_of(places.build / "library"), "first");
  bring_up_to_date(places, library);                           // Ninja finds no work, and is not asked again
  std::this_thread::sleep_for(std::chrono::milliseconds{20});  // longer than the clock of the file system ticks
  write_text(places.root / "src" / "source", "second");
  bring_up_to_date(places, library);
  EXPECT_EQ(text_of(places.build / "library"), "second");
}

TEST_F(BringUpToDate, DoesNotWaitForAnotherWhereNothingHasChanged) {
  bring_up_to_date(places, library);
  const auto another = lock_of(places.work / ".lock");
  bring_up_to_date(places, library);  // hangs if it waits
}

TEST_F(BringUpToDate, LeavesABuildThatIsNotOursAlone) {
  Places foreign = places;
  foreign.work = folder / "cache";
  bring_up_to_date(foreign, library);
  EXPECT_FALSE(std::filesystem::exists(places.build / "library"));
}

TEST_F(BringUpToDate, StopsWithTheLogWhereTheBuildFails) {
  ::testing::internal::CaptureStderr();
  EXPECT_THROW(bring_up_to_date(places, {.what = "the library", .targets = {"broken"}}), Stop);
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("the reason why"), std::string::npos);
}

}  // namespace
}  // namespace moat::launcher
