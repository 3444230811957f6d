#include "design/en_1998_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "message_of.hpp"
#include "sheet_building.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double mega = 1e6;

/// Type 1, ground C, a_g = 0.30 g; 3.2.2.2.
Acceleration type_1_c(Time period, double damping) {
  constexpr double a_g = 0.30, soil = 1.15, t_b = 0.2, t_c = 0.6, t_d = 2.0;
  const double t = period.si(), eta = std::max(0.55, std::sqrt(10.0 / (5.0 + 100.0 * damping)));
  const double plateau = 2.5 * eta * a_g * soil;
  if (t < t_b) return a_g * soil * (1.0 + t / t_b * (2.5 * eta - 1.0)) * g;
  if (t < t_c) return plateau * g;
  return (t < t_d ? plateau * t_c / t : plateau * t_c * t_d / (t * t)) * g;
}

En1998Sheet sheet_of(SheetBuilding building = sheet_building()) {
  return {.building = std::move(building), .spectrum = En1998Spectrum{.ground_acceleration = 0.30 * g, .ground = 'C'}};
}

DesignSheet made(const En1998Sheet& sheet) { return sheet; }

// The formulas of the clauses, worked in double precision by a program that shares no code with moat: the displacement
// as the root of its own equation, for the building of sheet_building() and the spectrum of sheet_of().
TEST(En1998Sheet, HasTheNumbersOfAnIndependentProgram) {
  const DesignSheet sheet = sheet_of();
  const auto line = [&](const char* symbol) { return sheet.line(symbol); };
  expect_printed(line("d_dc"), {".14167482", ".14140474", ".12409699"});
  expect_printed(line("K_eff"), {"22.876413", "26.148345", "39.201782"}, mega);
  expect_printed(line("xi_eff"), {"27.931935", "28.799935", "32.485517"}, 0.01);
  expect_printed(line("eta"), {".55105047", ".55", ".55"});
  expect_printed(line("T_eff"), {"2.2976623", "2.1491071", "1.7552026"});
  expect_printed(line("S_e"), {".10803372", ".12325", ".16216077"});
  expect_printed(line("V"), {"3.2410117", "3.6975", "4.8648230"}, mega);
  expect_printed(line("r").value() * line("r").value(), "194.66667", "r^2");
  expect_printed(line("delta").value(), "1.1643836", "delta");
  expect_printed(line("d_bd"), {".16496383", ".16464936", ".14449649"});
  expect_printed(line("d_max"), {".19795660", ".19757923", ".17339579"});
  expect_printed(line("restoring"), {".02851686", ".031625", ".03608038"});
  expect_printed(line("E_s/E_h"), {".55915415", ".52708333", ".40089315"});
  EXPECT_EQ(line("xi_most").verdict, "xi_most 0.3249 (upper bounds) > 0.3: no equivalent linear model");
  EXPECT_EQ(line("T_least").verdict, "T_least 1.755 s (upper bounds) < 1.8 s: no simplified analysis");
}

TEST(En1998Sheet, SolvesTheDisplacementToTheLastDigits) {
  const DesignSheet sheet = sheet_of();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto of = [&](const char* symbol) { return sheet.line(symbol).value(static_cast<Bound>(i)); };
    const double d = of("d_dc");
    EXPECT_NEAR(of("K_eff") / (of("k_2") + of("Q") / d), 1.0, 1e-14);
    EXPECT_NEAR(of("xi_eff") / (2.0 * of("Q") * (d - 0.01) / (std::numbers::pi * of("K_eff") * d * d)), 1.0, 1e-12);
    EXPECT_NEAR(of("S_e") / (type_1_c(of("T_eff") * s, of("xi_eff")) / g), 1.0, 1e-12);
    EXPECT_NEAR(d / (30e6 * of("S_e") / of("K_eff")), 1.0, 1e-12);
    // m_j S_e of 5 MN, and both directions with 30 %.
    for (int floor = 1; floor <= 5; ++floor)
      EXPECT_NEAR(of(("f floor " + std::to_string(floor)).c_str()) / (5e6 * of("S_e")), 1.0, 1e-14);
    EXPECT_NEAR(of("d_xy") / (of("d_max") * std::sqrt(1.09)), 1.0, 1e-14);
    // Secant at a fifth of d_dc, beyond yield.
    EXPECT_NEAR(of("K_ratio") / (of("K_eff") / (of("k_2") + of("Q") / (0.2 * d))), 1.0, 1e-14);
  }
}

