// Fig. 4 of Zhao, Liu & Li (2017): histories under the Gebze record at 0.4 g, gap 10 cm, modified Hertz-damp law.
#include <moat.hpp>

#include <algorithm>
#include <functional>

#include "paper/exhibit.hpp"
#include "paper/paper_building.hpp"
#include "paper/records.hpp"

using namespace moat;
using namespace moat::paper;
using namespace moat::units;

namespace {

Series history(const CaseResult& result, const std::string& quantity, const std::string& where, double unit,
               const std::string& name) {
  for (const Column& column : result.histories.columns) {
    if (column.quantity != quantity || column.where != where) continue;
    Series series{.name = name, .x = result.histories.columns.front().values, .y = column.values};
    for (double& value : series.y) value /= unit;
    return series;
  }
  throw InputError{"There is no history of " + quantity + " at " + where + "."};
}

double peak(const CaseResult& result, const std::string& quantity, const std::string& where) {
  const auto found = std::ranges::find_if(
      result.peaks, [&](const Peak& each) { return each.quantity == quantity && each.where == where; });
  if (found == result.peaks.end()) throw InputError{"There is no peak of " + quantity + " at " + where + "."};
  return found->magnitude();
}

CaseResult run(const std::string& title, const GroundMotion& motion, const std::function<void(Model&)>& build) {
  Model model;
  build(model);
  return run_case(model, motion, {.title = title});
}

void show(Exhibit& exhibit) {
  if (const std::string missing = missing_records(); !missing.empty()) return exhibit.skip(missing);
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
    table.rows.push_back({label, of_superstructure ? fixed(peak(fixed_base, quantity, where) / unit, 2) : "",
                          fixed(peak(isolated, quantity, where) / unit, 2),
                          fixed(peak(pounding, quantity, where) / unit, 2)});
  };
  row("top acceleration [m/s²]", "absolute_acceleration", "floor 5", 1.0, true);
  row("base acceleration [m/s²]", "absolute_acceleration", "base", 1.0, false);
  row("isolator force [MN]", "isolator_force", "bearings", 1e6, false);
  row("total base shear [MN]", "total_base_shear", "base", 1e6, true);
  row("first-storey shear [MN]", "storey_shear", "storey 1", 1e6, true);
  row("sum of floor inertia maxima [MN]", "sum_of_floor_inertia_maxima", "base", 1e6, true);
  exhibit.table(table);

  const double top_fixed = peak(fixed_base, "absolute_acceleration", "floor 5");
  const double top_pounding = peak(pounding, "absolute_acceleration", "floor 5");
  const double similar = top_pounding / top_fixed;
  exhibit.finding({"4.2, Fig. 4", "The top acceleration at pounding is almost that of the fixed-base structure",
                   "ratio between 0.8 and 1.25",
                   fixed(top_pounding, 1) + " against " + fixed(top_fixed, 1) + " m/s², ratio " + fixed(similar, 2),
                   similar >= 0.8 && similar <= 1.25 ? Verdict::holds : Verdict::fails});
  const auto growth = [&](const char* where) {
    return peak(pounding, "absolute_acceleration", where) / peak(isolated, "absolute_acceleration", where);
  };
  exhibit.finding({"4.2, Fig. 4", "Pounding raises accelerations remarkably",
                   "top floor, with walls over without, >= 1.5",
                   "base " + fixed(growth("base"), 2) + ", top " + fixed(growth("floor 5"), 2) + " times",
                   growth("floor 5") >= 1.5 ? Verdict::holds : Verdict::fails});
  exhibit.finding({"4.2, Fig. 4", "Above all at the base, where the impact occurs",
                   "base acceleration grows more than that of the top floor",
                   "base " + fixed(growth("base"), 2) + ", top " + fixed(growth("floor 5"), 2) + " times",
                   growth("base") > growth("floor 5") ? Verdict::holds : Verdict::fails});
}

}  // namespace

int main(int argc, char** argv) { return run_exhibit(argc, argv, "fig4", "Figure 4: histories", show); }
