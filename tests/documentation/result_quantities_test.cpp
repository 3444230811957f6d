// The table of quantities in docs/reference/results.md has every quantity that a result can have, with its unit.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "in_folder.hpp"
#include "moat.hpp"
#include "output/peaks/peak_groups.hpp"
#include "output/recorders/impact_columns.hpp"

namespace moat::testing {
namespace {

using namespace units;

using Units = std::map<std::string, std::string>;  // by the names of the quantities

const ExactHertzDamp concrete{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65};

// The run is long enough for the pulse, and coarse: names do not depend on accuracy.
struct SmallCase {
  Model model{};
  GroundMotion motion = near_fault_pulse({.pulse_period = 1.5 * s}).scaled_to_pga(0.6 * g);
  TransientOptions options{.tolerance = 1e-3, .end = 5 * s};
};

// Bearings that lift and stick many times need steps that do not end there.
const TransientOptions few_steps{.step = 5 * ms, .end = 5 * s, .events = EventTreatment::at_end_of_step};

// Yielding storeys on rubber with dampers, a wall that bends with soil behind it, and a tank on a spring.
SmallCase yielding_building_in_soil() {
  SmallCase made;
  const auto building = add(
      made.model, ShearBuilding{.storeys = 2,
                                .floor_mass = 500 * tonne,
                                .storey = YieldingStorey{.stiffness = 500 * MN / m, .yield_force = 3 * MN},
                                .base_mass = 500 * tonne,
                                .isolation = Isolation{LeadRubberBearing{.yield_force = 0.8 * MN,
                                                                         .yield_displacement = 1 * cm,
                                                                         .post_yield_stiffness = 8 * MN / m},
                                                       NonlinearViscous{.reference_force = 0.2 * MN, .exponent = 0.4}},
                                .storey_height = 3.5 * m});
  FlexibleWall wall{.mass = 50 * tonne, .stiffness = 200 * MN / m};
  wall.backfill = HyperbolicBackfill{.initial_stiffness = 200 * MN / m, .ultimate_force = 3 * MN};
  add(made.model, Moat{.around = building.base, .clearance = 5 * cm, .law = concrete, .wall = wall});
  const NodeId tank = add(made.model, Node{.name = "tank", .mass = 20 * tonne});
  add(made.model, Spring<Linear>{.name = "hanger", .lower = building.top(), .upper = tank, .law = {2 * MN / m}});
  return made;
}

// The weight of a tall building changes on pendulums that lift, and it rocks.
SmallCase rocking_tower() {
  SmallCase made{.options = few_steps};
  const auto row = [](const char* name, Length at) {
    return Isolator{.name = name, .law = FrictionPendulum{.radius = 2 * m, .friction = 0.3}, .at = at};
  };
  add(made.model, ShearBuilding{.storeys = 1,
                                .floor_mass = 500 * tonne,
                                .storey_stiffness = 1 * GN / m,
                                .base_mass = 100 * tonne,
                                .isolation = Isolation{row("left", -2 * m), row("middle", 0 * m), row("right", 2 * m)},
                                .storey_height = 12 * m,
                                .axial_forces = AxialForces{.rocking = AxialForces::Rocking::continues}});
  return made;
}

// Rubber loses its stability under a weight that sways.
SmallCase unstable_rubber() {
  SmallCase made{.options = few_steps};
  const SofteningRubber soft{
      .bearing =
          LeadRubberBearing{
              .yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 0.6 * MN / m},
      .rubber = RubberBearing{
          .diameter = 60 * cm, .layer_thickness = 8 * mm, .rubber_thickness = 20 * cm, .shear_modulus = 0.4 * MPa}};
  const auto row = [&](const char* name, Length at) {
    return Isolator<SofteningRubber>{.name = name, .law = soft, .count = 3, .at = at};
  };
  add(made.model, ShearBuilding{.storeys = 1,
                                .floor_mass = 1500 * tonne,
                                .storey_stiffness = 2 * GN / m,
                                .base_mass = 500 * tonne,
                                .isolation = Isolation{row("left", -5 * m), row("right", 5 * m)},
                                .storey_height = 8 * m,
                                .axial_forces = AxialForces{.may_pull = 1 * MN}});
  return made;
}

// Isolators with quantities of their own, side by side.
SmallCase isolators_of_all_kinds() {
  SmallCase made;
  const Force weight = 5 * MN;
  add(made.model,
      ShearBuilding{.storeys = 1,
                    .floor_mass = 1000 * tonne,
                    .storey_stiffness = 1 * GN / m,
                    .base_mass = 500 * tonne,
                    .isolation = Isolation{
                        HeatedLeadRubber::typical(), KikuchiAikenRubber::typical(),
                        Isolator{.name = "triple", .law = TriplePendulum::typical(), .weight = weight},
                        Isolator{.name = "heated", .law = HeatedFrictionPendulum::typical(), .weight = weight}}});
  return made;
}

Superstructure two_floors(Freedoms freedoms, const Eigen::MatrixXd& stiffness) {
  const bool in_plan = freedoms != Freedoms::x;
  const auto floor = [&](Length height) {
    SuperstructureFloor made{.height = height, .mass = 200 * tonne};
    if (!in_plan) return made;
    made.rotary_inertia = 10e3 * tonne * m * m;
    made.outline = rectangle(20 * m, 12 * m);
    return made;
  };
  return {.stiffness = in_units(stiffness, {.force = N, .length = m}),
          .freedoms = per_floor(freedoms),
          .floors = {floor(4 * m), floor(8 * m)},
          .damping = ModalDamping{0.05}};
}

SmallCase matrix_on_a_line() {
  SmallCase made;
  Superstructure tower = two_floors(Freedoms::x, 1e8 * Eigen::Matrix2d{{2.0, -1.0}, {-1.0, 1.0}});
  tower.base = SuperstructureBase{.mass = 200 * tonne};
  tower.isolation =
      LeadRubberBearing{.yield_force = 300 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 4 * MN / m};
  add(made.model, tower);
  return made;
}

// A body that moves in a coordinate of its own.
SmallCase generalised_body() {
  SmallCase made;
  add(made.model, GeneralisedBody{.name = "mode",
                                  .coordinates = {{.name = "first", .ground_influence = {1.0, 0.0, 0.0}}},
                                  .mass = Eigen::MatrixXd::Constant(1, 1, 1e5),
                                  .free = true});
  return made;
}

PlanBuilding small_plan_building() {
  return {
      .outline = rectangle(20 * m, 12 * m),
      .storeys = 2,
      .floor_mass = 400 * tonne,
      .mass_offset = {1 * m, 0.6 * m},
      .columns = grid(2, 2, {.stiffness = 100 * MN / m}),
      .damping = {.ratio = 0.05},
      .base_mass = 400 * tonne,
      .bearings = grid(
          2, 2,
          LeadRubberBearing{.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 2 * MN / m}),
      .storey_height = 3.5 * m};
}

GroundMotion two_components() {
  const GroundMotion one = near_fault_pulse({.pulse_period = 1.5 * s}).scaled_to_pga(0.5 * g);
  return PlanMotion{one, one.scaled_by(0.7), {}};
}

SmallCase building_in_plan() {
  SmallCase made{.motion = two_components()};
  const auto building = add(made.model, small_plan_building());
  add(made.model, PlanMoat{.around = building.base, .clearance = 10 * cm, .law = concrete, .friction = 0.3});
  add(made.model, PlanSpring<Linear>{.name = "tie",
                                     .lower = PlanPoint{ground, {-11 * m, 0 * m}},
                                     .upper = PlanPoint{building.base, {-9 * m, 0 * m}},
                                     .law = {1 * MN / m}});
  return made;
}

SmallCase weight_in_plan() {
  SmallCase made{.motion = two_components(), .options = few_steps};
  PlanBuilding building = small_plan_building();
  building.axial_forces = AxialForces{.may_pull = 5 * MN};
  add(made.model, building);
  return made;
}

std::vector<SmallCase> all_cases() {
  std::vector<SmallCase> cases;
  cases.push_back(yielding_building_in_soil());
  cases.push_back(rocking_tower());
  cases.push_back(unstable_rubber());
  cases.push_back(isolators_of_all_kinds());
  cases.push_back(matrix_on_a_line());
  cases.push_back(generalised_body());
  cases.push_back(building_in_plan());
  cases.push_back(weight_in_plan());
  return cases;
}

// A quantity that is an error belongs to another; every other one has a row.
void note(Units& printed, std::string quantity, const std::string& unit) {
  if (quantity.ends_with("_error")) quantity.resize(quantity.size() - 6);
  const auto [found, inserted] = printed.try_emplace(quantity, unit);
  EXPECT_EQ(found->second, unit) << quantity;
}

void note_run(Units& printed, const SmallCase& each) {
  const CaseResult result =
      run_case(each.model, each.motion, {.transient = each.options, .error_bars = ErrorBarMode::never});
  for (const Column& column : result.histories.columns) note(printed, column.quantity, column.unit);
  for (const Peak& peak : result.peaks) note(printed, peak.quantity, peak.unit);
  for (const Peak& peak : isolators_at_the_end(result.histories)) note(printed, peak.quantity, peak.unit);
  for (const Peak& peak : residual_displacements(result.histories)) note(printed, peak.quantity, peak.unit);
  for (const ImpactColumn& column : columns_of(result.impacts)) note(printed, column.name, column.unit);
}

void note_study(Units& printed, const SmallCase& each) {
  const StudyResult study = run_study(
      {{.name = "gap", .unit = "cm", .values = {10.0}}},
      [&](const StudyCase&) {
        return StudyModel{each.model, each.motion};
      },
      {.transient = each.options,
       .error_bars = true,
       .energies = true,
       .floor_spectra = FloorSpectraOptions{.floors = {"base"}, .periods = {0.3 * s}, .absolute_acceleration = true}});
  const CaseOutcome first = study.outcome(0);
  for (const NamedNumber& number : first.results) note(printed, number.quantity, number.unit);
}

Units printed_by_all_cases() {
  Units printed;
  for (const SmallCase& each : all_cases()) note_run(printed, each);
  note_study(printed, yielding_building_in_soil());
  note_study(printed, rocking_tower());
  note_study(printed, building_in_plan());
  return printed;
}

// The rows of the section "Quantities": names in backticks, then their unit; 1 has none.
Units of_the_table() {
  std::istringstream page{read_file(MOAT_SOURCE_DIR "/docs/reference/results.md")};
  Units rows;
  bool inside = false;
  const std::regex name{"`([a-z_0-9]+)`"}, row{R"(\| (`[^|]+) \| ([^|]+) \|.*)"};
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) inside = line == "## Quantities";
    std::smatch cells;
    if (!inside || !std::regex_match(line, cells, row)) continue;
    const std::string names = cells[1];
    for (std::sregex_iterator at{names.begin(), names.end(), name}, end; at != end; ++at) rows[(*at)[1]] = cells[2];
  }
  return rows;
}

TEST(Reference, HasEveryQuantityOfResults) {
  const Units printed = printed_by_all_cases(), table = of_the_table();
  for (const auto& [quantity, unit] : printed) {
    const auto row = table.find(quantity);
    if (row == table.end())
      ADD_FAILURE() << "docs/reference/results.md, \"Quantities\", lacks " << quantity << " [" << unit << "]";
    else
      EXPECT_EQ(row->second, unit) << quantity;
  }
  for (const auto& [quantity, unit] : table)
    EXPECT_TRUE(printed.contains(quantity)) << quantity << " stands in the table, and no model of this test has it";
}

}  // namespace
}  // namespace moat::testing
