#include "design/asce_7_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "message_of.hpp"
#include "sheet_building.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double mega = 1e6;

Asce7Sheet sheet_of(SheetBuilding building = sheet_building()) {
  return {.building = std::move(building),
          .spectrum = Asce7Spectrum{.s_ds = 1.0, .s_d1 = 0.6, .long_period = 8 * s},
          .s_1 = 0.6,
          .response_modification = 5};
}

DesignSheet made(const Asce7Sheet& sheet) { return sheet; }

// The formulas of the clauses, worked in double precision by a program that shares no code with moat: the displacement
// as the root of its own equation, for the building of sheet_building() and the spectrum of sheet_of().
TEST(Asce7Sheet, HasTheNumbersOfAnIndependentProgram) {
  const DesignSheet sheet = sheet_of();
  const auto line = [&](const char* symbol) { return sheet.line(symbol); };
  expect_printed(line("P_T").value(), "1.2808003", "P_T");
  expect_printed(line("D_TM").value() / line("D_M").value(), "1.1643836", "amplification");
  expect_printed(line("D_M"), {".49100724", ".43914841", ".32225997"});
  expect_printed(line("k_M"), {"15.193078", "17.517770", "25.822935"}, mega);
  expect_printed(line("beta_M"), {".12790915", ".14556558", ".20014368"});
  expect_printed(line("B_M"), {"1.2837274", "1.3366967", "1.5002874"});
  expect_printed(line("T_M"), {"2.8194037", "2.6256737", "2.1626058"});
  expect_printed(line("D_TM"), {".57172075", ".51133718", ".37523421"});
  expect_printed(line("D_min"), {".44735867", ".39879020", ".28926086"});
  expect_printed(line("V_b"), {"7.4599115", "7.6929006", "8.3216980"}, mega);
  expect_printed(line("V_min"), {"6.7139203", "6.9236106", "7.4895282"}, mega);
  expect_printed(line("V_st"), {"6.5898031", "6.8505278", "7.5971338"}, mega);
  expect_printed(line("V_s"), {"3.5145617", "3.6536149", "4.0518047"}, mega);
  expect_printed(line("F_1"), {".46405777", ".44926548", ".38643429"}, mega);
  expect_printed(line("k"), {"1.0744368", "1.2227509", "1.6812069"});
  expect_printed(line("restoring"), {".09883186", ".09821501", ".09369497"});
  const std::array<std::array<const char*, 3>, 5> shares{{{".060854", ".050585", ".027934"},
                                                          {".128153", ".118061", ".089584"},
                                                          {".198119", ".193830", ".177123"},
                                                          {".269877", ".275543", ".287291"},
                                                          {".342996", ".361982", ".418069"}}};
  for (std::size_t floor = 0; floor < shares.size(); ++floor)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto bound = static_cast<Bound>(i);
      const SheetLine& force = sheet.line("F floor " + std::to_string(floor + 1));
      expect_printed(force.value(bound) / line("V_s").value(bound), shares[floor][i], force.symbol);
    }
  EXPECT_NEAR(line("R_I").value(), 1.875, 1e-15);
  EXPECT_NEAR(line("C_s").value(), 0.06, 1e-15);
  EXPECT_NEAR(line("V_s1").value(), 1.5 * mega, 1e-6);
  expect_printed(line("F_y").value(Bound::upper) / mega, "2.87444606", "F_y");
  expect_printed(line("F_s").value() / mega, "2.90128391", "F_s");
  expect_printed(line("V_s3").value() / mega, "2.64867120", "V_s3");
  const SheetLine drawn = line("static");
  EXPECT_TRUE(*drawn.is_kept) << drawn.verdict;
  // The range of scaling.
  expect_printed(0.75 * line("T_M").value(Bound::upper), "1.6219543", "shortest period");
  expect_printed(1.25 * line("T_M").value(Bound::lower), "3.5242546", "longest period");
  Asce7Sheet slider = sheet_of();
  slider.abrupt_transition = true;
  expect_printed(made(slider).line("V_st"), {"6.7452872", "7.0347732", "7.8794771"}, mega);
}

