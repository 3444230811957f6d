// Options of analyses, and models that no analysis can compute.
#include <gtest/gtest.h>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

Model one_mass() {
  Model model;
  add(model, Node{.name = "mass", .mass = 1 * kg, .free = true});
  return model;
}
std::function<void()> options(const TransientOptions& options) {
  return [options] {
    const Model model = one_mass();
    Transient(model, still_ground(1 * s), options);
  };
}
std::function<void()> cases(const CaseOptions& options) {
  return [options] {
    const Model model = one_mass();
    CaseRun(model, still_ground(1 * s), options);
  };
}
std::function<void()> floor_spectra(const FloorSpectraOptions& options) {
  return [options] {
    const Model model = one_mass();
    FloorSpectra spectra{options};
    CaseRun run{model, still_ground(1 * s)};
    run.attach(spectra);
    run.run();
  };
}
template <class Build>
std::function<void()> model(Build build, const GroundMotion& motion = still_ground(1 * s)) {
  return [build, motion] {
    Model model;
    build(model);
    Transient(model, motion).run();
  };
}

}  // namespace

Constructions analyses() {
  return {
      {"a step before it begins",
       options({.step = -1 * ms}),
       {"TransientOptions", "step", "-0.001 s", ">= 0 s and finite", "Check its sign and its unit"}},
      {"a tolerance below round-off",
       options({.tolerance = 1e-17}),
       {"TransientOptions", "tolerance", "1e-17", ">= 1e-12 and < 1",
        "3e-05 is the default; below 1e-12 is round-off"}},
      {"a contact in three steps",
       options({.steps_per_contact = 3}),
       {"TransientOptions", "steps_per_contact", "3", ">= 4", "Give a number in this range"}},
      {"a longest step of no number",
       options({.largest_step = not_a_number * s}),
       {"TransientOptions", "largest_step", "nan s", ">= 0 s and finite", "division by zero"}},
      {"a step halved forty-one times",
       options({.max_halvings = 41}),
       {"TransientOptions", "max_halvings", "41", "from 0 to 40", "Give a number in this range"}},
      {"an end before the start",
       options({.end = -1 * s}),
       {"TransientOptions", "end", "-1 s", ">= 0 s and finite", "Check its sign and its unit"}},
      {"an end after the age of the world",
       options({.end = 1e17 * s}),
       {"TransientOptions", "number of steps (end / step)", "1e+19", "<= 1e9",
        "Take a longer step (now 0.01 s) or an earlier end (now"}},
      {"forces that need not balance",
       options({.force_tolerance = 1}),
       {"TransientOptions", "force_tolerance", "1", "> 0 and < 1", "Give a number in this range"}},
      {"no iteration",
       options({.max_iterations = 0}),
       {"TransientOptions", "max_iterations", "0", ">= 1", "Give a number in this range"}},
      {"a step cut less than never",
       options({.max_cuts = -1}),
       {"TransientOptions", "max_cuts", "-1", ">= 0", "Give a number in this range"}},
      {"events located exactly",
       options({.location_tolerance = 0 * m}),
       {"TransientOptions", "location_tolerance", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"no event a second",
       options({.max_events_per_second = 0}),
       {"TransientOptions", "max_events_per_second", "0", ">= 1", "Give a number in this range"}},
      {"newmark beyond one half",
       options({.integrator = Newmark{.beta = 0.6}}),
       {"TransientOptions", "integrator.beta", "0.6", "> 0 and <= 0.5",
        "Use Newmark::average_acceleration(), linear_acceleration()"}},
      {"newmark corrected at average acceleration",
       options({.integrator = Newmark{.beta = 0.25, .corrects_velocity = true}}),
       {"TransientOptions", "integrator.beta", "0.25", "1/12 with corrects_velocity", "Use Newmark::fourth_order()"}},
      {"hht-alpha that feeds",
       options({.integrator = HilberHughesTaylor{.alpha = 0.1}}),
       {"TransientOptions", "integrator.alpha", "0.1", ">= -1/3 and <= 0", "-0.1 damps a little"}},
      {"generalized alpha of radius 1.5",
       options({.integrator = GeneralizedAlpha{.spectral_radius = 1.5}}),
       {"TransientOptions", "integrator.spectral_radius", "1.5", ">= 0 and <= 1",
        "0.8 damps a little; 1 damps nothing"}},
      {"exact steps of a given length",
       options({.integrator = ExactBetweenEvents{}, .step = 1 * ms}),
       {"TransientOptions", "step", "0.001 s", "0 s with ExactBetweenEvents{}", "Its steps adapt themselves"}},
      {"exact steps of a law that is not linear",
       [] {
         Model model;
         const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
         add(model, Isolator<BoucWen>{.upper = body, .law = BoucWen::typical()});
         Transient(model, still_ground(1 * s), {.integrator = ExactBetweenEvents{}});
       },
       {"TransientOptions", "integrator", "ExactBetweenEvents{}", "linear between located events", "Use Newmark{}"}},
      {"automatic steps of a law that is not linear",
       [] {
         Model model;
         const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
         add(model, Isolator<BoucWen>{.upper = body, .law = BoucWen::typical()});
         Transient analysis{model, still_ground(1 * s), {.integrator = Automatic{}}};
         analysis.run();
         EXPECT_EQ(analysis.state().displacement(body), 0.0);
       }},
      {"histories before they happen",
       cases({.title = "case", .history_interval = -1 * s}),
       {"CaseOptions \"case\"", "history_interval", "-1 s", ">= 0 s and finite", "Check its sign and its unit"}},
      {"an energy error of no size",
       cases({.title = "case", .warn_above_energy_error = 0}),
       {"CaseOptions \"case\"", "warn_above_energy_error", "0", "> 0 and finite", "Give a number in this range"}},
      {"spectra of a floor that is not there",
       floor_spectra({.floors = {"msas"}}),
       {"FloorSpectra", "floor", "msas", "It has", "\"mass\""}},
      {"spectra of a floor twice",
       floor_spectra({.floors = {"mass", "mass"}}),
       {"FloorSpectra", "floors", "mass", "twice", "Name it once"}},
      {"spectra with negative damping",
       floor_spectra({.floors = {"mass"}, .dampings = {-0.05}}),
       {"FloorSpectra", "dampings", "-0.05", ">= 0 and < 1", "Give 5 % as 0.05"}},
      {"spectra without damping ratio",
       floor_spectra({.floors = {"mass"}, .dampings = {}}),
       {"FloorSpectra", "dampings", "is empty", "Leave it out", "5 %"}},
      {"spectra of periods that fall",
       floor_spectra({.floors = {"mass"}, .periods = {1 * s, 0.5 * s}}),
       {"FloorSpectra", "periods", "do not ascend", "Give each once", "the shortest first"}},
      {"spectra of corners on a line",
       floor_spectra({.floors = {"mass"}, .corners = true}),
       {"FloorSpectra", "corners", "no floor has any", "Give", "Diaphragm::outline"}},
      {"an analysis of nothing",
       model([](Model&) {}),
       {"Model", "there is", "no node", "Add nodes", "add(model, Node{...})"}},
      {"a body that gaps alone hold",
       model([](Model& all) {
         const NodeId body = add(all, Node{.name = "body", .mass = 1 * kg});
         add(all, Gap<Hertz>{.name = "west",
                             .left = body,
                             .right = ground,
                             .clearance = 1 * m,
                             .law = {.stiffness = 1e9 * N / m_3_2}});
       }),
       {"Model", "body", "held by nothing", "Add the missing spring", "a gap holds nothing"}},
      {"a model on a line under a pair",
       model([](Model& all) { add(all, Node{.name = "body", .mass = 1 * kg, .free = true}); },
             PlanMotion{still_ground(1 * s), still_ground(1 * s)}),
       {"Transient \"still ground + still ground\"", "motion", "two components", "the model moves on a line",
        "Give one component"}},
      {"a loop of two points",
       [] {
         static_cast<void>(effective_properties(std::vector{0.0, 1.0}, std::vector{0.0, 1.0}));
       },
       {"EffectiveProperties", "a loop needs", "at least three", "points", "Give some hundred points"}},
      {"a loop without width",
       [] {
         static_cast<void>(effective_properties(std::vector{1.0, 1.0, 1.0}, std::vector{0.0, 1.0, 2.0}));
       },
       {"EffectiveProperties", "the loop", "has no width", "Give the deformations and forces", "one full cycle"}},
      {"no force at all for 1e6 s",
       [] {
         Model model;
         const NodeId body =
             add(model, Node{.name = "body", .mass = 1 * kg, .initial_velocity = 1 * m / s, .free = true});
         Transient analysis{model, GroundMotion{"still", 1000.0, {0.0, 0.0}}, {.end = 1e6 * s}};
         analysis.run();
         EXPECT_NEAR(analysis.state().displacement(body), 1e6, 1e-3);
       }},
  };
}

}  // namespace moat::constructions
