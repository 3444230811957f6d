// The text that GCC prints, taken apart.
#pragma once

#include <string>
#include <vector>

namespace moat::launcher {

/// One "file:line:column: kind: text" with the lines around it.
struct Diagnostic {
  std::string file;
  int line = 0, column = 0;  ///< column 0: not known
  std::string kind;          ///< "error", "warning", "note"
  std::string text;
  std::vector<std::string> before;   ///< "In file included from ...", "required from here"
  std::vector<std::string> snippet;  ///< the line of the source and its underlining

  /// The underlined piece of the source, "500 * kN"; empty if there is none.
  [[nodiscard]] std::string underlined() const;
};

/// An error with all that the compiler says about it.
using ErrorGroup = std::vector<Diagnostic>;

/// Every group begins with an error; warnings by themselves are left out. Errors at one place of the script, and those
/// that follow from a failed deduction of template arguments, are one group.
std::vector<ErrorGroup> error_groups(const std::string& output, const std::string& script);

}  // namespace moat::launcher
