// Axial forces of bearings that follow overturning and vertical motion: statics by hand, and coupled motions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "message_of.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;

constexpr double gravity = 9.80665;  // m/s^2

GroundMotion constant_acceleration(double value, double duration = 1.0) { return {"push", duration, {value, value}}; }

// A rigid block on two sliders at -b and +b, its centre of mass at a height above them.
struct Block {
  double weight = 10e6, half_width = 4.0, height = 6.0;  // N, m, m
  FlatSlider left{.friction = 0.3, .yield_displacement = 1 * mm}, right = left;
  AxialForces options{.displaced_weight = false};
  double initial_velocity = 0.0, initial_displacement = 0.0;  // m/s, m

  Model model;
  NodeId node;

  void build() {
    options.base_height = height * m;
    node = add(model, Node{.name = "block",
                           .mass = weight / gravity * kg,
                           .initial_displacement = initial_displacement * m,
                           .initial_velocity = initial_velocity * m / s});
    const auto slider = [&](const char* name, const FlatSlider& law, double at) {
      add(model, Isolator<FlatSlider>{.name = name,
                                      .upper = node,
                                      .law = law,
                                      .weight = 0.5 * weight * N,
                                      .at = at * m,
                                      .weight_changes = true});
    };
    slider("left", left, -half_width);
    slider("right", right, half_width);
    add(model, Building{.name = "block", .base = node, .axial_forces = options});
  }
};

double compression(const AnalysisState& state, std::size_t bearing) {
  return state.weights()[0].bearings()[bearing].compression;
}

// The slip of a bearing that sticks rests.
bool slides(const AnalysisState& state, const WeightOnBearings::Bearing& bearing) {
  return state.elements(bearing.element.block).law_quantity(bearing.element.element, 1).rate != 0.0;
}

TEST(AxialForces, OfAStuckBlockAreThoseOfStatics) {
  Block block;
  block.build();
  Transient analysis{block.model, constant_acceleration(0.5), {.step = 1 * ms}};
  for (int i = 0; i < 50; ++i) {
    analysis.advance();
    const AnalysisState& state = analysis.state();
    const double a = state.acceleration(block.node) + 0.5, tilt = block.weight * a * block.height / (2 * gravity * 4.0);
    ASSERT_NEAR(compression(state, 0), 5e6 + tilt, 1e-10 * block.weight) << i;
    ASSERT_NEAR(compression(state, 1), 5e6 - tilt, 1e-10 * block.weight) << i;
  }
}

// mu 0.05 at -4 m and 0.10 at +4 m: F/W = 0.075/(1 -+ 0.0375). Beside the rigid-plastic way of 1.472215 and 1.586933 m
// the elastic move of 1/2 F/k_0 counts.
TEST(AxialForces, OfASlidingBlockBelongToTheSameInstant) {
  for (const double way : {1.0, -1.0}) {
    Block block;
    block.left.friction = 0.05;
    block.right.friction = 0.10;
    block.left.yield_displacement = block.right.yield_displacement = 0.1 * mm;
    block.initial_velocity = way * 1.5;
    block.build();
    Transient analysis{block.model, constant_acceleration(0.0, 3.0), {}};
    while (analysis.state().time() < 1.0) analysis.advance();
    const double force = -analysis.state().acceleration(block.node) / gravity;
    EXPECT_NEAR(force, way > 0.0 ? 0.0779220779 : -0.0722891566, 1e-9);
    while (!analysis.finished() && way * analysis.state().velocity(block.node) > 0.0) analysis.advance();
    EXPECT_NEAR(way * analysis.state().displacement(block.node), way > 0.0 ? 1.472268 : 1.586982, 2e-6);
    EXPECT_NEAR(analysis.state().time(), way > 0.0 ? 1.962990 : 2.115950, 4e-5);
  }
}

