#include "measuring/five_peaks.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace moat::performance {
namespace {

constexpr Peaks reference{0.3, 0.4, 5.0, 6.0, 1e7};

TEST(LargestError, IsThatOfTheWorstPeak) {
  EXPECT_EQ(largest_error(reference, reference), 0.0);
  EXPECT_NEAR(largest_error({0.3, 0.39, 5.0, 6.06, 1e7}, reference), 0.025, 1e-12);
}

TEST(LargestError, IsVeryLargeWhereAPeakIsNoNumber) {
  for (std::size_t i = 0; i < reference.size(); ++i)
    for (const double useless : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Peaks peaks = reference;
      peaks[i] = useless;
      EXPECT_GE(largest_error(peaks, reference), 1e9) << i;
    }
}

}  // namespace
}  // namespace moat::performance
