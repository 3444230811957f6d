// Tour 10: which gap makes pounding less than 10 % probable? Read 01_moat_wall.cpp before.
//
// Twenty recorded motions are scaled to one spectral acceleration at the period of the isolated building. For each of
// them the smallest gap is found that the building does not close. These gaps are a distribution: pounding in a gap is
// as probable as a record that needs more. The report draws it with its confidence band.
//
//     ./moat run examples/10_gap_study.cpp
//     ./moat run examples/10_gap_study.cpp --sa 0.15g --probability 0.05 --out results/rare
//     ./moat run examples/10_gap_study.cpp --records FOLDER_OF_RECORDS
//
// The first twenty records of the folder are taken; without it synthetic pulses. Stopped at any moment, the study
// goes on where it was when the same command is given again.
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Which gap makes pounding improbable"};
  const std::string folder = script.text("records", "", "folder of records; without it synthetic pulses are taken");
  const Acceleration sa = script.acceleration("sa", 0.2 * g, "spectral acceleration at the period of isolation, 5 %");
  const double probability = script.number("probability", 0.1, "of pounding, that is accepted");
  const Time period = 2.5 * s;

  std::vector<GroundMotion> motions;
  if (folder.empty())
    for (int i = 0; i < 20; ++i) motions.push_back(near_fault_pulse({.pulse_period = (0.8 + 0.15 * i) * s}));
  else
    motions = read_record_folder(folder);
  if (motions.size() > 20) motions.erase(motions.begin() + 20, motions.end());
  for (GroundMotion& motion : motions) motion = scaled_to_sa(motion, period, sa);

  const StudyResult study = script.study({record_axis("record", motions)}, [&](const StudyCase& each) {
    return smallest_gap_of([&](Length gap) {
      StudyModel one{Model{}, motions[each.position("record")]};
      const auto building =
          add(one.model, ShearBuilding{.storeys = 5,
                                       .floor_mass = 500 * tonne,
                                       .storey_stiffness = 1 * GN / m,
                                       .damping = {.ratio = 0.05},
                                       .base_mass = 550 * tonne,
                                       .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                                      .yield_displacement = 1 * cm,
                                                                      .post_yield_stiffness = 19.3 * MN / m}});
      add(one.model, Moat{.around = building.base,
                          .clearance = gap,
                          .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65}});
      return one;
    });
  });

  const GapDemand demand{study};
  const Bounds band = demand.gap_bounds(probability);
  char text[200];
  std::snprintf(text, sizeof text,
                "A gap of %.1f cm makes pounding %.3g %% probable; 95 %% confidence: %.1f to %.1f cm.",
                100.0 * demand.gap(probability).si(), 100.0 * probability, 100.0 * band.low, 100.0 * band.high);
  script.answer(text);
  script.answer(demand.description());
  return script.finish();
}
