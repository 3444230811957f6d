#include "analyses/acceleration_scales.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace moat {
namespace {

constexpr double seconds_to_fade = 1.0;  // by a factor e

// Numbers of connected parts: two nodes have the same one if elements other than gaps lead from one to the other.
std::vector<int> connected_parts(const Model& model) {
  std::vector<int> parent(static_cast<std::size_t>(model.node_count()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int node) {
    while (parent[static_cast<std::size_t>(node)] != node) {
      int& above = parent[static_cast<std::size_t>(node)];
      above = parent[static_cast<std::size_t>(above)];
      node = above;
    }
    return node;
  };
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      if (info.kind == ElementKind::gap || info.first == ground || info.second == ground) continue;
      parent[static_cast<std::size_t>(root(info.first.index))] = root(info.second.index);
    }
  std::vector<int> part(parent.size());
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = root(static_cast<int>(i));
  return part;
}

}  // namespace

AccelerationScales::AccelerationScales(const Model& model, double lowest)
    : lowest_{std::max(lowest, std::numeric_limits<double>::min())},
      building_{connected_parts(model)},
      touching_(building_.size(), 0) {
  values_.setConstant(model.degrees_of_freedom(), lowest_);
  outside_contact_ = values_;
  regimes_changed(model);
}

void AccelerationScales::regimes_changed(const Model& model) {
  const bool were_touching = any_touching_;
  std::vector<char> touching(touching_.size(), 0);
  any_touching_ = false;
  for (const auto& block : model.blocks()) {
    if (!block->has_regimes()) continue;
    for (std::size_t e = 0; e < block->size(); ++e) {
      if (!block->contact(e).touching) continue;
      any_touching_ = true;
      for (const NodeId node : {block->info(e).first, block->info(e).second})
        if (node != ground) touching[static_cast<std::size_t>(building_[static_cast<std::size_t>(node.index)])] = 1;
    }
  }
  if (were_touching)
    for (std::size_t i = 0; i < building_.size(); ++i) {
      const auto building = static_cast<std::size_t>(building_[i]);
      if (touching_[building] != 0 && touching[building] == 0)
        values_[static_cast<Eigen::Index>(i)] = outside_contact_[static_cast<Eigen::Index>(i)];
    }
  touching_ = std::move(touching);
}

void AccelerationScales::accepted(const Model& model, double h, double ground_acceleration) {
  const double fade = std::exp(-h / seconds_to_fade);
  const int count = model.degrees_of_freedom();
  const double* acceleration = model.state().acceleration.data();
  double* __restrict values = values_.data();
  double* __restrict outside = outside_contact_.data();
  for (int i = 0; i < count; ++i)
    values[i] = std::max(std::max(values[i] * fade, lowest_), std::abs(acceleration[i] + ground_acceleration));
  if (!any_touching_) {
    for (int i = 0; i < count; ++i) outside[i] = values[i];
    return;
  }
  for (int i = 0; i < count; ++i) {
    const bool touching =
        touching_[static_cast<std::size_t>(building_[static_cast<std::size_t>(i)])] != 0;
    outside[i] = touching ? std::max(outside[i] * fade, lowest_) : values[i];
  }
}

}  // namespace moat
