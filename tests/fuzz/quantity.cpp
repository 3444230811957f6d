// Quantities of the command line, in each of their dimensions.

#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/parse_quantity.hpp"
#include "fuzzing.hpp"

using namespace moat;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr int dimensions[][3] = {{0, 0, 0},  {0, 2, 0},  {0, 0, 2},   {2, 0, 0}, {0, 2, -4},
                                          {2, 0, -4}, {2, 2, -4}, {2, -1, -4}, {0, 2, -2}};
  // Memory of its own, so that the sanitizer sees a step behind the end.
  const std::vector<char> text(data, data + size);
  for (const auto& each : dimensions)
    (void)fuzz::tried([&] {
      if (!std::isfinite(parse_si({text.data(), text.size()}, "--x", each[0], each[1], each[2]))) std::abort();
    });
  return 0;
}
