#include "performance/function_timer.hpp"

#include <benchmark/benchmark.h>

#include <map>

#include "performance/measure.hpp"

namespace moat::performance {
namespace {

// Keeps what others print.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  std::map<std::string, std::vector<double>> nanoseconds;

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        nanoseconds[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
  }
};

}  // namespace

std::vector<Spread> nanoseconds_per_call(const std::vector<TimedFunction>& functions, int repetitions) {
  constexpr double least_seconds = 0.03;
  benchmark::ClearRegisteredBenchmarks();
  for (const TimedFunction& function : functions) {
    const auto loop = [&function](benchmark::State& state) {
      for ([[maybe_unused]] auto turn : state) {
        function.call();
        benchmark::ClobberMemory();
      }
    };
    benchmark::RegisterBenchmark(function.name.c_str(), loop)
        ->MinTime(least_seconds)
        ->Repetitions(repetitions)
        ->Unit(benchmark::kNanosecond);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector, "all");
  benchmark::ClearRegisteredBenchmarks();
  std::vector<Spread> spreads;
  for (const TimedFunction& function : functions) spreads.push_back(spread_of(collector.nanoseconds[function.name]));
  return spreads;
}

}  // namespace moat::performance
