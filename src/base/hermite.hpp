// Polynomials through values and derivatives at both ends of a step.
#pragma once

#include <cmath>

namespace moat {

/// The cubic through values and rates at both ends of a step leaves the range of its values there by at most 4/27 of
/// the step times each rate; this bounds it.
inline constexpr double cubic_beyond_ends = 0.15;

/// A quantity over one step, x = t/h from 0 to 1: the cubic through value and rate at both ends. Its error is
/// h^4/384 of the fourth derivative.
class HermiteCubic {
 public:
  /// Values, rates (per second) and the length h > 0 s of the step.
  HermiteCubic(double value0, double rate0, double value1, double rate1, double h)
      : value_{value0},
        rise_{value1 - value0},
        left_{h * rate0 - (value1 - value0)},
        right_{(value1 - value0) - h * rate1},
        h_{h} {}

  /// False where the rate at one end is much larger than the other rate and the rise allow: the quantity has an
  /// infinite slope there, like d^1/4 at d = 0, and the cubic overshoots. For a parabola |h rate0| <= 2 |rise| + |h
  /// rate1|.
  [[nodiscard]] bool is_smooth() const {
    constexpr double far_beyond = 4.0;
    const double rise = std::fabs(rise_), slope0 = std::fabs(left_ + rise_), slope1 = std::fabs(rise_ - right_);
    return slope0 <= far_beyond * (2.0 * rise + slope1) && slope1 <= far_beyond * (2.0 * rise + slope0);
  }

  /// At x, 0 at the left end and 1 at the right.
  [[nodiscard]] double value(double x) const {
    return value_ + x * (rise_ + (1.0 - x) * ((1.0 - x) * left_ + x * right_));
  }
  /// Returns the rate of the value, per second.
  [[nodiscard]] double rate(double x) const {
    return (rise_ + (1.0 - x) * (1.0 - 3.0 * x) * left_ + x * (2.0 - 3.0 * x) * right_) / h_;
  }
  /// Where the rate is zero inside the step if the rates at its ends have opposite signs: the root between them.
  [[nodiscard]] double turn() const {
    // h * rate = c + b x + a x^2 with c and c + b + a of opposite signs. The form without cancellation.
    const double c = rise_ + left_, b = 2.0 * right_ - 4.0 * left_, a = 3.0 * (left_ - right_);
    const double root = std::sqrt(std::fmax(b * b - 4.0 * a * c, 0.0));
    const double q = -0.5 * (b + std::copysign(root, b));
    const double first = q != 0.0 ? c / q : -1.0;
    return first >= 0.0 && first <= 1.0 ? first : a != 0.0 ? std::fmin(std::fmax(q / a, 0.0), 1.0) : 0.5;
  }

 private:
  double value_, rise_, left_, right_, h_;
};

/// A quantity over one step, x = t/h from 0 to 1: the quintic through value and first two derivatives at both ends.
/// Its error is h^6/46080 of the sixth derivative.
class HermiteQuintic {
 public:
  /// Values, rates and their rates (per second, per second squared) and the length h > 0 s of the step.
  HermiteQuintic(double value0, double rate0, double second0, double value1, double rate1, double second1, double h)
      : h_{h} {
    const double rise = value1 - value0, slope0 = h * rate0, slope1 = h * rate1;
    const double bend0 = 0.5 * h * h * second0, bend1 = 0.5 * h * h * second1;
    c_[0] = value0;
    c_[1] = slope0;
    c_[2] = bend0;
    c_[3] = 10.0 * rise - 6.0 * slope0 - 4.0 * slope1 - 3.0 * bend0 + bend1;
    c_[4] = -15.0 * rise + 8.0 * slope0 + 7.0 * slope1 + 3.0 * bend0 - 2.0 * bend1;
    c_[5] = 6.0 * rise - 3.0 * (slope0 + slope1) - bend0 + bend1;
  }

  /// At x, 0 at the left end and 1 at the right.
  [[nodiscard]] double value(double x) const {
    return c_[0] + x * (c_[1] + x * (c_[2] + x * (c_[3] + x * (c_[4] + x * c_[5]))));
  }
  /// Returns the rate of the value, per second.
  [[nodiscard]] double rate(double x) const {
    return (c_[1] + x * (2.0 * c_[2] + x * (3.0 * c_[3] + x * (4.0 * c_[4] + x * 5.0 * c_[5])))) / h_;
  }

 private:
  double c_[6];
  double h_;
};

/// One place on many such quintics over the same step: HermiteQuintic{...}.value(x) with less to compute.
class HermiteQuinticsAt {
 public:
  /// At x, 0 to 1, of a step of length h > 0 s.
  HermiteQuinticsAt(double x, double h)
      : value_{.of_rise = x * x * x * (10.0 - x * (15.0 - 6.0 * x)),
               .of_rate0 = h * x * (1.0 - x * x * (6.0 - x * (8.0 - 3.0 * x))),
               .of_rate1 = -h * x * x * x * (4.0 - x * (7.0 - 3.0 * x)),
               .of_second0 = 0.5 * h * h * x * x * (1.0 - x) * (1.0 - x) * (1.0 - x),
               .of_second1 = 0.5 * h * h * x * x * x * (1.0 - x) * (1.0 - x)},
        rate_{.of_rise = 30.0 * x * x * (1.0 - x) * (1.0 - x) / h,
              .of_rate0 = 1.0 - x * x * (18.0 - x * (32.0 - 15.0 * x)),
              .of_rate1 = -x * x * (12.0 - x * (28.0 - 15.0 * x)),
              .of_second0 = 0.5 * h * x * (1.0 - x) * (1.0 - x) * (2.0 - 5.0 * x),
              .of_second1 = 0.5 * h * x * x * (1.0 - x) * (3.0 - 5.0 * x)} {}

  /// The value of the quintic with these values, rates and their rates (per second, per second squared) at its ends: of
  /// a number, or of a vector.
  template <class Value>
  [[nodiscard]] Value value(Value value0, Value rate0, Value second0, Value value1, Value rate1, Value second1) const {
    return value0 + value_.sum(value1 - value0, rate0, second0, rate1, second1);
  }
  /// Returns the rate of the value, per second.
  template <class Value>
  [[nodiscard]] Value rate(Value value0, Value rate0, Value second0, Value value1, Value rate1, Value second1) const {
    return rate_.sum(value1 - value0, rate0, second0, rate1, second1);
  }

 private:
  struct Weights {
    double of_rise, of_rate0, of_rate1, of_second0, of_second1;

    template <class Value>
    [[nodiscard]] Value sum(Value rise, Value rate0, Value second0, Value rate1, Value second1) const {
      return of_rise * rise + of_rate0 * rate0 + of_rate1 * rate1 + of_second0 * second0 + of_second1 * second1;
    }
  };
  Weights value_, rate_;
};

}  // namespace moat
