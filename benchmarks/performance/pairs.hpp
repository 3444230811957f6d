// Six numbers in three registers of two.
#pragma once

#include <cstddef>

namespace moat::performance {

inline constexpr std::size_t floors = 5;

/// One number for the base (0) and for each floor (1 to 5). Number i lies in pair i % 3, so that neighbours stand in
/// the same place of neighbouring pairs and differences between storeys need no shuffling but one: at 3 - 2.
struct Values {
  using Pair [[gnu::vector_size(16)]] = double;
  Pair pairs[3] = {};

  double operator[](std::size_t i) const { return pairs[i % 3][i / 3]; }
  void set(std::size_t i, double value) { pairs[i % 3][i / 3] = value; }

  friend Values operator+(const Values& a, const Values& b) {
    return {{a.pairs[0] + b.pairs[0], a.pairs[1] + b.pairs[1], a.pairs[2] + b.pairs[2]}};
  }
  friend Values operator-(const Values& a, const Values& b) {
    return {{a.pairs[0] - b.pairs[0], a.pairs[1] - b.pairs[1], a.pairs[2] - b.pairs[2]}};
  }
  friend Values operator*(double factor, const Values& a) {
    return {{factor * a.pairs[0], factor * a.pairs[1], factor * a.pairs[2]}};
  }
};

}  // namespace moat::performance
