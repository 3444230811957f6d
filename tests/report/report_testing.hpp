// Results for the tests of the report.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "moat.hpp"
#include "small_plan_building.hpp"

namespace moat::testing_report {

inline CaseResult result_with(std::vector<Column> columns) {
  CaseResult result;
  result.histories.columns = std::move(columns);
  return result;
}

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// A building of two storeys on lead-rubber bearings that hits its moat.
inline CaseResult line_result(Time end = 5.0 * units::s) {
  using namespace units;
  Model model;
  const auto building = add(model, ShearBuilding{.storeys = 2,
                                                 .floor_mass = 500 * tonne,
                                                 .storey_stiffness = 1 * GN / m,
                                                 .damping = RayleighDamping{.ratio = 0.05},
                                                 .base_mass = 550 * tonne,
                                                 .isolation = LeadRubberBearing{.yield_force = 1 * MN,
                                                                                .yield_displacement = 1 * cm,
                                                                                .post_yield_stiffness = 8 * MN / m}});
  add(model, moat::Moat{.around = building.base,
                        .clearance = 10 * cm,
                        .law = HertzDamp{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65}});
  return run_case(model, near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g),
                  {.title = "Two storeys", .transient = {.end = end}});
}

/// A tower in plan that hits its moat with friction.
inline CaseResult plan_result(Time end = 4.0 * units::s) {
  using namespace units;
  Model model;
  PlanBuilding building = testing::small_plan_building(
      1, {.yield_force = 184 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m});
  building.mass_offset = {1 * m, 0.6 * m};
  const auto tower = add(model, building);
  add(model, PlanMoat{.around = tower.base,
                      .clearance = 20 * cm,
                      .law = HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                      .friction = 0.2});
  const GroundMotion pulse = near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g);
  const PlanMotion motion{pulse, pulse.scaled_by(0.5), 20 * deg};
  return run_case(model, motion, {.title = "Tower", .transient = {.end = end}});
}

}  // namespace moat::testing_report
