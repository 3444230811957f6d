// The history of a contact.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>

#include "materials/response.hpp"

namespace moat {

/// The state of a gap.
enum class ContactPhase : std::uint8_t {
  open,      ///< apart
  loaded,    ///< touching, the law acts
  released,  ///< still indented, but the law has ended: no force until it would push again or the gap opens
};

/// Where a contact ends.
enum class Separation : std::uint8_t {
  at_zero_force,  ///< where the force reaches zero, at the latest where the gap opens: the contact never pulls
  at_opening,     ///< where the gap opens; a dashpot may pull before that
};

/// For laws with a field `may_pull`.
inline Separation separation(bool may_pull) { return may_pull ? Separation::at_opening : Separation::at_zero_force; }

/// History of a contact: its phase, and the approach speed at the instant of first touch, which stays the same until
/// the gap opens. Laws divide by this speed, so it has a lower bound; elements keep the true speed (ContactView).
///
///             touch                  force reaches zero
///     open ----------> loaded  ----------------------------> released
///       ^                |  ^                                  |   |
///       |   gap opens    |  |    law would push again          |   |
///       +----------------+  +----------------------------------+   |
///       +----------------------------------------------------------+  gap opens
struct ContactState {
  ContactPhase phase = ContactPhase::open;  ///< open, loaded or released
  double approach_speed = 0.0;              ///< m/s, >= least_approach_speed while not open
  double slip = 0.0;                        ///< m, in this contact, of laws that yield
  int yields = 0;                           ///< +1, -1: with the motion in this direction; 0: elastic
  double damping = 0.0;                     ///< of this contact, where it depends on the approach speed

  friend bool operator==(const ContactState&, const ContactState&) = default;
};

/// Lower bound of the approach speed in laws, m/s. Laws divide by the approach speed, which is zero for a grazing
/// touch. At a lower speed v0 the damping of a law with d'/v0 is smaller by the factor v0/least_approach_speed.
inline constexpr double least_approach_speed = 1e-4;

/// An open gap touches where it is indented by more than this, m, so that round-off does not close one that is built
/// wall to wall: a tenth of the default TransientOptions::location_tolerance.
inline constexpr double touch_threshold = 1e-13;

/// A released contact is loaded again only where it would push by more than this, m, so that round-off does not switch
/// it: ten times the default TransientOptions::location_tolerance.
inline constexpr double reload_threshold = 1e-11;

/// The regime margin (LawWithRegimes) of every contact, m.
///
/// `push` is the force as a length, m: it has the sign of the force, crosses zero with a finite slope, and is of the
/// order of the indentation; d F/F_elastic for example. A law that never ends before the gap opens passes infinity.
inline double contact_margin(const ContactState& committed, double indentation, double push) {
  switch (committed.phase) {
    case ContactPhase::open:
      return touch_threshold - indentation;
    case ContactPhase::loaded:
      return std::min(indentation, push);
    case ContactPhase::released:
      break;
  }
  return std::min(indentation, reload_threshold - push);
}

/// The state beyond the margin: a touch stores the approach speed, an opening clears it.
inline ContactState next_contact_state(const ContactState& committed, double indentation, double rate) {
  if (committed.phase == ContactPhase::open) return {ContactPhase::loaded, std::max(rate, least_approach_speed)};
  if (indentation <= 0.0) return {};
  ContactState next = committed;
  next.phase = committed.phase == ContactPhase::loaded ? ContactPhase::released : ContactPhase::loaded;
  return next;
}

/// A law that touches and separates.
template <class Law>
concept ContactLaw = LawWithRegimes<Law> && std::same_as<typename Law::State, ContactState> &&
    requires(const Law& law, double effective_mass, double approach_speed) {
  // Time scale of a free impact, s; steps are chosen by it.
  { law.contact_duration(effective_mass, approach_speed) } -> std::same_as<double>;
};

}  // namespace moat
