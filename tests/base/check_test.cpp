#include "base/check.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <type_traits>

#include "base/error.hpp"
#include "base/units.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;

using testing::message_of;

const Check check{"Gap", "moat left"};

// A check keeps a view of its name: a temporary does not compile, whether constant or not.
static_assert(!std::is_constructible_v<Check, const char*, std::string>);
static_assert(!std::is_constructible_v<Check, const char*, const std::string>);
static_assert(std::is_constructible_v<Check, const char*, const std::string&>);

TEST(Check, NamesObjectParameterValueRangeUnitAndAdvice) {
  EXPECT_EQ(message_of([] { check.positive("clearance", -10 * cm, "Give the distance at rest."); }),
            "Gap \"moat left\": clearance = -0.1 m is not allowed; it must be > 0 m and finite. "
            "Give the distance at rest.");
  EXPECT_EQ(
      message_of([] { check.above_up_to("restitution", 1.2, 0.0, 1.0, "1"); }),
      "Gap \"moat left\": restitution = 1.2 is not allowed; it must be > 0 and <= 1. Give a number in this range.");
}

TEST(Check, RefusesWhatIsNotFinite) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_THROW(check.positive("x", bad, "m"), InputError) << bad;
    EXPECT_THROW(check.not_negative("x", bad, "m"), InputError) << bad;
    EXPECT_THROW(check.finite("x", bad, "m"), InputError) << bad;
    EXPECT_THROW(check.between("x", bad, 0.0, 1.0, "m"), InputError) << bad;
  }
}

TEST(Check, LetsTheBoundsThrough) {
  EXPECT_NO_THROW(check.not_negative("x", 0.0, "m"));
  EXPECT_THROW(check.positive("x", 0.0, "m"), InputError);
  EXPECT_NO_THROW(check.above_up_to("x", 1.0, 0.0, 1.0, "1"));
  EXPECT_THROW(check.above_up_to("x", 0.0, 0.0, 1.0, "1"), InputError);
}

}  // namespace
}  // namespace moat
