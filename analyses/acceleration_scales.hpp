// How large the acceleration of each place is, for errors to be judged against.
#pragma once

#include <vector>

#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat {

/// The scale of every node's absolute acceleration, m/s^2: its largest so far, fading with time.
///
/// Every node has its own, so that a light body that pounds somewhere does not loosen the tolerance of a building. While
/// a building is in contact its nodes count as they are, and what they did in contact is forgotten when it ends: an
/// impact is no measure of the motion that follows. A building is here what elements other than gaps hold together.
class AccelerationScales {
 public:
  /// lowest >= 0: no scale is below this, m/s^2.
  AccelerationScales(const Model& model, double lowest);

  /// Contacts began or ended.
  void regimes_changed(const Model& model);
  /// A step of h s was committed.
  void accepted(const Model& model, double h, double ground_acceleration);

  /// Of every node, > 0.
  [[nodiscard]] const Vector& values() const { return values_; }

 private:
  double lowest_;
  std::vector<int> building_;  // of every node
  std::vector<char> touching_;  // of every building
  bool any_touching_ = false;
  Vector values_;
  Vector outside_contact_;
};

}  // namespace moat
