// Bodies that nothing connects do not change each other's peaks.
#include "analyses/unconnected_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "analyses/case_run.hpp"
#include "elements/gap.hpp"
#include "elements/spring.hpp"
#include "materials/impact_laws.hpp"
#include "materials/linear.hpp"
#include "moat_model.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/plan_motion.hpp"
#include "paper_building.hpp"
#include "random_model.hpp"
#include "small_plan_building.hpp"
#include "structures/plan_moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

// 100 kg that hit walls hard.
void add_company(Model& model) {
  const NodeId light = add(model, Node{.name = "company", .mass = 100 * kg});
  add(model, Spring{.name = "spring of company",
                    .lower = ground,
                    .upper = light,
                    .law = Linear{.stiffness = 4 * kN / m, .damping = 10 * N * s / m}});
  const HertzDamp law{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65};
  add(model, Gap{.name = "right of company", .left = light, .right = ground, .clearance = 1 * cm, .law = law});
  add(model, Gap{.name = "left of company", .left = ground, .right = light, .clearance = 1 * cm, .law = law});
}

// Every peak of the first run is in the second, with the same value, time and side.
void expect_same_peaks(const std::vector<Peak>& alone, const std::vector<Peak>& with_company) {
  constexpr double round_off = 1e-10;
  for (const Peak& peak : alone) {
    const auto same = std::ranges::find_if(
        with_company, [&](const Peak& other) { return other.quantity == peak.quantity && other.where == peak.where; });
    ASSERT_NE(same, with_company.end()) << peak.quantity << " of " << peak.where;
    EXPECT_NEAR(same->value, peak.value, round_off * peak.magnitude()) << peak.quantity << " of " << peak.where;
    EXPECT_NEAR(same->time, peak.time, 1e-9) << peak.quantity << " of " << peak.where;
    EXPECT_EQ(same->side, peak.side) << peak.quantity << " of " << peak.where;
  }
}

void expect_same_clearances(const std::vector<GapClearance>& alone, const std::vector<GapClearance>& with_company) {
  constexpr double round_off = 1e-11;  // m
  for (const GapClearance& gap : alone) {
    const auto same = std::ranges::find(with_company, gap.where, &GapClearance::where);
    ASSERT_NE(same, with_company.end()) << gap.where;
    EXPECT_NEAR(same->left, gap.left, round_off) << gap.where;
  }
}

TEST(UnconnectedBodies, DoNotChangePeaksOfRandomModels) {
  int pounding = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const PlainModel plain = random_model(seed);
    const GroundMotion motion = moat_motion(plain.motion);
    Model alone = moat_model(plain), with_company = moat_model(plain);
    add_company(with_company);
    const PeaksAndImpacts first = compute_peaks(alone, motion, {}), second = compute_peaks(with_company, motion, {});
    EXPECT_GT(second.peaks.size(), first.peaks.size());
    expect_same_peaks(first.peaks, second.peaks);
    expect_same_clearances(first.clearances, second.clearances);
    // Company that hits nothing would prove nothing.
    pounding += second.touches.size() > first.touches.size() + 2 ? 1 : 0;
  }
  EXPECT_GT(pounding, 8);
}

Model isolated_building() {
  Model model;
  const Building nodes = add(model, paper_building());
  add(model, Moat{.around = nodes.base, .clearance = 5 * cm, .law = paper_hertz_damp()});
  return model;
}

GroundMotion pulse() { return near_fault_pulse().scaled_to_pga(0.4 * g); }

TEST(UnconnectedBodies, DoNotChangePeaksOfARunWithErrorBars) {
  Model alone = isolated_building(), with_company = isolated_building();
  add_company(with_company);
  const CaseResult first = run_case(alone, pulse()), second = run_case(with_company, pulse());
  expect_same_peaks(first.peaks, second.peaks);
  expect_same_clearances(first.clearances, second.clearances);
  EXPECT_GT(second.impacts.size(), first.impacts.size() + 2);
  const auto about_bodies = [](const std::string& text) { return text.starts_with("Nothing connects 2 bodies"); };
  EXPECT_TRUE(std::ranges::any_of(second.assumptions, about_bodies));
  EXPECT_FALSE(std::ranges::any_of(first.assumptions, about_bodies));
  ASSERT_TRUE(second.error_bars.checked);
  for (const Peak& peak : second.peaks) EXPECT_TRUE(std::isfinite(peak.error)) << peak.quantity << " of " << peak.where;
}

