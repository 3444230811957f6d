#include "recipes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace moat::testing {
namespace {

// Each folder that tests/documentation/CMakeLists.txt has made holds the files that it compiles.
TEST(Contributing, HasNoRecipeThatNoTestCompiles) {
  for (const auto& [name, code] : code_of_recipes(MOAT_SOURCE_DIR "/CONTRIBUTING.md"))
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path{MOAT_RECIPES} / name))
        << name << " has no moat_add_recipe() in tests/documentation/CMakeLists.txt";
}

}  // namespace
}  // namespace moat::testing