TEST(En1998Sheet, HasAForceForEveryFloorOfATower) {
  SheetBuilding building = sheet_building();
  building.floors.clear();
  for (int floor = 1; floor <= 60; ++floor) building.floors.push_back({floor * 10 * kN, floor * 3 * m});
  const DesignSheet sheet = sheet_of(building);
  for (int floor = 1; floor <= 60; ++floor)
    for (const Bound bound : {Bound::lower, Bound::nominal, Bound::upper})
      EXPECT_NEAR(
          sheet.line("f floor " + std::to_string(floor)).value(bound) / (floor * 1e4 * sheet.line("S_e").value(bound)),
          1.0, 1e-14);
}

TEST(En1998Sheet, JudgesItsRules) {
  const DesignSheet sheet = sheet_of();
  for (const char* kept : {"restoring", "T_most", "plan", "e_tot/d", "E_s/E_h"}) EXPECT_TRUE(*sheet.line(kept).is_kept);
  EXPECT_EQ(sheet.line("K_ratio").verdict, "K_ratio 0.3106 (upper bounds) < 0.5: no equivalent linear model");
  SheetBuilding building = sheet_building();
  building.longer_side = 60 * m;
  building.eccentricity = 2 * m;
  const DesignSheet wide = sheet_of(building);
  EXPECT_EQ(wide.line("plan").verdict, "plan 60 m > 50 m: no simplified analysis");
  EXPECT_EQ(wide.line("e_tot/d").verdict, "e_tot/d 0.08333 > 0.075: no simplified analysis");
  building = sheet_building();
  building.isolation = IsolationLoop{3 * MN, 5 * MN / m, 10 * mm};
  building.fixed_base_period = 0.3 * s;
  const DesignSheet stuck = sheet_of(building);
  EXPECT_NE(stuck.line("E_s/E_h").verdict.find(" < 0.25: no re-centring"), std::string::npos);
  EXPECT_NE(stuck.line("restoring").verdict.find(" < 0.025: no equivalent linear model"), std::string::npos);
  EXPECT_TRUE(*stuck.line("T_least").is_kept);
}

TEST(En1998Sheet, SaysFirstWhetherTheGapIsWideEnough) {
  En1998Sheet sheet = sheet_of();
  EXPECT_EQ(made(sheet).rules().front()->verdict, "clearance 0.45 m >= d_max 0.198 m (lower bounds)");
  sheet.magnification = 2.0;
  sheet.slow_displacement = 15 * cm;
  // 2 x 0.16496383 + 0.15.
  EXPECT_EQ(made(sheet).rules().front()->verdict, "clearance 0.45 m < d_max 0.4799 m (lower bounds)");
  EXPECT_EQ(made(sheet).line("d_max").numbers, "2 x 0.165 + 0.15");
}

TEST(En1998Sheet, TakesTheGapFromHistories) {
  SheetBuilding building = sheet_building();
  building.suite = {.statistic = "mean of 7 records",
                    .lower = {.corner_displacement = 0.2 * m},
                    .upper = {.corner_displacement = 0.1 * m}};
  En1998Sheet input = sheet_of(building);
  input.slow_displacement = 1 * cm;
  const DesignSheet sheet = input;
  // 1.2 x 0.2 + 0.01; the nominal case was not computed.
  EXPECT_NEAR(sheet.line("gap").value(), 0.25, 1e-15);
  EXPECT_EQ(sheet.line("gap").value(Bound::nominal), 0.0);
  EXPECT_EQ(sheet.line("gap").verdict, "clearance 0.45 m >= gamma_x d_bd,dyn + d_slow 0.25 m (lower bounds)");
  EXPECT_EQ(sheet.line("d_bd,dyn").numbers, "mean of 7 records");
}