TEST(Asce7Sheet, SolvesTheDisplacementToTheLastDigits) {
  const DesignSheet sheet = sheet_of();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto of = [&](const char* symbol) { return sheet.line(symbol).value(static_cast<Bound>(i)); };
    const double d = of("D_M"), q = of("Q"), k_2 = of("k_2"), pi = std::numbers::pi;
    EXPECT_NEAR(of("k_M") / (k_2 + q / d), 1.0, 1e-14);
    EXPECT_NEAR(of("beta_M") / (2.0 * q * (d - 0.01) / (pi * of("k_M") * d * d)), 1.0, 1e-12);
    EXPECT_NEAR(of("T_M") / (2.0 * pi * std::sqrt(30e6 / (of("k_M") * 9.80665))), 1.0, 1e-14);
    EXPECT_NEAR(d / (9.80665 * 0.9 * of("T_M") / (4.0 * pi * pi * of("B_M"))), 1.0, 1e-12);
  }
}

TEST(Asce7Sheet, PutsNumbersIntoItsFormulas) {
  const DesignSheet sheet = sheet_of();
  EXPECT_EQ(sheet.line("D_M").numbers, "9.807 x 0.9 x 2.819/(4 pi^2 x 1.284)");
  EXPECT_EQ(sheet.line("T_M").numbers, "2 pi sqrt(30000/(15193 x 9.807))");
  EXPECT_EQ(sheet.line("beta_M").numbers, "2 x 1530 x (0.491 - 0.01)/(pi x 15193 x 0.491^2)");
  EXPECT_EQ(sheet.line("D_TM").numbers, "0.491 x (1 + 16/1.281^2 x 12 x 2/(20^2 + 32^2)) >= 1.15 x 0.491");
  EXPECT_EQ(sheet.line("V_st").numbers, "8322 x (25000/30000)^(1 - 2.5 x 0.2001)");
  EXPECT_EQ(sheet.line("C_s").numbers, "0.6/(2.163 x 5/1) <= 1/(5/1); >= 0.044 x 1 x 1, 0.01, 0.5 x 0.6/(5/1)");
  EXPECT_EQ(sheet.line("F floor 5").numbers, "4052 x 0.4181");
  EXPECT_EQ(sheet.line("lambda_Q").numbers, "") << "a formula of words";
}

TEST(Asce7Sheet, NamesTheBoundThatGoverns) {
  const DesignSheet sheet = sheet_of();
  for (const char* far : {"D_M", "D_TM", "D_min", "gap", "F_1"}) EXPECT_EQ(sheet.line(far).of, Bound::lower) << far;
  for (const char* strong : {"V_b", "V_st", "V_s", "restoring"})
    EXPECT_EQ(sheet.line(strong).of, Bound::upper) << strong;
  for (const char* step : {"k_M", "beta_M", "T_M", "B_M"}) EXPECT_FALSE(sheet.line(step).governs) << step;
}

TEST(Asce7Sheet, MarksClausesFromMemory) {
  const DesignSheet sheet = sheet_of();
  for (const char* symbol : {"lambda_Q", "C_s", "V_s1", "V_s3", "V_s", "restoring", "static", "D_min", "V_min", "gap"})
    EXPECT_EQ(sheet.line(symbol).source, ClauseSource::recalled) << symbol;
  for (const char* symbol :
       {"k_M", "beta_M", "T_M", "B_M", "D_M", "P_T", "D_TM", "V_b", "V_st", "R_I", "F_1", "F floor 1"})
    EXPECT_EQ(sheet.line(symbol).source, ClauseSource::followed) << symbol;
}

TEST(Asce7Sheet, SaysFirstWhetherTheGapIsWideEnough) {
  SheetBuilding building = sheet_building();
  const auto first = [&] { return made(sheet_of(building)).rules().front()->verdict; };
  EXPECT_EQ(first(), "clearance 0.45 m < D_TM 0.5717 m (lower bounds)");
  building.clearance = 0.6 * m;
  EXPECT_EQ(first(), "clearance 0.6 m >= D_TM 0.5717 m (lower bounds)");
  building.clearance.reset();
  EXPECT_EQ(first(), "gap needed: D_TM 0.5717 m (lower bounds)");
}

