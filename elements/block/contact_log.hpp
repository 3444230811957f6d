// Which contacts of a block touch, how fast they came and how long they last.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "materials/contact/contact_state.hpp"
#include "model/element_states.hpp"

namespace moat {

/// The contacts of a block: the approach speed of each, and its duration as a free impact, from which the length of
/// steps follows.
class ContactLog {
 public:
  ContactLog() = default;
  /// All contacts are open at first.
  explicit ContactLog(std::size_t count) : contacts_(count) {}

  /// A contact enters a phase: notes in `change`, which has the rate of indentation, whether it touched or opened.
  /// Returns whether it touched.
  bool enter(std::size_t i, ContactPhase phase, RegimeChange& change) {
    Contact& contact = contacts_[i];
    const bool touched_before = contact.touching;
    contact.touching = phase != ContactPhase::open;
    count_ += static_cast<int>(contact.touching) - static_cast<int>(touched_before);
    change.opened = change.opened || (touched_before && !contact.touching);
    if (!contact.touching || touched_before) return false;
    change.touched = true;
    contact.approach_speed = change.rate;
    return true;
  }
  /// s, of a free impact.
  void set_duration(std::size_t i, double duration) { contacts_[i].duration = duration; }

  /// Whether a contact has touched and not opened, at the committed state.
  [[nodiscard]] bool touching(std::size_t i) const { return contacts_[i].touching; }
  /// Effective mass in kg; approach speed of the law's state, m/s, which has a lower bound.
  [[nodiscard]] ContactView view(std::size_t i, double effective_mass, double speed_of_law) const {
    const Contact& contact = contacts_[i];
    ContactView view{.touching = contact.touching, .approach_speed = contact.approach_speed};
    if (contact.touching) view.expected_force = std::numbers::pi * effective_mass * speed_of_law / contact.duration;
    return view;
  }
  /// Writes or reads all contacts.
  void archive(auto& archive) { archive(contacts_, count_); }
  /// The duration of the shortest one in progress, s; infinite without one.
  [[nodiscard]] double shortest() const {
    double shortest = std::numeric_limits<double>::infinity();
    if (count_ > 0)
      for (const Contact& contact : contacts_)
        if (contact.touching) shortest = std::min(shortest, contact.duration);
    return shortest;
  }

 private:
  struct Contact {
    bool touching = false;
    double approach_speed = 0.0;  // m/s, at the last touch
    double duration = 0.0;        // s, of the contact in progress
  };

  std::vector<Contact> contacts_;
  int count_ = 0;  // of contacts in progress
};

}  // namespace moat
