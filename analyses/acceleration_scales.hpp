// How large the acceleration of each place is, for errors to be judged against.
#pragma once

#include <vector>

#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat {

/// The scale of every node's absolute acceleration, m/s^2: its largest so far, fading by a factor e in a second, and at
/// least a quarter of the largest in its building: an impact below reaches a floor that has not moved yet.
///
/// A light body that pounds somewhere else does not loosen the tolerance of a building. While a building is in contact
/// its nodes count as they are, and the nodes that touch (ElementInfo::first and second) with at least four times
/// the acceleration to be expected of the impact. All that is forgotten when the building's last contact ends: an
/// impact is no measure of the motion that follows. A building is here all that elements other than gaps hold together.
class AccelerationScales {
 public:
  /// lowest >= 0: no scale is below this, m/s^2.
  AccelerationScales(const Model& model, double lowest);

  /// Contacts may have begun or ended.
  void regimes_changed(const Model& model);
  /// A step of h s was committed.
  void accepted(const Model& model, double h, double ground_acceleration);

  /// Of every node, > 0.
  [[nodiscard]] const Vector& values();

 private:
  double lowest_;
  void raise_to_building();

  std::vector<int> building_;                    // of every node: the number of one of its nodes
  std::vector<char> touching_, touched_before_;  // of every building, now and before the last change
  bool any_touching_ = false;
  double step_of_fade_ = 0.0, fade_ = 1.0;  // the last step, s, and how much is left after it
  Vector values_;                           // scales that errors are judged on, if they are up to date
  bool up_to_date_ = false;
  Vector own_;              // of each node alone
  Vector outside_contact_;  // the same, without contacts
  Vector of_building_;      // largest, at the index building_ names
};

}  // namespace moat