TEST(Asce7Sheet, TakesTheMultiPeriodSpectrum) {
  Asce7Sheet sheet = sheet_of();
  const DesignSheet two_periods = sheet;
  // The same below T_L = 2.4 s, less above.
  sheet.mce_spectrum =
      TargetSpectrum{.name = "site", .source = "a study", .shortest = 0.1 * s, .longest = 5 * s, .value = [](double t) {
                       return 9.80665 * 0.9 / t * std::min(1.0, 2.4 / t);
                     }};
  const DesignSheet multi = sheet;
  EXPECT_DOUBLE_EQ(multi.line("D_M").value(Bound::upper), two_periods.line("D_M").value(Bound::upper));
  const auto of = [&](const char* symbol) { return multi.line(symbol).value(Bound::lower); };
  EXPECT_GT(of("T_M"), 2.4);
  EXPECT_NEAR(of("S_aM"), 0.9 * 2.4 / (of("T_M") * of("T_M")), 1e-14);
  EXPECT_NEAR(of("D_M") / (9.80665 * of("S_aM") * std::pow(of("T_M") / (2.0 * std::numbers::pi), 2) / of("B_M")), 1.0,
              1e-12);
  EXPECT_EQ(multi.notes.front(), "Spectrum: site; a study.");
  EXPECT_LT(of("D_M"), two_periods.line("D_M").value(Bound::lower));
}

// With k_2 of the loop small beside Q, the damping runs through the whole table.
TEST(Asce7Sheet, HoldsTheDampingCoefficientBeyondTheTable) {
  SheetBuilding building = sheet_building();
  building.bounds = {};
  const auto at = [&](double strength_ratio, double stiffness) {
    building.isolation = IsolationLoop{strength_ratio * 30 * MN, stiffness * MN / m, 1 * mm};
    return made(sheet_of(building));
  };
  const DesignSheet strong = at(0.15, 2.0), weak = at(0.001, 20.0);
  EXPECT_GT(strong.line("beta_M").value(), 0.5);
  EXPECT_DOUBLE_EQ(strong.line("B_M").value(), 2.0);
  EXPECT_TRUE(std::ranges::any_of(strong.notes, [](const std::string& note) {
    return note.find("is beyond table 17.5-1, which ends at 0.5: B_M is held at 2.0.") != std::string::npos;
  }));
  EXPECT_FALSE(*strong.line("static").is_kept);
  EXPECT_LT(weak.line("beta_M").value(), 0.02);
  EXPECT_DOUBLE_EQ(weak.line("B_M").value(), 0.8);
}

TEST(Asce7Sheet, NeverTakesLessThanFifteenPerCentForTurning) {
  SheetBuilding building = sheet_building();
  building.eccentricity = 0 * m;
  const DesignSheet small = sheet_of(building);
  // 1 + 16 x 1.6/194.667 = 1.1315.
  EXPECT_DOUBLE_EQ(small.line("D_TM").value(), 1.15 * small.line("D_M").value());
  // All isolators in the middle: P_T = 1 at least. 1 + 20 x 3.6/(1424/12).
  building.bearings = {{1 * m, 1 * m}};
  building.eccentricity = 2 * m;
  building.corner_distance = 20 * m;
  const DesignSheet narrow = sheet_of(building);
  EXPECT_DOUBLE_EQ(narrow.line("P_T").value(), 1.0);
  EXPECT_NEAR(narrow.line("D_TM").value() / narrow.line("D_M").value(), 1.0 + 20.0 * 3.6 * 12.0 / 1424.0, 1e-14);
}

