// Figs. 7 to 11 of Zhao, Liu & Li (2017): one parameter of the building in its moat varied under the four records, and
// the gap under a synthetic pulse. All that is not named is held: yield force 1.93 MN, yield displacement 1 cm, T_b =
// 2.5 s, the superstructure, the gap of 10 cm.
#include <algorithm>

#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "paper/sweep.hpp"

namespace moat::paper {
namespace {

using namespace units;
using Curve = std::vector<double>;

SweepResult run_sweep(Exhibit& exhibit, const Sweep& sweep) {
  return run_sweep(exhibit, sweep, scaled_records(), record_labels());
}

/// Whether a response grows with the axis (sign 1) or falls (-1).
std::function<Answer(const Curve&)> follows(const Curve& x, double sign) {
  return [&x, sign](const Curve& y) {
    const double correlation = rank_correlation(x, y);
    return Answer{sign * correlation >= 0.8, to_fixed(correlation, 2)};
  };
}

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
                                        : to_fixed(100 * ratios[i], 0) + " % of critical at 2.5 s"};
    for (const double each : displacement) row.push_back(to_fixed(100 * each, 1));
    table.rows.push_back(row);
    exhibit.report(displacement.size());
    const double largest = 100 * std::ranges::max(displacement);
    if (i == 0) plain = largest;
    found += (found.empty() ? "largest "
                            : "; with " + to_fixed(100 * ratios[i], 0) + " % viscous damping of the isolator ") +
             to_fixed(largest, 1) + " cm";
  }
  exhibit.table(table);
  exhibit.finding({"4.3.3", "Pounding is avoided if the gap is over 40 cm",
                   "base displacement without walls <= 40 cm for all four records (plain reading)", found,
                   plain <= 40.0 ? Verdict::holds : Verdict::fails, "largest " + to_fixed(plain, 1) + " cm"});
}

}  // namespace

// T_b from 1.5 to 4.5 s by Eq. 33, through the post-yield stiffness of the bearings.
void show_fig7(Exhibit& exhibit) {
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
           },
       .caption = "Peaks over the isolation period T_b (Eq. 33, by the post-yield stiffness); yield force and yield "
                  "displacement held, gap 10 cm."});
  const std::string source = "4.3.1, conclusion 2";
  judge(exhibit, result,
        {source, "Peak accelerations do not change notably with the isolation period",
         "top floor: largest / smallest peak <= 1.25", "top_acceleration"},
        [](const Curve& y) {
          return Answer{spread(y) <= 1.25, to_fixed(spread(y), 2)};
        });
  judge(exhibit, result,
        {source, "Peak drifts increase at first, then stay almost constant",
         "drift at 1.5 s below its mean for T_b >= 3 s, and largest / smallest there <= 1.10", "largest_drift"},
        [&](const Curve& drift) {
          Curve later;
          double mean = 0.0;
          for (std::size_t i = 0; i < drift.size(); ++i)
            if (result.x[i] >= 3.0) later.push_back(drift[i]);
          for (const double each : later) mean += each / static_cast<double>(later.size());
          return Answer{drift.front() < mean && spread(later) <= 1.10,
                        to_fixed(100 * drift.front(), 2) + " cm at 1.5 s, mean " + to_fixed(100 * mean, 2) +
                            " cm, later spread " + to_fixed(spread(later), 2)};
        });
  judge(exhibit, result,
        {source, "The peak impact force decreases with the isolation period",
         "rank correlation with the period <= -0.8", "impact_force"},
        follows(result.x, -1.0));
  judge(exhibit, result,
        {source, "The peak base shear decreases with the isolation period",
         "total base shear: rank correlation <= -0.8", "total_base_shear"},
        follows(result.x, -1.0));
}

