// Results of elements at the end of every step: they belong to the motion that was committed.

#include <gtest/gtest.h>

#include "analyses/time_history/transient.hpp"
#include "analysis_testing.hpp"
#include "elements/line/lead_rubber_bearing.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/viscous_damper.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {
namespace {

using namespace units;
using testing::constant_acceleration;

constexpr double storey_stiffness = 80e6, damping = 90e3;

// The blocks are, in this order: storeys, dampers, bearings.
enum Block : std::size_t { storeys, dampers, bearings };

Model isolated_storey() {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 50 * tonne});
  const NodeId floor = add(model, Node{.name = "floor", .mass = 40 * tonne});
  add(model, ShearSpring{.name = "storey", .lower = base, .upper = floor, .stiffness = storey_stiffness * N / m});
  add(model, ViscousDamper{.name = "damper", .lower = base, .upper = floor, .damping = damping * N * s / m});
  add(model, LeadRubberBearing{.name = "bearing",
                               .upper = base,
                               .yield_force = 40 * kN,
                               .yield_displacement = 1 * cm,
                               .post_yield_stiffness = 400 * kN / m});
  return model;
}

// Compares results with the motion of the nodes.
class Reader final : public StepObserver {
 public:
  void start(const StepView&) override {}
  void step(const StepView& view) override {
    ++steps;
    for (const std::size_t block : {storeys, dampers, bearings})
      EXPECT_TRUE(is_up_to_date(view.state, block)) << "block " << block;
  }
  void finish(const StepView& view) override { step(view); }

  int steps = 0;

 private:
  static bool is_up_to_date(const AnalysisState& state, std::size_t block) {
    const Vector &u = state.motion().displacement, &v = state.motion().velocity, &a = state.motion().acceleration;
    const ResultsOf<double> results = state.elements(block).results().line;
    const int upper = block == bearings ? 0 : 1, lower = block == bearings ? 2 : 0;  // 2: the ground
    const double rate = v[upper] - v[lower];
    if (results.deformations[0] != u[upper] - u[lower]) return false;
    // Their rate is that with which the step was solved, before its velocity was corrected.
    if (block == bearings) return true;
    if (results.rates[0] != rate) return false;
    const double force = block == storeys ? storey_stiffness * (u[1] - u[0]) : damping * rate,
                 force_rate = block == storeys ? storey_stiffness * rate : damping * (a[1] - a[0]);
    return results.forces[0] == force && results.force_rates[0] == force_rate;
  }
};

GroundMotion push() { return constant_acceleration(2.0, 1 * s); }

TEST(ResultsOfElements, FollowTheCommittedMotion) {
  for (const Integrator& integrator : {Integrator{Newmark{}}, Integrator{HilberHughesTaylor{}}}) {
    Model model = isolated_storey();
    Transient analysis{model, push(), {.integrator = integrator}};
    Reader reader;
    analysis.attach(reader);
    analysis.run([&] { return analysis.state().time() > 0.5; });
    // By hand, results may be read between the steps.
    while (!analysis.finished()) {
      analysis.advance();
      reader.step({model, analysis.state()});
    }
    EXPECT_GT(reader.steps, 20);
  }
}

}  // namespace
}  // namespace moat