TEST(Asce7Sheet, KeepsTheLeastShear) {
  Asce7Sheet sheet = sheet_of();
  sheet.response_modification = 2;
  EXPECT_DOUBLE_EQ(made(sheet).line("R_I").value(), 1.0);
  sheet.response_modification = 8;
  const DesignSheet ductile = sheet;
  EXPECT_DOUBLE_EQ(ductile.line("R_I").value(), 2.0);
  EXPECT_DOUBLE_EQ(ductile.line("C_s").value(), 0.044) << "0.044 S_DS I_e is above 0.5 S_1/R = 0.0375";
  sheet.importance = 1.5;
  EXPECT_NEAR(made(sheet).line("C_s").value(), 0.066, 1e-15);
  sheet = sheet_of();
  sheet.s_1 = 0.59;
  const double t = made(sheet).line("T_M").value(Bound::upper);
  EXPECT_NEAR(made(sheet).line("C_s").value(), 0.6 / (5.0 * t), 1e-15);
  sheet.spectrum = Asce7Spectrum{.s_ds = 0.6, .s_d1 = 0.6, .long_period = 1.5 * s};
  EXPECT_NEAR(made(sheet).line("C_s").value(), 0.6 * 1.5 / (5.0 * t * t), 1e-15);
  EXPECT_EQ(made(sheet).line("C_s").formula, "S_D1 T_L/(T_M^2 R/I_e) <= S_DS/(R/I_e); >= 0.044 S_DS I_e, 0.01");
  // The displacement is that of another spectrum.
  sheet.mce_spectrum = TargetSpectrum{
      .name = "site", .source = "", .longest = 9 * s, .value = [](double period) { return 9.80665 * 0.9 / period; }};
  sheet.spectrum = Asce7Spectrum{.s_ds = 0.01, .s_d1 = 0.01, .long_period = 8 * s};
  EXPECT_DOUBLE_EQ(made(sheet).line("C_s").value(), 0.01);
  // Wind above all.
  sheet = sheet_of();
  sheet.wind = 5 * MN;
  for (const Bound bound : {Bound::lower, Bound::nominal, Bound::upper})
    EXPECT_DOUBLE_EQ(made(sheet).line("V_s").value(bound), 5e6);
  EXPECT_DOUBLE_EQ(made(sheet).line("V_s2").value(), 5e6);
  // The yield force of strong isolators is not reduced by R_I.
  SheetBuilding strong = sheet_building();
  strong.bounds.upper.strength = 3.0;
  const DesignSheet yields = sheet_of(strong);
  const double beta = yields.line("beta_M").value(Bound::upper);
  EXPECT_NEAR(yields.line("V_s3").value() / ((3.0 * 1.8e6 + 1.3 * 0.01 * yields.line("k_2").value(Bound::nominal)) *
                                             std::pow(25.0 / 30.0, 1.0 - 2.5 * beta)),
              1.0, 1e-12);
  EXPECT_DOUBLE_EQ(yields.line("V_s").value(Bound::upper), yields.line("V_s3").value());
}

TEST(Asce7Sheet, SaysWhyTheStaticProcedureIsAMinimumOnly) {
  SheetBuilding building = sheet_building();
  building.fixed_base_period = 0.8 * s;
  EXPECT_EQ(made(sheet_of(building)).line("static").verdict,
            "static procedure as minimum only: T_M 2.163 s <= 3 T_fb 2.4 s");
  building = sheet_building();
  building.bounds = {};
  building.isolation = IsolationLoop{0.3 * MN, 0.5 * MN / m, 10 * mm};
  const DesignSheet soft = sheet_of(building);
  const double t = soft.line("T_M").value(), restoring = soft.line("restoring").value();
  EXPECT_GT(t, 5.0);
  EXPECT_LT(restoring, 0.025) << "0.5 k_2 D/W";
  EXPECT_NE(soft.line("static").verdict.find(" > 5 s, restoring force"), std::string::npos)
      << soft.line("static").verdict;
  EXPECT_FALSE(*soft.line("restoring").is_kept);
  EXPECT_NE(soft.line("restoring").verdict.find("(lower bounds) < 0.025"), std::string::npos)
      << soft.line("restoring").verdict;
}

