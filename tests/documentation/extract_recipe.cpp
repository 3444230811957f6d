// Writes the code of a recipe in a Markdown file to files of their own, so that the compiler sees it.
//
//     extract_recipe CONTRIBUTING.md impact_law OUTPUT_FOLDER lee_wang.hpp ...

#include <filesystem>
#include <fstream>
#include <iostream>

#include "recipes.hpp"

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: extract_recipe MARKDOWN RECIPE OUTPUT_FOLDER FILE...\n";
    return 2;
  }
  const std::string recipe = argv[2];
  const std::filesystem::path folder = argv[3];
  try {
    const auto code = moat::testing::code_of_recipes(argv[1]);
    std::filesystem::remove_all(folder);  // files that the recipe no longer has must not be found by #include
    for (int i = 4; i < argc; ++i) {
      const auto found = code.find(recipe + "/" + argv[i]);
      if (found == code.end()) {
        std::cerr << argv[1] << ": the recipe " << recipe << " has no code block of the file " << argv[i] << ".\n";
        return 1;
      }
      std::filesystem::create_directories((folder / argv[i]).parent_path());
      std::ofstream{folder / argv[i]} << found->second;
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
