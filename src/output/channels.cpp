#include "output/channels.hpp"

#include <algorithm>

namespace moat {

Channels::Channels(const Model& model) {
  for (const Node& node : model.nodes()) {
    list_.push_back({"displacement", node.name, node.name, "m"});
    list_.push_back({"velocity", node.name, node.name, "m/s"});
    list_.push_back({"absolute_acceleration", node.name, node.name, "m/s^2"});
  }
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    BlockChannels of_block{b, {}};
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementInfo& info = block.info(e);
      if (!info.deformation_quantity.empty()) {
        list_.push_back({info.deformation_quantity.text(), info.name, info.listed_under(), "m"});
        of_block.elements.push_back({e, info.kind == ElementKind::gap ? Shown::indentation : Shown::deformation});
      }
      if (!info.force_quantity.empty()) {
        list_.push_back({info.force_quantity.text(), info.name, info.listed_under(), "N"});
        of_block.elements.push_back({e, Shown::force});
      }
    }
    if (!of_block.elements.empty()) blocks_.push_back(std::move(of_block));
  }
  for (const BaseShear& shear : model.base_shears())
    list_.push_back({"total_base_shear", shear.where, shear.where, "N"});
}

int Channels::find(std::string_view quantity, std::string_view where) const {
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (list_[i].quantity == quantity && list_[i].where == where) return static_cast<int>(i);
  return -1;
}

void Channels::sample(const StepView& view, std::vector<double>& values) const {
  values.resize(list_.size());
  double* next = values.data();
  const MotionState& state = view.model.state();
  const double *displacement = state.displacement.data(), *velocity = state.velocity.data(),
               *acceleration = state.acceleration.data();
  for (std::size_t i = 0; i < view.model.nodes().size(); ++i) {
    *next++ = displacement[i];
    *next++ = velocity[i];
    *next++ = acceleration[i] + view.ground_acceleration;
  }
  for (const BlockChannels& channels : blocks_) {
    const ElementBlock& block = *view.model.blocks()[channels.block];
    const double *deformations = block.deformations().data(), *forces = block.forces().data();
    for (const ElementChannel& channel : channels.elements) {
      const double deformation = deformations[channel.element];
      // An open gap is not indented.
      *next++ = channel.shown == Shown::force         ? forces[channel.element]
                : channel.shown == Shown::indentation ? std::max(deformation, 0.0)
                                                      : deformation;
    }
  }
  const Vector& mass = view.model.masses();
  for (const BaseShear& shear : view.model.base_shears()) {
    // The force from outside is minus the inertia of all that stands on the base.
    double inertia = 0.0;
    for (const NodeId node : shear.nodes)
      inertia += mass[node.index] * (state.acceleration[node.index] + view.ground_acceleration);
    *next++ = -inertia;
  }
}

}  // namespace moat
