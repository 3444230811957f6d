// A step that never balances: cut, then given up with everything a user needs to know.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "analysis_testing.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using testing::still_ground;

// A linear spring whose force has, above a deformation, the value `beyond`.
struct Brittle {
  double stiffness = 1e6;
  double largest_deformation = 0.05;
  double beyond = std::numeric_limits<double>::quiet_NaN();

  using State = NoState;

  Response evaluate(const State&, double deformation, double, State&) const {
    if (deformation > largest_deformation) return {beyond, stiffness, 0.0};
    return {stiffness * deformation, stiffness, 0.0};
  }
  double stored_energy(const State&, double) const { return 0.0; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return stiffness; }
};

// Nothing up to 53.7 mm and a push far too large beyond: any step across has its end on the wrong side of the edge,
// with the push and without it.
struct Edge {
  using State = NoState;

  static constexpr double place = 0.0537;

  Response evaluate(const State&, double deformation, double, State&) const {
    return {deformation > place ? 1e15 : 0.0, 1.0, 0.0};
  }
  double stored_energy(const State&, double) const { return 0.0; }
  double dissipation_rate(const State&, double, double) const { return 0.0; }
  double linear_stiffness(StiffnessStage) const { return 1.0; }
};

// Two masses that move at 1 m/s; the second pulls at the law and reaches 5 cm at t = 0.05 s.
template <class Law>
Model pulling(const Law& law) {
  Model model;
  add(model, Node{.name = "bystander", .mass = 1000 * kg, .initial_velocity = 1 * m / s});
  const NodeId puller = add(model, Node{.name = "puller", .mass = 1e9 * kg, .initial_velocity = 1 * m / s});
  model.register_element("Spring", "nasty");
  model.block<LinkBlock<Law>>().add({.name = "nasty",
                                     .place = "nasty",
                                     .first = ground,
                                     .second = puller,
                                     .deformation_quantity = "stretch",
                                     .force_quantity = "pull"},
                                    law);
  return model;
}

ConvergenceError failure_of(CaseRun& run) {
  try {
    run.run();
  } catch (const ConvergenceError& error) {
    return error;
  }
  ADD_FAILURE() << "the analysis did not fail";
  return ConvergenceError{"", 0.0, 0.0, 0.0, ""};
}

TEST(FailingStep, NamesTimeStepResidualAndWorstNode) {
  Model model = pulling(Edge{});
  CaseRun run{model, still_ground(1 * s), {.transient = {.step = 10 * ms, .max_iterations = 5, .max_cuts = 3}}};
  const ConvergenceError error = failure_of(run);
  // Every step that stays before the edge is accepted; the last one starts closer to it than its own length.
  EXPECT_LE(error.step, 0.01 / 8.0);
  EXPECT_GT(error.time + error.step, Edge::place);
  EXPECT_LT(error.time, Edge::place);
  EXPECT_EQ(error.time, run.transient().state().time());
  EXPECT_NEAR(error.residual, 1.0, 1e-6);
  EXPECT_EQ(error.worst_place, "puller");
  const std::string message = error.what();
  const std::string start = "The step from t = " + to_text(error.time) + " s did not converge although it was cut to " +
                            to_text(error.step) + " s: the forces are out of balance by ";
  EXPECT_TRUE(message.starts_with(start)) << message;
  EXPECT_TRUE(
      message.ends_with(" of the largest force there (allowed: 1e-08), worst at \"puller\". Check the parameters of "
                        "the elements there; results up to this time are kept."))
      << message;
}

TEST(FailingStep, AForceThatIsNotANumberIsAFailureWithAPlace) {
  for (const double beyond : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Model model = pulling(Brittle{.beyond = beyond});
    CaseRun run{model, still_ground(1 * s), {.transient = {.step = 10 * ms, .max_cuts = 2}}};
    const ConvergenceError error = failure_of(run);
    EXPECT_EQ(error.worst_place, "puller") << beyond;
    EXPECT_TRUE(std::isnan(error.residual)) << beyond;
    EXPECT_LE(error.time, 0.0501) << beyond;
    // Cut twice, so the last accepted state is closer than a quarter of the step.
    EXPECT_GT(error.time, 0.05 - 0.0026) << beyond;
    EXPECT_TRUE(run.transient().state().motion().displacement.allFinite()) << beyond;
    const std::string message = error.what();
    EXPECT_NE(message.find("worst at \"puller\""), std::string::npos) << message;
  }
}