// N' = m h j/(2 b), while friction follows N and j follows friction.
TEST(AxialForces, RatesOfASlidingBlockBelongToItsJerk) {
  Block block;
  block.left.friction = 0.05;
  block.right.friction = 0.10;
  block.left.restoring_stiffness = block.right.restoring_stiffness = 1 * MN / m;
  block.initial_velocity = 1.5;
  block.build();
  Transient analysis{block.model, constant_acceleration(0.0), {}};
  double largest = 0.0;
  while (analysis.state().time() < 0.5) {
    analysis.advance();
    const double expected =
        block.weight / gravity * block.height * analysis.state().jerk(block.node) / (2.0 * block.half_width);
    EXPECT_NEAR(analysis.state().weights()[0].bearings()[0].rate, expected, 1e-9 * block.weight);
    largest = std::max(largest, std::abs(expected));
  }
  EXPECT_GT(largest, 0.1 * block.weight);
}

TEST(AxialForces, UpliftOfAStuckBlockBeginsAtGTimesHalfWidthOverHeight) {
  for (const double factor : {0.999, 1.001}) {
    Block block;
    block.build();
    Transient analysis{block.model, constant_acceleration(0.0), {.step = 1 * ms}};
    AnalysisState state = analysis.state();
    state.return_to_committed_state();
    state.trial().acceleration[0] = factor * gravity * block.half_width / block.height;
    state.evaluate();
    EXPECT_EQ(compression(state, 1) < 1.0, factor > 1.0);  // N
  }
}

// The block on two bearings rocks where one of them lifts: there is no distribution.
TEST(AxialForces, ABlockThatRocksEndsTheAnalysisOrGoesOnByOption) {
  for (const AxialForces::Rocking rocking : {AxialForces::Rocking::stops, AxialForces::Rocking::continues}) {
    Block block;
    block.left.friction = block.right.friction = 0.3;
    block.half_width = 1.0;
    block.height = 8.0;
    block.options.rocking = rocking;
    block.build();
    Transient analysis{block.model, constant_acceleration(3.0), {}};
    if (rocking == AxialForces::Rocking::stops) {
      EXPECT_THROW(analysis.run(), RockingError);
    } else {
      analysis.run();
      EXPECT_GT(analysis.state().weights()[0].rocking_time(), 0.0);
      EXPECT_EQ(analysis.warnings().size(), 1U);
    }
  }
}

// Three bearings carry a moment while one of them is lifted.
TEST(AxialForces, LiftedRubberIsReported) {
  for (const Force may_pull : {0 * N, 1 * MN}) {
    const auto rubber = [](const char* name, Length at) {
      return Isolator<Bilinear>{
          .name = name,
          .law = {.yield_force = 0.6 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 50 * kN / m},
          .at = at};
    };
    Model model;
    add(model,
        ShearBuilding{.storeys = 1,
                      .floor_mass = 500 * tonne,
                      .storey_stiffness = 1 * GN / m,
                      .base_mass = 100 * tonne,
                      .isolation = Isolation{rubber("left", -4 * m), rubber("middle", 0 * m), rubber("right", 4 * m)},
                      .storey_height = 12 * m,
                      .axial_forces = AxialForces{.may_pull = may_pull, .rocking = AxialForces::Rocking::continues}});
    Transient analysis{model, constant_acceleration(3.2), {}};
    analysis.run();
    const auto bearing = analysis.state().weights()[0].bearings();
    EXPECT_EQ(bearing[0].uplifts + bearing[2].uplifts > 0, may_pull.si() == 0.0);
    const std::vector<std::string> warnings = analysis.warnings();
    EXPECT_EQ(std::ranges::any_of(warnings,
                                  [](const std::string& each) {
                                    return each.find("kept their horizontal force") != std::string::npos;
                                  }),
              may_pull.si() == 0.0);
  }
}