TEST(Asce7Sheet, ComparesHistoriesWithTheirMinima) {
  SheetBuilding building = sheet_building();
  building.clearance = 0.5 * m;
  building.suite = {.statistic = "mean of 7 records",
                    .lower = {0.42 * m, 0.48 * m, 7.5 * MN, 7 * MN, 0.012},
                    .upper = {0.25 * m, 0.30 * m, 8.2 * MN, 7.4 * MN, 0.021}};
  Asce7Sheet input = sheet_of(building);
  const DesignSheet sheet = input;
  // 0.30 against 0.28926, 0.48 against 0.44736.
  EXPECT_EQ(sheet.line("D_TM,dyn").verdict, "D_TM,dyn 0.3 m (upper bounds) >= 0.2893 m");
  EXPECT_EQ(sheet.line("D_TM,dyn").numbers, "mean of 7 records");
  EXPECT_EQ(sheet.line("V_b,dyn").verdict, "V_b,dyn 8200 kN (upper bounds) >= 7490 kN");
  // 8.2/8.3216980 is below 7.5/7.4599115.
  EXPECT_EQ(sheet.line("V_above").verdict, "V_above 8200 kN (upper bounds) < 8322 kN: multiply the results by 1.015");
  // 7 MN/1.875 against 2.6486712 MN.
  EXPECT_EQ(sheet.line("V_s,dyn").verdict, "V_s,dyn 3733 kN (lower bounds) >= 2649 kN");
  EXPECT_EQ(sheet.line("drift").verdict, "drift 0.021 (upper bounds) > 0.02: too much");
  EXPECT_EQ(sheet.line("D_M,dyn").value(), 0.42);
  EXPECT_EQ(sheet.line("gap").verdict, "clearance 0.5 m >= D_TM,dyn 0.48 m (lower bounds)");
  std::vector<std::string> order;
  for (const SheetLine* rule : sheet.rules()) order.push_back(rule->symbol);
  EXPECT_EQ(order, (std::vector<std::string>{"gap", "V_above", "drift", "restoring", "static", "D_TM,dyn", "V_b,dyn",
                                             "V_s,dyn"}));
  input.regular = true;
  EXPECT_TRUE(*made(input).line("V_above").is_kept) << "0.8 V_b";
  // Histories below their minimum: it is the gap.
  building.suite->lower.corner_displacement = 0.40 * m;
  const DesignSheet low = sheet_of(building);
  EXPECT_EQ(low.line("gap").verdict, "clearance 0.5 m >= D_TM,dyn 0.4474 m (lower bounds)");
  EXPECT_EQ(low.line("D_TM,dyn").verdict, "D_TM,dyn 0.4 m (lower bounds) < 0.4474 m: multiply the results by 1.118");
  // Histories of nominal properties alone do not replace the displacement by lower bounds.
  building.suite = {.statistic = "mean of 7 records", .nominal = {0.42 * m, 0.48 * m, 7.5 * MN, 7 * MN, 0.012}};
  EXPECT_EQ(made(sheet_of(building)).line("gap").verdict, "clearance 0.5 m < D_TM 0.5717 m (lower bounds)");
  // A suite without results changes nothing.
  building.suite = SuiteForSheet{};
  EXPECT_EQ(made(sheet_of(building)).lines.size(), made(sheet_of()).lines.size());
}

