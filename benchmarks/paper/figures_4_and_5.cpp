// Figs. 4 and 5 of Zhao, Liu & Li (2017) under the Gebze record at 0.4 g: histories with a gap of 10 cm and the
// modified Hertz-damp law, and peaks over the height of the building.
#include <algorithm>
#include <functional>
#include <tuple>

#include "measuring/five_peaks.hpp"
#include "paper/exhibit.hpp"
#include "paper/paper_building.hpp"
#include "paper/records.hpp"

namespace moat::paper {
namespace {

using namespace units;
using performance::peak_of;

Series history(const CaseResult& result, const std::string& quantity, const std::string& where, double unit,
               const std::string& name) {
  Series series{.name = name, .x = result.histories.values("time"), .y = result.histories.values(quantity, where)};
  for (double& value : series.y) value /= unit;
  return series;
}

CaseResult run(const std::string& title, const GroundMotion& motion, const std::function<void(Model&)>& build) {
  Model model;
  build(model);
  return run_case(model, motion, {.title = title});
}

struct Profile {
  std::string name;
  std::vector<double> drift;         ///< storeys 1 to 5, m
  std::vector<double> acceleration;  ///< base and floors 1 to 5, m/s^2
};

Profile profile(const std::string& name, const GroundMotion& motion, const std::function<void(Model&)>& build) {
  Model model;
  build(model);
  const bool has_base = model.degrees_of_freedom() > 5;
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
      drift_row.push_back(to_fixed(100 * each.drift[i], 2));
    }
    for (std::size_t i = 0; i < each.acceleration.size(); ++i) {
      acceleration.x.push_back(each.acceleration[i]);
      acceleration.y.push_back(static_cast<double>(i));
      acceleration_row.push_back(to_fixed(each.acceleration[i], 2));
    }
    drifts.series.push_back(drift);
    accelerations.series.push_back(acceleration);
    table.rows.insert(table.rows.end(), {drift_row, acceleration_row});
  }
  exhibit.figure({"fig5", "Fig. 5: peaks over the height under GBZ000 at 0.4 g.", {drifts, accelerations}, 420, 2});
  exhibit.table(table);
}

}  // namespace

void show_fig4(Exhibit& exhibit) {
  const GroundMotion motion = scaled_records()[gebze];
  const CaseResult fixed_base = run("fixed base", motion, [](Model& model) { add(model, {.isolated = false}); });
  const CaseResult isolated = run("isolated, no walls", motion, [](Model& model) { add(model, PaperBuilding{}); });
  const CaseResult pounding = run("isolated, walls at 10 cm", motion, [](Model& model) { add_pounding(model, {}); });

  const auto acceleration = [&](const CaseResult& result) {
    return history(result, "absolute_acceleration", "floor 5", 1.0, result.title);
  };
  const auto chart = [](const std::string& title, const std::string& y_label, std::vector<Series> series) {
    return Chart{.title = title, .x_label = "time [s]", .y_label = y_label, .series = std::move(series)};
  };
  Series impact = history(pounding, "impact_force", "moat left", 1e6, "impact force");
  const Series right = history(pounding, "impact_force", "moat right", 1e6, "");
  std::ranges::transform(impact.y, right.y, impact.y.begin(), [](double a, double b) { return a + b; });
  const std::vector<Series> accelerations{acceleration(fixed_base), acceleration(pounding), acceleration(isolated)};
  Chart around_impact = chart("(a) around the impact", "acceleration [m/s²]", accelerations);
  around_impact.x_range = {{6.5, 9.0}};
  exhibit.figure(
      {"fig4",
       "Fig. 4: histories under GBZ000 at 0.4 g. (a) absolute acceleration of the top floor; (b) impact force, "
       "compression positive; (c) base shear under its different names.",
       {chart("(a) Top floor", "acceleration [m/s²]", accelerations), around_impact,
        chart("(b) Impact force", "force [MN]", {impact}),
        chart("(c) Base shear with impact", "force [MN]",
              {history(pounding, "total_base_shear", "base", 1e6, "total base shear (isolator + impact)"),
               history(pounding, "storey_shear", "storey 1", 1e6, "first-storey shear"),
               history(pounding, "isolator_force", "bearings", 1e6, "isolator force")})},
       300});

  ShownTable table{"Peaks", {"", fixed_base.title, isolated.title, pounding.title}, {}};
  const auto row = [&](const std::string& label, const std::string& quantity, const std::string& where, double unit,
                       bool of_superstructure) {
    table.rows.push_back({label, of_superstructure ? to_fixed(peak_of(fixed_base, quantity, where) / unit, 2) : "",
                          to_fixed(peak_of(isolated, quantity, where) / unit, 2),
                          to_fixed(peak_of(pounding, quantity, where) / unit, 2)});
  };
  row("top acceleration [m/s²]", "absolute_acceleration", "floor 5", 1.0, true);
  row("base acceleration [m/s²]", "absolute_acceleration", "base", 1.0, false);
  row("isolator force [MN]", "isolator_force", "bearings", 1e6, false);
  row("total base shear [MN]", "total_base_shear", "base", 1e6, true);
  row("first-storey shear [MN]", "storey_shear", "storey 1", 1e6, true);
  row("sum of floor inertia maxima [MN]", "sum_of_floor_inertia_maxima", "base", 1e6, true);
  exhibit.table(table);

  const double top_fixed = peak_of(fixed_base, "absolute_acceleration", "floor 5");
  const double top_pounding = peak_of(pounding, "absolute_acceleration", "floor 5");
  const double similar = top_pounding / top_fixed;
  exhibit.finding(
      {"4.2, Fig. 4", "The top acceleration at pounding is almost that of the fixed-base structure",
       "ratio between 0.8 and 1.25",
       to_fixed(top_pounding, 1) + " against " + to_fixed(top_fixed, 1) + " m/s², ratio " + to_fixed(similar, 2),
       similar >= 0.8 && similar <= 1.25 ? Verdict::holds : Verdict::fails});
  const auto growth = [&](const char* where) {
    return peak_of(pounding, "absolute_acceleration", where) / peak_of(isolated, "absolute_acceleration", where);
  };
  exhibit.finding({"4.2, Fig. 4", "Pounding raises accelerations remarkably",
                   "top floor, with walls over without, >= 1.5",
                   "base " + to_fixed(growth("base"), 2) + ", top " + to_fixed(growth("floor 5"), 2) + " times",
                   growth("floor 5") >= 1.5 ? Verdict::holds : Verdict::fails});
  exhibit.finding({"4.2, Fig. 4", "Above all at the base, where the impact occurs",
                   "base acceleration grows more than that of the top floor",
                   "base " + to_fixed(growth("base"), 2) + ", top " + to_fixed(growth("floor 5"), 2) + " times",
                   growth("base") > growth("floor 5") ? Verdict::holds : Verdict::fails});
}

void show_fig5(Exhibit& exhibit) {
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
      found += (found.empty() ? "" : "; ") + each.name + " " + to_fixed(top(each) / unit, decimals);
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
      found += (found.empty() ? "" : "; ") + with->name + ", " + name + ": " + to_fixed(low, 2) + " below, " +
               to_fixed(high, 2) + " above";
    }
  }
  exhibit.finding({"4.2, Fig. 5, conclusion 1",
                   "The influence of pounding is larger on lower floors than on upper ones",
                   "with walls over without: lowest floor or storey more than highest", found,
                   held == 4  ? Verdict::holds
                   : held > 0 ? Verdict::partly
                              : Verdict::fails,
                   std::to_string(held) + " of 4 comparisons"});
}

}  // namespace moat::paper
