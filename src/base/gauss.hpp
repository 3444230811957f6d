// Gauss's quadrature.
#pragma once

#include <array>
#include <cstddef>

namespace moat {

/// Gauss's rule with five points from 0 to 1, exact for polynomials up to degree 9. Not Boost's: its header would make
/// scripts compile longer.
struct Gauss {
  static constexpr std::array<double, 5> points{0.04691007703066802, 0.23076534494715845, 0.5, 0.7692346550528415,
                                                0.953089922969332};  ///< Positions, 0 to 1, ascending.
  static constexpr std::array<double, 5> weights{0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                                 0.23931433524968324,
                                                 0.11846344252809454};  ///< Positive, with the sum 1.

  /// Calls visit(x, weight) at the points between `from` and `to`; the weights add up to to - from.
  template <class Visit>
  static void visit(double from, double to, const Visit& visit) {
    for (std::size_t i = 0; i < points.size(); ++i) visit(from + points[i] * (to - from), weights[i] * (to - from));
  }
};

}  // namespace moat
