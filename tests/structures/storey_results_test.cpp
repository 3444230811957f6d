// Shears, torques and overturning moments of storeys. Without damping and contacts they are the inertia of all floors
// above, at every step.
#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "output/recorders/channels.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;

// Compares results of storeys with those of inertia, which `expected` computes from a view.
class Comparison final : public StepObserver {
 public:
  using Results = std::map<std::pair<std::string, std::string>, double>;  // by quantity and place
  Comparison(const Model& model, std::function<Results(const StepView&)> expected)
      : channels_{model}, expected_{std::move(expected)} {}

  void start(const StepView&) override {}
  void step(const StepView& view) override {
    channels_.sample(view, values_, rates_);
    for (const auto& [key, value] : expected_(view)) {
      const auto channel = std::ranges::find_if(channels_.list(), [&](const Channel& each) {
        return each.quantity == key.first && each.place == key.second;
      });
      ASSERT_NE(channel, channels_.list().end()) << key.first << " " << key.second;
      Extremes& extremes = found_[key];
      const double own = values_[static_cast<std::size_t>(channel - channels_.list().begin())];
      extremes.difference = std::max(extremes.difference, std::abs(own - value));
      extremes.largest = std::max(extremes.largest, std::abs(value));
    }
  }
  // The balance of forces is solved to 1e-8 of each row.
  void expect_equal() const {
    EXPECT_FALSE(found_.empty());
    for (const auto& [key, extremes] : found_) {
      EXPECT_GT(extremes.largest, 0.0) << key.first;
      EXPECT_LT(extremes.difference, 1e-6 * extremes.largest) << key.first << " " << key.second;
    }
  }

 private:
  struct Extremes {
    double difference = 0.0, largest = 0.0;
  };
  Channels channels_;
  std::function<Results(const StepView&)> expected_;
  std::vector<double> values_, rates_;
  std::map<std::pair<std::string, std::string>, Extremes> found_;
};

TEST(StoreyResults, OnALineAreTheInertiaOfTheFloorsAbove) {
  Model model;
  const Building tower = add(model, ShearBuilding{.name = "tower",
                                                  .storeys = 3,
                                                  .floor_mass = {500 * tonne, 400 * tonne, 300 * tonne},
                                                  .storey_stiffness = 1 * GN / m,
                                                  .storey_height = {5 * m, 4 * m, 3 * m}});
  const double heights[] = {0.0, 5.0, 9.0, 12.0};
  Comparison comparison{model, [&](const StepView& view) {
                          Comparison::Results results;
                          for (std::size_t i = 0; i < 3; ++i)
                            for (std::size_t j = i; j < 3; ++j) {
                              const NodeId floor = tower.floors[j];
                              const double force = -model.mass(floor) * view.absolute_acceleration(floor);
                              const std::string storey = "tower storey " + std::to_string(i + 1);
                              results[{"storey_shear", storey}] += force;
                              results[{"overturning_moment", storey}] += force * (heights[j + 1] - heights[i]);
                            }
                          return results;
                        }};
  Transient analysis{model, near_fault_pulse({}), {.step = 5 * ms}};
  analysis.attach(comparison);
  analysis.run();
  comparison.expect_equal();
}

TEST(StoreyResults, InPlanAreTheInertiaOfTheFloorsAbove) {
  Model model;
  PlanBuilding building = testing::small_plan_building(
      2, {.yield_force = 184 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m});
  building.mass_offset = {1 * m, 0.6 * m};
  building.base_mass_offset = {-0.5 * m, 0.3 * m};
  building.storey_height = {5 * m, 4 * m};
  // One storey of columns, one as a whole.
  building.columns = {
      PlanColumns{grid(3, 2, StoreyColumn{.stiffness_x = 100 * MN / m, .stiffness_y = 60 * MN / m})},
      PlanColumns{StoreyStiffness{
          .x = 300 * MN / m, .y = 200 * MN / m, .rotation = 2e10 * N * m, .centre_of_rigidity = {2 * m, -1 * m}}}};
  const PlanBuildingParts tower = add(model, building);
  const PlanVector origin = model.diaphragm(tower.base).centre_of_mass;
  const double heights[] = {0.0, 5.0, 9.0};
  Comparison comparison{
      model, [&](const StepView& view) {
        Comparison::Results results;
        for (std::size_t i = 0; i < 2; ++i)
          for (std::size_t j = i; j < 2; ++j) {
            const PlacedDiaphragm& floor = model.diaphragm(tower.floors[j]);
            const PlanVector force = -floor.mass * PlanVector{view.absolute_acceleration(floor.id.x),
                                                              view.absolute_acceleration(floor.id.y)};
            const double turning = -floor.mass * floor.gyration * view.state.acceleration(floor.id.r);
            const std::string storey = "storey " + std::to_string(i + 1);
            const double arm = heights[j + 1] - heights[i];
            results[{"storey_shear_x", storey}] += force.x;
            results[{"storey_shear_y", storey}] += force.y;
            results[{"storey_torque", storey}] += turning + cross(floor.centre_of_mass - origin, force);
            results[{"overturning_moment_x", storey}] += arm * force.x;
            results[{"overturning_moment_y", storey}] += arm * force.y;
          }
        return results;
      }};
  const GroundMotion pulse = near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g);
  Transient analysis{model, PlanMotion{pulse, pulse.scaled_by(0.5), 20 * deg}, {.step = 5 * ms, .end = 4 * s}};
  analysis.attach(comparison);
  analysis.run();
  comparison.expect_equal();
}

}  // namespace
}  // namespace moat
