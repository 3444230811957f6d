#include "base/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <numbers>

#include "base/units.hpp"

namespace moat {
namespace {

using namespace units;

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Comparable = requires(A a, B b) {
  a < b;
};

template <class A>
concept HasRoot = requires(A a) {
  sqrt(a);
};

static_assert(Addable<Length, Length> && !Addable<Length, Mass> && !Addable<Length, double>);
static_assert(Comparable<Force, Force> && !Comparable<Force, Stiffness>);
static_assert(!std::convertible_to<double, Length> && !std::convertible_to<Length, double>);
static_assert(!std::convertible_to<Stiffness, Mass> && !std::convertible_to<Stiffness, HertzStiffness>);
static_assert(std::convertible_to<Dimensionless, double>);
static_assert(std::same_as<decltype(2.95e9 * N / m_3_2), HertzStiffness>);
static_assert(std::same_as<decltype(kg * m / s / s), Force>);
static_assert(std::same_as<decltype(1.0 / s), Frequency>);
static_assert(HasRoot<Length> && !HasRoot<Mass> && !HasRoot<Speed>);
static_assert(std::same_as<decltype(sqrt(m * m)), Length>);
static_assert(std::same_as<decltype(sqrt(J / kg)), Speed>);
static_assert(sizeof(Length) == sizeof(double));

TEST(Quantity, KeepsSi) {
  EXPECT_DOUBLE_EQ((10 * cm).si(), 0.1);
  EXPECT_DOUBLE_EQ((1.93 * MN).si(), 1.93e6);
  EXPECT_DOUBLE_EQ((0.4 * g).si(), 0.4 * 9.80665);
  EXPECT_DOUBLE_EQ((2.95e9 * N / m_3_2).si(), 2.95e9);
  EXPECT_DOUBLE_EQ((1.93 * MN / cm).si(), 1.93e8);
}

TEST(Quantity, HasARootWhereTheDimensionAllows) {
  const Mass mass = 4 * tonne;
  const Stiffness k = 1 * MN / m;
  const Time period = 2 * pi * sqrt(mass / k);
  EXPECT_DOUBLE_EQ(period / s, 2.0 * std::numbers::pi * std::sqrt(0.004));
  const Speed fall = sqrt(2 * g * 10 * m);
  EXPECT_DOUBLE_EQ(fall.si(), std::sqrt(196.133));
}

TEST(Quantity, NamesItsUnit) {
  EXPECT_EQ(unit_symbol<Length>(), "m");
  EXPECT_EQ(unit_symbol<HertzStiffness>(), "N/m^1.5");
  EXPECT_EQ(unit_symbol<DampingCoefficient>(), "N s/m");
  EXPECT_EQ(unit_symbol<Area>(), "m^2");
  EXPECT_EQ(unit_symbol<SecondMoment>(), "m^4");
  EXPECT_EQ(unit_symbol<Density>(), "kg/m^3");
  EXPECT_EQ(unit_symbol<Modulus>(), "Pa");
  EXPECT_EQ((unit_symbol<Quantity<1, -1, 3>>()), "kg m^-0.5 s^3");
  EXPECT_EQ((unit_symbol<Quantity<0, 3, 0>>()), "m^1.5");
  EXPECT_EQ((unit_symbol<Quantity<2, 4, 0>>()), "kg^2 m^2");
}

// A quotient of two quantities of one dimension is used as the plain number it is.
constexpr Length gap = 12 * cm;

TEST(Dimensionless, ComparesWithPlainNumbers) {
  static_assert(gap / cm > 10);
  static_assert(gap / m < 1.0);
  static_assert(10.0 < gap / cm);
  static_assert(gap / gap == 1.0);
  static_assert(gap / gap == gap / gap);
  static_assert(gap / m != gap / cm);
  static_assert(gap / m <= gap / cm);
}

TEST(Dimensionless, AddsAndSubtractsPlainNumbers) {
  static_assert(gap / gap + 1.0 == 2.0);
  static_assert(1 - gap / gap == 0.0);
  static_assert(gap / gap + gap / gap == 2.0);
  static_assert((gap / gap - gap / gap) * m == 0 * m);
  Dimensionless sum = gap / gap;
  sum += 0.5;
  EXPECT_EQ(sum, 1.5);
  EXPECT_DOUBLE_EQ(std::sqrt(gap / (3 * cm)), 2.0);
}

}  // namespace
}  // namespace moat
