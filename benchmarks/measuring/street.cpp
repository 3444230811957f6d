#include "measuring/street.hpp"

#include <cmath>
#include <string>

#include "base/check.hpp"

namespace moat::performance {

using namespace units;

namespace {

/// The n-th term of an additive sequence, evenly spread over [-1, 1) for an irrational step.
double spread_evenly(int n, double irrational_step) {
  const double term = n * irrational_step;
  return 2.0 * (term - std::floor(term)) - 1.0;
}

// Powers of the root of x^5 = x + 1: jointly irrational, so that the five properties of a building are unrelated.
constexpr double root = 1.1673039782614187;
constexpr double stiffness_step = 1.0 / root;
constexpr double mass_step = stiffness_step / root;
constexpr double clearance_step = mass_step / root;
constexpr double displacement_step = clearance_step / root;
constexpr double velocity_step = displacement_step / root;

constexpr double variation = 0.3;

Building add_building(Model& model, int number) {
  return add(model, ShearBuilding{.name = std::to_string(number),
                                  .storeys = 5,
                                  .floor_mass = (1.0 + variation * spread_evenly(number, mass_step)) * 500 * tonne,
                                  .storey_stiffness = 1 * GN / m,
                                  .damping = RayleighDamping{.ratio = 0.05},
                                  .base_mass = 550 * tonne,
                                  .isolation = LeadRubberBearing{
                                      .yield_force = 1.93 * MN,
                                      .yield_displacement = 1 * cm,
                                      .post_yield_stiffness =
                                          (1.0 + variation * spread_evenly(number, stiffness_step)) * 19.3 * MN / m}});
}

Length clearance_after(int number) { return (2.5 + 2.0 * spread_evenly(number, clearance_step)) * cm; }

template <class Law>
Model street_of(int buildings, const Law& law) {
  Check{"Street", ""}.that(buildings >= 2, "buildings", buildings, "1", ">= 2");
  Model model;
  NodeId left = ground;
  for (int number = 1; number <= buildings; ++number) {
    const NodeId base = add_building(model, number).base;
    add(model, Gap<Law>{.name = "gap " + std::to_string(number),
                        .left = left,
                        .right = base,
                        .clearance = clearance_after(number - 1),
                        .law = law});
    left = base;
  }
  add(model, Gap<Law>{.name = "gap " + std::to_string(buildings + 1),
                      .left = left,
                      .right = ground,
                      .clearance = clearance_after(buildings),
                      .law = law});
  return model;
}

constexpr HertzStiffness hertz_stiffness = 2.95e9 * N / m_3_2;
constexpr double restitution = 0.65;

}  // namespace

NamedImpactLaw street_law(const std::string& name) {
  return {
      .name = name, .linear_stiffness = 5.8e8 * N / m, .hertz_stiffness = hertz_stiffness, .restitution = restitution};
}

Model street(int buildings) {
  return street_of(buildings, HertzDamp{.stiffness = hertz_stiffness, .restitution = restitution});
}

Model street(int buildings, const NamedImpactLaw& law) { return street_of(buildings, law); }

AnalysisState street_at_start(const Model& street) {
  AnalysisState state{street};
  MotionState& motion = state.trial();
  for (int i = 0; i < street.degrees_of_freedom(); ++i) {
    const int number = 1 + i / degrees_of_freedom_per_building;
    motion.displacement[i] = 0.01 * spread_evenly(number, displacement_step);
    motion.velocity[i] = 0.6 * spread_evenly(number, velocity_step);
  }
  state.evaluate();
  state.commit();
  return state;
}

GroundMotion street_motion() { return near_fault_pulse({.lead_in = 0 * s}).scaled_to_pga(0.4 * g); }

}  // namespace moat::performance
