// Changes of regime inside steps give the same results as located ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "analysis_testing.hpp"
#include "elements/contact/gap.hpp"
#include "materials/impact/kelvin_by_damping_ratio.hpp"
#include "materials/impact/linear_elastic.hpp"
#include "materials/impact/nonlinear_viscoelastic.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

// Isolated buildings in a row between two fixed walls, all different, all moving at the start.
template <class Law>
Model street(int buildings, const Law& law) {
  Model model;
  NodeId left = ground;
  const auto clearance = [](int number) { return (2.5 + 2.0 * std::sin(1.7 * number)) * cm; };
  for (int number = 1; number <= buildings; ++number) {
    ShearBuilding building = paper_building(std::to_string(number));
    building.storeys = 2;
    building.floor_mass = floor_mass * (1.0 + 0.3 * std::sin(2.3 * number)) * kg;
    LeadRubberBearing bearings = paper_bearings();
    bearings.post_yield_stiffness = post_yield_stiffness * (1.0 + 0.3 * std::cos(3.1 * number)) * N / m;
    building.isolation = bearings;
    const NodeId base = add(model, building).base;
    add(model, Gap<Law>{.name = "gap " + std::to_string(number),
                        .left = left,
                        .right = base,
                        .clearance = clearance(number),
                        .law = law});
    left = base;
  }
  add(model, Gap<Law>{.name = "last gap", .left = left, .right = ground, .clearance = clearance(0), .law = law});
  model.prepare();
  MotionState& state = model.trial();
  for (int i = 0; i < model.degrees_of_freedom(); ++i) state.velocity[i] = 0.5 * std::sin(1.0 + 2.0 * (i / 3));
  model.evaluate();
  model.commit();
  return model;
}

GroundMotion shaking() {
  std::vector<double> samples(201);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = 3.0 * std::sin(0.04 * static_cast<double>(i));
  return {"sine", 0.01, samples};
}

CaseResult run(Model model, EventTreatment events) {
  return run_case(model, shaking(),
                  {.transient = {.tolerance = 1e-7, .steps_per_contact = 512, .events = events},
                   .error_bars = ErrorBarMode::never});
}

// Of restitution and peaks, relative: errors are those of a step of 1/512 of a contact, some 1e-6, and every impact
// amplifies those of the ones before it.
constexpr double alike = 1e-3;

void expect_alike(const CaseResult& inside, const CaseResult& located) {
  ASSERT_EQ(inside.impacts.size(), located.impacts.size());
  ASSERT_GT(located.impacts.size(), 5u);
  for (std::size_t i = 0; i < located.impacts.size(); ++i) {
    const Impact &one = inside.impacts[i], &other = located.impacts[i];
    EXPECT_EQ(one.where, other.where) << i;
    EXPECT_NEAR(one.start, other.start, 1e-4) << i;
    ASSERT_EQ(std::isnan(one.rebound_ratio), std::isnan(other.rebound_ratio)) << i;
    if (std::isnan(one.rebound_ratio)) continue;
    EXPECT_NEAR(one.rebound_ratio, other.rebound_ratio, alike) << other.where << " at " << other.start;
  }
  ASSERT_EQ(inside.peaks.size(), located.peaks.size());
  for (std::size_t i = 0; i < located.peaks.size(); ++i) {
    EXPECT_NEAR(inside.peaks[i].magnitude(), located.peaks[i].magnitude(), alike * located.peaks[i].magnitude())
        << located.peaks[i].quantity << " " << located.peaks[i].where;
  }
}

TEST(InsideTheStep, ThreeBuildingsPoundAlike) {
  const Model model = street(3, paper_hertz_damp());
  expect_alike(run(model, EventTreatment::inside_the_step), run(model, EventTreatment::located));
}

TEST(InsideTheStep, AStreetOfTenPoundsAlike) {
  const Model model = street(10, paper_hertz_damp());
  expect_alike(run(model, EventTreatment::inside_the_step), run(model, EventTreatment::located));
}

// At default tolerances, with laws whose forces have a corner, a finite and an infinite slope at touch. A force that
// counts at the end of its first step alone makes errors of some hundredths there.
template <class Law>
void expect_peaks_at_default_tolerances(const Law& law) {
  const Model model = street(60, law);
  const CaseResult tight = run(model, EventTreatment::located);
  for (const EventTreatment events : {EventTreatment::automatic, EventTreatment::inside_the_step}) {
    Model copy = model;
    const CaseResult result =
        run_case(copy, shaking(), {.transient = {.events = events}, .error_bars = ErrorBarMode::never});
    // By default the events of small models are located.
    if (events == EventTreatment::automatic)
      EXPECT_EQ(result.solver.changes_inside, 0);
    else
      EXPECT_GT(result.solver.changes_inside, 100);
    EXPECT_GT(result.impacts.size(), 60U);
    ASSERT_EQ(result.peaks.size(), tight.peaks.size());
    for (std::size_t i = 0; i < tight.peaks.size(); ++i)
      EXPECT_NEAR(result.peaks[i].magnitude(), tight.peaks[i].magnitude(), 1e-3 * tight.peaks[i].magnitude())
          << tight.peaks[i].quantity << " " << tight.peaks[i].where;
  }
}

