// Contacts of corners with walls, in plan.
#pragma once

#include <cstddef>
#include <string>

#include "base/plan_vector.hpp"

namespace moat {

/// A corner of one body and an edge of another.
///
///        edge  |
///              |     normal: from the body of the corner to the other body
///     corner > |-->  tangent: the normal turned by +90 degrees
///              |
struct CornerPair {
  std::string corner, edge;             ///< names, for tables: "base corner 2", "moat wall 3"
  PlanVector position{};                ///< of the corner at rest, m
  PlanVector edge_begin{}, edge_end{};  ///< at rest, m; the corner is on the left of the way between them
  PlanVector normal{};                  ///< of length 1
};

/// The side of an ElementBlock whose elements are contacts of corners with walls: they slide along these.
class PlanContacts {
 public:
  /// Names and places of a contact.
  [[nodiscard]] virtual const CornerPair& pair(std::size_t element) const = 0;
  /// Friction force along the tangent on the body of the edge, N, and its rate, N/s.
  [[nodiscard]] virtual double friction_force(std::size_t element) const = 0;
  /// Rate of that force, N/s.
  [[nodiscard]] virtual double friction_force_rate(std::size_t element) const = 0;
  /// Where in the last committed step the corner began to slide, so that rates jumped there: a fraction of the step,
  /// NaN where it did not.
  [[nodiscard]] virtual double slide_begin(std::size_t element) const = 0;
  /// Speed of the corner along the tangent at the last touch, relative to the edge, m/s.
  [[nodiscard]] virtual double tangential_speed_at_touch(std::size_t element) const = 0;
  /// The distance of a corner from its edge at rest, and at the last evaluate() with its rate, m and m/s: that from the
  /// nearer end where the corner is beside the edge. Negative while the corner is indented.
  struct Distance {
    double value = 0.0, rate = 0.0;  ///< m, m/s
  };
  /// m
  [[nodiscard]] virtual double distance_at_rest(std::size_t element) const = 0;
  /// At the last evaluate().
  [[nodiscard]] virtual Distance distance(std::size_t element) const = 0;
  /// Whether a corner that slides could be pressed into its edge without an end: 1/m_n <= mu |m_nt|, with the mobility
  /// m_nt of normal motion under a force along the tangent. No law can separate them then.
  [[nodiscard]] virtual bool may_jam(std::size_t element) const = 0;
  /// How often the corner left its edge in contact: it slid past an end, so that the contact was released.
  [[nodiscard]] virtual int times_left(std::size_t element) const = 0;

 protected:
  ~PlanContacts() = default;
};

}  // namespace moat
