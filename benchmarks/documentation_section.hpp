// Generated sections of a document that is otherwise written by hand.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "base/error.hpp"

namespace moat {

/// Replaces the text of a Markdown file between the lines
///
///     <!-- NAME: begin, written by COMMAND -->  and  <!-- NAME: end -->
///
/// Throws FileError where the file or one of the two lines is missing.
inline void replace_section(const std::filesystem::path& path, const std::string& name, const std::string& text) {
  std::ifstream input{path};
  if (!input) throw FileError{path.string() + ": cannot be read."};
  std::ostringstream content;
  content << input.rdbuf();
  std::string document = content.str();
  const std::size_t begin = document.find("<!-- " + name + ": begin");
  const std::size_t end = document.find("<!-- " + name + ": end -->");
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw FileError{path.string() + ": has no section between <!-- " + name + ": begin ... --> and <!-- " + name +
                    ": end -->."};
  const std::size_t after_begin = document.find('\n', begin) + 1;
  document.replace(after_begin, end - after_begin, "\n" + text + "\n");
  std::ofstream output{path};
  output << document;
  if (!output.flush()) throw FileError{path.string() + ": cannot be written."};
}

}  // namespace moat
