// The quantities that a model in plan reports besides those of its degrees of freedom.
#pragma once

#include <cstddef>
#include <vector>

#include "model/model.hpp"
#include "output/recorders/channel_list.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Resultants of simultaneous components and quantities at corners:
///
/// - `displacement`, `absolute_acceleration` [m, m/s^2]: resultants at the centre of mass of every diaphragm;
/// - `corner_displacement`, `corner_acceleration`: the same at the corners of its outline;
/// - `corner_drift` [m]: resultant displacement of a floor relative to the floor below, at the corners of its outline,
///   and `drift_x`, `drift_y` at its centre of mass, `drift_rotation` [rad], for the floors of every Building;
/// - components "_x" and "_y" of the quantities of elements that deform in two directions at once;
/// - `friction_force` [N] of contacts, along the edge;
/// - `total_base_shear_x`, `total_base_shear_y` [N] and `total_base_torque` [N m] about the origin of every Building.
///
/// Corners share the place of their diaphragm, so that the peak is the largest of all corners and its side names it.
class PlanChannels {
 public:
  PlanChannels() = default;
  /// Appends the channels to `list`.
  PlanChannels(const Model& model, ChannelList& list);

  /// Writes its values and rates among all channels, from the motion of the nodes, which is there already.
  void sample(const StepView& view, double* values, double* rates) const;
  /// Appends the channels of a contact's friction.
  void add_friction(std::size_t block, std::size_t element, std::vector<std::size_t>& bent) const;
  /// Appends the channels whose rates jump where the acceleration of this body does.
  void add_bent_by(const Model& model, NodeId body, std::vector<std::size_t>& bent) const;

 private:
  // A point of a diaphragm, by the channel of its ux, behind which stand those of uy and of the rotation.
  struct Point {
    std::size_t floor;  // on_ground for the ground
    PlanVector arm;     // from the centre of mass, m
  };
  struct Drift {
    DiaphragmId of;
    Point upper, lower;
  };
  struct ElementOfBlock {
    std::size_t block, element;
    bool has_deformation, has_force;
  };
  void add_diaphragm(const Model& model, const PlacedDiaphragm& diaphragm, ChannelList& list);
  void add_drifts(const Model& model, const Building& building, ChannelList& list);
  void add_elements(const Model& model, ChannelList& list);

  std::size_t first_ = 0;      // channel of the first of points_
  std::vector<Point> points_;  // two channels each: displacement, acceleration
  std::vector<Drift> corner_drifts_, centre_drifts_;
  std::vector<ElementOfBlock> planar_, sliding_;
  std::size_t frictions_ = 0;  // channel of the first of sliding_
  std::vector<std::vector<DiaphragmId>> buildings_;
  std::vector<std::size_t> shears_;  // first channel of every building
};

}  // namespace moat
