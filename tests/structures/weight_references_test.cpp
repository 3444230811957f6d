// Towers on pendulums under recorded motions with their vertical component, against histories of an independent
// program: Runge and Kutta's method with steps of 1e-5 s, axial forces iterated in every stage. The folder of
// MOAT_RECORDS has the records.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

#include "moat.hpp"
#include "output/peaks/peak_groups.hpp"
#include "peak_in.hpp"

namespace moat::testing {
namespace {

using namespace units;

class WeightReferences : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MOAT_RECORDS");
    if (folder == nullptr) GTEST_SKIP() << "set MOAT_RECORDS to a folder with the records of Kobe to run this test";
    folder_ = std::string{folder} + "/RSN1108_KOBE_KBU";
  }
  [[nodiscard]] GroundMotion kobe(const std::string& component) const {
    return read_motion(folder_ + component + ".AT2");
  }

 private:
  std::string folder_;
};

FrictionPendulum pendulum(double area) {
  return {.radius = 2.2352 * m,
          .friction = VelocityPressureDependent{.slow = 0.03,
                                                .at_zero_pressure = 0.10,
                                                .reduction = 0.05,
                                                .pressure_factor = 2.5e-8 * m * m / N,
                                                .area = area * m * m,
                                                .rate = 50 * s / m},
          .yield_displacement = 1 * mm};
}

Model tower(std::optional<AxialForces> options) {
  const auto group = [](const char* name, double at) {
    return Isolator<FrictionPendulum>{.name = name, .law = pendulum(0.6), .weight = 1525 * tonne * g, .at = at * m};
  };
  Model model;
  add(model, ShearBuilding{.storeys = 5,
                           .floor_mass = 500 * tonne,
                           .storey_stiffness = 1 * GN / m,
                           .damping = {.ratio = 0.05},
                           .base_mass = 550 * tonne,
                           .isolation = Isolation{group("left", -3.5), group("right", 3.5)},
                           .storey_height = 4 * m,
                           .axial_forces = options});
  return model;
}

CaseResult result_of(const Model& model, const GroundMotion& motion, double tolerance) {
  return run_case(model, motion,
                  {.transient = {.tolerance = tolerance, .end = 20 * s}, .error_bars = ErrorBarMode::never});
}

using Expected = std::map<std::pair<std::string, std::string>, double>;

// Within a share of each value; three times that for torques and smallest axial forces.
void expect_peaks(const CaseResult& result, const Expected& expected, double share) {
  for (const auto& [key, value] : expected) {
    const auto& [quantity, place] = key;
    const bool sensitive =
        quantity == "torque_of_bearings" || quantity == "smallest_bearing_compression" || quantity == "rotation";
    EXPECT_NEAR(std::abs(peak_in(result, quantity, place).value), value, (sensitive ? 3.0 : 1.0) * share * value)
        << quantity << " " << place;
  }
}

TEST_F(WeightReferences, FiveStoreysOnTwoGroups) {
  const GroundMotion horizontal = kobe("000").scaled_by(1.5), motion = with_vertical(horizontal, kobe("-UP"));
  const AxialForces full{.base_height = 0.6 * m, .sliding_surface = SlidingSurface::above};
  AxialForces text_book = full;
  text_book.displaced_weight = false;
  const auto expected = [](double u_base, double u_top, double a_base, double a_top, double force, double left,
                           double right, double drift) {
    return Expected{{{"displacement", "base"}, u_base},          {{"displacement", "floor 5"}, u_top},
                    {{"absolute_acceleration", "base"}, a_base}, {{"absolute_acceleration", "floor 5"}, a_top},
                    {{"total_base_shear", "base"}, force},       {{"isolator_force", "left"}, left},
                    {{"isolator_force", "right"}, right},        {{"drift", "storey 1"}, drift}};
  };
  Expected all = expected(.3097730, .3255279, 3.127339, 3.527079, 6.312313e6, 2.662528e6, 5.209678e6, 5.070648e-3);
  all.insert({{{"smallest_bearing_compression", "left"}, 3.577252e6},
              {{"bearing_compression", "left"}, 24.13859e6},
              {{"smallest_bearing_compression", "right"}, 4.999861e6},
              {{"bearing_compression", "right"}, 29.08477e6},
              {{"overturning_moment", "base"}, 68.71372e6}});
  for (const auto& [tolerance, share] : {std::pair{3e-5, 1e-3}, {1e-7, 2e-4}}) {
    const CaseResult result = result_of(tower(full), motion, tolerance);
    expect_peaks(result, all, share);
    EXPECT_NEAR(result.energy.hysteretic, 3.650614e6, share * 3.650614e6);
    EXPECT_NEAR(result.energy.weight_work, -46.85137e3, share * 46.85137e3);
    EXPECT_NEAR(isolators_at_the_end(result.histories).front().value, -14.17199e-3, share * 14.17199e-3);
  }
  expect_peaks(result_of(tower(text_book), motion, 3e-5),
               expected(.3095363, .3253909, 3.112549, 3.521944, 6.358992e6, 2.611697e6, 4.965281e6, 5.105044e-3), 1e-3);
  expect_peaks(result_of(tower(full), horizontal, 3e-5),
               expected(.3148937, .3295686, 3.077552, 3.488405, 6.159195e6, 2.670927e6, 5.059359e6, 4.947916e-3), 1e-3);
  expect_peaks(result_of(tower({}), horizontal, 3e-5),
               expected(.3131494, .3282015, 3.150797, 3.469756, 6.334837e6, 3.167418e6, 3.167418e6, 5.092479e-3), 1e-3);
}