// d_y from 0.5 to 4.5 cm at the same yield force: the initial stiffness F_y / d_y varies.
void show_fig8(Exhibit& exhibit) {
  const SweepResult result = run_sweep(
      exhibit,
      {.name = "fig8",
       .title = "yield displacement",
       .axis = {.name = "yield displacement", .unit = "cm", .values = linearly_spaced(0.5, 4.5, points(exhibit, 81))},
       .x_label = "yield displacement [cm]",
       .build =
           [](Model& model, const StudyCase& each) {
             PaperBuilding building;
             building.yield_displacement = each.value("yield displacement") * cm;
             return add_pounding(model, building);
           },
       .caption = "Peaks over the yield displacement; yield force and post-yield stiffness held (initial stiffness "
                  "varies), gap 10 cm."});
  const std::string source = "4.3.2, conclusion 2";
  for (const auto& [response, name] :
       {std::pair{"base_acceleration", "base acceleration"}, std::pair{"top_acceleration", "top acceleration"},
        std::pair{"largest_drift", "drift"}})
    judge(exhibit, result,
          {source, std::string{"Peak "} + name + " has its minimum near a yield displacement of 1.5 cm",
           "smallest value between 1 and 2 cm", response},
          [&](const Curve& y) {
            const double at = result.x[position_of_minimum(y)];
            return Answer{at >= 1.0 && at <= 2.0, "minimum at " + to_fixed(at, 1) + " cm"};
          });
  const auto falls_then_rises = [&](const Curve& y) {
    const std::size_t lowest = position_of_minimum(y);
    const double rise_before = y.front() / y[lowest], rise_after = y.back() / y[lowest];
    return Answer{rise_before > 1.02 && rise_after > 1.02, "minimum at " + to_fixed(result.x[lowest], 1) +
                                                               " cm, ends " + to_fixed(rise_before, 2) + " and " +
                                                               to_fixed(rise_after, 2) + " times it"};
  };
  judge(exhibit, result,
        {source, "The peak impact force first decreases, then increases",
         "at both ends more than 2 % above the smallest value", "impact_force"},
        falls_then_rises);
  judge(exhibit, result,
        {source, "The peak base shear first decreases, then increases",
         "total base shear, at both ends more than 2 % above the smallest value", "total_base_shear"},
        falls_then_rises);
}

// The gap on each side.
void show_fig9(Exhibit& exhibit) {
  const SweepResult result = run_sweep(
      exhibit,
      {.name = "fig9",
       .title = "gap",
       .axis = {.name = "gap", .unit = "cm", .values = linearly_spaced(10.0, 50.0, points(exhibit, 81))},
       .x_label = "gap [cm]",
       .build = [](Model& model, const StudyCase& each) { return add_pounding(model, {}, each.value("gap") * cm); },
       .caption = "Peaks over the gap on each side; everything else held."});
  const auto rises_then_falls = [&](const Curve& y) {
    const std::size_t highest = position_of_maximum(y);
    return Answer{y[highest] > 1.02 * y.front() && y[highest] > 1.02 * y.back(),
                  "maximum at " + to_fixed(result.x[highest], 0) + " cm"};
  };
  const std::string source = "4.3.3, conclusion 2", criterion = "largest value inside the range, 2 % above both ends";
  for (const Claim& claim :
       {Claim{"4.3.3", "The peak floor acceleration increases at first with the gap", "top floor: " + criterion,
              "top_acceleration"},
        Claim{source, "Peak drifts increase up to a certain gap, then decrease", criterion, "largest_drift"},
        Claim{source, "The peak impact force does the same", criterion, "impact_force"},
        Claim{source, "The peak base shear does the same", "total base shear: " + criterion, "total_base_shear"}})
    judge(exhibit, result, claim, rises_then_falls);
  show_unpounded_displacement(exhibit);
}

// 1 to 10 storeys. The paper does not specify the bearings under a heavier building. Two readings:
//   kept      the same bearings; the isolation period grows from 1.5 s (one storey) to 3.4 s (ten);
//   designed  T_b = 2.5 s for every building, yield force in proportion to its weight, d_y = 1 cm.
void show_fig10(Exhibit& exhibit) {
  struct Reading {
    const char *name, *bearings, *held;
    bool designed;
  };
  std::vector<double> storeys;
  for (int i = 1; i <= 10; i += exhibit.coarse ? 3 : 1) storeys.push_back(i);
  for (const Reading& reading :
       {Reading{"fig10", "kept", "the bearings are those of the five-storey building", false},
        Reading{"fig10_designed", "designed",
                "bearings designed for each building (T_b = 2.5 s, yield force in proportion to weight)", true}}) {
    const SweepResult result = run_sweep(
        exhibit, {.name = reading.name,
                  .title = std::string{"storeys, bearings "} + reading.bearings,
                  .axis = {.name = "storeys", .unit = "", .values = storeys},
                  .x_label = "number of storeys [1]",
                  .build =
                      [&](Model& model, const StudyCase& each) {
                        PaperBuilding building{.storeys = static_cast<int>(each.value("storeys"))};
                        const double of_five = total_mass(building.storeys) / total_mass(5);
                        const double share = reading.designed ? of_five : 1.0;
                        building.post_yield_stiffness = share * building.post_yield_stiffness;
                        building.yield_force = share * building.yield_force;
                        return add_pounding(model, building);
                      },
                  .caption = std::string{"Peaks over the number of storeys; "} + reading.held + ", gap 10 cm."});
    for (const auto& [response, text] :
         {std::pair{"top_acceleration", "The peak top acceleration increases significantly with"},
          std::pair{"first_storey_drift", "The peak drift of the first storey increases with"},
          std::pair{"impact_force", "The peak impact force increases with"},
          std::pair{"total_base_shear", "The peak base shear increases with"}})
      judge(exhibit, result,
            {"4.3.4, conclusion 3", text + std::string{" the number of storeys (bearings "} + reading.bearings + ")",
             "rank correlation >= 0.8, and ten storeys at least 1.2 times one", response},
            [&](const Curve& y) {
              const double correlation = rank_correlation(result.x, y), growth = y.back() / y.front();
              return Answer{
                  correlation >= 0.8 && growth >= 1.2,
                  to_fixed(correlation, 2) + (y.front() > 0.0 ? ", " + to_fixed(growth, 2) + " times" : ", from none")};
            });
  }
}

