#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <vector>

namespace moat {
namespace {

struct Least {
  double value = std::numeric_limits<double>::infinity();
  void merge(const Least& other) { value = std::min(value, other.value); }
};

class ForRanges : public ::testing::TestWithParam<int> {};

TEST_P(ForRanges, CoversEveryIndexOnce) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, shortest_parallel_loop, std::size_t{100003}}) {
    std::vector<std::atomic<int>> visits(count);
    for_ranges(GetParam(), count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_TRUE(std::ranges::all_of(visits, [](const auto& v) { return v == 1; })) << count;
  }
}

TEST_P(ForRanges, GathersFromEveryRange) {
  const std::size_t count = 100003;
  for (const std::size_t place : {std::size_t{0}, std::size_t{50000}, count - 1}) {
    Least least{7.0};
    for_ranges(GetParam(), count, least, [&](std::size_t begin, std::size_t end, Least& part) {
      for (std::size_t i = begin; i < end; ++i) part.value = std::min(part.value, i == place ? 1.0 : 5.0);
    });
    EXPECT_EQ(least.value, 1.0) << place;
  }
}

TEST_P(ForRanges, KeepsWhatWasGatheredBefore) {
  Least least{0.5};
  for_ranges(GetParam(), 100003, least,
             [](std::size_t, std::size_t, Least& part) { part.value = std::min(part.value, 1.0); });
  EXPECT_EQ(least.value, 0.5);
}

TEST_P(ForRanges, PassesOnExceptions) {
  EXPECT_THROW(for_ranges(GetParam(), 100003, [](std::size_t, std::size_t) { throw std::runtime_error{"no"}; }),
               std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Threads, ForRanges, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace moat
