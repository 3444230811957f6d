// The axial forces of bearings, as channels.
#pragma once

#include "model/model.hpp"
#include "output/recorders/channel_list.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Quantities of buildings with AxialForces:
///
/// - `bearing_compression` [N] of every bearing, negative in tension; bearings share a place as their forces do;
/// - `vertical_acceleration` [m/s^2], absolute, up positive, and `vertical_load` [N] of every building;
/// - `overturning_moment` [N m], in plan `_x` and `_y`: of inertia and of forces from outside the building, without
///   displaced weight; positive where it presses the bearings at +x, +y;
/// - in plan `torque_of_bearings` [N m]: moment of the bearings' forces about the base's centre of mass at rest.
class WeightChannels {
 public:
  WeightChannels() = default;
  /// Appends the channels to a list.
  WeightChannels(const Model& model, ChannelList& list);

  [[nodiscard]] bool empty() const { return first_ == behind_; }  ///< Whether there are none.
  /// Writes values and rates of its channels at the committed state into those of all channels.
  void sample(const StepView& view, double* values, double* rates) const;

 private:
  std::size_t first_ = 0, behind_ = 0;  // channels
};

}  // namespace moat
