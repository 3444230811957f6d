#include "analyses/periods.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "solvers/modes.hpp"

namespace moat {
namespace {

// Nodes that move together.
struct Building {
  std::vector<int> nodes;  // ascending
  std::vector<bool> held;  // for each of `nodes`: whether it stands on bearings
};

int root_of(std::vector<int>& parents, int node) {
  while (parents[static_cast<std::size_t>(node)] != node) {
    int& parent = parents[static_cast<std::size_t>(node)];
    parent = parents[static_cast<std::size_t>(parent)];
    node = parent;
  }
  return node;
}

template <class Action>
void for_each_element(const Model& model, Action action) {
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) action(*block, e);
}

std::vector<Building> find_buildings(const Model& model) {
  const auto count = static_cast<std::size_t>(model.node_count());
  std::vector<int> parents(count);
  std::iota(parents.begin(), parents.end(), 0);
  std::vector<bool> on_bearings(count, false);
  for_each_element(model, [&](const ElementBlock& block, std::size_t e) {
    const ElementInfo& info = block.info(e);
    if (info.kind == ElementKind::gap) return;
    if (info.first != ground && info.second != ground)
      parents[static_cast<std::size_t>(root_of(parents, info.first.index))] = root_of(parents, info.second.index);
    else if (info.kind == ElementKind::bearing)
      on_bearings[static_cast<std::size_t>((info.first == ground ? info.second : info.first).index)] = true;
  });
  std::vector<Building> buildings;
  std::vector<int> building_of_root(count, -1);
  for (int node = 0; node < model.node_count(); ++node) {
    int& building = building_of_root[static_cast<std::size_t>(root_of(parents, node))];
    if (building < 0) {
      building = static_cast<int>(buildings.size());
      buildings.emplace_back();
    }
    Building& its = buildings[static_cast<std::size_t>(building)];
    its.nodes.push_back(node);
    its.held.push_back(on_bearings[static_cast<std::size_t>(node)]);
  }
  return buildings;
}

// First period of the given nodes, all others held; infinite if they are free, 0 if there are none.
double first_period(const SparseMatrix& stiffness, const Vector& masses, const std::vector<int>& nodes) {
  if (nodes.empty()) return 0.0;
  std::vector<int> position(static_cast<std::size_t>(stiffness.size), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) position[static_cast<std::size_t>(nodes[i])] = static_cast<int>(i);
  const auto for_each_entry = [&](auto action) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto column = static_cast<std::size_t>(nodes[i]);
      for (int k = stiffness.column_starts[column]; k < stiffness.column_starts[column + 1]; ++k) {
        const int row = position[static_cast<std::size_t>(stiffness.row_indices[static_cast<std::size_t>(k)])];
        if (row >= 0) action(row, static_cast<int>(i), stiffness.values[static_cast<std::size_t>(k)]);
      }
    }
  };
  PatternBuilder builder{static_cast<int>(nodes.size())};
  for_each_entry([&](int row, int column, double) { builder.couple(row, column); });
  SparseMatrix part = builder.build();
  for_each_entry([&](int row, int column, double value) {
    part.values[static_cast<std::size_t>(part.slot(row, column))] = value;
  });
  Vector mass{static_cast<Eigen::Index>(nodes.size())};
  for (std::size_t i = 0; i < nodes.size(); ++i) mass[static_cast<Eigen::Index>(i)] = masses[nodes[i]];
  return slowest_modes(part, mass, 1).front().period();
}

}  // namespace

std::vector<NamedPeriod> characteristic_periods(Model& model, std::size_t most_buildings) {
  model.prepare();
  SparseMatrix initial = model.pattern(), post_yield = model.pattern();
  model.assemble_linear_stiffness(StiffnessStage::initial, initial);
  model.assemble_linear_stiffness(StiffnessStage::post_yield, post_yield);

  std::vector<NamedPeriod> periods;
  const std::vector<Building> buildings = find_buildings(model);
  for (std::size_t b = 0; b < std::min(buildings.size(), most_buildings); ++b) {
    const Building& building = buildings[b];
    const std::string prefix = buildings.size() > 1 ? std::string{model.node_name({building.nodes.front()})} + ": " : "";
    const auto report = [&](const char* name, double value) {
      if (value > 0.0 && std::isfinite(value)) periods.push_back({prefix + name, value});
    };
    std::vector<int> superstructure;
    double mass = 0.0, bearing_stiffness = 0.0;
    for (std::size_t i = 0; i < building.nodes.size(); ++i) {
      const int node = building.nodes[i];
      mass += model.masses()[node];
      if (!building.held[i]) superstructure.push_back(node);
    }
    // With the building rigid only what joins it to the ground deforms: the sum of all entries of its stiffness.
    for (const int node : building.nodes) {
      const auto column = static_cast<std::size_t>(node);
      for (int k = post_yield.column_starts[column]; k < post_yield.column_starts[column + 1]; ++k)
        bearing_stiffness += post_yield.values[static_cast<std::size_t>(k)];
    }
    if (superstructure.size() == building.nodes.size()) {
      report("first mode", first_period(initial, model.masses(), building.nodes));
      continue;
    }
    report("fixed base", first_period(initial, model.masses(), superstructure));
    if (bearing_stiffness > 0.0)
      report("isolation, rigid building", 2.0 * std::numbers::pi * std::sqrt(mass / bearing_stiffness));
    report("first mode, post-yield bearings", first_period(post_yield, model.masses(), building.nodes));
    report("first mode, initial bearings", first_period(initial, model.masses(), building.nodes));
  }
  return periods;
}

}  // namespace moat