TEST(FailingStep, WhatWasComputedBeforeIsKept) {
  Model model = pulling(Brittle{});
  std::optional<CaseRun> run;
  run.emplace(model, still_ground(1 * s), CaseOptions{.title = "fails", .transient = {.step = 10 * ms}});
  const ConvergenceError error = failure_of(*run);
  EXPECT_EQ(run->transient().state().time(), error.time);
  const CaseResult copied = run->result(), result = take_result(run);
  EXPECT_EQ(result.title, "fails");
  ASSERT_EQ(copied.histories.columns.size(), result.histories.columns.size());
  for (std::size_t i = 0; i < result.histories.columns.size(); ++i)
    EXPECT_EQ(copied.histories.columns[i].values, result.histories.columns[i].values);
  ASSERT_FALSE(result.histories.columns.empty());
  const auto& times = result.histories.columns.front().values;
  ASSERT_GE(times.size(), 5u);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_LE(times.back(), error.time);
  for (const Column& column : result.histories.columns)
    for (const double value : column.values) EXPECT_TRUE(std::isfinite(value)) << column.quantity;
  for (const Peak& peak : result.peaks) {
    EXPECT_TRUE(std::isfinite(peak.value)) << peak.quantity;
    if (peak.quantity == "stretch") {
      EXPECT_NEAR(peak.value, 0.05, 1e-4);
    }
  }
  EXPECT_GT(result.solver.accepted_steps, 0);
  // The committed state is the last good one, and the failure repeats from there.
}

// An observer is finished behind the failure, and reads results of elements.
TEST(FailingStep, LeavesResultsOfTheCommittedState) {
  Model model = pulling(Brittle{});
  Transient analysis{model, still_ground(1 * s), {.step = 10 * ms}};
  EXPECT_THROW(analysis.run(), ConvergenceError);
  const double stretch = analysis.state().displacement(NodeId{1});
  const ElementResult result = analysis.state().elements(0).results()[0];
  EXPECT_EQ(result.deformation, stretch);
  EXPECT_EQ(result.force, Brittle{}.stiffness * stretch);
}

TEST(FailingStep, AStepThatOnlyNeedsCuttingIsAccepted) {
  // Two iterations are too few for the large step around the corner, enough for a shorter one.
  struct Corner {
    using State = NoState;
    Response evaluate(const State&, double deformation, double, State&) const {
      const double push = 1e5 * deformation;
      return {std::sinh(push) * 1e3, std::cosh(push) * 1e8, 0.0};
    }
    double stored_energy(const State&, double) const { return 0.0; }
    double dissipation_rate(const State&, double, double) const { return 0.0; }
    double linear_stiffness(StiffnessStage) const { return 1e8; }
  };
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = 1000 * kg, .initial_velocity = 1 * mm / s});
  model.block<LinkBlock<Corner>>().add({.name = "corner", .place = "corner", .first = ground, .second = node},
                                       Corner{});
  Transient analysis{model, still_ground(0.5 * s), {.step = 100 * ms, .max_iterations = 4}};
  EXPECT_NO_THROW(analysis.run());
  EXPECT_GT(analysis.statistics().rejected_steps, 0);
  EXPECT_TRUE(analysis.finished());
}

// Before the edge the law has no force, and the pulse begins with accelerations of almost nothing: all terms of the
// row vanish together.
TEST(FailingStep, IsNoneWhereAllForcesVanish) {
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1000 * kg, .initial_velocity = 10 * mm / s});
  model.register_element("Spring", "edge");
  model.block<LinkBlock<Edge>>().add({.name = "edge", .first = ground, .second = body}, Edge{});
  Transient analysis{model, near_fault_pulse(), {.end = 0.2 * s}};
  analysis.run();
  EXPECT_EQ(analysis.statistics().rejected_steps, 0);
  EXPECT_LE(analysis.statistics().newton_iterations, 2 * analysis.statistics().accepted_steps);
}

}  // namespace
}  // namespace moat
