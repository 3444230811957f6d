#include "launcher/without_progress.hpp"

#include <regex>

#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

// Headline of a step. The output of the step follows, if there is any.
bool begins_step(const std::string& line) {
  static const std::regex step{R"(\[\d+/\d+\] .*|(/\S*/)?clang-tidy(-\d+)? .*)"};
  return matches(line, step);
}

bool is_noise(const std::string& line) {
  static const std::regex noise{
      R"(ninja: Entering directory .*|ninja: build stopped: .*)"
      R"(|-- .*)"
      R"(| +Start +\d+: .*| *\d+/\d+ Test +#\d+: .* Passed .*)"
      R"(|\d+ warnings? (treated as errors?|generated\.)|Suppressed \d+ warnings .*|Use -header-filter=.*)"};
  return matches(line, noise);
}

}  // namespace

std::string without_progress(const std::string& log) {
  std::string kept, headline;
  bool is_command = false;
  for (const std::string& line : lines_of(with_short_lines(log))) {
    if (is_command) {  // of the step that failed, thousands of letters
      is_command = false;
    } else if (begins_step(line)) {
      headline = line + "\n";
    } else if (!is_noise(line) && !(line.empty() && !headline.empty())) {
      is_command = line.starts_with("FAILED: ");
      kept += headline + line + "\n";
      headline.clear();
    }
  }
  return kept.empty() ? with_short_lines(log) : kept;
}

}  // namespace moat::launcher