TEST(InsideTheStep, HasThePeaksOfLocatedTouchesAtDefaultTolerances) {
  expect_peaks_at_default_tolerances(paper_hertz_damp());
  expect_peaks_at_default_tolerances(LinearElastic{.stiffness = 1 * GN / m});
  expect_peaks_at_default_tolerances(NonlinearViscoelastic{.stiffness = 10e9 * N / m_3_2, .restitution = 0.5});
}

TEST(InsideTheStep, ALawWhoseForceJumpsPoundsAlike) {
  for (const bool may_pull : {false, true}) {
    SCOPED_TRACE(may_pull);
    const Model model =
        street(3, KelvinByDampingRatio{.stiffness = 5e8 * N / m, .damping_ratio = 0.14, .may_pull = may_pull});
    expect_alike(run(model, EventTreatment::inside_the_step), run(model, EventTreatment::located));
  }
}

TEST(InsideTheStep, AGapThatPullsUntilItOpensLetsGoAlike) {
  // The force jumps where the gap opens; half a step of it would be 1e-3 of the rebound.
  for (const double clearance : {12.3, 13.7, 15.2, 17.9}) {
    Model model;
    const NodeId body = add(model, Node{.name = "body", .mass = 1e5 * kg, .initial_velocity = 1 * m / s});
    add(model, Gap{.name = "wall",
                   .left = body,
                   .right = ground,
                   .clearance = clearance * mm,
                   .law = KelvinByDampingRatio{.stiffness = 1e9 * N / m, .damping_ratio = 0.14, .may_pull = true}});
    const CaseResult result =
        run_case(model, still_ground(1 * s),
                 {.transient = {.steps_per_contact = 512, .events = EventTreatment::inside_the_step},
                  .error_bars = ErrorBarMode::never});
    ASSERT_EQ(result.impacts.size(), 1u);
    EXPECT_NEAR(-model.state().velocity[0], std::exp(-std::acos(-1.0) * 0.14 / std::sqrt(1.0 - 0.14 * 0.14)),
                std::pow(3.2 / 512.0, 2));
  }
}

// The largest error of the rebound of a free body from a wall with this law, over touches at all places of a step. The
// body comes with 1 m/s; fixed steps, this many in the duration of an elastic contact of that stiffness.
template <class Law>
double largest_rebound_error(const Law& law, double exact, int steps_per_contact, const Integrator& integrator) {
  constexpr double mass = 1e5, stiffness = 1e9;
  const double step = std::acos(-1.0) * std::sqrt(mass / stiffness) / steps_per_contact;
  constexpr int places = 16;
  double largest = 0.0;
  for (int place = 0; place < places; ++place) {
    Model model;
    const NodeId body = add(model, Node{.name = "body", .mass = mass * kg, .initial_velocity = 1 * m / s});
    add(model, Gap<Law>{.name = "wall",
                        .left = body,
                        .right = ground,
                        .clearance = (3.0 + (place + 0.5) / places) * step * m,
                        .law = law});
    Transient analysis{model,
                       still_ground(1 * s),
                       {.integrator = integrator,
                        .step = step * s,
                        .end = (4 + 2 * steps_per_contact) * step * s,
                        .events = EventTreatment::inside_the_step}};
    analysis.run();
    EXPECT_GE(analysis.statistics().changes_inside, 2);
    largest = std::max(largest, std::abs(-model.state().velocity[0] - exact));
  }
  return largest;
}

// A force that begins or ends inside a step has its whole impulse. Without the part that the scheme leaves out the
// rebound would have errors of (pi/32)^2/12 = 8e-4, and of second order. (Average acceleration conserves the energy of
// this contact.)
TEST(InsideTheStep, TheReboundKeepsTheOrderOfTheScheme) {
  const LinearElastic elastic{.stiffness = 1 * GN / m};
  for (const Integrator& integrator :
       {Integrator{Newmark::fourth_order()}, Integrator{Newmark::average_acceleration()}}) {
    const double coarse = largest_rebound_error(elastic, 1.0, 32, integrator),
                 fine = largest_rebound_error(elastic, 1.0, 128, integrator);
    EXPECT_LT(coarse, 1e-5);
    EXPECT_LT(fine, coarse / std::pow(4.0, 3.5));
  }
}

TEST(InsideTheStep, AFreeBodyReboundsAlike) {
  // Against a wall at 1 m/s, with the restitution of the law either way. The touch is located; the force is zero where
  // the contact ends and only bends there, which costs the square of a step.
  for (const EventTreatment events : {EventTreatment::located, EventTreatment::inside_the_step}) {
    Model model;
    const NodeId body = add(model, Node{.name = "body", .mass = 1e5 * kg, .initial_velocity = 1 * m / s});
    add(model, Gap{.name = "wall",
                   .left = body,
                   .right = ground,
                   .clearance = 12.3 * mm,
                   .law = KelvinByDampingRatio{.stiffness = 1e9 * N / m, .damping_ratio = 0.14}});
    const CaseResult result =
        run_case(model, still_ground(1 * s),
                 {.transient = {.steps_per_contact = 512, .events = events}, .error_bars = ErrorBarMode::never});
    const double angle = std::acos(0.14);  // see KelvinByDampingRatio
    ASSERT_EQ(result.impacts.size(), 1u);
    EXPECT_NEAR(result.impacts[0].rebound_ratio, std::exp(-2.0 * angle / std::tan(angle)), std::pow(3.2 / 512.0, 2));
    EXPECT_NEAR(result.impacts[0].start, 12.3e-3, 1e-12);
  }
}

}  // namespace
}  // namespace moat