// Walls limit displacements, and impacts add to forces.
TEST(Asce7Sheet, DoesNotJudgeAsKeptWhatImpactsMayHide) {
  SheetBuilding building = sheet_building();
  building.clearance = 0.5 * m;
  building.suite = {.statistic = "mean of 7 records",
                    .lower = {0.42 * m, 0.48 * m, 8.6 * MN, 7 * MN, 0.012, 2},
                    .upper = {0.25 * m, 0.30 * m, 8.6 * MN, 7.4 * MN, 0.012}};
  const DesignSheet alone = sheet_of(building);
  EXPECT_EQ(alone.line("V_b,dyn").formula, "histories, isolators alone, both directions, >= V_min");
  EXPECT_TRUE(*alone.line("V_b,dyn").is_kept);
  EXPECT_TRUE(*alone.line("V_above").is_kept);
  EXPECT_TRUE(*alone.line("D_TM,dyn").is_kept) << "walls make it smaller";
  EXPECT_EQ(alone.line("D_TM,dyn").numbers, "mean of 7 records; 2 records touch");
  EXPECT_FALSE(alone.line("V_s,dyn").is_kept.has_value());
  EXPECT_EQ(alone.line("V_s,dyn").verdict,
            "V_s,dyn 3733 kN (lower bounds) >= 2649 kN, not judged: 2 records touch, and the forces of impacts are in "
            "it");
  EXPECT_FALSE(alone.line("gap").is_kept.has_value());
  EXPECT_EQ(alone.line("gap").verdict,
            "clearance 0.5 m >= D_TM,dyn 0.48 m (lower bounds), not judged: 2 records touch; repeat the histories with "
            "a gap that stays open");
  building.suite->base_shear_has_impacts = true;
  const DesignSheet together = sheet_of(building);
  EXPECT_EQ(together.line("V_b,dyn").formula, "histories, base shear, both directions, >= V_min");
  EXPECT_EQ(together.line("V_b,dyn").verdict,
            "V_b,dyn 8600 kN (upper bounds) >= 7490 kN, not judged: 2 records touch, and the forces of impacts are in "
            "it");
  EXPECT_FALSE(together.line("V_above").is_kept.has_value());
  // Behind those that are not kept.
  EXPECT_EQ(together.rules()[1]->symbol, "V_b,dyn");
  // Without impacts it would be still less.
  building.suite->lower.base_shear = 6 * MN;
  EXPECT_FALSE(*made(sheet_of(building)).line("V_b,dyn").is_kept);
  EXPECT_EQ(made(sheet_of(building)).line("V_b,dyn").numbers, "mean of 7 records; 2 records touch");
  building.suite->lower.touching = 0;
  building.suite->upper.touching = 1;
  building.suite->lower.base_shear = 8.6 * MN;
  EXPECT_NE(made(sheet_of(building)).line("V_b,dyn").verdict.find("not judged: 1 record touches"), std::string::npos);
  building.suite->upper.touching = 0;
  EXPECT_TRUE(*made(sheet_of(building)).line("V_b,dyn").is_kept);
}

// Beyond beta_M = 1/2.5 (sliders: 1/3.5) the formula would exceed V_b, and F_1 would be negative.
TEST(Asce7Sheet, HoldsTheExponentOfTheShearAboveTheBaseAtZero) {
  SheetBuilding building = sheet_building();
  building.bounds = {};
  const auto at = [&](double strength_ratio, bool abrupt) {
    building.isolation = IsolationLoop{strength_ratio * 30 * MN, 6 * MN / m, 1 * mm};
    Asce7Sheet sheet = sheet_of(building);
    sheet.abrupt_transition = abrupt;
    return made(sheet);
  };
  const auto has_note = [](const DesignSheet& sheet, const std::string& words) {
    return std::ranges::any_of(sheet.notes,
                               [&](const std::string& note) { return note.find(words) != std::string::npos; });
  };
  const DesignSheet held = at(0.12, false);
  EXPECT_GT(held.line("beta_M").value(), 0.4);
  EXPECT_DOUBLE_EQ(held.line("V_st").value(), held.line("V_b").value());
  EXPECT_DOUBLE_EQ(held.line("F_1").value(), 0.0);
  EXPECT_DOUBLE_EQ(held.line("V_s3").value(), held.line("F_s").value());
  EXPECT_TRUE(has_note(held, "makes the exponent 1 - 2.5 beta_M negative: it is held at 0, V_st at V_b."));
  const DesignSheet slider = at(0.08, true), smooth = at(0.08, false);
  const double beta = slider.line("beta_M").value();
  EXPECT_GT(beta, 1.0 / 3.5);
  EXPECT_LT(beta, 0.4);
  EXPECT_DOUBLE_EQ(slider.line("V_st").value(), slider.line("V_b").value());
  EXPECT_TRUE(has_note(slider, "1 - 3.5 beta_M"));
  EXPECT_FALSE(has_note(smooth, "exponent"));
  EXPECT_NEAR(smooth.line("V_st").value() / smooth.line("V_b").value(), std::pow(25.0 / 30.0, 1.0 - 2.5 * beta), 1e-12);
}

