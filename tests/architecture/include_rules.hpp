// The rules of DESIGN "The house": which folder may include which, checked on the #include lines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moat::architecture {

/// A source file: its path relative to the checkout ("src/base/check.hpp") and its text.
struct SourceFile {
  std::string path;
  std::string text;
};

/// Every .hpp, .h and .cpp file under src, materials, elements, structures and analyses, sorted by path.
std::vector<SourceFile> read_sources(const std::filesystem::path& checkout);

/// One sentence for each broken rule, naming the file and the line:
///  - an include of a folder that the including folder may not know, or a folder without a rule;
///  - a quoted include that names no file of the project;
///  - a header that includes Trilinos, VTK, SuiteSparse, SQLite or MPI (they stay in .cpp files);
///  - a file that includes VTK, and is not the one that writes with it;
///  - any file that includes a GPL part of SuiteSparse;
///  - files that include each other in a circle.
std::vector<std::string> broken_rules(const std::vector<SourceFile>& sources);

}  // namespace moat::architecture
