// Tour 12: how probable is damage at a given intensity? Read 10_gap_study.cpp before.
//
// Incremental dynamic analysis of a building in its moat: every record is scaled up until a storey drifts too far
// (hunt), and levels between are filled in. The levels at which records exceed the limit give the fragility. An
// analysis that does not converge is neither safe nor collapsed, and counted apart.
//
//     ./moat run examples/12_fragility.cpp
//     ./moat run examples/12_fragility.cpp --limit "2 cm" --out results/severe
//     ./moat run examples/12_fragility.cpp --records FOLDER_OF_RECORDS
//
// Without a folder of records synthetic pulses are taken.
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Fragility of a building in its moat"};
  const std::string folder = script.text("records", "", "folder of records; without it synthetic pulses are taken");
  const Length gap = script.length("gap", 25 * cm, "clearance on each side");
  const Length limit = script.length("limit", 1.5 * cm, "drift of the first storey that is damage");
  const Time period = 2.5 * s;

  std::vector<GroundMotion> motions;
  if (folder.empty())
    for (int i = 0; i < 12; ++i) motions.push_back(near_fault_pulse({.pulse_period = (0.8 + 0.2 * i) * s}));
  else
    motions = read_record_folder(folder);
  // The motions at 1 g: a level is then a factor.
  for (GroundMotion& motion : motions) motion = scaled_to_sa(motion, period, 1 * g);

  const HuntAndFill levels{.first_level = 0.05,
                           .first_step = 0.05,
                           .step_increment = 0.02,
                           .response_limit = limit.si(),
                           .largest_level = 2.0,
                           .fill = 4};
  const StudyResult study = script.study({record_axis("record", motions)}, [&](const StudyCase& each) {
    return record_of(hunt_and_fill(
        [&](double level) {
          Model model;
          const auto building =
              add(model, ShearBuilding{.storeys = 5,
                                       .floor_mass = 500 * tonne,
                                       .storey_stiffness = 1 * GN / m,
                                       .damping = {.ratio = 0.05},
                                       .base_mass = 550 * tonne,
                                       .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                                      .yield_displacement = 1 * cm,
                                                                      .post_yield_stiffness = 19.3 * MN / m}});
          add(model, Moat{.around = building.base,
                          .clearance = gap,
                          .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65}});
          return value_of(peaks_of(model, motions[each.position("record")].scaled_by(level)), "drift", "storey 1");
        },
        levels));
  });

  const std::vector<IdaCurve> curves = ida_curves(study);
  const LognormalFit fragility{capacities(curves, limit.si()), 0.95, "capacities"};
  const Bounds median = fragility.median_bounds(), dispersion = fragility.dispersion_bounds();
  std::size_t without_solution = 0;
  for (const IdaCurve& curve : curves) without_solution += curve.without_solution.size();
  char text[240];
  std::snprintf(text, sizeof text,
                "Drift above %.2g cm: median Sa(2.5 s) %.3f g (95 %%: %.3f to %.3f), dispersion %.2f (%.2f to %.2f).",
                100.0 * limit.si(), fragility.median(), median.low, median.high, fragility.dispersion(), dispersion.low,
                dispersion.high);
  script.answer(text);
  std::snprintf(text, sizeof text, "Records: %zu; analyses that did not converge: %zu.", curves.size(),
                without_solution);
  script.answer(text);
  script.show(fragility_chart(fragility, {}, "Fragility", "Sa(2.5 s) [g]"));
  script.show(
      ida_chart(curves, "Incremental dynamic analysis", "Sa(2.5 s) [g]", "drift of the first storey [cm]", 1 * cm));
  return script.finish();
}
