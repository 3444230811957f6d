// Words of users, such as names of files and of walls, reach a terminal through print_text() and printable() alone.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>

#include "in_folder.hpp"

namespace moat::architecture {
namespace {

// Prints anything but a text that stands in the line itself.
std::string prints_in(const std::string& source) {
  static const std::regex prints{
      R"((std::(cout|cerr|clog) *<<(?! *"[^"\n]*"(?:;| << reason_of))|\b(puts|fputs|printf) *\((?!"))[^\n]*)"
      R"(|\bfprintf *\(std[^\n]*%s[^\n]*|\bfputs *\([^"][^\n]*)"};
  std::smatch found;
  return std::regex_search(source, found, prints) ? found.str() : "";
}

TEST(Printing, KnowsItsForms) {
  for (const char* text :
       {"std::cout << title;", "std::cerr <<\n name", "std::cerr << \"moat: \" << name;", "std::puts(name.c_str())",
        "std::fprintf(stderr, \"%s\", name)", "std::fputs(text.c_str(), stdout)"})
    EXPECT_NE(prints_in(text), "") << text;
  for (const char* text : {"print_text(std::cout, title)", "std::cerr << \"moat: a text\\n\";",
                           "std::snprintf(text, 9, \"%s\", name)", "std::cout.flush()"})
    EXPECT_EQ(prints_in(text), "") << text;
}

TEST(Printing, OfTheProgramsOfTheLibraryGoesThroughPrintableText) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{MOAT_SOURCE_DIR "/src"}) {
    const std::filesystem::path path = entry.path();
    // The launcher prints lines of its own. The bar of progress holds printable texts.
    if (path.extension() != ".cpp" || path.parent_path().filename() == "launcher" ||
        path.filename() == "progress_bar.cpp")
      continue;
    ++files;
    EXPECT_EQ(prints_in(testing::read_file(path)), "") << path;
  }
  EXPECT_GT(files, 100);
}

}  // namespace
}  // namespace moat::architecture
