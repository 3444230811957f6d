// Physical quantities: a double in SI whose dimension is part of its type.
#pragma once

#include <cmath>
#include <compare>
#include <string>

namespace moat {

/// A physical quantity with the dimension kg^mass * m^(half_length / 2) * s^time.
///
/// The value is kept in SI units. Lengths count in halves because the stiffness of a Hertz contact
/// is measured in N/m^1.5. Adding, comparing or passing quantities of different dimension does not
/// compile; products and quotients have the product and quotient of the dimensions:
///
///     const Stiffness k = 1.93 * MN / cm;
///     const Time period = 2 * pi * sqrt(mass / k);   // pi is in base/units.hpp
///
/// Quantities are made from units (`10 * cm`, base/units.hpp) and read back by division
/// (`gap / cm` is a plain double) or with si().
template <int mass, int half_length, int time>
class Quantity {
 public:
  static constexpr int mass_exponent = mass;                                         ///< Exponent of kg.
  static constexpr int half_length_exponent = half_length;                           ///< Exponent of m^1/2.
  static constexpr int time_exponent = time;                                         ///< Exponent of s.
  static constexpr bool dimensionless = mass == 0 && half_length == 0 && time == 0;  ///< Whether it is a plain number.

  /// Makes zero.
  constexpr Quantity() = default;

  /// From a value that is already in SI units. A plain number becomes a quantity only where the
  /// quantity has no dimension.
  constexpr explicit(!dimensionless) Quantity(double value_in_si) : si_{value_in_si} {}

  /// The value in SI units (m, kg, s, N, ...).
  [[nodiscard]] constexpr double si() const { return si_; }

  constexpr operator double() const requires(dimensionless) { return si_; }  ///< A number without dimension.

  constexpr Quantity operator-() const { return Quantity{-si_}; }  ///< With the other sign.
  constexpr Quantity operator+() const { return *this; }           ///< Itself.
  /// Adds.
  constexpr Quantity& operator+=(Quantity other) {
    si_ += other.si_;
    return *this;
  }
  /// Subtracts.
  constexpr Quantity& operator-=(Quantity other) {
    si_ -= other.si_;
    return *this;
  }
  /// Multiplies.
  constexpr Quantity& operator*=(double factor) {
    si_ *= factor;
    return *this;
  }
  /// Divides.
  constexpr Quantity& operator/=(double divisor) {
    si_ /= divisor;
    return *this;
  }

  // Without dimension these are those of double: both kinds together would leave `gap / cm > 10` ambiguous.
  friend constexpr Quantity operator+(Quantity a, Quantity b) requires(!dimensionless) {
    return Quantity{a.si_ + b.si_};
  }
  friend constexpr Quantity operator-(Quantity a, Quantity b) requires(!dimensionless) {
    return Quantity{a.si_ - b.si_};
  }
  friend constexpr std::partial_ordering operator<=>(Quantity a, Quantity b) requires(!dimensionless) {
    return a.si_ <=> b.si_;
  }
  friend constexpr bool operator==(Quantity a, Quantity b) requires(!dimensionless) = default;
  friend constexpr Quantity operator*(double factor, Quantity q) { return Quantity{factor * q.si_}; }
  friend constexpr Quantity operator*(Quantity q, double factor) { return Quantity{q.si_ * factor}; }
  friend constexpr Quantity operator/(Quantity q, double divisor) { return Quantity{q.si_ / divisor}; }
  friend constexpr Quantity<-mass, -half_length, -time> operator/(double number, Quantity q) {
    return Quantity<-mass, -half_length, -time>{number / q.si_};
  }
  /// The root of a quantity. It must have whole powers of kg and s, and whole or half powers of m.
  friend Quantity<mass / 2, half_length / 2, time / 2> sqrt(Quantity q) requires(!dimensionless && mass % 2 == 0 &&
                                                                                 half_length % 2 == 0 &&
                                                                                 time % 2 == 0) {
    return Quantity<mass / 2, half_length / 2, time / 2>{std::sqrt(q.si_)};
  }

 private:
  double si_ = 0.0;
};

/// The dimensions multiply too.
template <int m1, int l1, int t1, int m2, int l2, int t2>
constexpr Quantity<m1 + m2, l1 + l2, t1 + t2> operator*(Quantity<m1, l1, t1> a, Quantity<m2, l2, t2> b) {
  return Quantity<m1 + m2, l1 + l2, t1 + t2>{a.si() * b.si()};
}

/// The dimensions divide too.
template <int m1, int l1, int t1, int m2, int l2, int t2>
constexpr Quantity<m1 - m2, l1 - l2, t1 - t2> operator/(Quantity<m1, l1, t1> a, Quantity<m2, l2, t2> b) {
  return Quantity<m1 - m2, l1 - l2, t1 - t2>{a.si() / b.si()};
}

/// 1
using Dimensionless = Quantity<0, 0, 0>;
/// kg
using Mass = Quantity<1, 0, 0>;
/// m
using Length = Quantity<0, 2, 0>;
/// s
using Time = Quantity<0, 0, 1>;
/// 1/s
using Frequency = Quantity<0, 0, -1>;
/// m/s
using Speed = Quantity<0, 2, -1>;
/// m/s^2
using Acceleration = Quantity<0, 2, -2>;
/// N
using Force = Quantity<1, 2, -2>;
/// J
using Energy = Quantity<1, 4, -2>;
/// W
using Power = Quantity<1, 4, -3>;
/// N/m
using Stiffness = Quantity<1, 0, -2>;
/// N s/m
using DampingCoefficient = Quantity<1, 0, -1>;
/// kg m^2, about a vertical axis
using RotaryInertia = Quantity<1, 4, 0>;
/// rad
using Angle = Dimensionless;
/// N/m^1.5, the stiffness of a Hertz contact
using HertzStiffness = Quantity<1, -1, -2>;
/// m^2
using Area = Quantity<0, 4, 0>;
/// m^4, the second moment of an area
using SecondMoment = Quantity<0, 8, 0>;
/// kg/m^3
using Density = Quantity<1, -6, 0>;
/// Pa, a modulus of elasticity
using Modulus = Quantity<1, -2, -2>;

/// The SI unit of a dimension as it is written in output and messages: "m", "N/m^1.5", "1".
std::string unit_symbol(int mass, int half_length, int time);

/// The SI unit of a quantity type.
template <class Q>
std::string unit_symbol() {
  return unit_symbol(Q::mass_exponent, Q::half_length_exponent, Q::time_exponent);
}

}  // namespace moat
