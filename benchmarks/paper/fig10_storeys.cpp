// Fig. 10 of Zhao, Liu & Li (2017): the number of storeys, 1 to 10.
//
// The paper does not specify the bearings under a heavier building. Two readings:
//   kept      the same bearings; the isolation period grows from 1.5 s (one storey) to 3.4 s (ten);
//   designed  T_b = 2.5 s for every building, yield force in proportion to its weight, d_y = 1 cm.
#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "paper/sweep.hpp"

using namespace moat;
using namespace moat::paper;
using namespace moat::units;

namespace {

PaperBuilding with_kept_bearings(int storeys) { return {.storeys = storeys}; }

PaperBuilding with_designed_bearings(int storeys) {
  PaperBuilding building{.storeys = storeys};
  const double share = total_mass(storeys) / total_mass(5);
  building.post_yield_stiffness = share * building.post_yield_stiffness;
  building.yield_force = share * building.yield_force;
  return building;
}

void show_reading(Exhibit& exhibit, const std::string& name, const std::string& reading, const std::string& held,
                  PaperBuilding (*building)(int)) {
  const int step = exhibit.coarse() ? 3 : 1;
  std::vector<double> storeys;
  for (int i = 1; i <= 10; i += step) storeys.push_back(i);
  const SweepResult result =
      run_sweep(exhibit,
                {.name = name,
                 .title = "storeys, bearings " + reading,
                 .axis = {.name = "storeys", .unit = "", .values = storeys},
                 .x_label = "number of storeys [1]",
                 .build =
                     [building](Model& model, const StudyCase& each) {
                       return add_pounding(model, building(static_cast<int>(each.value("storeys"))));
                     }},
                scaled_records(), record_labels(), "Peaks over the number of storeys; " + held + ", gap 10 cm.");

  struct Claim {
    const char* response;
    const char* text;
  };
  for (const auto& [response, text] :
       {Claim{"top_acceleration", "The peak top acceleration increases significantly with the number of storeys"},
        Claim{"first_storey_drift", "The peak drift of the first storey increases with the number of storeys"},
        Claim{"impact_force", "The peak impact force increases with the number of storeys"},
        Claim{"total_base_shear", "The peak base shear increases with the number of storeys"}})
    judge(exhibit, result, "4.3.4, conclusion 3", text + std::string{" (bearings "} + reading + ")",
          "rank correlation >= 0.8, and ten storeys at least 1.2 times one", [&](std::size_t motion) {
            const std::vector<double> y = result.curve(response, motion);
            const double correlation = rank_correlation(result.x(), y), growth = y.back() / y.front();
            return Answer{
                correlation >= 0.8 && growth >= 1.2,
                fixed(correlation, 2) + (y.front() > 0.0 ? ", " + fixed(growth, 2) + " times" : ", from none")};
          });
}

void show(Exhibit& exhibit) {
  if (const std::string missing = missing_records(); !missing.empty()) return exhibit.skip(missing);
  show_reading(exhibit, "fig10", "kept", "the bearings are those of the five-storey building", with_kept_bearings);
  show_reading(exhibit, "fig10_designed", "designed",
               "bearings designed for each building (T_b = 2.5 s, yield force in proportion to weight)",
               with_designed_bearings);
}

}  // namespace

int main(int argc, char** argv) { return run_exhibit(argc, argv, "fig10", "Figure 10: number of storeys", show); }
