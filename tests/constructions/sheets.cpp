// Design sheets.
#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

SheetBuilding hospital() {
  return {.name = "Hospital",
          .weight = 30 * MN,
          .floors = {SheetFloor{5 * MN, 3.5 * m}, SheetFloor{5 * MN, 7 * m}},
          .isolation = IsolationLoop{.characteristic_strength = 1.8 * MN,
                                     .post_yield_stiffness = 13 * MN / m,
                                     .yield_displacement = 10 * mm},
          .bounds = {.lower = {0.85, 0.90}, .upper = {1.5, 1.3}},
          .shorter_side = 20 * m,
          .longer_side = 32 * m,
          .bearings = {{-10 * m, -8 * m}, {10 * m, -8 * m}, {10 * m, 8 * m}, {-10 * m, 8 * m}},
          .fixed_base_period = 0.6 * s};
}
template <class Change>
std::function<void()> asce(Change change) {
  return [change] {
    Asce7Sheet sheet{.building = hospital(),
                     .spectrum = Asce7Spectrum{.s_ds = 1.0, .s_d1 = 0.6, .long_period = 8 * s},
                     .s_1 = 0.6,
                     .response_modification = 5};
    change(sheet);
    static_cast<void>(static_cast<DesignSheet>(sheet));
  };
}
template <class Change>
std::function<void()> building(Change change) {
  return asce([change](Asce7Sheet& sheet) {
    SheetBuilding changed = sheet.building;
    change(changed);
    sheet.building = changed;
  });
}
template <class Change>
std::function<void()> suite(Change change) {
  return building([change](SheetBuilding& all) {
    SuiteForSheet results{.statistic = "mean of 7 records"};
    change(results);
    all.suite = results;
  });
}
template <class Change>
std::function<void()> en(Change change) {
  return [change] {
    En1998Sheet sheet{.building = hospital(),
                      .spectrum = En1998Spectrum{.ground_acceleration = 0.3 * g, .ground = 'C'}};
    change(sheet);
    static_cast<void>(static_cast<DesignSheet>(sheet));
  };
}

}  // namespace

