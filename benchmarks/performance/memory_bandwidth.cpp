#include "performance/memory_bandwidth.hpp"

#include <cstddef>
#include <cstring>
#include <vector>

#include "performance/measure.hpp"

namespace moat::performance {

double seconds_per_byte_copied() {
  constexpr std::size_t bytes = std::size_t{256} << 20;
  static std::vector<char> from(bytes, 1), to(bytes, 2);
  const double start = seconds(Clock::wall);
  std::memcpy(to.data(), from.data(), bytes);
  const double taken = seconds(Clock::wall) - start;
  // Next time the other way round: nothing can be left out as a copy that was made before.
  from.swap(to);
  return taken / static_cast<double>(2 * bytes);
}

}  // namespace moat::performance
