// Fig. 9 of Zhao, Liu & Li (2017): the gap between building and wall, 10 to 50 cm, everything else held.
#include <algorithm>

#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "paper/sweep.hpp"

using namespace moat;
using namespace moat::paper;
using namespace moat::units;

namespace {

/// How far the base goes where there is no wall: the gap beyond which nothing pounds.
void show_unpounded_displacement(Exhibit& exhibit) {
  const std::vector<double> ratios{0.0, 0.05, 0.10};
  const std::vector<GroundMotion> motions = scaled_records();
  const StudyResult result = run_study(
      {{.name = "damping ratio", .unit = "", .values = ratios}, StudyAxis::of_names("record", record_labels())},
      [&](const StudyCase& each) {
        StudyModel study{Model{}, motions[each.position("record")]};
        PaperBuilding building;
        building.isolator_damping = isolator_damping(each.value("damping ratio"), 2.5 * s, 5);
        add(study.model, building);
        return study;
      },
      {.progress = ProgressBar{"fig9, without walls"}});
  ShownTable table{"Largest base displacement without walls [cm]: the gap beyond which pounding is avoided",
                   {"viscous damping of the isolator"},
                   {}};
  for (const PaperRecord& record : paper_records) table.header.emplace_back(record.label);
  std::string found;
  double plain = 0.0;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const std::vector<double> displacement = result.values("displacement", "base", {{"damping ratio", i}});
    std::vector<std::string> row{i == 0 ? "none (plain reading)"
                                        : fixed(100 * ratios[i], 0) + " % of critical at 2.5 s"};
    for (const double each : displacement) row.push_back(fixed(100 * each, 1));
    table.rows.push_back(row);
    exhibit.report(displacement.size());
    const double largest = 100 * std::ranges::max(displacement);
    if (i == 0) plain = largest;
    found +=
        (found.empty() ? "largest " : "; with " + fixed(100 * ratios[i], 0) + " % viscous damping of the isolator ") +
        fixed(largest, 1) + " cm";
  }
  exhibit.table(table);
  exhibit.finding({"4.3.3", "Pounding is avoided if the gap is over 40 cm",
                   "base displacement without walls <= 40 cm for all four records (plain reading)", found,
                   plain <= 40.0 ? Verdict::holds : Verdict::fails});
}

void show(Exhibit& exhibit) {
  if (const std::string missing = missing_records(); !missing.empty()) return exhibit.skip(missing);
  const SweepResult result = run_sweep(
      exhibit,
      {.name = "fig9",
       .title = "gap",
       .axis = {.name = "gap", .unit = "cm", .values = linearly_spaced(10.0, 50.0, points(exhibit, 81))},
       .x_label = "gap [cm]",
       .build = [](Model& model, const StudyCase& each) { return add_pounding(model, {}, each.value("gap") * cm); }},
      scaled_records(), record_labels(), "Peaks over the gap on each side; everything else held.");

  const auto rises_then_falls = [&](const char* response) {
    return [&result, response](std::size_t motion) {
      const std::vector<double> y = result.curve(response, motion);
      const std::size_t highest = position_of_maximum(y);
      return Answer{y[highest] > 1.02 * y.front() && y[highest] > 1.02 * y.back(),
                    "maximum at " + fixed(result.x()[highest], 0) + " cm"};
    };
  };
  const std::string criterion = "largest value inside the range, 2 % above both ends";
  judge(exhibit, result, "4.3.3", "The peak floor acceleration increases at first with the gap",
        "top floor: " + criterion, rises_then_falls("top_acceleration"));
  judge(exhibit, result, "4.3.3, conclusion 2", "Peak drifts increase up to a certain gap, then decrease", criterion,
        rises_then_falls("largest_drift"));
  judge(exhibit, result, "4.3.3, conclusion 2", "The peak impact force does the same", criterion,
        rises_then_falls("impact_force"));
  judge(exhibit, result, "4.3.3, conclusion 2", "The peak base shear does the same", "total base shear: " + criterion,
        rises_then_falls("total_base_shear"));
  show_unpounded_displacement(exhibit);
}

}  // namespace

int main(int argc, char** argv) { return run_exhibit(argc, argv, "fig9", "Figure 9: gap", show); }
