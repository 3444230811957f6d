// Floor spectra of a pounding building are those of its motion, not of rows as far apart as the samples of a record.

#include <gtest/gtest.h>

#include <cmath>

#include "moat.hpp"
#include "paper_building.hpp"
#include "report/charts/result_charts.hpp"
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

CaseResult run(const Model& model, const GroundMotion& motion, Time rows = {}) {
  return run_case(model, motion, {.history_interval = rows, .error_bars = ErrorBarMode::never});
}

struct Case {
  const char* name;
  Model model;
  GroundMotion motion;
};

std::vector<Case> cases() {
  return {{"isolated", pounding_building(20 * cm), pulse(20 * ms, 0.5 * g)},
          {"isolated, a close wall", pounding_building(5 * cm), pulse(12.7 * ms, 0.3 * g)},
          {"neighbours", neighbours(), pulse(20 * ms, 0.4 * g)},
          {"in plan", in_plan(), PlanMotion{pulse(20 * ms, 0.4 * g), pulse(20 * ms, 0.2 * g), 20 * deg}}};
}

TEST(FloorAccelerations, GiveTheSpectraOfAFarFinerHistory) {
  for (const Case& each : cases()) {
    SCOPED_TRACE(each.name);
    const CaseResult result = run(each.model, each.motion), fine = run(each.model, each.motion, 0.25 * ms);
    ASSERT_GT(result.impacts.size(), 1u);
    EXPECT_TRUE(fine.floor_accelerations.columns.empty()) << "its histories have rows enough";
    const std::vector<Chart> spectra = floor_spectra(result), right = floor_spectra(fine);
    ASSERT_EQ(spectra.size(), right.size());
    for (std::size_t c = 0; c < spectra.size(); ++c) {
      ASSERT_EQ(spectra[c].series.size(), right[c].series.size());
      for (std::size_t i = 0; i < spectra[c].series.size(); ++i) {
        const Series &series = spectra[c].series[i], &reference = right[c].series[i];
        EXPECT_EQ(series.name, reference.name);
        ASSERT_EQ(series.x, reference.x);
        for (std::size_t k = 0; k < series.x.size(); ++k)
          EXPECT_NEAR(series.y[k], reference.y[k], 0.01 * reference.y[k])
              << series.name << " at " << series.x[k] << " s";
      }
    }
  }
}

TEST(FloorAccelerations, AreTheRowsOfAFinerHistory) {
  for (const Case& each : cases()) {
    SCOPED_TRACE(each.name);
    const double parts = std::ceil(each.motion.time_step() / 1e-3), interval = each.motion.time_step() / parts;
    const CaseResult result = run(each.model, each.motion), fine = run(each.model, each.motion, interval * s);
    const Table& floors = result.floor_accelerations;
    ASSERT_GT(floors.columns.size(), 2u);
    EXPECT_NEAR(static_cast<double>(floors.rows()), static_cast<double>(fine.histories.rows()), 1.0);
    for (const Column& column : floors.columns) {
      const std::vector<double>& expected = fine.histories.values(column.quantity, column.where);
      double largest = 0.0;
      for (const double value : expected) largest = std::max(largest, std::abs(value));
      for (std::size_t i = 0; i + 1 < column.values.size(); ++i)
        ASSERT_NEAR(column.values[i], expected[i], 1e-9 * largest)
            << column.quantity << " " << column.where << " " << i;
    }
  }
}

TEST(FloorAccelerations, AreLeftOutWithoutImpacts) {
  const GroundMotion motion = pulse(20 * ms, 0.3 * g);
  Model without_gaps;
  add(without_gaps, paper_building());
  for (const Model& model : {pounding_building(2 * m), without_gaps}) {
    CaseResult result = run(model, motion);
    EXPECT_TRUE(result.floor_accelerations.columns.empty());
    EXPECT_EQ(floor_spectra(result).size(), 1u);
  }
}

}  // namespace
}  // namespace moat
