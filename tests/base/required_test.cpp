#include "base/required.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <type_traits>

#include "base/units.hpp"

namespace moat {
namespace {

using namespace units;

static_assert(!std::is_default_constructible_v<Required<Mass>>);
static_assert(!std::is_default_constructible_v<Required<double>>);
static_assert(std::is_copy_constructible_v<Required<Mass>>);
// A value that does not convert to Mass does not convert to Required<Mass>.
static_assert(!std::is_convertible_v<Stiffness, Required<Mass>>);
static_assert(!std::is_convertible_v<double, Required<Mass>>);
static_assert(std::is_convertible_v<Mass, Required<Mass>>);
static_assert(std::is_convertible_v<Required<Mass>, Mass>);
static_assert(std::is_convertible_v<int, Required<double>>);

struct Parameters {
  Required<Mass> mass;
  Required<double> ratio;
  Required<std::string> name;
};

TEST(Required, BehavesAsTheValueItHolds) {
  const Parameters parameters{.mass = 2 * tonne, .ratio = 0.65, .name = "base"};
  EXPECT_EQ(parameters.mass.si(), 2000.0);
  EXPECT_EQ(parameters.mass.value(), 2000 * kg);
  const Mass mass = parameters.mass;
  EXPECT_EQ(mass / tonne, 2.0);
  EXPECT_DOUBLE_EQ(parameters.ratio * parameters.ratio, 0.4225);
  EXPECT_EQ(parameters.name.value(), "base");
}

TEST(Required, CopiesAndAssigns) {
  Parameters parameters{.mass = 2 * tonne, .ratio = 0.65, .name = "base"};
  const Parameters copy = parameters;
  parameters.mass = 3 * tonne;
  parameters.ratio = 1;
  EXPECT_EQ(parameters.mass.si(), 3000.0);
  EXPECT_EQ(parameters.ratio.value(), 1.0);
  EXPECT_EQ(copy.mass.si(), 2000.0);
}

// 5.9 storeys were 5.
TEST(Required, TakesNoFractionForAWholeNumber) {
  static_assert(!std::convertible_to<double, Required<int>>);
  static_assert(!std::convertible_to<float, Required<int>>);
  static_assert(std::convertible_to<int, Required<int>>);
  static_assert(std::convertible_to<int, Required<double>>);
}

TEST(Required, TakesWhatCanOnlyBeMoved) {
  Required<std::unique_ptr<int>> pointer{std::make_unique<int>(7)};
  EXPECT_EQ(*pointer.value(), 7);
}

}  // namespace
}  // namespace moat
