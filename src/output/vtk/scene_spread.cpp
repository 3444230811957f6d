#include "output/vtk/scene_spread.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace moat {
namespace {

// A neighbour of a body, and how much further it stands.
struct Neighbour {
  std::size_t body;
  PlanVector further;
};

std::vector<std::vector<Neighbour>> neighbours_of(const Model& model, const std::vector<int>& part) {
  const auto body_of = [&](NodeId node) {
    return static_cast<std::size_t>(part[static_cast<std::size_t>(model.place(node))]);
  };
  std::vector<std::vector<Neighbour>> neighbours(part.size());
  for (const auto& block : model.blocks()) {
    for (std::size_t e = 0; block->kind().contacts && e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      if (info.first == ground || info.second == ground) continue;
      const PlanVector direction = info.corner_pair() != nullptr ? info.corner_pair()->normal : PlanVector{1.0, 0.0};
      const auto from = body_of(info.second), to = body_of(info.first);
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
  const std::vector<int> part = connected_parts(model);
  const std::vector<std::vector<Neighbour>> neighbours = neighbours_of(model, part);
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
  for (const int body : part) of_nodes.push_back(*spread[static_cast<std::size_t>(body)]);
  return of_nodes;
}

}  // namespace moat
