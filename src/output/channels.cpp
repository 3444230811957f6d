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
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementInfo& info = block.info(e);
      if (!info.deformation_quantity.empty()) {
        list_.push_back({info.deformation_quantity, info.name, info.place, "m"});
        elements_.push_back({b, e, false});
      }
      if (!info.force_quantity.empty()) {
        list_.push_back({info.force_quantity, info.name, info.place, "N"});
        elements_.push_back({b, e, true});
      }
    }
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
  const MotionState& state = view.model.state();
  const auto nodes = static_cast<Eigen::Index>(view.model.nodes().size());
  std::size_t next = 0;
  for (Eigen::Index i = 0; i < nodes; ++i) {
    values[next++] = state.displacement[i];
    values[next++] = state.velocity[i];
    values[next++] = state.acceleration[i] + view.ground_acceleration;
  }
  for (const ElementChannel& channel : elements_) {
    const ElementBlock& block = *view.model.blocks()[channel.block];
    const double deformation = block.deformations()[channel.element];
    // An open gap is not indented.
    const bool gap = block.info(channel.element).kind == ElementKind::gap;
    values[next++] = channel.force ? block.forces()[channel.element] : gap ? std::max(deformation, 0.0) : deformation;
  }
  const Vector& mass = view.model.masses();
  for (const BaseShear& shear : view.model.base_shears()) {
    // The force from outside is minus the inertia of all that stands on the base.
    double inertia = 0.0;
    for (const NodeId node : shear.nodes)
      inertia += mass[node.index] * (state.acceleration[node.index] + view.ground_acceleration);
    values[next++] = -inertia;
  }
}

}  // namespace moat