// Rubber that pulls, in plan: pushed to the other side, the bearings of both sides change their parts.
TEST(AxialForces, BearingsThatPullInPlanMirror) {
  const auto compressions = [](double push) {
    Model model;
    add(model, PlanBuilding{.outline = rectangle(8 * m, 6 * m),
                            .storeys = 1,
                            .floor_mass = 300 * tonne,
                            .columns = grid(2, 2, StoreyColumn{.stiffness = 200 * MN / m}),
                            .damping = {.ratio = 0.05},
                            .base_mass = 100 * tonne,
                            .bearings = grid(2, 2,
                                             LeadRubberBearing{.yield_force = 0.4 * MN,
                                                               .yield_displacement = 1 * cm,
                                                               .post_yield_stiffness = 200 * kN / m}),
                            .storey_height = 12 * m,
                            .axial_forces = AxialForces{.may_pull = 0.3 * MN}});
    Transient analysis{model, constant_acceleration(push), {}};
    std::vector<double> all;
    while (!analysis.finished()) {
      analysis.advance();
      double sum = 0.0;
      for (std::size_t i = 0; i < 4; ++i) {
        all.push_back(compression(analysis.state(), i));
        sum += all.back();
      }
      EXPECT_NEAR(sum, 400e3 * gravity, 1e-3) << "the bearings carry the weight";
    }
    return all;
  };
  const std::vector<double> right = compressions(4.0), left = compressions(-4.0);
  ASSERT_EQ(right.size(), left.size());
  EXPECT_LT(std::ranges::min(right), -0.03e6) << "they pull";
  for (std::size_t i = 0; i < right.size(); i += 2) {
    ASSERT_NEAR(right[i], left[i + 1], 1.0) << i;
    ASSERT_NEAR(right[i + 1], left[i], 1.0) << i;
  }
}

struct Tower {
  Model model;
  Building building;
};

Tower tower(bool with_axial_forces, const FrictionPendulum& pendulum, AxialForces options = {}) {
  options.base_height = 0.6 * m;
  ShearBuilding design{
      .storeys = 5,
      .floor_mass = 500 * tonne,
      .storey_stiffness = 1 * GN / m,
      .damping = {.ratio = 0.05},
      .base_mass = 550 * tonne,
      .isolation = Isolation{Isolator<FrictionPendulum>{.name = "left", .law = pendulum, .at = -3.5 * m},
                             Isolator<FrictionPendulum>{.name = "right", .law = pendulum, .at = 3.5 * m}},
      .storey_height = 4 * m};
  if (with_axial_forces) {
    design.axial_forces = options;
  } else {
    FrictionPendulum carrying = pendulum;
    carrying.weight = 0.5 * 3050 * tonne * g;
    design.isolation = Isolation{Isolator<FrictionPendulum>{.name = "left", .law = carrying},
                                 Isolator<FrictionPendulum>{.name = "right", .law = carrying}};
  }
  Tower made;
  made.building = add(made.model, design);
  return made;
}

GroundMotion ramp() {
  std::vector<double> samples;
  for (int i = 0; i <= 400; ++i) samples.push_back(1.5 * std::sin(0.02 * i * 3.0));
  return {"ramp", 0.02, samples};
}

