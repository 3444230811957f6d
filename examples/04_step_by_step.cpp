// Tour 4: driving an analysis by hand, with a law of one's own. Read 01_moat_wall.cpp and 02_by_hand.cpp before.
//
//        o tank         A water tank on the roof, on a hardening spring that no library has: a law is a struct
//        $ HardeningSpring           with four functions.
//     [ roof ]
//        | |            No Script and no results folder here: the program makes a Transient, advances it step by
//     [ base ]<-gap->|  step, looks at the model in between, and prints each touch and each opening of the gap.
//     =bearings=
//
//     ./moat run examples/04_step_by_step.cpp
#include <moat.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace moat;
using namespace moat::units;

// F = k d (1 + (d/a)^2) + c d': a spring that is twice as stiff in the secant at d = a, and a dashpot. Tension
// positive.
struct HardeningSpring {
  Required<Stiffness> stiffness;  // k > 0 N/m
  Required<Length> scale;         // a > 0 m
  DampingCoefficient damping{};   // c >= 0 N s/m

  using State = NoState;  // no memory: the force follows from deformation and rate

  // Called by add(); optional.
  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check.positive("scale", scale);
    check.not_negative("damping", damping);
  }
  // The force with both its exact derivatives: Newton's method converges quadratically with these.
  Response evaluate(const State&, double deformation, double rate, State&) const {
    const double ratio = deformation / scale.si();
    return {.force = stiffness.si() * deformation * (1.0 + ratio * ratio) + damping.si() * rate,
            .stiffness = stiffness.si() * (1.0 + 3.0 * ratio * ratio),
            .damping = damping.si()};
  }
  // The next two let the energy balance check the analysis.
  double stored_energy(const State&, double deformation) const {
    const double ratio = deformation / scale.si();
    return 0.5 * stiffness.si() * deformation * deformation * (1.0 + 0.5 * ratio * ratio);
  }
  double dissipation_rate(const State&, double, double rate) const { return damping.si() * rate * rate; }
  // The stiffness for periods.
  double linear_stiffness(StiffnessStage) const { return stiffness.si(); }
};

// An observer sees every accepted step, and every change of regime: touches and openings of gaps among them.
class ImpactPrinter final : public StepObserver {
 public:
  void start(const StepView&) override {}
  void step(const StepView&) override {}
  void event(const StepView& view, std::span<const RegimeChange> changes) override {
    for (const RegimeChange& change : changes) {
      // Bearings that yield change their regime too, and contacts that stay closed.
      if (!change.touched && !change.opened) continue;
      ++events;
      const ElementBlock& block = *view.model.blocks()[change.block];
      std::printf("%8.4f s  %-10s  %s", change.time, block.info(change.element).name.c_str(),
                  change.touched ? "touches" : "opens\n");
      if (change.touched)
        std::printf(" at %.1f cm/s\n",
                    100.0 * view.state.elements(change.block).contact(change.element).approach_speed);
    }
  }

  int events = 0;
};

int main() {
  Model model;
  const auto building = add(model, ShearBuilding{.storeys = 1,
                                                 .floor_mass = 500 * tonne,
                                                 .storey_stiffness = 1 * GN / m,
                                                 .damping = {.ratio = 0.05},
                                                 .base_mass = 550 * tonne,
                                                 .isolation = LeadRubberBearing{.yield_force = 0.6 * MN,
                                                                                .yield_displacement = 1 * cm,
                                                                                .post_yield_stiffness = 7 * MN / m}});
  const NodeId tank = add(model, Node{.name = "tank", .mass = 20 * tonne});
  add(model, Spring<HardeningSpring>{.name = "tank spring",
                                     .lower = building.top(),
                                     .upper = tank,
                                     .law = {.stiffness = 0.8 * MN / m, .scale = 20 * cm, .damping = 8 * kN * s / m}});
  add(model, Moat{.around = building.base,
                  .clearance = 25 * cm,
                  .law = ExactHertzDamp{.stiffness = 1e10 * N / m_3_2, .restitution = 0.65},
                  .sides = Sides::right});

  const GroundMotion motion = near_fault_pulse().scaled_to_pga(0.4 * g);
  std::printf("%s\n\n", motion.description().c_str());

  Transient analysis{model, motion, {.end = 10 * s}};
  ImpactPrinter printer;
  analysis.attach(printer);

  // The model does not change; the state of the analysis can be read after every step.
  const AnalysisState& state = analysis.state();
  double largest_stretch = 0.0, its_time = 0.0;
  while (!analysis.finished()) {
    analysis.advance();
    const double stretch = std::abs(state.displacement(tank) - state.displacement(building.top()));
    if (stretch > largest_stretch) {
      largest_stretch = stretch;
      its_time = state.time();
    }
  }

  const SolverStatistics& cost = analysis.statistics();
  std::printf("\nThe tank's spring stretches by up to %.1f cm, at %.2f s.\n", 100.0 * largest_stretch, its_time);
  std::printf("%ld steps, %d events, %ld Newton iterations\n", cost.accepted_steps, printer.events,
              cost.newton_iterations);
  return 0;
}
