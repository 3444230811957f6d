// A study of many short cases: a pulse on an isolated mass beside a wall. With MOAT_TEST_LOG every case that is
// computed adds a character to this file, and then takes longer, so that a test can disturb the study after a certain
// case. With MOAT_TEST_SHEET there are two design sheets; with MOAT_TEST_RECORDS it reads a folder before its study.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <moat.hpp>
#include <thread>

#include "design/design_sheet.hpp"

using namespace moat;
using namespace moat::units;

namespace {

void log_the_case() {
  const char* log = std::getenv("MOAT_TEST_LOG");
  if (log == nullptr) return;
  std::ofstream{log, std::ios::app} << '.';
  std::this_thread::sleep_for(std::chrono::milliseconds{30});
}

/// Pulses, or the records of a folder.
std::vector<GroundMotion> motions_of(const std::string& records, int pulses) {
  if (!records.empty()) return read_record_folder(records);
  const char* amplitude = std::getenv("MOAT_TEST_AMPLITUDE");
  std::vector<GroundMotion> motions;
  for (int i = 1; i <= pulses; ++i)
    motions.push_back(near_fault_pulse({.pulse_period = i * s, .amplitude = (amplitude ? 0.5 : 0.8) * m / s}));
  return motions;
}

StudyModel mass_in_a_moat(const GroundMotion& motion, Length gap, double stiffness) {
  StudyModel one{Model{}, motion};
  const NodeId mass = add(one.model, Node{.name = "mass", .mass = 1000 * tonne});
  add(one.model, ShearSpring{.name = "spring", .lower = ground, .upper = mass, .stiffness = 10 * MN / m});
  add(one.model,
      Moat{.around = mass, .clearance = gap, .law = HertzDamp{.stiffness = stiffness * N / m_3_2, .restitution = 0.6}});
  return one;
}

/// 50 results without an analysis, in cases that read a file.
StudyResult study_of_numbers(Script& script, int gaps, const std::string& record) {
  std::vector<std::string> names;
  for (int i = 1; i <= 20; ++i) names.push_back("a record with a long name, " + std::to_string(i));
  return script.study(
      {{.name = "gap", .unit = "cm", .values = linearly_spaced(1.0, 50.0, gaps)},
       StudyAxis::of_names("component", names)},
      [&](const StudyCase& each) {
        static_cast<void>(read_motion(record));
        StudyRecord results;
        for (int i = 1; i <= 50; ++i)
          results.push_back({"displacement", "storey " + std::to_string(i), "m", i * each.value("gap")});
        return results;
      });
}

Model isolated_house(const SuiteCase& each) {
  Model model;
  const auto house =
      add(model, ShearBuilding{.storeys = 1,
                               .floor_mass = 500 * tonne,
                               .storey_stiffness = 1000 * MN / m,
                               .base_mass = 500 * tonne,
                               .isolation = LeadRubberBearing{.yield_force = each.factors.strength * 0.5 * MN,
                                                              .yield_displacement = 1 * cm,
                                                              .post_yield_stiffness = 6 * MN / m}});
  add(model, Moat{.around = house.base,
                  .clearance = 1 * m,
                  .law = HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.6}});
  return model;
}

}  // namespace

int main(int argc, char** argv) {
  Script script{argc, argv, "Study of a mass"};
  const Length mass_gap = script.length("last-gap", 30 * cm, "largest gap");
  const int gaps = script.integer("gaps", 20, "how many");
  const int failing = script.integer("failing", -1, "a case that fails");
  const int stuck = script.integer("stuck", -1, "a case that does not converge");
  const std::string inside = script.text("inside", "", "a record that every case reads");
  const GroundMotion motion = script.motion(near_fault_pulse({.pulse_period = 1 * s})).scaled_to_pga(0.3 * g);
  const std::string records = script.text("records", "", "folder of records, a case for each"),
                    pairs = script.text("pairs", "", "folder of pairs of records, a case for each");
  const int pulses = script.integer("pulses", 0, "a case for each");
  const int times = script.integer("times", 1, "studies of one name");
  const int suite = script.integer("suite", 0, "records of a suite");
  const int numbers = script.integer("numbers", 0, "gaps of cases without analysis, 20 cases for each");
  if (const char* folder = std::getenv("MOAT_TEST_RECORDS")) static_cast<void>(read_record_folder(folder));
  if (numbers > 0) {
    study_of_numbers(script, numbers, inside);
    return script.finish();
  }
  if (suite > 0) {
    script.suite({motions_of("", suite),
                  {.bounds = PropertyBounds{.lower = {.strength = 0.9}, .upper = {.strength = 1.3}},
                   .study = {.floor_spectra = FloorSpectraOptions{.floors = {"base"}, .periods = {0.1 * s, 1 * s}}}}},
                 isolated_house);
    return script.finish();
  }
  if (!pairs.empty()) {
    const std::vector<PlanMotion> motions = read_record_pairs(pairs);
    script.study({record_axis("pair", motions)}, [&](const StudyCase& each) {
      return mass_in_a_moat(motions[each.position("pair")].first, 10 * cm, 1e9);
    });
    return script.finish();
  }
  if (const std::vector<GroundMotion> motions = motions_of(records, pulses); !motions.empty()) {
    for (int i = 0; i < times; ++i)
      script.study({record_axis("motion", motions)}, [&](const StudyCase& each) {
        if (each.position("motion") == static_cast<std::size_t>(failing)) throw InputError{"this motion fails."};
        return mass_in_a_moat(motions[each.position("motion")], 10 * cm, 1e9);
      });
    return script.finish();
  }
  const StudyResult study =
      script.study({{.name = "gap", .unit = "cm", .values = linearly_spaced(5.0, mass_gap / cm, gaps)},
                    StudyAxis::of_names("stiffness", {"soft", "stiff, \"rigid\""})},
                   [&](const StudyCase& each) {
                     log_the_case();
                     if (static_cast<int>(each.number()) == failing) throw InputError{"this case fails"};
                     if (static_cast<int>(each.number()) == stuck)
                       throw ConvergenceError{"this case is stuck", 1.0, 0.1, 1.0, "mass"};
                     return mass_in_a_moat(inside.empty() ? motion : read_motion(inside), each.value("gap") * cm,
                                           (each.value("stiffness") + 1.0) * 1e9);
                   });
  double impacts = 0.0;
  for (const double each : study.values("impacts", "")) impacts += each;
  std::printf("%.17g impacts\n", impacts);
  if (std::getenv("MOAT_TEST_SHEET") != nullptr) {
    script.design_sheet({.name = "first",
                         .code = "a code",
                         .lines = {{.symbol = "gap", .formula = "D", .verdict = "gap needed: 1 m"}}});
    script.design_sheet({.name = "second", .code = "another code"});
  }
  return script.finish();
}
