// Tour 16: a suite of records, and the design sheet. Read 05_plan.cpp and 10_gap_study.cpp before.
//
// Seven pairs of pulses stand for the records of a site. They are scaled together to the MCE_R spectrum of ASCE 7 over
// the periods of the isolation, and run with lower, nominal and upper properties of the bearings. The report has
// statistics over the records, profiles over the height and the spectra of the suite; design_sheet.html has the
// formulas of the code with their numbers, beside the results of the histories.
//
//     ./moat run examples/16_design_suite.cpp
//     ./moat run examples/16_design_suite.cpp --gap "80 cm" --eccentricity 0.05 --out results/wide
#include <moat.hpp>

#include <string>
#include <vector>

using namespace moat;
using namespace moat::units;

// Periods from 1.2 to 3.3 s; the second component is shorter and weaker.
std::vector<NamedPair> records() {
  std::vector<NamedPair> pairs;
  for (int i = 0; i < 7; ++i) {
    const Time period = (1.2 + 0.35 * i) * s;
    const GroundMotion first = near_fault_pulse({.pulse_period = period, .quiet_after = 8 * s}),
                       second = near_fault_pulse({.pulse_period = 0.7 * period, .phase = 0.0, .quiet_after = 8 * s});
    pairs.push_back({"pulse " + std::to_string(i + 1), PlanMotion{first, second.scaled_by(0.6)}});
  }
  return pairs;
}

int main(int argc, char** argv) {
  Script script{argc, argv, "A hospital, its records and its design sheet"};
  const Length gap = script.length("gap", 60 * cm, "clearance on each side");
  const double eccentricity = script.number("eccentricity", 0.0, "accidental, as a share of the plan");

  // One of 15 bearings, and their bounds.
  const LeadRubberBearing bearing{
      .yield_force = 130 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 0.9 * MN / m};
  const PropertyBounds bounds{.lower = {.strength = 0.85, .stiffness = 0.9},
                              .upper = {.strength = 1.5, .stiffness = 1.3}};
  const Mass floor = 510 * tonne;

  // The sheet of the code, with all bearings together.
  SheetBuilding building{
      .name = "Hospital",
      .weight = 6 * floor * g,
      .isolation = LeadRubberBearing{.yield_force = 15 * bearing.yield_force.value(),
                                     .yield_displacement = bearing.yield_displacement,
                                     .post_yield_stiffness = 15 * bearing.post_yield_stiffness.value()},
      .bounds = bounds,
      .shorter_side = 20 * m,
      .longer_side = 32 * m,
      .fixed_base_period = 0.5 * s,
      .clearance = gap};
  for (int i = 1; i <= 5; ++i) building.floors.push_back({floor * g, i * 3.5 * m});
  for (const double x : {-16.0, -8.0, 0.0, 8.0, 16.0})
    for (const double y : {-10.0, 0.0, 10.0}) building.bearings.push_back({x * m, y * m});
  const auto sheet = [&] {
    return DesignSheet(Asce7Sheet{.building = building,
                                  .s_m1 = 0.675,
                                  .s_ds = 0.8,
                                  .s_d1 = 0.45,
                                  .s_1 = 0.45,
                                  .long_period = 8 * s,
                                  .response_modification = 4});
  };

  // Its periods are the range of scaling.
  const SheetLine period = sheet().line("T_M");
  const ScaledSuite suite =
      scale_suite(records(), Asce7Spectrum{.s_ds = 0.8, .s_d1 = 0.45, .long_period = 8 * s}.mce_r(),
                  SuiteScaling::asce_7_16(period.value(Bound::upper) * s, period.value(Bound::lower) * s));

  const StudyResult result =
      script.suite({suite, {.bounds = bounds, .eccentricity = eccentricity}}, [&](const SuiteCase& each) {
        LeadRubberBearing bounded = bearing;
        bounded.yield_force = each.factors.strength * bearing.yield_force.value();
        bounded.post_yield_stiffness = each.factors.stiffness * bearing.post_yield_stiffness.value();
        const PlanBuilding hospital{.outline = rectangle(32 * m, 20 * m),
                                    .storeys = 5,
                                    .floor_mass = floor,
                                    .columns = grid(5, 3, StoreyColumn{.stiffness = 60 * MN / m}),
                                    .damping = {.ratio = 0.02},
                                    .base_mass = floor,
                                    .bearings = grid(5, 3, bounded),
                                    .storey_height = 3.5 * m};
        Model model;
        const PlanBuildingParts parts =
            add(model, with_eccentricity(hospital, each.eccentricity.x, each.eccentricity.y));
        add(model, PlanMoat{.around = parts.base,
                            .clearance = gap,
                            .law = HertzDamp{.stiffness = 2.95e9 * N / m_3_2, .restitution = 0.65},
                            .friction = 0.3});
        return model;
      });

  // Once more, with the results of the histories beside its minima.
  building.suite = suite_for_sheet(result);
  script.design_sheet(sheet());
  return script.finish();
}
