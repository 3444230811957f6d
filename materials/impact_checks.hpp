// Checks that impact laws share.
#pragma once

#include "base/check.hpp"

namespace moat {

/// Throws InputError unless 0 < restitution <= 1.
inline void check_restitution(const Check& check, double restitution) {
  check.above_up_to("restitution", restitution, 0.0, 1.0, "1",
                    "It is the speed after the impact over the speed before; 1 is elastic.");
}

}  // namespace moat