// Histories of nominal properties alone do not replace the displacements by bounds.
TEST(En1998Sheet, TakesTheFormulaForBoundsWithoutHistories) {
  SheetBuilding building = sheet_building();
  building.clearance = 0.19 * m;
  building.suite = {.statistic = "mean of 7 records", .nominal = {.corner_displacement = 0.1 * m}};
  const SheetLine gap = made(sheet_of(building)).line("gap");
  EXPECT_NEAR(gap.value(Bound::nominal), 0.12, 1e-15);
  expect_printed(gap.value(Bound::lower), ".19795660", "d_max");
  expect_printed(gap.value(Bound::upper), ".17339579", "d_max");
  EXPECT_EQ(gap.verdict, "clearance 0.19 m < d_max 0.198 m (lower bounds)");
  EXPECT_FALSE(*gap.is_kept);
  // And of upper bounds alone.
  building.suite = {.statistic = "largest of 3 records", .upper = {.corner_displacement = 0.2 * m, .touching = 1}};
  building.clearance = 0.45 * m;
  const DesignSheet upper = sheet_of(building);
  expect_printed(upper.line("gap").value(Bound::lower), ".19795660", "d_max");
  EXPECT_EQ(upper.line("gap").verdict,
            "clearance 0.45 m >= gamma_x d_bd,dyn + d_slow 0.24 m (upper bounds), not judged: 1 record touches; repeat "
            "the histories with a gap that stays open");
  EXPECT_EQ(upper.line("d_bd,dyn").numbers, "largest of 3 records; 1 record touches");
}

TEST(En1998Sheet, MarksClausesFromMemory) {
  const DesignSheet sheet = sheet_of();
  EXPECT_EQ(sheet.line("S_e").source, ClauseSource::followed);
  EXPECT_EQ(sheet.line("d_bd").source, ClauseSource::followed);
  for (const char* symbol : {"d_dc", "V", "d_max", "d_xy", "gap", "xi_most", "K_ratio", "T_least", "E_s/E_h"})
    EXPECT_EQ(sheet.line(symbol).source, ClauseSource::recalled) << symbol;
}

TEST(En1998Sheet, RefusesBadInput) {
  const auto refused = [](const std::function<void(En1998Sheet&)>& change) {
    En1998Sheet sheet = sheet_of();
    change(sheet);
    return message_of([&] { static_cast<void>(made(sheet)); });
  };
  EXPECT_NE(refused([](En1998Sheet& each) { each.magnification = 0.9; }).find("magnification = 0.9 "),
            std::string::npos);
  EXPECT_NE(refused([](En1998Sheet& each) { each.slow_displacement = -1 * cm; }).find("slow_displacement = -0.01 m"),
            std::string::npos);
  EXPECT_NE(refused([](En1998Sheet& each) { each.magnification = 3.0; }).find("magnification = 3 "), std::string::npos);
  const auto refused_isolation = [](IsolationLoop loop) {
    SheetBuilding building = sheet_building();
    building.isolation = loop;
    return message_of([&] { static_cast<void>(made(sheet_of(building))); });
  };
  EXPECT_NE(refused_isolation({30 * MN, 13 * MN / m, 50 * cm}).find("d_dc (lower bounds) does not exceed the yield"),
            std::string::npos);
  // The period of the isolators alone is 11 s, beyond the spectrum, whose remedy is given.
  EXPECT_NE(refused_isolation({30 * kN, 1 * MN / m, 1 * cm}).find("4 s"), std::string::npos);
}

}  // namespace
}  // namespace moat::testing
