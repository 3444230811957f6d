#include "launcher/time_of_change.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

using TimeOfChange = InSmallCheckout;

TEST_F(TimeOfChange, IsThatOfTheFileAndNotItsDate) {
  namespace fs = std::filesystem;
  const fs::path first = folder / "first", second = folder / "second";
  write_text(first, "");
  EXPECT_TRUE(changed_after(first, second)) << "there is no second";
  EXPECT_FALSE(changed_after(second, first));
  std::this_thread::sleep_for(std::chrono::milliseconds{20});  // longer than the clock of the file system ticks
  write_text(second, "");
  fs::last_write_time(second, fs::last_write_time(first) - std::chrono::hours{1});
  EXPECT_TRUE(changed_after(second, first));
  EXPECT_FALSE(changed_after(first, second));
}

TEST_F(TimeOfChange, IsComparedWithTheWritingOfAStamp) {
  namespace fs = std::filesystem;
  const auto tick = [] { std::this_thread::sleep_for(std::chrono::milliseconds{20}); };
  const fs::path file = folder / "file", stamp = folder / "stamp";
  write_text(file, "");
  EXPECT_TRUE(changed_since_written(file, stamp)) << "there is no stamp";
  tick();
  write_text(folder / "new stamp", "");
  EXPECT_FALSE(changed_since_written(file, folder / "new stamp"));
  tick();
  write_text(file, "");
  fs::rename(folder / "new stamp", stamp);
  EXPECT_TRUE(changed_since_written(file, stamp)) << "a new name does not make a stamp later";
}

}  // namespace
}  // namespace moat::launcher
