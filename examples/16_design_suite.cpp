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

#include <cmath>
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

  // Each of 15 bearings carries its share of the weight.
  const PropertyBounds bounds{.lower = {.strength = 0.85, .stiffness = 0.9},
                              .upper = {.strength = 1.5, .stiffness = 1.3}};
  const auto bearing = [](const PropertyFactors& factors) {
    return BearingDesign{.strength_ratio = 0.06 * factors.strength,
                         .isolation_period = 3 * s / std::sqrt(factors.stiffness),
                         .yield_displacement = 1 * cm};
  };
  const auto make = [&](const SuiteCase& each) {
    const PlanBuilding hospital{.outline = rectangle(32 * m, 20 * m),
                                .storeys = 5,
                                .floor_mass = 510 * tonne,
                                .columns = grid(5, 3, StoreyColumn{.stiffness = 60 * MN / m}),
                                .damping = {.ratio = 0.02},
                                .base_mass = 510 * tonne,
                                .bearings = grid(5, 3, bearing(each.factors)),
                                .storey_height = 3.5 * m};
    Model model;
    const PlanBuildingParts parts = add(model, with_eccentricity(hospital, each.eccentricity.x, each.eccentricity.y));
    add(model, PlanMoat{.around = parts.base,
                        .clearance = gap,
                        .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65},
                        .friction = 0.3});
    return model;
  };

  // The sheet of the code takes weights, heights, plan and period from the model.
  const Asce7Spectrum spectrum{.s_ds = 0.8, .s_d1 = 0.45, .long_period = 8 * s};
  SheetBuilding building = sheet_building_of(make({}), bearing({}));
  building.name = "Hospital";
  building.bounds = bounds;
  building.clearance = gap;
  const auto sheet = [&] {
    return DesignSheet(Asce7Sheet{.building = building, .spectrum = spectrum, .s_1 = 0.45, .response_modification = 4});
  };

  // The periods of the sheet are the range of scaling.
  const SheetLine period = sheet().line("T_M");
  SuiteScaling scaling = SuiteScaling::asce_7_16(period.value(Bound::upper) * s, period.value(Bound::lower) * s);
  scaling.fraction = script.number("fraction", scaling.fraction, "of the target that the mean reaches");
  const ScaledSuite suite = scale_suite(records(), spectrum.mce_r(), scaling);

  const StudyResult result = script.suite({suite, {.bounds = bounds, .eccentricity = eccentricity}}, make);

  // Once more, with the results of the histories beside its minima.
  building.suite = suite_for_sheet(result, suite);
  script.design_sheet(sheet());
  return script.finish();
}
