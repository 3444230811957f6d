#include "performance/compare.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "measuring/command_output.hpp"

namespace moat::performance {
namespace {

using Times = std::map<std::string, double>;  // the shortest of each figure

void keep_shorter(Times& times, const std::filesystem::path& file) {
  std::ifstream stream{file};
  const auto json = nlohmann::json::parse(stream);
  for (const auto& section : json.at("sections"))
    for (const auto& figure : section.at("figures")) {
      const auto unit = figure.at("unit").get<std::string>();
      if (unit != "s" && unit != "ms") continue;
      double& time = times.try_emplace(figure.at("name").get<std::string>() + " [" + unit + "]", 1e300).first->second;
      time = std::min(time, figure.at("value").get<double>());
    }
}

}  // namespace

void compare(const Comparison& comparison) {
  const std::string self = shell_quoted(std::filesystem::read_symlink("/proc/self/exe")),
                    other = shell_quoted(std::filesystem::absolute(comparison.other));
  // Streets are computed in processes of their own, so that both builds have streets of the same sizes.
  const std::string before = comparison.section == "scale" ? self + " --street-program " + other : other;
  Times a, b;
  for (int turn = 1; turn <= comparison.turns; ++turn)
    for (const bool first : {true, false}) {
      const std::filesystem::path out = comparison.folder / ((first ? "A" : "B") + std::to_string(turn));
      std::printf("%s: %s\n", out.filename().c_str(), (first ? before : self).c_str());
      std::fflush(stdout);
      output_of((first ? before : self) + " --only " + comparison.section + " --out " + shell_quoted(out));
      keep_shorter(first ? a : b, out / "performance.json");
    }
  bool common = false;
  for (const auto& [name, after] : b) {
    const auto found = a.find(name);
    if (found == a.end()) continue;
    common = true;
    std::printf("%-95s %10.4g %10.4g  %.3f\n", name.c_str(), found->second, after, after / found->second);
  }
  if (!common) throw Error{"The two programs have no figure in common."};
}

}  // namespace moat::performance