// The sum of N is W: equal radii and equal constant friction give the force of a constant weight.
TEST(AxialForces, OfEqualPendulumsDoNotChangeTheirSumWhileAllSlide) {
  const FrictionPendulum pendulum{.radius = 2.2352 * m, .friction = 0.06};
  Tower made = tower(true, pendulum, {.displaced_weight = false});
  const double weight = 3050e3 * gravity;
  Transient analysis{made.model, ramp(), {}};
  int compared = 0;
  while (!analysis.finished()) {
    analysis.advance();
    const AnalysisState& state = analysis.state();
    const WeightOnBearings& on_bearings = state.weights()[0];
    double force = 0.0;
    bool slide = true;
    for (const auto& bearing : on_bearings.bearings()) {
      const ElementStates& elements = state.elements(bearing.element.block);
      force += elements.results()[bearing.element.element].force;
      slide = slide && bearing.compression > 0.0 && slides(state, bearing);
    }
    if (!slide) continue;
    const double d = state.displacement(made.building.base),
                 sense = state.velocity(made.building.base) > 0.0 ? 1.0 : -1.0;
    ASSERT_NEAR(force, weight * (d / 2.2352 + sense * 0.06), 1e-12 * weight);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

// The force of sliding pendulums under a rigid vertical motion is sigma (W d/R + mu W sgn v).
TEST(AxialForces, UnderAVerticalRecordTheForceFollowsTheLoad) {
  const FrictionPendulum pendulum{.radius = 2.2352 * m, .friction = 0.06};
  Tower made = tower(true, pendulum, {.displaced_weight = false});
  std::vector<double> up;
  for (int i = 0; i <= 400; ++i) up.push_back(2.0 * std::sin(i * 1.7));
  const GroundMotion motion = with_vertical(ramp(), {"up", 0.02, up});
  const double weight = 3050e3 * gravity;
  Transient analysis{made.model, motion, {}};
  int compared = 0;
  while (!analysis.finished()) {
    analysis.advance();
    const AnalysisState& state = analysis.state();
    const WeightOnBearings& on_bearings = state.weights()[0];
    const double a = motion.components_at(state.time()).z, v = state.velocity(made.building.base);
    ASSERT_NEAR(on_bearings.load(), weight * (1.0 + a / gravity), 1e-9 * weight);
    if (!slides(state, on_bearings.bearings()[0]) || !slides(state, on_bearings.bearings()[1])) continue;
    double force = 0.0;
    for (const auto& bearing : on_bearings.bearings())
      force += state.elements(bearing.element.block).results()[bearing.element.element].force;
    ASSERT_NEAR(force,
                on_bearings.load() * (state.displacement(made.building.base) / 2.2352 + (v > 0.0 ? 0.06 : -0.06)),
                1e-10 * weight);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

// A constant vertical acceleration is another g: the period of a pendulum is 2 pi sqrt(R/(g + 2)).
TEST(AxialForces, AConstantVerticalAccelerationIsAnotherGravity) {
  Block block;
  block.left = block.right = {.friction = 1e-9, .yield_displacement = 1 * mm};
  const FrictionPendulum pendulum{.radius = 2.2352 * m, .friction = 1e-9};
  Model model;
  const NodeId node = add(model, Node{.name = "block", .mass = 1e6 * kg, .initial_displacement = 0.1 * m});
  for (const double at : {-4.0, 4.0})
    add(model, Isolator<FrictionPendulum>{.name = at < 0 ? "left" : "right",
                                          .upper = node,
                                          .law = pendulum,
                                          .weight = 0.5e6 * gravity * N,
                                          .at = at * m,
                                          .weight_changes = true});
  add(model, Building{.base = node, .axial_forces = AxialForces{.displaced_weight = false}});
  const GroundMotion motion = with_vertical(constant_acceleration(0.0, 4.0), constant_acceleration(2.0, 4.0));
  Transient analysis{model, motion, {.tolerance = 1e-7, .end = 2.7338502 * s}};
  analysis.run();
  EXPECT_NEAR(analysis.state().displacement(node), 0.1, 1e-7);
  EXPECT_NEAR(analysis.state().velocity(node), 0.0, 1e-6);
}

TEST(AxialForces, EnergyClosesWithTheWorkOfTheWeight) {
  const FrictionPendulum pendulum{.radius = 2.2352 * m,
                                  .friction = VelocityPressureDependent{.slow = 0.03,
                                                                        .at_zero_pressure = 0.10,
                                                                        .reduction = 0.05,
                                                                        .pressure_factor = 2.5e-8 * m * m / N,
                                                                        .area = 0.6 * m * m,
                                                                        .rate = 50 * s / m}};
  std::vector<double> up;
  for (int i = 0; i <= 400; ++i) up.push_back(2.0 * std::sin(i * 1.7));
  const GroundMotion motion = with_vertical(ramp(), {"up", 0.02, up});
  for (const double tolerance : {3e-5, 1e-8}) {
    Tower made = tower(true, pendulum, {.sliding_surface = SlidingSurface::above});
    const CaseResult result =
        run_case(made.model, motion, {.transient = {.tolerance = tolerance}, .error_bars = ErrorBarMode::never});
    EXPECT_NE(result.energy.weight_work, 0.0);
    EXPECT_LT(result.energy.error_share(), tolerance > 1e-6 ? 1e-3 : 1e-6);
  }
}

TEST(AxialForces, MirroredTowerHasMirroredForces) {
  const FrictionPendulum pendulum{.radius = 2.2352 * m,
                                  .friction = VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 50 * s / m}};
  const GroundMotion motion = ramp();
  Tower one = tower(true, pendulum), other = tower(true, pendulum);
  Transient a{one.model, motion, {}}, b{other.model, motion.scaled_by(-1.0), {}};
  for (int i = 0; i < 400; ++i) {
    a.advance();
    b.advance();
    ASSERT_NEAR(compression(a.state(), 0), compression(b.state(), 1), 1e-6);
  }
}

TEST(AxialForces, RefuseWhatHasNoMeaning) {
  const FrictionPendulum pendulum{.radius = 2.2352 * m, .friction = 0.06};
  const ShearBuilding good{
      .storeys = 1,
      .floor_mass = 500 * tonne,
      .storey_stiffness = 1 * GN / m,
      .base_mass = 550 * tonne,
      .isolation = Isolation{Isolator<FrictionPendulum>{.name = "left", .law = pendulum, .at = -3.5 * m},
                             Isolator<FrictionPendulum>{.name = "right", .law = pendulum, .at = 3.5 * m}},
      .storey_height = 4 * m,
      .axial_forces = AxialForces{}};
  const auto message = [&](const auto& spoil) {
    ShearBuilding bad = good;
    spoil(bad);
    Model model;
    return testing::message_of([&] { add(model, bad); });
  };
  using Contains = std::string;
  EXPECT_NE(message([](ShearBuilding& b) {
              b.storey_height = PerStorey<Length>::unless_given(3 * m);
            }).find("storey_height is left out"),
            Contains::npos);
  EXPECT_NE(message([](ShearBuilding& b) { b.axial_forces->base_height = -1 * m; }).find("base_height"),
            Contains::npos);
  EXPECT_NE(message([](ShearBuilding& b) { b.axial_forces->vertical_period = 2 * s; }).find("vertical_period"),
            Contains::npos);
  EXPECT_NE(message([](ShearBuilding& b) { b.axial_forces->vertical_damping = 0.02; }).find("without vertical_period"),
            Contains::npos);
  EXPECT_NE(message([](ShearBuilding& b) { b.axial_forces->vertical_damping = 1.0; }).find("vertical_damping"),
            Contains::npos);
  EXPECT_NE(message([&](ShearBuilding& b) { b.isolation = Isolation{pendulum}; }).find("one position"), Contains::npos);
  EXPECT_NE(message([&](ShearBuilding& b) {
              b.isolation = Isolation{Isolator<FrictionPendulum>{.name = "left", .law = pendulum, .at = 1 * m},
                                      Isolator<FrictionPendulum>{.name = "right", .law = pendulum, .at = 3 * m}};
            }).find("pulled at rest"),
            Contains::npos);
  EXPECT_NE(message([&](ShearBuilding& b) {
              b.isolation = Isolation{
                  Isolator<FrictionPendulum>{.name = "left", .law = pendulum, .weight = 1 * MN, .at = -3 * m},
                  Isolator<FrictionPendulum>{.name = "right", .law = pendulum, .weight = 1 * MN, .at = 3 * m}};
            }).find("weights on its bearings"),
            Contains::npos);
  EXPECT_NE(testing::message_of([] {
              Model model;
              add(model, Superstructure{
                             .stiffness = MatrixInUnits{.values = Eigen::MatrixXd::Constant(1, 1, 1e8), .force = 1.0},
                             .freedoms = per_floor(Freedoms::x),
                             .floors = {{.height = 3 * m, .mass = 10 * tonne}},
                             .axial_forces = AxialForces{}});
            }).find("without bearings of its own"),
            Contains::npos);
  Model model;
  add(model, good);
  EXPECT_NE(testing::message_of([&] {
              Transient{model, ramp(), {.integrator = ExactBetweenEvents{}}};
            }).find("ExactBetweenEvents"),
            Contains::npos);
}

}  // namespace
}  // namespace moat
