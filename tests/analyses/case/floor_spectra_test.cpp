// Floor spectra of a pounding building are those of its motion, not of rows as far apart as the samples of a record.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "moat.hpp"
#include "paper_building.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

GroundMotion pulse(Time interval, Acceleration pga) {
  return near_fault_pulse({.pulse_period = 1.3 * s, .time_step = interval, .quiet_after = 6 * s}).scaled_to_pga(pga);
}

// An isolated building and its neighbour on a fixed base; their second floors touch.
Model neighbours() {
  Model model;
  const auto left = add(model, paper_building("left"));
  ShearBuilding stiff = paper_building_on_fixed_base();
  stiff.name = "right";
  const auto right = add(model, stiff);
  add(model, Gap{.name = "gap",
                 .left = left.floors[1],
                 .right = right.floors[1],
                 .clearance = 10 * cm,
                 .law = paper_hertz_damp()});
  return model;
}

Model in_plan() {
  Model model;
  const auto building =
      add(model, small_plan_building(
                     2, {.yield_force = 250 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 3 * MN / m}));
  add(model, PlanMoat{.around = building.base, .clearance = 12 * cm, .law = paper_hertz_damp(), .friction = 0.3});
  return model;
}

// From the rows of a run, whose interval is constant.
ResponseSpectrum of_rows(const CaseResult& result, const FloorSpectrum& place, const std::vector<Time>& periods) {
  const std::string component = place.direction.empty() ? "" : "_" + place.direction;
  const std::vector<double>& time = result.histories.values("time", "");
  return response_spectrum(
      {place.floor, time[1] - time[0], result.histories.values("absolute_acceleration" + component, place.floor)},
      periods, 0.05);
}

struct Case {
  const char* name;
  Model model;
  GroundMotion motion;
  std::vector<std::string> floors;
};

TEST(FloorSpectra, OfARunAreThoseOfAFarFinerHistory) {
  const std::vector<Case> cases{
      {"isolated", pounding_building(20 * cm), pulse(20 * ms, 0.5 * g), {"base", "floor 5"}},
      {"isolated, a close wall", pounding_building(5 * cm), pulse(12.7 * ms, 0.3 * g), {"base", "floor 5"}},
      {"neighbours", neighbours(), pulse(20 * ms, 0.4 * g), {"left base", "left floor 5", "right floor 5"}},
      {"in plan",
       in_plan(),
       PlanMotion{pulse(20 * ms, 0.4 * g), pulse(20 * ms, 0.2 * g), 20 * deg},
       {"base", "base", "floor 2", "floor 2"}}};
  for (const Case& each : cases) {
    SCOPED_TRACE(each.name);
    const CaseResult fine =
        run_case(each.model, each.motion, {.history_interval = 0.25 * ms, .error_bars = ErrorBarMode::never});
    const CaseResult result = run_case(each.model, each.motion, {.error_bars = ErrorBarMode::never});
    ASSERT_GT(result.impacts.size(), 1u);
    std::vector<std::string> floors;
    for (const FloorSpectrum& place : result.floor_spectra) {
      floors.push_back(place.floor);
      const ResponseSpectrum& spectrum = place.spectrum;
      const std::vector<Time> periods{spectrum.period.begin(), spectrum.period.end()};
      const ResponseSpectrum right = of_rows(fine, place, periods);
      for (std::size_t i = 0; i < periods.size(); ++i)
        EXPECT_NEAR(spectrum.pseudo_acceleration[i], right.pseudo_acceleration[i], 0.01 * right.pseudo_acceleration[i])
            << place.where() << " at " << periods[i].si() << " s";
    }
    EXPECT_EQ(floors, each.floors) << "base and top";
  }
}

TEST(FloorSpectra, OfTheFirstTourUnderARecordDoNotDependOnItsInterval) {
  const char* folder = std::getenv("MOAT_RECORDS");
  const std::filesystem::path record =
      std::filesystem::path{folder != nullptr ? folder : ""} / "RSN1106_KOBE_KJM000.AT2";
  if (!std::filesystem::exists(record)) GTEST_SKIP() << "set MOAT_RECORDS to a folder with " << record.filename();
  GroundMotion motion = read_motion(record);
  motion = motion.scaled_by(0.3 * g / spectral_acceleration(motion, 2.5 * s, 0.05));
  const Model model = pounding_building(20 * cm);
  const CaseOptions options{.transient = {.end = 25 * s}, .error_bars = ErrorBarMode::never};
  const std::vector<Time> periods = spaced_periods(0.05 * s, 0.3 * s, 40);
  FloorSpectra base{{.floors = {"base"}, .periods = periods}};
  CaseRun run{model, motion, options};
  run.attach(base);
  run.run();
  const CaseResult result = run.result();
  ASSERT_EQ(result.floor_spectra.size(), 1u) << "those of the script replace those of the run";
  EXPECT_EQ(result.impacts.size(), 8u);
  const FloorSpectrum& found = result.floor_spectra[0];
  CaseOptions finer = options;
  finer.history_interval = 0.1 * ms;
  const ResponseSpectrum right = of_rows(run_case(model, motion, finer), found, periods),
                         coarse = of_rows(result, found, periods);
  double lost = 0.0;
  for (std::size_t i = 0; i < periods.size(); ++i) {
    EXPECT_NEAR(found.spectrum.pseudo_acceleration[i], right.pseudo_acceleration[i],
                0.01 * right.pseudo_acceleration[i])
        << periods[i].si();
    lost = std::max(lost, 1.0 - coarse.pseudo_acceleration[i] / right.pseudo_acceleration[i]);
  }
  EXPECT_GT(lost, 0.12) << "rows of 20 ms lose so much";
}

}  // namespace
}  // namespace moat
