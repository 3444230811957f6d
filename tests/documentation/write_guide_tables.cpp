// Writes the tables of the reference that come from the code: write_guide_tables docs/reference

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "documentation_section.hpp"
#include "law_pictures.hpp"
#include "law_tables.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_guide_tables FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder{argv[1]};
    moat::replace_section(folder / "impact_laws.md", "impact laws", moat::testing::impact_law_tables());
    moat::replace_section(folder / "isolators_and_storeys.md", "spring laws", moat::testing::spring_law_tables());
    const std::filesystem::path images = folder.parent_path() / "images";
    std::ofstream{images / "impact_laws.svg"} << moat::testing::impact_law_picture();
    std::ofstream{images / "spring_laws.svg"} << moat::testing::spring_law_picture();
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