TEST(Asce7Sheet, NotesHowTheRecordsWereScaled) {
  SheetBuilding building = sheet_building();
  building.suite = {.statistic = "mean of 7 records",
                    .lower = {0.42 * m, 0.48 * m, 7.5 * MN, 7 * MN, 0.012},
                    .scaling = {"Scaling by ASCE 7-16", "Mean SRSS of 7 records >= 0.9 target from 1 to 3 s"}};
  EXPECT_EQ(made(sheet_of(building)).notes.back(),
            "Scaling by ASCE 7-16. Mean SRSS of 7 records >= 0.9 target from 1 to 3 s.");
}

TEST(Asce7Sheet, RefusesBadInput) {
  const auto refused = [](auto change) {
    Asce7Sheet sheet = sheet_of();
    change(sheet);
    return message_of([&] { static_cast<void>(made(sheet)); });
  };
  EXPECT_EQ(refused([](Asce7Sheet& each) { each.s_1 = 60.0; }),
            "Asce7Sheet \"Hospital\": s_1 = 60 g is not allowed; it must be > 0 g and <= 5 g. It is a fraction of g: "
            "60 % of g is 0.6.");
  const auto spectrum = [](double s_ds, Time long_period) {
    return
        [=](Asce7Sheet& each) { each.spectrum = Asce7Spectrum{.s_ds = s_ds, .s_d1 = 0.6, .long_period = long_period}; };
  };
  EXPECT_NE(refused(spectrum(-1.0, 8 * s)).find("Asce7Spectrum: s_ds = -1 "), std::string::npos);
  EXPECT_NE(refused(spectrum(1.0, 0.4 * s)).find("Asce7Spectrum: long_period = 0.4 s"), std::string::npos);
  for (const auto& [field, message] : std::vector<std::pair<std::function<void(Asce7Sheet&)>, std::string>>{
           {[](Asce7Sheet& each) { each.s_1 = 6.0; }, "s_1 = 6 g"},
           {[](Asce7Sheet& each) { each.s_1 = 0.0; }, "s_1 = 0 g"},
           {[](Asce7Sheet& each) { each.response_modification = 0.5; }, "response_modification = 0.5"},
           {[](Asce7Sheet& each) { each.importance = 2.0; }, "importance = 2"},
           {[](Asce7Sheet& each) {
              each.mce_spectrum = TargetSpectrum{.name = "", .source = "", .damping_ratio = 0.1};
            },
            "mce_spectrum.damping_ratio = 0.1"},
           {[](Asce7Sheet& each) { each.wind = -1 * kN; }, "wind = -1000 N"}})
    EXPECT_NE(refused(field).find(message + " "), std::string::npos) << refused(field);
}

TEST(Asce7Sheet, RefusesADisplacementWithoutSolution) {
  SheetBuilding building = sheet_building();
  building.isolation = IsolationLoop{30 * kN, 1 * kN / m, 1 * cm};
  EXPECT_EQ(message_of([&] { static_cast<void>(made(sheet_of(building))); }),
            "Asce7Sheet \"Hospital\": D_M (lower bounds) has no solution below 5 m. Check strength, stiffness and the "
            "spectrum, which is in g.");
  building.isolation = IsolationLoop{30 * MN, 13 * MN / m, 50 * cm};
  EXPECT_EQ(message_of([&] { static_cast<void>(made(sheet_of(building))); }),
            "Asce7Sheet \"Hospital\": D_M (lower bounds) does not exceed the yield displacement 0.5 m. Check strength, "
            "weight and the spectrum, which is in g.");
}

TEST(DesignSheet, NamesItsLinesWhereOneIsUnknown) {
  const std::string message = message_of([] { static_cast<void>(made(sheet_of()).line("D_D")); });
  EXPECT_NE(message.find("there is no line \"D_D\". The lines are lambda_Q, lambda_k, Q, k_2, k_M"), std::string::npos)
      << message;
  EXPECT_EQ(message_of([] { static_cast<void>(made(sheet_of()).line("static").value()); }),
            "SheetLine: \"static\" has no value.");
}

}  // namespace
}  // namespace moat::testing
