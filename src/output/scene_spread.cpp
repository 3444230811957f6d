#include "output/scene_spread.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>

namespace moat {
namespace {

// Bodies as sets of nodes that are merged.
class Bodies {
 public:
  explicit Bodies(const Model& model) : parent_(static_cast<std::size_t>(model.node_count())) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const PlacedDiaphragm& diaphragm : model.diaphragms()) {
      join(diaphragm.id.x, diaphragm.id.y);
      join(diaphragm.id.x, diaphragm.id.r);
    }
    for (const auto& block : model.blocks())
      for (std::size_t e = 0; block->contacts() == nullptr && e < block->size(); ++e)
        join(block->info(e).first, block->info(e).second);
  }

  [[nodiscard]] std::size_t of(NodeId node) const {
    auto body = static_cast<std::size_t>(node.index);
    while (parent_[body] != body) body = parent_[body];
    return body;
  }

 private:
  void join(NodeId a, NodeId b) {
    if (a == ground || b == ground) return;
    const std::size_t first = of(a), second = of(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

  std::vector<std::size_t> parent_;
};

// Of a body: another one, and how much further that one stands.
struct Neighbour {
  std::size_t body;
  PlanVector further;
};

std::vector<std::vector<Neighbour>> neighbours_of(const Model& model, const Bodies& bodies) {
  std::vector<std::vector<Neighbour>> neighbours(static_cast<std::size_t>(model.node_count()));
  for (const auto& block : model.blocks()) {
    const PlanContacts* corners = block->plan_contacts();
    for (std::size_t e = 0; block->contacts() != nullptr && e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      if (info.first == ground || info.second == ground) continue;
      const PlanVector direction = corners != nullptr ? corners->pair(e).normal : PlanVector{1.0, 0.0};
      const std::size_t from = bodies.of(info.second), to = bodies.of(info.first);
      neighbours[from].push_back({to, info.offset * direction});
      neighbours[to].push_back({from, -info.offset * direction});
    }
  }
  // The smallest gap between two bodies is found first.
  for (std::vector<Neighbour>& each : neighbours)
    std::ranges::stable_sort(each, {}, [](const Neighbour& neighbour) { return length(neighbour.further); });
  return neighbours;
}

}  // namespace

std::vector<PlanVector> spread_of_nodes(const Model& model) {
  const Bodies bodies{model};
  const std::vector<std::vector<Neighbour>> neighbours = neighbours_of(model, bodies);
  std::vector<std::optional<PlanVector>> spread(neighbours.size());  // of bodies
  for (std::size_t first = 0; first < spread.size(); ++first) {
    if (spread[first]) continue;
    spread[first] = PlanVector{};
    for (std::vector<std::size_t> reached{first}; !reached.empty();) {
      const std::size_t body = reached.back();
      reached.pop_back();
      for (const auto& [other, further] : neighbours[body]) {
        if (spread[other]) continue;
        spread[other] = *spread[body] + further;
        reached.push_back(other);
      }
    }
  }
  std::vector<PlanVector> of_nodes;
  for (std::size_t node = 0; node < spread.size(); ++node)
    of_nodes.push_back(*spread[bodies.of(NodeId{static_cast<int>(node)})]);
  return of_nodes;
}

}  // namespace moat
