#include "recipes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "in_folder.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

class CodeOfRecipes : public InFolder {
 protected:
  [[nodiscard]] std::string written(const std::string& text) const {
    const std::string path = (folder / "recipes.md").string();
    std::ofstream{path} << text;
    return path;
  }
};

TEST_F(CodeOfRecipes, IsTheBlockAfterEveryMark) {
  const auto code = code_of_recipes(
      written("# Title\n<!-- recipe: law/a.hpp -->\n```cpp\nint a;\n\nint b;\n```\n```cpp\nnot marked\n```\n"
              "<!-- recipe: law/b.hpp -->\n```\nint c;\n```\n"));
  EXPECT_EQ(code, (std::map<std::string, std::string>{{"law/a.hpp", "int a;\n\nint b;\n"}, {"law/b.hpp", "int c;\n"}}));
}

TEST_F(CodeOfRecipes, RefusesMarksWithoutTheirCode) {
  const auto refusal = [this](const std::string& text) {
    return message_of<std::runtime_error>([&] { code_of_recipes(written(text)); });
  };
  EXPECT_TRUE(refusal("<!-- recipe: a/b -->\n\n```\n```\n").ends_with("no code block after the mark of a/b."));
  EXPECT_TRUE(refusal("<!-- recipe: a/b -->\n```\nint a;\n").ends_with("the code block of a/b does not end."));
  EXPECT_TRUE(
      refusal("<!-- recipe: a/b -->\n```\n```\n<!-- recipe: a/b -->\n```\n```\n").ends_with("a/b occurs twice."));
  EXPECT_TRUE(refusal("<!-- recipe: a/b\n").ends_with("has no end."));
}

// Each folder that tests/documentation/CMakeLists.txt has made holds the files that it compiles.
TEST(Contributing, HasNoRecipeThatNoTestCompiles) {
  for (const auto& [name, code] : code_of_recipes(MOAT_SOURCE_DIR "/CONTRIBUTING.md"))
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path{MOAT_RECIPES} / name))
        << name << " has no moat_add_recipe() in tests/documentation/CMakeLists.txt";
}

}  // namespace
}  // namespace moat::testing
