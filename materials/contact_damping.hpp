// When the dashpot of a contact acts.
#pragma once

#include <cstdint>

namespace moat {

enum class ContactDamping : std::uint8_t {
  throughout,     ///< in approach and restitution
  approach_only,  ///< only while the bodies approach; the force is elastic on the way back and never pulls
};

}  // namespace moat
