// Equal bearings at one place under axial forces that change: one element with a count, and single elements.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "block_on_bearings.hpp"
#include "elements/line/softening_rubber.hpp"
#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr int count = 4;

struct Course {
  std::vector<std::vector<double>> rows;  // time, motion, and of every place N, N', force and its rate
  long events = 0, uplifts = 0;
  double uplift_time = 0.0, in_steps = 0.0;  // s, of the first bearing, and in the steps that end with its uplift
};

Course course(const Model& model, const GroundMotion& motion, std::size_t per_place) {
  Transient analysis{model, motion, {.step = 2 * ms, .force_tolerance = 1e-10}};
  Course course;
  while (!analysis.finished()) {
    analysis.advance();
    const AnalysisState& state = analysis.state();
    std::vector<double> row{state.time(), state.motion().displacement[0], state.motion().velocity[0],
                            state.motion().acceleration[0]};
    const auto bearings = state.weights()[0].bearings();
    for (std::size_t place = 0; place < 3; ++place) {
      double sums[4]{};
      for (std::size_t i = place * per_place; i < (place + 1) * per_place; ++i) {
        const auto [b, e] = bearings[i].element;
        const ElementResult result = state.elements(b).results()[e];
        const double values[]{bearings[i].compression, bearings[i].rate, result.force, result.force_rate};
        for (int k = 0; k < 4; ++k) sums[k] += values[k];
      }
      row.insert(row.end(), std::begin(sums), std::end(sums));
    }
    if (bearings[0].deficit > 0.0)
      course.in_steps += state.time() - (course.rows.empty() ? 0.0 : course.rows.back()[0]);
    course.rows.push_back(row);
  }
  course.events = analysis.statistics().events;
  course.uplifts = analysis.state().weights()[0].bearings()[0].uplifts;
  course.uplift_time = analysis.state().weights()[0].bearings()[0].uplift_time;
  return course;
}

// All columns agree to this share of their largest value, and so do the energies.
template <class Law>
void expect_sum_of_single_bearings(const Law& law, double height, double size) {
  const Model together = block_on(law, height, count, true), apart = block_on(law, height, count);
  const GroundMotion motion = shaking_along_and_up(size, 4.0);
  const Course one = course(together, motion, 1), four = course(apart, motion, count);
  ASSERT_EQ(one.rows.size(), four.rows.size());
  EXPECT_GT(one.events, 20);
  EXPECT_EQ(count * one.events, four.events);
  EXPECT_GT(one.uplifts, 0);
  EXPECT_EQ(one.uplifts, four.uplifts);
  EXPECT_NEAR(one.uplift_time, one.in_steps, 1e-9);
  constexpr double close = 1e-9;
  for (std::size_t column = 0; column < one.rows.front().size(); ++column) {
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < one.rows.size(); ++i) {
      largest = std::max(largest, std::abs(one.rows[i][column]));
      difference = std::max(difference, std::abs(one.rows[i][column] - four.rows[i][column]));
    }
    EXPECT_LE(difference, close * largest) << "column " << column;
  }
  const CaseOptions options{.transient = {.step = 2 * ms, .force_tolerance = 1e-10}, .error_bars = ErrorBarMode::never};
  const EnergyBalance a = run_case(together, motion, options).energy, b = run_case(apart, motion, options).energy;
  for (const auto& member : {&EnergyBalance::input, &EnergyBalance::weight_work, &EnergyBalance::kinetic,
                             &EnergyBalance::strain, &EnergyBalance::hysteretic})
    EXPECT_NEAR(a.*member, b.*member, close * a.largest_input);
}

TEST(EqualBearings, OfPendulumsThatHeatAreFourOfThem) {
  expect_sum_of_single_bearings(
      HeatedFrictionPendulum{.radius = 2 * m,
                             .friction = PressureTemperatureVelocity{.reference_coefficient = 0.06,
                                                                     .reference_pressure = 20 * MPa,
                                                                     .slider_radius = 15 * cm}},
      16.0, 1.0);
}

TEST(EqualBearings, OfSlidersWhoseFrictionFollowsPressureAreFourOfThem) {
  expect_sum_of_single_bearings(FlatSlider{.friction = VelocityPressureDependent{.slow = 0.03,
                                                                                 .at_zero_pressure = 0.10,
                                                                                 .reduction = 0.05,
                                                                                 .pressure_factor = 2.5e-8 * m * m / N,
                                                                                 .area = 0.12 * m * m,
                                                                                 .rate = 50 * s / m},
                                           .restoring_stiffness = 400 * kN / m},
                                20.0, 1.2);
}

TEST(EqualBearings, OfRubberUnderWeightAreFourOfThem) {
  expect_sum_of_single_bearings(SofteningRubber{.bearing = Bilinear{.yield_force = 60 * kN,
                                                                    .yield_displacement = 1 * cm,
                                                                    .post_yield_stiffness = 400 * kN / m},
                                                .rubber = {.diameter = 0.5 * m,
                                                           .layer_thickness = 6 * mm,
                                                           .rubber_thickness = 180 * mm,
                                                           .shear_modulus = 0.5 * MPa}},
                                16.0, 1.0);
}

}  // namespace
}  // namespace moat::testing
