#include "launcher/text.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "base/text/terminal.hpp"
#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

using ShellQuoted = moat::testing::InTemporaryFolder;

TEST_F(ShellQuoted, IsReadBackByAShell) {
  for (const char* word : {"plain", "two words", "it's", "$(touch x)", "`a`", "\\", "\"", "*", "#1", "", "~", "a;b&c"})
    EXPECT_EQ(moat::testing::run_program("/bin/sh", {"-c", "printf %s " + shell_word(word)}, folder).output, word);
  EXPECT_EQ(shell_word("plain/name.cpp"), "plain/name.cpp");
}

TEST(Replaced, DoesNotReadItsOwnWords) { EXPECT_EQ(replaced("a$b$", "$", "$$"), "a$$b$$"); }

using TimeOfChange = moat::testing::InTemporaryFolder;

TEST_F(TimeOfChange, IsThatOfTheFileAndNotItsDate) {
  namespace fs = std::filesystem;
  const fs::path first = folder / "first", second = folder / "second";
  write_text(first, "");
  EXPECT_EQ(time_of_change(second), 0) << "there is no second";
  std::this_thread::sleep_for(std::chrono::milliseconds{20});  // longer than the clock of the file system ticks
  write_text(second, "");
  fs::last_write_time(second, fs::last_write_time(first) - std::chrono::hours{1});
  EXPECT_GT(time_of_change(second), time_of_change(first));
}

using InstalledText = InSmallCheckout;

TEST_F(InstalledText, NamesTheInstalledCommandAndItsExamples) {
  const std::string text = "  ./moat run examples/01_moat_wall.cpp\n  cd ~/study && ~/moat/moat run ./moat.cpp\n";
  EXPECT_EQ(places.adapted(text), text) << "a checkout";
  become_a_package();
  EXPECT_EQ(places.adapted(text), "  moat run " + (places.root / "examples/01_moat_wall.cpp").string() +
                                      "\n  cd ~/study && moat run ./moat.cpp\n");
}

}  // namespace
}  // namespace moat::launcher
