#include "base/required.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <type_traits>

#include "base/units.hpp"

namespace moat {
namespace {

static_assert(!std::is_default_constructible_v<Required<Mass>>);
static_assert(!std::is_default_constructible_v<Required<double>>);
static_assert(std::is_copy_constructible_v<Required<Mass>>);
// A value that does not convert to Mass does not convert to Required<Mass>.
static_assert(!std::is_convertible_v<Stiffness, Required<Mass>>);
static_assert(!std::is_convertible_v<double, Required<Mass>>);
static_assert(std::is_convertible_v<Mass, Required<Mass>>);
static_assert(std::is_convertible_v<Required<Mass>, Mass>);
static_assert(std::is_convertible_v<int, Required<double>>);
// 5.9 storeys were 5.
static_assert(!std::is_convertible_v<double, Required<int>>);
static_assert(!std::is_convertible_v<float, Required<int>>);
static_assert(std::is_convertible_v<int, Required<int>>);

TEST(Required, TakesWhatCanOnlyBeMoved) {
  Required<std::unique_ptr<int>> pointer{std::make_unique<int>(7)};
  EXPECT_EQ(*pointer.value(), 7);
}

}  // namespace
}  // namespace moat