TEST(UnconnectedBodies, ShareStepsWithAWarningWhereTheirOwnRunsAreStopped) {
  Model model = isolated_building();
  add_company(model);
  CaseRun run{model, pulse(), {}};
  run.stop_when([&] { return run.transient().finished(); });
  run.run();
  EXPECT_FALSE(run.stopped());
  const CaseResult result = run.result();
  EXPECT_TRUE(std::ranges::any_of(result.warnings, [](const std::string& warning) {
    return warning.find("share their steps in these results") != std::string::npos;
  }));
  EXPECT_GT(std::ranges::find(result.peaks, "displacement", &Peak::quantity)->magnitude(), 0.01);
}

void add_tower(Model& model, const std::string& name, Length clearance) {
  const LeadRubberBearing bearing{
      .yield_force = 500 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 4 * MN / m};
  PlanBuilding building = small_plan_building(1, bearing);
  building.name = name;
  const auto nodes = add(model, with_eccentricity(building, 0.05, 0.04));
  add(model, PlanMoat{.name = name + " moat",
                      .around = nodes.base,
                      .clearance = clearance,
                      .law = HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                      .friction = 0.2});
}

PlanMotion oblique() { return {pulse(), pulse().scaled_by(0.5), 20 * deg}; }

TEST(UnconnectedBodies, DoNotChangePeaksInPlan) {
  Model alone, with_company;
  add_tower(alone, "East", 8 * cm);
  add_tower(with_company, "East", 8 * cm);
  add_tower(with_company, "West", 5 * cm);
  const PlanMotion motion = oblique();
  const PeaksAndImpacts first = compute_peaks(alone, motion, {}), second = compute_peaks(with_company, motion, {});
  EXPECT_FALSE(first.touches.empty());
  EXPECT_GT(second.touches.size(), first.touches.size());
  expect_same_peaks(first.peaks, second.peaks);
  expect_same_clearances(first.clearances, second.clearances);
}

// A body that is taken out of a moving model goes on as it would have done there: histories of bearings, contacts in
// progress and grips of corners are all copied.
void expect_to_go_on(const Model& model, const GroundMotion& motion, double until, double end) {
  Model whole = model;
  TransientOptions options;
  options.tolerance = 1e-8;
  options.steps_per_contact = 128;
  options.end = until * s;
  Transient{whole, motion, options}.run();
  std::vector<Model> bodies = whole.unconnected_bodies();
  ASSERT_FALSE(bodies.empty());
  options.end = end * s;
  Transient{whole, motion, options}.run();
  int nodes = 0;
  for (Model& body : bodies) Transient{body, motion, options}.run();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (int node = 0; node < bodies[i].node_count(); ++node) {
      const NodeId in_body{node};
      const Node& its = bodies[i].node(in_body);
      const auto same = std::ranges::find(whole.nodes(), its.name, &Node::name);
      const NodeId in_whole{static_cast<int>(same - whole.nodes().begin())};
      EXPECT_NEAR(bodies[i].displacement(in_body), whole.displacement(in_whole), 1e-5) << its.name;
      EXPECT_NEAR(bodies[i].velocity(in_body), whole.velocity(in_whole), 2e-4) << its.name;
      ++nodes;
    }
  EXPECT_EQ(nodes, whole.node_count());
}

TEST(UnconnectedBodies, GoOnFromTheStateOfTheirModel) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const PlainModel plain = random_model(seed);
    Model model = moat_model(plain);
    add_company(model);
    expect_to_go_on(model, moat_motion(plain.motion), 0.5 * plain.end, 0.5 * plain.end + 0.25);
  }
}

TEST(UnconnectedBodies, GoOnInPlan) {
  Model model;
  add_tower(model, "East", 8 * cm);
  add_tower(model, "West", 5 * cm);
  // These instants lie before, in and after contacts.
  for (const double until : {1.0, 1.5, 2.0, 2.5, 3.0}) expect_to_go_on(model, oblique(), until, until + 0.25);
}

}  // namespace
}  // namespace moat::testing
