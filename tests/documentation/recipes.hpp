// The code blocks of recipes in a Markdown file.
#pragma once

#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

namespace moat::testing {

/// The text of every code block that follows a line
///
///     <!-- recipe: impact_law/lee_wang.hpp -->
///
/// by its name, here "impact_law/lee_wang.hpp". Throws std::runtime_error for a file that cannot be read, a mark
/// without a code block right after it, a block that does not end, and a name that occurs twice.
inline std::map<std::string, std::string> code_of_recipes(const std::string& markdown_file) {
  const std::string mark = "<!-- recipe: ", mark_end = " -->", fence = "```";
  std::ifstream input{markdown_file};
  if (!input) throw std::runtime_error{markdown_file + ": cannot be read."};
  std::map<std::string, std::string> blocks;
  for (std::string line; std::getline(input, line);) {
    if (!line.starts_with(mark)) continue;
    if (!line.ends_with(mark_end)) throw std::runtime_error{markdown_file + ": \"" + line + "\" has no end."};
    const std::string name = line.substr(mark.size(), line.size() - mark.size() - mark_end.size());
    if (!std::getline(input, line) || !line.starts_with(fence))
      throw std::runtime_error{markdown_file + ": no code block after the mark of " + name + "."};
    std::string code;
    while (std::getline(input, line) && line != fence) code += line + "\n";
    if (!input) throw std::runtime_error{markdown_file + ": the code block of " + name + " does not end."};
    if (!blocks.emplace(name, code).second) throw std::runtime_error{markdown_file + ": " + name + " occurs twice."};
  }
  return blocks;
}

}  // namespace moat::testing
