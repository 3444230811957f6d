// The benchmark building beside peaks of an independent program.
//
// S. Narasimhan, S. Nagarajaiah, E. A. Johnson, H. P. Gavin, Structural Control and Health Monitoring 13 (2006) 573.
#include "benchmark_building.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/sections.hpp"
#include "measuring/five_peaks.hpp"

namespace moat::experiments {

std::string benchmark_building(const Folders&) {
  struct Variant {
    std::string name;
    Superstructure building;
    bool has_walls, has_dashpots;
    const std::vector<testing::ExpectedPeak>& expected;
  };
  const testing::BenchmarkBuilding benchmark;
  const std::vector<Variant> variants{
      {"linear bearings", benchmark.from_matrices(), false, true, testing::without_walls},
      {"linear bearings, walls", benchmark.from_matrices(), true, true, testing::with_walls},
      {"lead-rubber bearings", benchmark.on_lead_rubber(), false, false, testing::on_lead_rubber}};
  std::vector<std::string> titles{"given / moat, SI units"}, impacts{"impacts of corners"};
  std::vector<std::vector<std::string>> rows;
  double worst = 0.0;
  for (const auto& [name, building, has_walls, has_dashpots, expected] : variants) {
    const CaseResult result = testing::run_benchmark(building, has_walls, has_dashpots).result;
    for (const auto& [quantity, where, value] : expected) {
      const double found = performance::peak_of(result, quantity, where);
      worst = std::max(worst, std::abs(found / value - 1.0));
      std::string peak = quantity + std::string{", "} + where;
      std::ranges::replace(peak, '_', ' ');
      auto line = std::ranges::find_if(rows, [&](const auto& each) { return each.front() == peak; });
      if (line == rows.end()) line = rows.insert(line, {peak});
      line->resize(titles.size());
      line->push_back(to_significant(value, 7) + " / " + to_significant(found, 7));
    }
    titles.push_back(name);
    impacts.push_back(
        has_walls ? std::to_string(testing::impacts_with_walls) + " / " + std::to_string(result.impacts.size()) : "");
  }
  rows.push_back(impacts);
  std::string text = heading(titles);
  for (std::vector<std::string>& line : rows) {
    line.resize(titles.size());
    text += row(line);
  }
  return text + "\nLargest difference of all peaks: " + to_fixed(100.0 * worst, 4) + " %.\n\n";
}

}  // namespace moat::experiments
