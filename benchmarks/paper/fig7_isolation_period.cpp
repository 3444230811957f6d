// Fig. 7 of Zhao, Liu & Li (2017): the isolation period.
//
// T_b from 1.5 to 4.5 s by Eq. 33, through the post-yield stiffness of the bearings. Held: yield force 1.93 MN, yield
// displacement 1 cm (so the initial stiffness too), the superstructure, the gap of 10 cm.
#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "paper/sweep.hpp"

using namespace moat;
using namespace moat::paper;
using namespace moat::units;

namespace {

void show(Exhibit& exhibit) {
  if (const std::string missing = missing_records(); !missing.empty()) return exhibit.skip(missing);
  const SweepResult result = run_sweep(
      exhibit,
      {.name = "fig7",
       .title = "isolation period",
       .axis = {.name = "isolation period", .unit = "s", .values = linearly_spaced(1.5, 4.5, points(exhibit, 61))},
       .x_label = "isolation period [s]",
       .build =
           [](Model& model, const StudyCase& each) {
             PaperBuilding building;
             building.post_yield_stiffness = stiffness_for_period(each.value("isolation period") * s, 5);
             return add_pounding(model, building);
           }},
      scaled_records(), record_labels(),
      "Peaks over the isolation period T_b (Eq. 33, by the post-yield stiffness); yield force and yield displacement "
      "held, gap 10 cm.");

  judge(exhibit, result, "4.3.1, conclusion 2", "Peak accelerations do not change notably with the isolation period",
        "top floor: largest / smallest peak <= 1.25", [&](std::size_t motion) {
          const double factor = spread(result.curve("top_acceleration", motion));
          return Answer{factor <= 1.25, fixed(factor, 2)};
        });
  judge(exhibit, result, "4.3.1, conclusion 2", "Peak drifts increase at first, then stay almost constant",
        "drift at 1.5 s below its mean for T_b >= 3 s, and largest / smallest there <= 1.10", [&](std::size_t motion) {
          const std::vector<double> drift = result.curve("largest_drift", motion);
          std::vector<double> later;
          double mean = 0.0;
          for (std::size_t i = 0; i < drift.size(); ++i)
            if (result.x()[i] >= 3.0) later.push_back(drift[i]);
          for (const double each : later) mean += each / static_cast<double>(later.size());
          return Answer{drift.front() < mean && spread(later) <= 1.10,
                        fixed(100 * drift.front(), 2) + " cm at 1.5 s, mean " + fixed(100 * mean, 2) +
                            " cm, later spread " + fixed(spread(later), 2)};
        });
  const auto decreases = [&](const char* response) {
    return [&result, response](std::size_t motion) {
      const double correlation = rank_correlation(result.x(), result.curve(response, motion));
      return Answer{correlation <= -0.8, fixed(correlation, 2)};
    };
  };
  judge(exhibit, result, "4.3.1, conclusion 2", "The peak impact force decreases with the isolation period",
        "rank correlation with the period <= -0.8", decreases("impact_force"));
  judge(exhibit, result, "4.3.1, conclusion 2", "The peak base shear decreases with the isolation period",
        "total base shear: rank correlation <= -0.8", decreases("total_base_shear"));
}

}  // namespace

int main(int argc, char** argv) { return run_exhibit(argc, argv, "fig7", "Figure 7: isolation period", show); }
