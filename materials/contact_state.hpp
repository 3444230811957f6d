// The history of a contact.
#pragma once

#include <cstdint>

namespace moat {

enum class ContactPhase : std::uint8_t {
  open,      ///< apart
  loaded,    ///< touching, the law acts
  released,  ///< still indented, but the law has ended: no force until it would push again or the gap opens
};

/// History of a contact: its phase, and the approach speed at the instant of first touch, which
/// belongs to the touch and stays until the gap opens.
///
///             touch                  force reaches zero
///     open ----------> loaded  ----------------------------> released
///       ^                |  ^                                  |   |
///       |   gap opens    |  |    law would push again          |   |
///       +----------------+  +----------------------------------+   |
///       +----------------------------------------------------------+  gap opens
struct ContactState {
  ContactPhase phase = ContactPhase::open;
  double approach_speed = 0.0;  ///< m/s, > 0 while not open
};

/// The approach speed is at least this, m/s: a grazing touch has none, and laws divide by it.
inline constexpr double least_approach_speed = 1e-4;

}  // namespace moat
