#include "launcher/skipped_tests.hpp"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

// GoogleTest prints "file:line: Skipped", the reason on the following lines, and an empty line.
std::string reason_in(const std::string& output) {
  std::string reason;
  bool inside = false;
  for (const std::string& line : lines_of(output)) {
    if (inside && (line.empty() || line.starts_with('['))) break;
    if (inside) reason += (reason.empty() ? "" : " ") + line;
    if (line.ends_with(": Skipped")) inside = true;
  }
  return reason;
}

}  // namespace

std::vector<SkippedTest> skipped_tests(const std::filesystem::path& report) {
  std::vector<SkippedTest> skipped;
  if (!std::filesystem::exists(report)) return skipped;
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(report.string(), tree);
  for (const auto& [kind, test] : tree.get_child("testsuite")) {
    if (kind != "testcase") continue;
    const std::string status = test.get<std::string>("<xmlattr>.status");
    if (status != "notrun" && status != "disabled") continue;
    std::string reason = reason_in(test.get("system-out", ""));
    if (reason.empty()) reason = status;
    skipped.push_back({.name = test.get<std::string>("<xmlattr>.name"), .reason = reason});
  }
  return skipped;
}

}  // namespace moat::launcher