Constructions sheets() {
  return {
      {"a sheet of no hazard",
       asce([](auto& sheet) { sheet.s_1 = 0; }),
       {"Asce7Sheet \"Hospital\"", "s_1", "0 g", "> 0 g and <= 5 g", "It is a fraction of g: 60 % of g is 0.6"}},
      {"a sheet of a building that never yields less",
       asce([](auto& sheet) { sheet.response_modification = 0.5; }),
       {"Asce7Sheet \"Hospital\"", "response_modification", "0.5", "from 1 to 8", "Give a number in this range"}},
      {"a sheet of a building of no importance",
       asce([](auto& sheet) { sheet.importance = 0; }),
       {"Asce7Sheet \"Hospital\"", "importance", "0", "from 1 to 1.5", "Give a number in this range"}},
      {"a sheet of wind that pulls",
       asce([](auto& sheet) { sheet.wind = -1 * kN; }),
       {"Asce7Sheet \"Hospital\"", "wind", "-1000 N", ">= 0 N and finite", "Check its sign and its unit"}},
      {"a sheet whose isolators never yield",
       asce([](auto& sheet) { sheet.spectrum = Asce7Spectrum{.s_ds = 1e-4, .s_d1 = 1e-4, .long_period = 8 * s}; }),
       {"Asce7Sheet \"Hospital\"", "D_M", "(lower bounds)", "exceed the yield displacement 0.01 m",
        "Check strength, weight and the spectrum"}},
      {"a sheet of no weight",
       building([](auto& all) { all.weight = 0 * N; }),
       {"Asce7Sheet \"Hospital\"", "weight", "0 N", "> 0 N and finite", "Check its sign and its unit"}},
      {"a sheet of floors heavier than the whole",
       building([](auto& all) { all.floors[0].weight = 40 * MN; }),
       {"Asce7Sheet \"Hospital\"", "weight of all floors", "4.5e+07 N", "<= weight = 3e+07 N, with the base level",
        "Check its sign and its unit"}},
      {"a sheet of a floor without weight",
       building([](auto& all) { all.floors[1].weight = 0 * N; }),
       {"Asce7Sheet \"Hospital\"", "weight of floor 2", "0 N", "> 0 N and finite", "Check its sign and its unit"}},
      {"a sheet of a floor at the base",
       building([](auto& all) { all.floors[0].height = 0 * m; }),
       {"Asce7Sheet \"Hospital\"", "height of floor 1", "0 m", "> 0 m and finite",
        "The forces of floors need it; it counts from the base"}},
      {"a sheet of sides exchanged",
       building([](auto& all) { all.longer_side = 10 * m; }),
       {"Asce7Sheet \"Hospital\"", "longer_side", "10 m", ">= shorter_side = 20 m and finite",
        "Check its sign and its unit"}},
      {"a sheet of a building as rigid as rock",
       building([](auto& all) { all.fixed_base_period = 0 * s; }),
       {"Asce7Sheet \"Hospital\"", "fixed_base_period", "0 s", "> 0 s and finite", "Check its sign and its unit"}},
      {"a sheet with a gap that overlaps",
       building([](auto& all) { all.clearance = -1 * cm; }),
       {"Asce7Sheet \"Hospital\"", "clearance", "-0.01 m", ">= 0 m and finite", "Check its sign and its unit"}},
      {"a sheet of a corner behind the centre",
       building([](auto& all) { all.corner_distance = -1 * m; }),
       {"Asce7Sheet \"Hospital\"", "corner_distance", "-1 m", ">= 0 m and finite", "Check its sign and its unit"}},
      {"a sheet of a negative eccentricity",
       building([](auto& all) { all.eccentricity = -1 * m; }),
       {"Asce7Sheet \"Hospital\"", "eccentricity", "-1 m", ">= 0 m and finite", "Check its sign and its unit"}},
      {"a sheet of isolators without strength",
       building([](auto& all) {
         all.isolation = IsolationLoop{
             .characteristic_strength = 0 * N, .post_yield_stiffness = 13 * MN / m, .yield_displacement = 10 * mm};
       }),
       {"Asce7Sheet \"Hospital\"", "isolation.characteristic_strength", "0 N", "> 0 N and finite",
        "Check its sign and its unit"}},
      {"a sheet of histories with negative drift",
       suite([](auto& results) { results.nominal.drift = -0.01; }),
       {"Asce7Sheet \"Hospital\"", "suite.nominal.drift", "-0.01", ">= 0 and finite", "Give a number in this range"}},
      {"a sheet of histories with a displacement of no number",
       suite([](auto& results) { results.lower = SuiteValues{.displacement = not_a_number * m}; }),
       {"Asce7Sheet \"Hospital\"", "suite.lower.displacement", "nan m", ">= 0 m and finite", "division by zero"}},
      {"a sheet of displacements made smaller",
       en([](auto& sheet) { sheet.magnification = 0.9; }),
       {"En1998Sheet \"Hospital\"", "magnification", "0.9", "from 1 to 2", "Give a number in this range"}},
      {"a sheet of creep backwards",
       en([](auto& sheet) { sheet.slow_displacement = -1 * cm; }),
       {"En1998Sheet \"Hospital\"", "slow_displacement", "-0.01 m", ">= 0 m and finite",
        "Check its sign and its unit"}},
      {"a line that is not on the sheet",
       [] {
         const DesignSheet sheet = En1998Sheet{
             .building = hospital(), .spectrum = En1998Spectrum{.ground_acceleration = 0.3 * g, .ground = 'C'}};
         static_cast<void>(sheet.line("D_M"));
       },
       {"DesignSheet", "there is no", "line", "D_M", "The lines are lambda_Q"}},
      {"a sheet of a model without building",
       [] {
         Model model;
         add(model, Diaphragm{.name = "floor", .mass = 1 * kg, .size = {1 * m, 1 * m}, .free = true});
         static_cast<void>(sheet_building_of(
             model, BearingDesign{.strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 10 * mm}));
       },
       {"sheet_building_of \"base\"", "the model has no building in plan", "on this base", "Give the name of the base",
        "building"}},
  };
}

}  // namespace moat::constructions
