#include "peers/ladders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace moat::peers {
namespace {

constexpr performance::Peaks reference{0.3, 0.4, 5.0, 6.0, 1e7};

/// The error falls with the square of the time.
Ladder ladder(const std::string& name, const std::vector<double>& seconds, double seconds_for_unit_error) {
  Ladder made{name, {}};
  for (const double time : seconds)
    made.settings.push_back({"setting", [time, seconds_for_unit_error] {
                               History history{reference, time};
                               history.peaks[2] *= 1.0 + std::pow(seconds_for_unit_error / time, 2.0);
                               return history;
                             }});
  return made;
}

TEST(Costs, AreReadOffTheTimesOfEveryRound) {
  const std::vector<Cost> found = costs({ladder("one", {1.0, 4.0, 16.0}, 0.1)}, reference, 1e-3, 3);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].seconds.size(), 3u);
  ASSERT_EQ(found[0].errors.size(), 3u) << "one of every setting";
  EXPECT_NEAR(found[0].errors[1], 0.1 * 0.1 / 16.0, 1e-12);
  for (const double seconds : found[0].seconds) EXPECT_NEAR(seconds, 0.1 / std::sqrt(1e-3), 1e-9);
}

TEST(Costs, OfOneNameAreThoseOfTheCheapestLadder) {
  const std::vector<Cost> found = costs({ladder("one", {1.0, 1.1}, 1.0), ladder("one", {1.0, 16.0}, 0.2),
                                         ladder("one", {1.0, 16.0}, 0.1), ladder("two", {1.0, 1.1}, 1.0)},
                                        reference, 1e-3, 1);
  ASSERT_EQ(found.size(), 2u);
  ASSERT_EQ(found[0].seconds.size(), 1u);
  EXPECT_NEAR(found[0].seconds[0], 0.1 / std::sqrt(1e-3), 1e-9);
  EXPECT_EQ(found[1].name, "two");
  EXPECT_TRUE(found[1].seconds.empty()) << "no setting is so exact";
}

}  // namespace
}  // namespace moat::peers
