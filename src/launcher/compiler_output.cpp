#include "launcher/compiler_output.hpp"

#include <algorithm>
#include <regex>

#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

std::vector<Diagnostic> diagnostics_in(const std::string& output) {
  // A line with more than 4,000 columns has no column.
  static const std::regex head{R"((.+?):(\d{1,9})(?::(\d{1,9}))?: (?:fatal )?(error|warning|note): (.*))"};
  std::vector<Diagnostic> all;
  std::vector<std::string> before;
  for (const std::string& line : lines_of(replaced(replaced(output, "‘", "'"), "’", "'"))) {
    std::smatch match;
    const std::string short_line = with_short_lines(line);
    const std::size_t bar = line.find_first_not_of(" 0123456789");
    if (bar > 0 && bar < line.size() && line.compare(bar - 1, 2, " |") == 0 && !all.empty()) {
      all.back().snippet.push_back(line);
    } else if (matches(short_line, match, head)) {
      all.push_back({.file = match[1],
                     .line = std::stoi(match[2]),
                     .column = match[3].matched ? std::stoi(match[3]) : 0,
                     .kind = match[4],
                     .text = match[5],
                     .before = std::move(before),
                     .snippet = {}});
      before.clear();
    } else {
      before.push_back(short_line);
    }
  }
  return all;
}

bool same_place(const Diagnostic& a, const Diagnostic& b) {
  return a.column > 0 && a.file == b.file && a.line == b.line && a.column == b.column;
}

// Errors inside headers that belong to a failed deduction, or that the group's first error caused.
bool continues(const ErrorGroup& group, const Diagnostic& error, const std::string& script) {
  if (same_place(group.front(), error)) return true;
  return error.file != script && group.front().text.starts_with("class template argument deduction failed");
}

}  // namespace

std::string Diagnostic::underlined() const {
  if (snippet.size() < 2) return {};
  const std::string &source = snippet[0], &marks = snippet[1];
  const auto ascii = [](unsigned char c) { return c < 128; };
  if (!std::all_of(source.begin(), source.end(), ascii)) return {};  // columns are not bytes there
  const std::size_t bar = marks.find('|'), begin = marks.find_first_of("~^", bar);
  if (bar == std::string::npos || begin == std::string::npos || begin >= source.size()) return {};
  return source.substr(begin, marks.find_last_of("~^") + 1 - begin);
}

std::vector<ErrorGroup> error_groups(const std::string& output, const std::string& script) {
  std::vector<ErrorGroup> groups;
  for (Diagnostic& diagnostic : diagnostics_in(output)) {
    const bool opens = diagnostic.kind == "error" && (groups.empty() || !continues(groups.back(), diagnostic, script));
    if (opens) groups.emplace_back();
    if (!groups.empty()) groups.back().push_back(std::move(diagnostic));
  }
  return groups;
}

}  // namespace moat::launcher
