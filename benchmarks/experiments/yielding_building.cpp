#include "experiments/yielding_building.hpp"

#include <numbers>
#include <string>

#include "benchmark_building.hpp"
#include "experiments/sections.hpp"
#include "measuring/five_peaks.hpp"
#include "peers/opensees.hpp"
#include "solvers/modes.hpp"

namespace moat::experiments {

using namespace units;
using Given = YieldingBuilding;

YieldingBuilding::YieldingBuilding() {
  for (std::size_t i = 0; i < std::size(masses); ++i) {
    const std::string name = i == 0 ? "base" : "floor " + std::to_string(i);
    const NodeId below = i == 0 ? ground : nodes.back(), node = add(model, Node{.name = name, .mass = masses[i] * kg});
    const Stiffness stiffness = stiffnesses[i] * N / m;
    const Force yield_force = yield_forces[i] * N;
    if (i == 0)
      add(model, LeadRubberBearing{.upper = node,
                                   .yield_force = yield_force,
                                   .yield_displacement = yield_force / stiffness,
                                   .post_yield_stiffness = post_yield_ratio * stiffness});
    else
      add(model,
          Storey<YieldingStorey>{.name = "storey " + std::to_string(i),
                                 .lower = below,
                                 .upper = node,
                                 .law = {.stiffness = stiffness, .yield_force = yield_force, .hardening_ratio = 0.0}});
    add(model, ViscousDamper{.name = name + " beta", .lower = below, .upper = node, .damping = beta * s * stiffness});
    add(model, ViscousDamper{
                   .name = name + " alpha", .lower = ground, .upper = node, .damping = alpha / s * (masses[i] * kg)});
    nodes.push_back(node);
  }
  add(model, Building{.base = nodes.front(), .floors = std::vector<NodeId>{nodes.begin() + 1, nodes.end()}});
}

std::vector<double> periods_of(const YieldingBuilding& building) {
  std::vector<double> periods;
  for (const Mode& mode : slowest_modes(building.model.linear_stiffness(StiffnessStage::initial),
                                        building.model.mass_matrix().diagonal(), 4))
    periods.push_back(mode.period());
  return periods;
}

std::string yielding_building(const Folders& folders) {
  const YieldingBuilding building;
  const std::vector<double> periods = periods_of(building);
  std::string text = heading({"", "given", "moat"});
  for (std::size_t i = 0; i < periods.size(); ++i)
    text += row({"period " + std::to_string(i + 1) + ", s", to_fixed(Given::periods[i], 6), to_fixed(periods[i], 6)});
  const RayleighFactors factors =
      rayleigh_factors(Given::damping_ratio, 2.0 * std::numbers::pi / periods[0], 2.0 * std::numbers::pi / periods[1]);
  text += row({"alpha, 1/s", to_significant(Given::alpha, 10), to_significant(factors.mass_factor, 10)}) +
          row({"beta, s", to_significant(Given::beta, 10), to_significant(factors.stiffness_factor, 10)});

  // At its own strength the record hardly makes the storeys yield.
  const GroundMotion motion = testing::newhall(false).scaled_by(2.0);
  const CaseResult result = run_case(building.model, motion, {.error_bars = ErrorBarMode::never});
  const auto peak = [&](const char* quantity, const char* where) {
    return performance::peak_of(result, quantity, where);
  };
  const std::vector<double> of_moat{peak("displacement", "base"), peak("displacement", "floor 3"),
                                    peak("absolute_acceleration", "base"), peak("absolute_acceleration", "floor 3")};
  const auto opensees = peers::OpenSees::find(folders.out / "opensees");
  std::vector<double> of_opensees;
  if (opensees)
    of_opensees = opensees
                      ->run(AnalysisState{building.model},
                            {.name = "yielding building",
                             .model = building.model,
                             .base = building.nodes.front(),
                             .top = building.nodes.back(),
                             .motion = motion,
                             .end = motion.duration()},
                            motion.time_step() / 50.0, peers::opensees_settings().front())
                      .peaks;
  const char* names[] = {"base displacement, m", "roof displacement, m", "base acceleration, m/s^2",
                         "roof acceleration, m/s^2"};
  text += "\n" + heading({"twice Newhall, fault normal", "moat", "OpenSees, steps of 0.1 ms", "ratio"});
  for (std::size_t i = 0; i < of_moat.size(); ++i)
    text +=
        row({names[i], to_fixed(of_moat[i], 5), of_opensees.size() > i ? to_fixed(of_opensees[i], 5) : "not installed",
             of_opensees.size() > i ? to_fixed(of_moat[i] / of_opensees[i], 5) : ""});
  text += row({"ductility of storeys 1, 2, 3",
               to_fixed(peak("ductility", "storey 1"), 3) + ", " + to_fixed(peak("ductility", "storey 2"), 3) + ", " +
                   to_fixed(peak("ductility", "storey 3"), 3),
               "", ""});
  return text + "\n";
}

}  // namespace moat::experiments
