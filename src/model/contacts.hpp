// Elements that touch and separate.
#pragma once

#include <cstddef>

namespace moat {

/// The state of one contact.
struct ContactView {
  bool touching = false;        ///< from touch until the gap opens, also while the force is zero
  double approach_speed = 0.0;  ///< m/s, at the last touch; <= 0 if the bodies did not approach
  double expected_force = 0.0;  ///< N, of a free impact that lasts half a sine: pi m v0 / duration
};

/// The side of an ElementBlock whose elements are contacts.
class Contacts {
 public:
  /// Returns the contact of one element at the committed state.
  [[nodiscard]] virtual ContactView contact(std::size_t element) const = 0;
  /// Number of contacts in progress.
  [[nodiscard]] virtual int touching() const = 0;
  /// Duration of the shortest contact in progress, as a free impact, s; infinite if there is none.
  [[nodiscard]] virtual double shortest_contact() const = 0;
  /// Restitution that the element's law delivers in a free impact at this approach speed, m/s. NaN if the speed is not
  /// positive, and for a law whose contact never ends.
  [[nodiscard]] virtual double delivered_restitution(std::size_t element, double approach_speed) const = 0;

 protected:
  ~Contacts() = default;
};

}  // namespace moat
