// Fig. 5 of Zhao, Liu & Li (2017): peaks over the height of the building, Gebze record at 0.4 g.
#include <moat.hpp>

#include <functional>

#include "paper/exhibit.hpp"
#include "paper/paper_building.hpp"
#include "paper/records.hpp"

using namespace moat;
using namespace moat::paper;
using namespace moat::units;

namespace {

struct Profile {
  std::string name;
  std::vector<double> drift;         ///< storeys 1 to 5, m
  std::vector<double> acceleration;  ///< base and floors 1 to 5, m/s^2
};

Profile profile(const std::string& name, const GroundMotion& motion, const std::function<void(Model&)>& build) {
  Model model;
  build(model);
  const bool has_base = model.node_count() > 5;
  const StudyRecord peaks = peaks_of(model, motion);
  Profile result{name, {}, {}};
  // The base of a fixed building moves with the ground.
  result.acceleration.push_back(has_base ? value_of(peaks, "absolute_acceleration", "base")
                                         : motion.peak_acceleration().si());
  for (int i = 1; i <= 5; ++i) {
    result.drift.push_back(value_of(peaks, "drift", "storey " + std::to_string(i)));
    result.acceleration.push_back(value_of(peaks, "absolute_acceleration", "floor " + std::to_string(i)));
  }
  return result;
}

void show_profiles(Exhibit& exhibit, const std::vector<Profile>& profiles) {
  Chart drifts{.title = "(a) Storey drift",
               .x_label = "peak drift [cm]",
               .y_label = "storey [1]",
               .series = {},
               .y_from_zero = true};
  Chart accelerations{.title = "(b) Floor acceleration",
                      .x_label = "peak absolute acceleration [m/s²]",
                      .y_label = "floor (0: base) [1]",
                      .series = {},
                      .y_from_zero = true};
  ShownTable table{"Peaks over the height, drift [cm] and acceleration [m/s²]", {"", "base"}, {}};
  for (int i = 1; i <= 5; ++i) table.header.push_back(std::to_string(i));
  for (const Profile& each : profiles) {
    Series drift{.name = each.name, .x = {}, .y = {}}, acceleration{.name = each.name, .x = {}, .y = {}};
    std::vector<std::string> drift_row{each.name + ", drift of storey", ""},
        acceleration_row{each.name + ", acceleration of floor"};
    for (std::size_t i = 0; i < each.drift.size(); ++i) {
      drift.x.push_back(100 * each.drift[i]);
      drift.y.push_back(static_cast<double>(i + 1));
      drift_row.push_back(fixed(100 * each.drift[i], 2));
    }
    for (std::size_t i = 0; i < each.acceleration.size(); ++i) {
      acceleration.x.push_back(each.acceleration[i]);
      acceleration.y.push_back(static_cast<double>(i));
      acceleration_row.push_back(fixed(each.acceleration[i], 2));
    }
    drifts.series.push_back(drift);
    accelerations.series.push_back(acceleration);
    table.rows.insert(table.rows.end(), {drift_row, acceleration_row});
  }
  exhibit.figure({"fig5", "Fig. 5: peaks over the height under GBZ000 at 0.4 g.", {drifts, accelerations}, 420, 2});
  exhibit.table(table);
}

void show(Exhibit& exhibit) {
  if (const std::string missing = missing_records(); !missing.empty()) return exhibit.skip(missing);
  const GroundMotion motion = scaled_records()[gebze];
  const std::vector<Profile> profiles{
      profile("fixed base", motion, [](Model& model) { add(model, {.isolated = false}); }),
      profile("isolated, no walls", motion, [](Model& model) { add(model, PaperBuilding{}); }),
      profile("walls at 5 cm", motion, [](Model& model) { add_pounding(model, {}, 5 * cm); }),
      profile("walls at 10 cm", motion, [](Model& model) { add_pounding(model, {}, 10 * cm); })};
  show_profiles(exhibit, profiles);
  const auto& [fixed_base, isolated, narrow, wide] = std::tie(profiles[0], profiles[1], profiles[2], profiles[3]);

  const auto at_top = [&](const std::vector<double> Profile::*response, double unit, int decimals) {
    const auto top = [&](const Profile& each) { return (each.*response).back(); };
    const bool above_isolated = top(narrow) > top(isolated) && top(wide) > top(isolated);
    const bool above_fixed = top(narrow) > top(fixed_base) && top(wide) > top(fixed_base);
    std::string found;
    for (const Profile& each : profiles)
      found += (found.empty() ? "" : "; ") + each.name + " " + fixed(top(each) / unit, decimals);
    return std::pair{found, above_isolated && above_fixed   ? Verdict::holds
                            : above_isolated || above_fixed ? Verdict::partly
                                                            : Verdict::fails};
  };
  const auto [accelerations, acceleration_verdict] = at_top(&Profile::acceleration, 1.0, 1);
  exhibit.finding({"4.2, Fig. 5, conclusion 1",
                   "With impact the top acceleration exceeds that without impact and that of the fixed-base structure",
                   "top floor, both gaps, against both", accelerations + " m/s²", acceleration_verdict});
  const auto [drifts, drift_verdict] = at_top(&Profile::drift, 0.01, 2);
  exhibit.finding({"4.2, Fig. 5, conclusion 1",
                   "With impact the top drift exceeds that without impact and that of the fixed-base structure",
                   "top storey, both gaps, against both", drifts + " cm", drift_verdict});
  // How much impact multiplies a response, low and high in the building.
  const auto growth = [&](const Profile& with, const std::vector<double> Profile::*response, bool top) {
    return top ? (with.*response).back() / (isolated.*response).back()
               : (with.*response).front() / (isolated.*response).front();
  };
  std::string found;
  int held = 0;
  for (const Profile* with : {&narrow, &wide}) {
    for (const auto& [response, name] :
         {std::pair{&Profile::acceleration, "acceleration"}, std::pair{&Profile::drift, "drift"}}) {
      const double low = growth(*with, response, false), high = growth(*with, response, true);
      held += low > high ? 1 : 0;
      found += (found.empty() ? "" : "; ") + with->name + ", " + name + ": " + fixed(low, 2) + " below, " +
               fixed(high, 2) + " above";
    }
  }
  exhibit.finding({"4.2, Fig. 5, conclusion 1",
                   "The influence of pounding is larger on lower floors than on upper ones",
                   "with walls over without: lowest floor or storey more than highest", found,
                   held == 4  ? Verdict::holds
                   : held > 0 ? Verdict::partly
                              : Verdict::fails});
}

}  // namespace

int main(int argc, char** argv) { return run_exhibit(argc, argv, "fig5", "Figure 5: peaks over the height", show); }
