// A model moved by hand, to test recorders.
#pragma once

#include <optional>

#include "elements/contact/gap.hpp"
#include "elements/line/isolator.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/viscous_damper.hpp"
#include "materials/impact/hertz_damp.hpp"
#include "output/recorders/channels.hpp"
#include "output/recorders/step_observer.hpp"
#include "structures/moat.hpp"
#include "unlocated_bilinear.hpp"

namespace moat::testing_output {

/// A base on bearings in a moat of 10 cm, and a floor on it.
struct HandMovedBuilding {
  HandMovedBuilding() {
    using namespace units;
    base = add(model, Node{.name = "base", .mass = 2 * kg, .half_width = 6 * m});
    floor = add(model, Node{.name = "floor 1", .mass = 3 * kg, .height = 3.5 * m, .half_width = 5 * m});
    add(model, ShearSpring{.name = "storey 1", .lower = base, .upper = floor, .stiffness = 100 * N / m});
    add(model, ViscousDamper{.name = "damper", .lower = base, .upper = floor, .damping = 1 * N * s / m});
    // A bearing that yields without a change of regime, which only an analysis makes.
    add(model,
        Isolator<testing::UnlocatedBilinear>{
            .upper = base, .law = {.yield_force = 10.0, .yield_displacement = 0.1, .post_yield_stiffness = 5.0}});
    add(model, Moat<HertzDamp>{
                   .around = base, .clearance = 10 * cm, .law = {.stiffness = 1000 * N / m_3_2, .restitution = 1.0}});
    add(model, Building{.base = base, .floors = {floor}});
    state.emplace(model);
  }

  /// Puts both nodes somewhere and commits.
  StepView move(double time, double base_displacement, double floor_displacement, double base_acceleration = 0.0,
                double floor_acceleration = 0.0, double ground_acceleration = 0.0, bool on_grid = true,
                std::optional<double> base_velocity = {}) {
    MotionState& trial = state->trial();
    trial.time = time;
    trial.displacement.head(2) << base_displacement, floor_displacement;
    trial.velocity.head(2) << base_velocity.value_or(0.1 * base_displacement), 0.1 * floor_displacement;
    trial.acceleration.head(2) << base_acceleration, floor_acceleration;
    state->evaluate();
    state->evaluate_rates();
    state->commit();
    return {model, *state, {ground_acceleration}, on_grid};
  }

  Model model;
  std::optional<AnalysisState> state;
  NodeId base, floor;
};

/// The number of the channel of this quantity at this place; -1 if there is none.
inline int find(const Channels& channels, std::string_view quantity, std::string_view where) {
  for (std::size_t i = 0; i < channels.list().size(); ++i)
    if (channels.list()[i].quantity == quantity && channels.list()[i].where == where) return static_cast<int>(i);
  return -1;
}

}  // namespace moat::testing_output