void show_fig11(Exhibit& exhibit) {
  const SweepResult result =
      run_sweep(exhibit, {.name = "fig11",
                          .title = "impact stiffness",
                          .axis = {.name = "impact stiffness",
                                   .unit = "GN/m^1.5",
                                   .values = logarithmically_spaced(0.01, 10.0, points(exhibit, 61))},
                          .x_label = "impact stiffness [GN/m^1.5]",
                          .logarithmic = true,
                          .build =
                              [](Model& model, const StudyCase& each) {
                                return add_pounding(model, {}, paper_gap, each.value("impact stiffness") * GN / m_3_2);
                              },
                          .caption = "Peaks over the impact stiffness k_h; e = 0.65, gap 10 cm."});
  const auto rises_then_stays = [&](const Curve& y) {
    Curve upper_end;
    for (std::size_t i = 0; i < y.size(); ++i)
      if (result.x[i] >= 2.0) upper_end.push_back(y[i]);
    const double above_two = spread(upper_end);
    return Answer{
        y.front() < 0.9 * y.back() && above_two <= 1.10,
        to_fixed(y.back() / y.front(), 2) + " times from end to end, spread " + to_fixed(above_two, 2) + " above 2"};
  };
  const std::string criterion =
      "higher at 10 than at 0.01 GN/m^1.5 by more than a tenth, and largest / smallest <= 1.10 from 2 GN/m^1.5 up";
  judge(exhibit, result,
        {"4.3.5, conclusion 3", "Peak drifts increase with impact stiffness, constant above 2 GN/m^1.5", criterion,
         "largest_drift"},
        rises_then_stays);
  judge(exhibit, result,
        {"conclusion 3", "Superstructure acceleration increases up to a maximum, then stays constant",
         "top floor: " + criterion, "top_acceleration"},
        rises_then_stays);
  judge_motions(exhibit, result,
                {"4.3.5", "The acceleration of the isolation layer grows more than the superstructure's",
                 "growth from 0.01 to 10 GN/m^1.5: base more than top", ""},
                [&](std::size_t motion) {
                  const Curve base = result.curve("base_acceleration", motion);
                  const Curve top = result.curve("top_acceleration", motion);
                  const double of_base = base.back() / base.front(), of_top = top.back() / top.front();
                  return Answer{of_base > of_top, to_fixed(of_base, 1) + " against " + to_fixed(of_top, 1) + " times"};
                });
  judge(exhibit, result,
        {"4.3.5, conclusion 3", "The peak impact force increases with impact stiffness", "rank correlation >= 0.8",
         "impact_force"},
        follows(result.x, 1.0));
  judge(exhibit, result,
        {"4.3.5, conclusion 3", "The peak base shear increases with impact stiffness",
         "total base shear: rank correlation >= 0.8", "total_base_shear"},
        follows(result.x, 1.0));
}

void show_pulse(Exhibit& exhibit) {
  exhibit.text(
      "The near-fault records cannot be handed on with moat. This is the same building under a synthetic velocity "
      "pulse (Mavroeidis & Papageorgiou 2003) of period 1.3 s, scaled to 0.4 g; the paper has nothing to compare it "
      "with.");
  run_sweep(
      exhibit,
      {.name = "pulse",
       .title = "gap under a pulse",
       .axis = {.name = "gap", .unit = "cm", .values = linearly_spaced(5.0, 50.0, points(exhibit, 46))},
       .x_label = "gap [cm]",
       .build = [](Model& model, const StudyCase& each) { return add_pounding(model, {}, each.value("gap") * cm); },
       .caption = "Peaks over the gap under the synthetic pulse; everything else as in the plain reading."},
      {near_fault_pulse().scaled_to_pga(paper_pga)}, {"synthetic pulse"});
}

}  // namespace moat::paper
