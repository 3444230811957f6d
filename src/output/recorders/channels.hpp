// The quantities a model reports, as a flat list of numbers per instant.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "model/model.hpp"
#include "output/recorders/channel_list.hpp"
#include "output/recorders/plan_channels.hpp"
#include "output/recorders/step_observer.hpp"
#include "output/recorders/weight_channels.hpp"

namespace moat {

/// All channels of a model: displacement, velocity and absolute acceleration of every node; deformation and
/// force of every element that reports them, and the quantities of its law; the total base shear of every building. In
/// plan a diaphragm has these in x, in y and in rotation, and the channels of PlanChannels besides.
///
/// Displacement and velocity are relative to the ground, accelerations absolute.
class Channels {
 public:
  /// The model must be complete, and outlive the channels.
  explicit Channels(const Model& model);

  /// In the order of values.
  [[nodiscard]] const std::deque<Channel>& list() const { return list_.channels(); }
  /// values := all channels at the committed state, rates := their rates, per second; as long as list().
  void sample(const StepView& view, std::vector<double>& values, std::vector<double>& rates) const;
  /// A channel at a fraction of the step that led to the committed state, where a cubic through its values and rates
  /// has the given value. The force of a law that is not linear comes from the law itself, so that no force exceeds its
  /// capacity.
  [[nodiscard]] double value_inside(const StepView& view, std::size_t channel, double fraction, double of_cubic) const;

  /// The channels whose rates jump where an element changes its regime: accelerations of the nodes that it strikes,
  /// base shears.
  [[nodiscard]] std::vector<std::size_t> bent_by(const Model& model, const RegimeChange& change) const;

  /// Index of the first of a node's channels: displacement, then velocity, then absolute acceleration.
  [[nodiscard]] static std::size_t of_node(const Model& model, NodeId node) {
    return 3 * static_cast<std::size_t>(model.place(node));
  }

 private:
  void add_node(const Model& model, NodeId id);
  void sample_storeys(const StepView& view, double* values, double* rates) const;
  void add_coupled_inertia(const MassMatrix& mass, double* values) const;

  // An element and its channel.
  struct Source {
    std::size_t element, channel;
  };
  struct LawSource {
    std::size_t element, channel, quantity;
  };
  struct BlockChannels {
    std::size_t block;
    std::vector<Source> deformations, indentations, forces;
    std::vector<LawSource> law_quantities;
  };
  void add_elements(const Model& model, std::size_t block);
  static void sample(const ElementStates& elements, const BlockChannels& channels, double* values, double* rates);

  // A channel whose value inside a step comes from its law.
  struct LawChannel {
    std::size_t channel, block, element;
  };

  ChannelList list_;
  std::vector<BlockChannels> blocks_;
  std::vector<LawChannel> of_laws_;  // ascending
  PlanChannels plan_;                // behind all others; on a line without channels
  // Rotations, by the channel of w: 1/gyration.
  struct Rotation {
    std::size_t channel;
    double per_metre;
  };
  std::vector<Rotation> rotations_;
  // The base shear of a building is minus the inertia of its base and floors. Masses that couple its nodes with others
  // add to it, unless they are those of floors that follow.
  struct BaseShear {
    std::size_t channel;
    std::vector<NodeId> nodes;
    bool has_followers;
  };
  std::vector<BaseShear> base_shears_;
  struct StoreySum {
    std::size_t channel;
    const StoreyResult* result;  // of the model
  };
  std::vector<StoreySum> storey_sums_;
  WeightChannels weights_;
  std::vector<int> base_shear_of_node_;  // channel, by the place of the node; -1 if there is none
};

}  // namespace moat
