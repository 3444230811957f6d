#include "launcher/bench.hpp"

#include <algorithm>
#include <array>

#include "launcher/library.hpp"
#include "launcher/process.hpp"
#include "launcher/records.hpp"
#include "launcher/stop.hpp"

namespace moat::launcher {

void run_benchmark(const Places& places, const std::vector<std::string>& words) {
  constexpr std::array names{"paper", "accuracy", "isolators", "performance", "peers"};
  const std::string known = "\nThere are ./moat bench paper, accuracy, isolators, performance and peers.";
  if (words.empty()) throw Stop{exit_usage, "bench needs the name of a benchmark." + known};
  const std::string& name = words.front();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw Stop{exit_usage, "There is no benchmark " + name + "." + known};

  find_records("bench");
  Part part{.what = "the library and the benchmark", .targets = {"moat_for_scripts", "moat_bench_" + name}};
  if (name == "performance") {
    part.package_lists = {"bench"};
    part.cmake_option = "MOAT_BENCH_PERFORMANCE";
  }
  bring_up_to_date(places, part);
  const std::filesystem::path program = places.build / "benchmarks" / name / name;
  become(program, program, {words.begin() + 1, words.end()});
  throw Stop{exit_failed, program.string() + " cannot be started."};
}

}  // namespace moat::launcher
