#include "elements/shares.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace moat {
namespace {

// Elements add to the entries `element` and `element + 1`, every third to the ground.
struct Chain {
  std::size_t entries;
  template <class Add>
  void operator()(std::size_t element, Add add) const {
    add(element % 3 == 0 ? static_cast<int>(entries) : static_cast<int>(element), -1.0);
    add(static_cast<int>(element + 1), 0.3);
  }
};

double value_of(std::size_t element) { return 1.0 / static_cast<double>(element + 3); }

class SharesOnThreads : public ::testing::TestWithParam<int> {};

TEST_P(SharesOnThreads, SumAsALoopOverElementsWouldToTheLastBit) {
  for (const std::size_t elements : {std::size_t{1}, std::size_t{10}, std::size_t{50001}}) {
    const Chain chain{elements + 1};
    std::vector<double> looped(chain.entries + 1, 0.7), shared = looped;
    for (std::size_t e = 0; e < elements; ++e)
      chain(e, [&](int entry, double weight) { looped[static_cast<std::size_t>(entry)] += weight * value_of(e); });
    Shares{chain.entries, elements, chain}.add(GetParam(), value_of, shared.data());
    looped.back() = 0.7;  // the ground's, which shares leave out
    EXPECT_EQ(shared, looped);
  }
}

TEST(Shares, OfNothingAddNothing) {
  std::vector<double> sums{1.0};
  Shares{1, 0, [](std::size_t, auto) {}}.add(2, value_of, sums.data());
  EXPECT_EQ(sums[0], 1.0);
}

INSTANTIATE_TEST_SUITE_P(Threads, SharesOnThreads, ::testing::Values(1, 2));

}  // namespace
}  // namespace moat
