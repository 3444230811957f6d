// The damping of a contact, from its restitution.
#pragma once

#include <cmath>
#include <functional>
#include <utility>

#include "materials/contact/contact_state.hpp"
#include "materials/contact/restitution.hpp"

namespace moat {

/// The number of a contact that decides how much energy it loses. It is a constant, or set at touch where the
/// restitution depends on the approach speed. A number converts to it.
class ContactDamping {
 public:
  /// Stays constant.
  ContactDamping(double constant = 0.0) : constant_{constant} {}
  /// Follows a restitution: `damping_of(e)` returns the damping of a constant one.
  template <class Function>
  ContactDamping(const Restitution& restitution, Function damping_of) {
    if (restitution.is_constant())
      constant_ = damping_of(restitution.at(1.0));
    else
      at_touch_ = [restitution, damping_of](double speed) { return damping_of(restitution.at(speed)); };
  }

  /// Returns the damping of a contact in progress.
  [[nodiscard]] double in(const ContactState& contact) const { return at_touch_ ? contact.damping : constant_; }
  /// Returns the damping of a touch at this approach speed, m/s.
  [[nodiscard]] double at(double approach_speed) const { return at_touch_ ? at_touch_(approach_speed) : constant_; }
  /// Returns the constant, or the damping of a touch at 1 m/s, for reports.
  [[nodiscard]] double shown() const { return at(1.0); }

 private:
  double constant_ = 0.0;
  std::function<double(double)> at_touch_;
};

/// The damping coefficient c = 2 xi sqrt(k m) of a restitution, with the damping ratio `ratio_of(e)`.
template <class Ratio>
ContactDamping damping_by_ratio(const Restitution& restitution, double stiffness, double effective_mass,
                                Ratio ratio_of) {
  return {restitution, [=](double e) { return 2.0 * ratio_of(e) * std::sqrt(stiffness * effective_mass); }};
}

/// next_contact_state() of a contact with this damping: a touch stores it, too.
inline ContactState next_contact_state(const ContactState& committed, double indentation, double rate,
                                       const ContactDamping& damping) {
  ContactState next = next_contact_state(committed, indentation, rate);
  if (committed.phase == ContactPhase::open) next.damping = damping.at(next.approach_speed);
  return next;
}

}  // namespace moat
