// Fig. 11 of Zhao, Liu & Li (2017): the impact stiffness, 0.01 to 10 GN/m^1.5, everything else held.
#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "paper/sweep.hpp"

using namespace moat;
using namespace moat::paper;
using namespace moat::units;

namespace {

void show(Exhibit& exhibit) {
  if (const std::string missing = missing_records(); !missing.empty()) return exhibit.skip(missing);
  const SweepResult result =
      run_sweep(exhibit,
                {.name = "fig11",
                 .title = "impact stiffness",
                 .axis = {.name = "impact stiffness",
                          .unit = "GN/m^1.5",
                          .values = logarithmically_spaced(0.01, 10.0, points(exhibit, 61))},
                 .x_label = "impact stiffness [GN/m^1.5]",
                 .logarithmic = true,
                 .build =
                     [](Model& model, const StudyCase& each) {
                       return add_pounding(model, {}, paper_gap, each.value("impact stiffness") * GN / m_3_2);
                     }},
                scaled_records(), record_labels(), "Peaks over the impact stiffness k_h; e = 0.65, gap 10 cm.");

  const auto upper_end = [&](const std::vector<double>& y) {
    std::vector<double> values;
    for (std::size_t i = 0; i < y.size(); ++i)
      if (result.x()[i] >= 2.0) values.push_back(y[i]);
    return values;
  };
  const auto rises_then_stays = [&](const char* response) {
    return [&, response](std::size_t motion) {
      const std::vector<double> y = result.curve(response, motion);
      const double above_two = spread(upper_end(y));
      return Answer{
          y.front() < 0.9 * y.back() && above_two <= 1.10,
          fixed(y.back() / y.front(), 2) + " times from end to end, spread " + fixed(above_two, 2) + " above 2"};
    };
  };
  const std::string criterion =
      "higher at 10 than at 0.01 GN/m^1.5 by more than a tenth, and largest / smallest <= 1.10 from 2 GN/m^1.5 up";
  judge(exhibit, result, "4.3.5, conclusion 3", "Peak drifts increase with impact stiffness, constant above 2 GN/m^1.5",
        criterion, rises_then_stays("largest_drift"));
  judge(exhibit, result, "conclusion 3", "Superstructure acceleration increases up to a maximum, then stays constant",
        "top floor: " + criterion, rises_then_stays("top_acceleration"));
  judge(exhibit, result, "4.3.5", "The acceleration of the isolation layer grows more than the superstructure's",
        "growth from 0.01 to 10 GN/m^1.5: base more than top", [&](std::size_t motion) {
          const std::vector<double> base = result.curve("base_acceleration", motion);
          const std::vector<double> top = result.curve("top_acceleration", motion);
          const double of_base = base.back() / base.front(), of_top = top.back() / top.front();
          return Answer{of_base > of_top, fixed(of_base, 1) + " against " + fixed(of_top, 1) + " times"};
        });
  const auto increases = [&](const char* response) {
    return [&result, response](std::size_t motion) {
      const double correlation = rank_correlation(result.x(), result.curve(response, motion));
      return Answer{correlation >= 0.8, fixed(correlation, 2)};
    };
  };
  judge(exhibit, result, "4.3.5, conclusion 3", "The peak impact force increases with impact stiffness",
        "rank correlation >= 0.8", increases("impact_force"));
  judge(exhibit, result, "4.3.5, conclusion 3", "The peak base shear increases with impact stiffness",
        "total base shear: rank correlation >= 0.8", increases("total_base_shear"));
}

}  // namespace

int main(int argc, char** argv) { return run_exhibit(argc, argv, "fig11", "Figure 11: impact stiffness", show); }
