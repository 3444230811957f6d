// One case, from its computation to its outcome.

#include "study/engine.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <system_error>
#include <thread>
#include <vector>

#include "base/error.hpp"

namespace moat {
namespace {

const StudyCases cases{{.name = "gap", .unit = "cm", .values = {10.0}}};

CaseOutcome outcome(const StudyRecord& record) {
  return outcome_of(StudyCase{cases, 0},
                    [&](const StudyCase&) { return CaseOutcome{.state = CaseState::done, .results = record}; });
}

TEST(Case, MayNotHaveTwoResultsOfOneName) {
  EXPECT_EQ(outcome({{"drift", "storey 1", "m", 1.0}, {"drift", "storey 2", "m", 1.0}}).state, CaseState::done);
  const CaseOutcome twice =
      outcome({{"drift", "storey 1", "m", 1.0}, {"x", "", "1", 2.0}, {"drift", "storey 1", "m", 3.0}});
  EXPECT_EQ(twice.state, CaseState::failed);
  EXPECT_EQ(
      twice.reason,
      "The result \"drift\" of \"storey 1\" appears twice. Give every result of a case a name or a place of its own.");
  EXPECT_TRUE(twice.results.empty());
  const CaseOutcome axis = outcome({{"gap", "", "m", 1.0}});
  EXPECT_EQ(axis.reason, "The result \"gap\" has the name of an axis. Give it another name.");
  EXPECT_EQ(outcome({{"gap", "left", "m", 1.0}}).state, CaseState::done);
}

TEST(Case, KnowsTheFilesThatItRead) {
  const FileRead first{"/first", "1"}, second{"/second", "2"};
  const CaseOutcome computed = outcome_of(StudyCase{cases, 0}, [&](const StudyCase&) {
    note_file_read(first);
    note_file_read(second);
    note_file_read(second);
    return CaseOutcome{.state = CaseState::done, .files = {second}};
  });
  EXPECT_EQ(computed.files, (std::vector{second, first}));
  const CaseOutcome failed = outcome_of(StudyCase{cases, 0}, [&](const StudyCase&) -> CaseOutcome {
    note_file_read(first);
    throw InputError{"no"};
  });
  EXPECT_EQ(failed.files, std::vector{first});
  EXPECT_TRUE(outcome({}).files.empty());
  EXPECT_EQ(files_read_by_program(), std::vector<FileRead>{});
}

TEST(Threads, ComputeEveryCaseOnceAndAskOneAtATime) {
  const StudyCases all{{.name = "gap", .unit = "cm", .values = linearly_spaced(1.0, 100.0, 2000)}};
  std::vector<std::size_t> numbers(2000), computed;
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::atomic<int> asking = 0;
  bool one_at_a_time = true;
  const auto stop = [&] {
    if (++asking > 1) one_at_a_time = false;
    std::this_thread::sleep_for(std::chrono::microseconds{1});
    --asking;
    return false;
  };
  const std::vector<ComputeCase> workers(4, [](const StudyCase&) { return CaseOutcome{.state = CaseState::done}; });
  compute_cases(
      all, numbers, workers, [&](std::size_t number, CaseOutcome&&) { computed.push_back(number); }, stop);
  std::ranges::sort(computed);
  EXPECT_EQ(computed, numbers);
  EXPECT_TRUE(one_at_a_time);
}

// As under a limit on processes: no memory is left for the stacks of many threads.
TEST(Threads, ThatTheSystemDoesNotGiveAreNotNeeded) {
  const auto with_little_memory = [] {
    std::ifstream sizes{"/proc/self/statm"};
    rlim_t pages = 0;
    sizes >> pages;
    const rlim_t limit = pages * static_cast<rlim_t>(::getpagesize()) + 30'000'000;
    const rlimit both{limit, limit};
    if (::setrlimit(RLIMIT_AS, &both) != 0) std::_Exit(3);
    bool are_few = false;
    try {
      std::vector<std::jthread> many;
      for (int i = 0; i < 64; ++i)
        many.emplace_back([] { std::this_thread::sleep_for(std::chrono::milliseconds{50}); });
    } catch (const std::system_error&) {
      are_few = true;
    }
    const StudyCases all{{.name = "gap", .unit = "cm", .values = linearly_spaced(1.0, 100.0, 100)}};
    std::vector<std::size_t> numbers(100);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::size_t finished = 0;
    const std::vector<ComputeCase> workers(64, [](const StudyCase&) {
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
      return CaseOutcome{.state = CaseState::done};
    });
    compute_cases(all, numbers, workers, [&](std::size_t, CaseOutcome&&) { ++finished; }, {});
    std::_Exit(!are_few ? 2 : finished == 100 ? 0 : 1);
  };
  EXPECT_EXIT(with_little_memory(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace moat
