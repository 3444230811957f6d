#include "launcher/installed_text.hpp"

#include <gtest/gtest.h>

#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

using InstalledText = InSmallCheckout;

TEST_F(InstalledText, NamesTheInstalledCommandAndItsExamples) {
  become_a_package();
  const std::string text = "  ./moat run examples/01_moat_wall.cpp\n  cd ~/study && ~/moat/moat run ./moat.cpp\n";
  EXPECT_EQ(as_installed(text, places), "  moat run " + (places.root / "examples/01_moat_wall.cpp").string() +
                                            "\n  cd ~/study && moat run ./moat.cpp\n");
}

TEST_F(InstalledText, StaysAsItIsInACheckout) {
  EXPECT_EQ(as_installed("./moat run examples/01_moat_wall.cpp", places), "./moat run examples/01_moat_wall.cpp");
}

}  // namespace
}  // namespace moat::launcher
