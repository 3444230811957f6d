#include "analyses/modes/periods.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "analyses/modes/plan_modes.hpp"
#include "solvers/modes.hpp"

namespace moat {
namespace {

// The nodes that these isolators separate from the ground.
std::vector<NodeId> isolated_nodes(const Model& model, const std::vector<ElementId>& isolators) {
  std::vector<NodeId> nodes;
  for (const ElementId id : isolators) {
    const ElementInfo& info = model.blocks()[id.block]->info(id.element);
    nodes.push_back(info.first == ground ? info.second : info.first);
  }
  return nodes;
}

// All degrees of freedom of the bodies of these nodes, ascending.
std::vector<int> indices_of(const Model& model, const std::vector<NodeId>& nodes) {
  std::vector<int> indices;
  for (const NodeId first : nodes)
    for (const NodeId node : model.body_of(first)) indices.push_back(node.index);
  std::ranges::sort(indices);
  indices.erase(std::ranges::unique(indices).begin(), indices.end());
  return indices;
}

// The rows and columns of these nodes.
SparseMatrix part_of(const SparseMatrix& matrix, const std::vector<int>& nodes) {
  std::vector<int> position(static_cast<std::size_t>(matrix.rows()), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) position[static_cast<std::size_t>(nodes[i])] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (SparseMatrix::InnerIterator entry{matrix, nodes[i]}; entry; ++entry)
      if (const int row = position[static_cast<std::size_t>(entry.row())]; row >= 0)
        entries.emplace_back(row, static_cast<int>(i), entry.value());
  const auto size = static_cast<Eigen::Index>(nodes.size());
  SparseMatrix part{size, size};
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

// The degrees of freedom of `nodes` that are not held, both ascending.
std::vector<int> without(const std::vector<int>& nodes, const std::vector<int>& held) {
  std::vector<int> rest;
  std::ranges::set_difference(nodes, held, std::back_inserter(rest));
  return rest;
}

// The first three modes, with both stiffnesses of bearings that yield; once where they are the same.
std::vector<NamedPeriod> periods_in_plan(const Model& model) {
  constexpr int count = 3;
  const auto named = [&](StiffnessStage stage, const char* bearings) {
    std::vector<NamedPeriod> periods;
    for (const PlanMode& mode : plan_modes(model, stage, count))
      if (std::isfinite(mode.period))
        periods.push_back(
            {"mode " + std::to_string(periods.size() + 1) + " (" + mode.character() + ")" + bearings, mode.period});
    return periods;
  };
  std::vector<NamedPeriod> periods = named(StiffnessStage::post_yield, ", post-yield bearings"),
                           initial = named(StiffnessStage::initial, ", initial bearings");
  const auto same = [](const NamedPeriod& a, const NamedPeriod& b) { return a.value == b.value; };
  if (std::ranges::equal(periods, initial, same)) return named(StiffnessStage::initial, "");
  periods.insert(periods.end(), initial.begin(), initial.end());
  return periods;
}

}  // namespace

double first_period(const SparseMatrix& stiffness, const SparseMatrix& mass, const std::vector<int>& nodes) {
  if (nodes.empty()) return 0.0;
  return slowest_modes(part_of(stiffness, nodes), part_of(mass, nodes), 1).front().period();
}

std::vector<NamedPeriod> characteristic_periods(const Model& model, std::size_t most_buildings) {
  if (model.is_plan()) return periods_in_plan(model);
  const SparseMatrix initial = model.linear_stiffness(StiffnessStage::initial),
                     post_yield = model.linear_stiffness(StiffnessStage::post_yield);
  SparseMatrix masses = model.zero_matrix();
  model.mass_matrix().add_to(1.0, masses);

  std::vector<NamedPeriod> periods;
  const std::vector<Building> buildings = all_buildings(model);
  const std::vector<std::vector<ElementId>> isolators = isolators_of(model, buildings);
  for (std::size_t b = 0; b < std::min(buildings.size(), most_buildings); ++b) {
    const Building& building = buildings[b];
    const std::string prefix = buildings.size() > 1 && !building.name.empty() ? building.name + ": " : "";
    const auto report = [&](const char* name, double value) {
      if (value > 0.0 && std::isfinite(value)) periods.push_back({prefix + name, value});
    };
    std::vector<int> nodes =
        indices_of(model, building.shares_base ? building.nodes() : carried_nodes(model, building));
    // Modes of a building on the base of another one follow it; it is held.
    if (building.shares_base)
      for (const NodeId of_base : model.body_of(building.base)) std::erase(nodes, of_base.index);
    const std::vector<int> held = indices_of(model, isolated_nodes(model, isolators[b]));
    if (held.empty()) {
      report("first mode", first_period(initial, masses, nodes));
      continue;
    }
    // With the building rigid only its isolators deform: it moves by 1, as on the moving ground.
    Vector rigid = Vector::Zero(masses.rows());
    for (const int node : nodes) rigid[node] = model.ground_influence().x[node];
    const double mass = rigid.dot(masses * rigid), isolation_stiffness = rigid.dot(post_yield * rigid);
    report("fixed base", first_period(initial, masses, without(nodes, held)));
    if (isolation_stiffness > 0.0)
      report("isolation, rigid building", 2.0 * std::numbers::pi * std::sqrt(mass / isolation_stiffness));
    report("first mode, post-yield bearings", first_period(post_yield, masses, nodes));
    report("first mode, initial bearings", first_period(initial, masses, nodes));
  }
  return periods;
}

double fixed_base_period(const Model& model, const Building& building) {
  SparseMatrix masses = model.zero_matrix();
  model.mass_matrix().add_to(1.0, masses);
  const std::vector<ElementId> isolators = isolators_of(model, {&building, 1}).front();
  return first_period(
      model.linear_stiffness(StiffnessStage::initial), masses,
      without(indices_of(model, carried_nodes(model, building)), indices_of(model, isolated_nodes(model, isolators))));
}

}  // namespace moat