TEST_F(WeightReferences, ABlockOnFourPendulumsInPlan) {
  PlanMotion motion{kobe("000").scaled_by(1.5), kobe("090").scaled_by(1.5)};
  motion.vertical = kobe("-UP");
  Model model;
  const DiaphragmId base = add(model, Diaphragm{.name = "base",
                                                .mass = 1.2e6 * kg,
                                                .rotary_inertia = 2.08e7 * kg * m * m,
                                                .outline = rectangle(12 * m, 8 * m)});
  PlanBearings{grid(2, 2, pendulum(0.12))}.add_under(model, Check{"block", ""}, "", base, rectangle(10 * m, 6 * m),
                                                     1200 * tonne * g, AxialForces{});
  add(model, Building{.base = base, .axial_forces = AxialForces{.base_height = 8 * m}});
  const Expected expected{{{"displacement_x", "base"}, .3283516},
                          {{"displacement_y", "base"}, .1556571},
                          {{"displacement", "base"}, .3436717},
                          {{"rotation", "base"}, .001325221},
                          {{"torque_of_bearings", "base"}, .857413e6},
                          {{"absolute_acceleration_x", "base"}, 2.171983},
                          {{"absolute_acceleration_y", "base"}, 1.177757},
                          {{"absolute_acceleration", "base"}, 2.209335},
                          {{"total_base_shear_x", "base"}, 2.606379e6},
                          {{"total_base_shear_y", "base"}, 1.413308e6},
                          {{"isolator_force", "bearing 1"}, .5363450e6},
                          {{"isolator_force", "bearing 2"}, .9396065e6},
                          {{"isolator_force", "bearing 3"}, .5769904e6},
                          {{"isolator_force", "bearing 4"}, .8178492e6},
                          {{"smallest_bearing_compression", "bearing 1"}, 1.763988e6},
                          {{"smallest_bearing_compression", "bearing 2"}, 1.504916e6},
                          {{"smallest_bearing_compression", "bearing 3"}, 1.606660e6},
                          {{"smallest_bearing_compression", "bearing 4"}, 1.762235e6},
                          {{"bearing_compression", "bearing 1"}, 4.943571e6},
                          {{"bearing_compression", "bearing 2"}, 4.462106e6},
                          {{"bearing_compression", "bearing 3"}, 4.676945e6},
                          {{"bearing_compression", "bearing 4"}, 4.717927e6},
                          {{"overturning_moment_x", "base"}, 20.85103e6},
                          {{"overturning_moment_y", "base"}, 11.30646e6}};
  for (const auto& [tolerance, share] : {std::pair{3e-5, 1e-3}, {1e-6, 2e-4}}) {
    const CaseResult result = result_of(model, motion, tolerance);
    expect_peaks(result, expected, share);
    EXPECT_NEAR(result.energy.hysteretic, 2.071379e6, share * 2.071379e6);
    EXPECT_NEAR(result.energy.weight_work, -19.09017e3, share * 19.09017e3);
  }
}

// Eight storeys, eccentric, on nine pendulums.
Model eight_storeys(double mirror) {
  Model model;
  add(model, PlanBuilding{.outline = rectangle(16 * m, 12 * m),
                          .storeys = 8,
                          .floor_mass = 300 * tonne,
                          .mass_offset = PlanPosition{mirror * 0.8 * m, 0.5 * m},
                          .base_mass_offset = {mirror * 0.4 * m, 0.2 * m},
                          .columns = grid(3, 3, StoreyColumn{.stiffness = 90 * MN / m}),
                          .damping = {.ratio = 0.05},
                          .base_mass = 350 * tonne,
                          .bearings = grid(3, 3, pendulum(0.12)),
                          .storey_height = 3.5 * m,
                          .axial_forces = AxialForces{.base_height = 0.5 * m}});
  return model;
}

TEST_F(WeightReferences, EightStoreysConvergeAndAreMirrored) {
  PlanMotion motion{kobe("000").scaled_by(1.3), kobe("090").scaled_by(1.3)};
  motion.vertical = kobe("-UP");
  PlanMotion mirrored = motion;
  mirrored.first = mirrored.first.scaled_by(-1.0);
  const CaseResult one = result_of(eight_storeys(1.0), motion, 3e-5),
                   finer = result_of(eight_storeys(1.0), motion, 1.5e-5),
                   other = result_of(eight_storeys(-1.0), mirrored, 3e-5);
  for (const auto& [quantity, place] : {std::pair{"displacement", "base"},
                                        {"absolute_acceleration", "base"},
                                        {"absolute_acceleration", "floor 8"},
                                        {"isolator_force", "bearings"},
                                        {"bearing_compression", "bearings"}}) {
    const double value = peak_in(one, quantity, place).magnitude();
    EXPECT_NEAR(peak_in(finer, quantity, place).magnitude(), value, 2e-4 * value) << quantity << place;
    EXPECT_NEAR(peak_in(other, quantity, place).magnitude(), value, 1e-6 * value) << quantity << place;
  }
}

}  // namespace
}  // namespace moat::testing
