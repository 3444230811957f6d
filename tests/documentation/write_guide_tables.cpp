// Writes the tables of the guide that come from the code: write_guide_tables docs/guide.md

#include <exception>
#include <iostream>

#include "documentation_section.hpp"
#include "law_tables.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_guide_tables GUIDE\n";
    return 2;
  }
  try {
    moat::replace_section(argv[1], "impact laws", moat::testing::impact_law_tables());
    moat::replace_section(argv[1], "spring laws", moat::testing::spring_law_tables());
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
