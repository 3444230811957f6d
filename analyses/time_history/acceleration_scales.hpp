// Scales of acceleration, by which errors of a step are divided.
#pragma once

#include <vector>

#include "analyses/time_history/resultants.hpp"
#include "base/vector.hpp"
#include "model/analysis_state.hpp"

namespace moat {

/// The scale of every node's absolute acceleration, m/s^2: its largest magnitude so far, which decays by a factor e in
/// one second; in plan that of the resultant of a diaphragm's translations. It is at least a quarter of the largest
/// scale in its building, because an impact at the base soon reaches a floor that has not moved yet.
///
/// A building here is a set of nodes that elements other than gaps connect: a light body that pounds elsewhere does not
/// loosen the tolerance of a building. While a building is in contact, accelerations of the impact enter the scales of
/// its nodes, and the nodes of a closed gap (ElementInfo::first and second) have at least sixteen times the expected
/// acceleration of the impact. When the last contact of the building ends, its scales return to those without contact,
/// because an impact is no measure of the motion that follows.
class AccelerationScales {
 public:
  /// lowest >= 0: no scale is below this, m/s^2.
  AccelerationScales(const AnalysisState& state, double lowest);

  /// Contacts may have begun or ended.
  void regimes_changed(const AnalysisState& state);
  /// A step of h s was committed.
  void accepted(const AnalysisState& state, double h, GroundVector ground_acceleration);

  /// The scale of every node, m/s^2, > 0.
  [[nodiscard]] const Vector& values();

 private:
  void raise_to_building();

  double lowest_;
  Resultants resultants_;

  std::vector<int> building_;                    // of every node
  std::vector<char> touching_, touched_before_;  // of every building, now and before the last change
  bool any_touching_ = false;
  double step_of_fade_ = 0.0, fade_ = 1.0;  // the last step, s, and how much is left after it
  Vector values_;                           // scales that errors are judged on, if they are up to date
  bool up_to_date_ = false;
  Vector own_;              // of each node alone
  Vector outside_contact_;  // the same, without contacts; kept while there are any
  Vector of_building_;      // largest of every building
  // Nodes that follow each other in one building.
  struct Run {
    int begin, end, building;
  };
  std::vector<Run> runs_;
  // A node in contact and the acceleration that its contact lets expect.
  struct Raised {
    int node;
    double acceleration;  // m/s^2
  };
  std::vector<Raised> raised_;
};

}  // namespace moat
