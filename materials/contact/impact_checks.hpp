// Checks that impact laws share.
#pragma once

#include "base/check.hpp"

namespace moat {

/// Throws InputError unless 0 < restitution <= 1.
inline void check_restitution(const Check& check, double restitution) {
  check.above_up_to("restitution", restitution, 0.0, 1.0, "1",
                    "It is the speed after the impact over the speed before; 1 is elastic.");
}

/// Below this restitution, laws whose damping grows as 1/e or faster have a damping at touch that no step of an
/// analysis can resolve.
inline constexpr double least_restitution_in_divisor = 1e-3;

/// Checks the restitution of such laws. Throws InputError unless least_restitution_in_divisor <= restitution <= 1.
inline void check_restitution_in_divisor(const Check& check, double restitution) {
  check.between("restitution", restitution, least_restitution_in_divisor, 1.0, "1",
                "It is the speed after the impact over the speed before; 1 is elastic. The damping of this law grows "
                "without bound as it falls to zero, and no time step follows such a contact.");
}

}  // namespace moat
