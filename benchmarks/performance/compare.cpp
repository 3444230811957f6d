#include "performance/compare.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.hpp"
#include "measuring/command_output.hpp"
#include "output/file_io.hpp"

namespace moat::performance {
namespace {

using Times = std::map<std::string, double>;  // the shortest of each figure

void keep_shorter(Times& times, const std::filesystem::path& file) {
  static const std::set<std::string> units{"s", "ms", "us", "ns"};
  std::ifstream stream{file};
  const auto json = nlohmann::json::parse(stream);
  for (const auto& section : json.at("sections"))
    for (const auto& figure : section.at("figures"))
      if (const auto unit = figure.at("unit").get<std::string>(); units.contains(unit)) {
        double& time = times.try_emplace(figure.at("name").get<std::string>() + " [" + unit + "]", 1e300).first->second;
        time = std::min(time, figure.at("value").get<double>());
      }
}

// SUNDIALS, Octave and bare loops show how much the machine alone changes.
bool is_of_moat(const std::string& name) { return name.find(", moat") != name.npos || name.starts_with("street"); }

}  // namespace

int compare(const Comparison& comparison) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  Times a, b;
  for (int turn = 1; turn <= comparison.turns; ++turn)
    for (const bool other : {true, false}) {
      const std::filesystem::path out = comparison.folder / ((other ? "A" : "B") + std::to_string(turn));
      std::printf("%s: %s\n", out.filename().c_str(), (other ? comparison.other : self).c_str());
      std::fflush(stdout);
      output_of(shell_quoted(other ? comparison.other : self) + " --only " + comparison.section + " --out " +
                shell_quoted(out));
      keep_shorter(other ? a : b, out / "performance.json");
    }
  auto json = nlohmann::ordered_json::array();
  int slower = 0;
  for (const auto& [name, after] : b) {
    const auto before = a.find(name);
    if (before == a.end()) continue;
    const double ratio = after / before->second;
    const bool counts = is_of_moat(name) && ratio > comparison.bound;
    slower += counts ? 1 : 0;
    json.push_back({{"name", name}, {"a", before->second}, {"b", after}, {"ratio", ratio}});
    std::printf("%-95s %10.4g %10.4g  %.3f%s\n", name.c_str(), before->second, after, ratio, counts ? "  SLOWER" : "");
  }
  if (json.empty()) throw Error{"The two programs have no figure in common."};
  write_file(comparison.folder / "comparison.json", json.dump(2) + "\n");
  std::printf("%d of %zu figures are slower than %.3g times\n", slower, json.size(), comparison.bound);
  return slower;
}

}  // namespace moat::performance
