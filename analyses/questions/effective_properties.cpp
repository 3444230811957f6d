#include "analyses/questions/effective_properties.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/check.hpp"

namespace moat {

EffectiveProperties effective_properties(std::span<const double> deformations, std::span<const double> forces) {
  const Check check{"EffectiveProperties", ""};
  check.that(deformations.size() == forces.size(), "there are different numbers of deformations and forces.");
  check.that(deformations.size() >= 3, "a loop needs at least three points.",
             "Give some hundred points of one full cycle.");
  const auto [least, largest] = std::ranges::minmax_element(deformations);
  check.that(*least < *largest, "the loop has no width.", "Give the deformations and forces of one full cycle.");
  const auto force_at = [&](auto where) { return forces[static_cast<std::size_t>(where - deformations.begin())]; };
  double area = 0.0;
  for (std::size_t i = 0; i < deformations.size(); ++i) {
    const std::size_t next = (i + 1) % deformations.size();
    area += 0.5 * (forces[i] + forces[next]) * (deformations[next] - deformations[i]);
  }
  const double range = *largest - *least, amplitude = 0.5 * range;
  const double stiffness = (std::abs(force_at(largest)) + std::abs(force_at(least))) / range;
  return {stiffness, area / (2.0 * std::numbers::pi * stiffness * amplitude * amplitude), amplitude};
}

}  // namespace moat
