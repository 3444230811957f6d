// The lines of a Tcl file as words.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace moat::peers {

struct Tcl {
  std::vector<std::vector<std::string>> lines;
  std::vector<int> measured;  ///< the tags that the writer returned

  explicit Tcl(const std::string& text) {
    std::istringstream stream{text};
    for (std::string line; std::getline(stream, line);) {
      std::istringstream words{line};
      auto& list = lines.emplace_back();
      for (std::string word; words >> word;) list.push_back(word);
    }
  }

  /// The lines with this first word, and with this second one unless it is empty.
  [[nodiscard]] std::vector<std::vector<std::string>> starting_with(const std::string& word,
                                                                    const std::string& second = "") const {
    std::vector<std::vector<std::string>> found;
    for (const auto& line : lines)
      if (line.front() == word && (second.empty() || line.at(1) == second)) found.push_back(line);
    return found;
  }
};

}  // namespace moat::peers
