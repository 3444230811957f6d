// Corners of a free slab that hit walls: closed forms of impulse, and the energy of friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis_testing.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

constexpr double mass = 8e5, inertia = 3.6266666666666667e7, restitution = 0.65;
constexpr double arm_x = 10.0, arm_y = 6.0;

struct FreeSlab {
  explicit FreeSlab(Speed vx, Speed vy = {}, PlanOutline outline = rectangle(20 * m, 12 * m)) {
    slab = add(
        model,
        Diaphragm{
            .name = "slab", .mass = mass * kg, .outline = outline, .initial_velocity_x = vx, .initial_velocity_y = vy});
  }
  // A corner of the slab before the wall at x = 10.01 m, from y = -8 m to 8 m.
  CornerGap<ExactHertzDamp> corner(PlanPosition at = {arm_x * m, arm_y* m}) {
    return {.name = "corner " + std::to_string(++corners),
            .corner = PlanPoint{slab, at},
            .edge_of = ground,
            .edge_begin = PlanPosition{10.01 * m, -8 * m},
            .edge_end = PlanPosition{10.01 * m, 8 * m},
            .law = {.stiffness = 1e9 * N / m_3_2, .restitution = restitution}};
  }
  void add_corner(CornerFriction friction) {
    CornerGap<ExactHertzDamp> gap = corner();
    gap.friction = friction;
    add(model, gap);
  }
  [[nodiscard]] EndedCase run(const TransientOptions& options) const {
    return run_to_end(model, still_ground(1 * s, 5 * ms), {.transient = options, .error_bars = ErrorBarMode::never});
  }
  Model model;
  DiaphragmId slab;
  int corners = 0;
};

TransientOptions tight() { return {.tolerance = 1e-8, .steps_per_contact = 1024}; }

TEST(CornerImpact, WithoutFrictionHasTheImpulseOfTheEffectiveMass) {
  for (const auto& [options, tolerance] : {std::pair{TransientOptions{}, 1e-3}, std::pair{tight(), 1e-5}}) {
    FreeSlab slab{0.6 * m / s};
    slab.add_corner(0.0);
    const auto [result, state] = slab.run(options);
    const double normal_mass = 1.0 / (1.0 / mass + arm_y * arm_y / inertia);
    EXPECT_NEAR(normal_mass, 445901.64, 0.01);
    const double impulse = normal_mass * (1.0 + restitution) * 0.6;
    EXPECT_NEAR(impulse, 441442.62, 0.01);
    EXPECT_NEAR(state.velocity(slab.slab.x), 0.04819672, tolerance * 0.6);
    EXPECT_NEAR(state.velocity(slab.slab.y), 0.0, 1e-12);
    EXPECT_NEAR(state.angular_velocity(slab.slab), 0.07303279, tolerance * 0.073);
    ASSERT_EQ(result.impacts.size(), 1U);
    EXPECT_NEAR(result.impacts[0].energy_lost / 46351.475, 1.0, 3.0 * tolerance);
    EXPECT_NEAR(result.impacts[0].rebound_ratio, restitution, 2.0 * tolerance);
    EXPECT_EQ(result.impacts[0].friction_loss, 0.0);
  }
}

// Sliding throughout. The wall's normal is +x, its tangent +y.
TEST(CornerImpact, WithSlidingFrictionHasTheClosedForm) {
  struct Case {
    double friction, speed, tangential_speed, friction_loss, normal_loss;
  };
  for (const Case& each : {Case{0.4, 0.6, 0.3, 79184.922, 65754.419}, Case{0.4, 0.6, -2.0, 196996.808, 35790.380},
                           Case{0.2, 0.6, 1.0, 126442.097, 54373.846}}) {
    const double sense = each.tangential_speed > 0.0 ? 1.0 : -1.0, mu = each.friction;
    const double normal_mass = 1.0 / (1.0 / mass + arm_y * arm_y / inertia - sense * mu * arm_x * arm_y / inertia);
    const double impulse = normal_mass * (1.0 + restitution) * each.speed;
    const double tangential = each.tangential_speed +
                              impulse * (arm_x * arm_y / inertia - sense * mu * (1.0 / mass + arm_x * arm_x / inertia));
    const double turn = impulse * (arm_y - sense * mu * arm_x) / inertia;
    for (const auto& [options, tolerance] : {std::pair{TransientOptions{}, 1e-3}, std::pair{tight(), 1e-5}}) {
      FreeSlab slab{each.speed * m / s, each.tangential_speed * m / s};
      slab.add_corner({mu, 1e10 * N / m});
      const auto [result, state] = slab.run(options);
      const double vx = state.velocity(slab.slab.x), vy = state.velocity(slab.slab.y),
                   w = state.angular_velocity(slab.slab);
      const double scale = impulse / mass;
      EXPECT_NEAR(vx, each.speed - impulse / mass, tolerance * scale) << mu << " " << each.tangential_speed;
      EXPECT_NEAR(vy, each.tangential_speed - sense * mu * impulse / mass, tolerance * scale);
      EXPECT_NEAR(w, turn, tolerance * impulse * arm_y / inertia);
      EXPECT_NEAR(vy + arm_x * w, tangential, 3.0 * tolerance * scale);
      ASSERT_EQ(result.impacts.size(), 1U);
      const Impact& impact = result.impacts[0];
      EXPECT_NEAR(impact.tangential_speed, each.tangential_speed, 1e-9);
      EXPECT_NEAR(impact.friction_loss / each.friction_loss, 1.0, 4.0 * tolerance);
      EXPECT_NEAR(impact.energy_lost / each.normal_loss, 1.0, 4.0 * tolerance);
      const double kinetic_loss =
          0.5 * mass * (each.speed * each.speed + each.tangential_speed * each.tangential_speed) -
          0.5 * mass * (vx * vx + vy * vy) - 0.5 * inertia * w * w;
      EXPECT_NEAR((impact.friction_loss + impact.energy_lost) / kinetic_loss, 1.0, 3.0 * tolerance);
      EXPECT_NEAR(result.energy.friction, impact.friction_loss, 1e-9 * impact.friction_loss);
    }
  }
}

// A sphere that hits a wall at an angle from its normal, without spin: 2 kg, radius 5 cm, 2 m/s.
namespace sphere {

constexpr double weight = 2.0, radius = 0.05, turning = 0.4 * weight * radius * radius;  // kg, m, kg m^2
constexpr double hertz = 1e9, rebound = 0.9, mu = 0.3, speed = 2.0;

struct After {
  double tangential = 0.0, spin = 0.0, energy_lost_over_kinetic = 0.0;
};

After computed(double angle, const CornerFriction& friction, const TransientOptions& options) {
  Model model;
  const DiaphragmId ball = add(model, Diaphragm{.name = "ball",
                                                .mass = weight * kg,
                                                .rotary_inertia = turning * kg * m * m,
                                                .initial_velocity_x = speed * std::cos(angle) * m / s,
                                                .initial_velocity_y = speed * std::sin(angle) * m / s});
  add(model, CornerGap<ExactHertzDamp>{.name = "contact",
                                       .corner = PlanPoint{ball, {radius * m, 0 * m}},
                                       .edge_of = ground,
                                       .edge_begin = PlanPosition{(radius + 1e-3) * m, -1 * m},
                                       .edge_end = PlanPosition{(radius + 1e-3) * m, 1 * m},
                                       .law = {.stiffness = hertz * N / m_3_2, .restitution = rebound},
                                       .friction = friction});
  const auto [result, state] =
      run_to_end(model, still_ground(10 * ms, 1 * ms), {.transient = options, .error_bars = ErrorBarMode::never});
  const EnergyBalance& energy = result.energy;
  const double start = 0.5 * weight * speed * speed;
  EXPECT_EQ(result.impacts.size(), 1U);
  EXPECT_NEAR(state.velocity(ball.x) / (-rebound * speed * std::cos(angle)), 1.0, 2e-3);
  return {state.velocity(ball.y), state.angular_velocity(ball),
          (energy.kinetic + energy.strain + energy.impact + energy.friction) / start};
}

// The same impact by a million steps of the contact alone. Friction with a spring of `ratio` times the elastic tangent:
// it keeps its force while the tangent grows, and its stretch while it falls.
After by_hand(double angle, double ratio) {
  const double z = damping_factor_of_viscous_hertz(rebound), v0 = speed * std::cos(angle);
  double d = 0.0, v = v0, w = 0.0, tangential = speed * std::sin(angle), force = 0.0, spring = 0.0;
  const double h = elastic_hertz_duration(hertz, weight, v0) / 1e6;
  while (true) {
    const double middle = d + 0.5 * h * v;
    if (middle <= 0.0) return {tangential, w, 0.0};
    v -= h / weight * hertz * std::pow(middle, 1.5) * (1.0 + z * v / v0);
    d = std::max(middle + 0.5 * h * v, 0.0);
    const double spring_now = ratio * 1.5 * hertz * std::sqrt(d);
    if (spring_now < spring) force *= spring_now / spring;
    spring = spring_now;
    const double limit = mu * hertz * std::pow(d, 1.5) * (1.0 + z * v / v0);
    force = std::clamp(force + spring * h * (tangential + radius * w), -limit, limit);
    tangential -= h / weight * force;
    w -= h / turning * radius * force;
  }
}

}  // namespace sphere

TEST(CornerImpact, OfASphereWithASpringThatFollowsTheNormalLaw) {
  for (const double degrees : {5.0, 20.0, 40.0}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * deg, turn = sphere::speed / sphere::radius;
    const sphere::After expected = sphere::by_hand(angle, 0.85);
    for (const auto& [options, tolerance] : {std::pair{TransientOptions{}, 2e-3}, std::pair{tight(), 2e-5}}) {
      const sphere::After found = sphere::computed(angle, {sphere::mu, 0.85}, options);
      EXPECT_NEAR(found.tangential, expected.tangential, tolerance * sphere::speed);
      EXPECT_NEAR(found.spin, expected.spin, tolerance * turn);
      EXPECT_NEAR(found.energy_lost_over_kinetic, 0.0, tolerance == 2e-5 ? 1e-6 : 1e-3);
    }
  }
}

// It slides throughout where tan(angle) exceeds 7/2 mu (1 + e): the spring does not matter.
TEST(CornerImpact, OfASphereThatSlidesHasTheClosedForm) {
  const double angle = 70.0 * deg, push = sphere::mu * (1.0 + sphere::rebound) * sphere::speed * std::cos(angle);
  for (const CornerFriction& friction : {CornerFriction{sphere::mu, 0.85}, CornerFriction{sphere::mu, 1e9 * N / m}}) {
    const sphere::After found = sphere::computed(angle, friction, tight());
    EXPECT_NEAR(found.tangential, sphere::speed * std::sin(angle) - push, 1e-5 * sphere::speed);
    EXPECT_NEAR(found.spin, -2.5 * push / sphere::radius, 1e-5 * sphere::speed / sphere::radius);
    EXPECT_NEAR(found.energy_lost_over_kinetic, 0.0, 1e-6);
  }
}

// The second analysis begins in contact.
TEST(CornerImpact, KeepsTheSpeedsOfItsTouchInALaterAnalysis) {
  FreeSlab slab{0.6 * m / s, 0.3 * m / s};
  slab.add_corner({0.4, 1e10 * N / m});
  const EndedCase first = slab.run({.end = 40 * ms});
  ASSERT_EQ(first.result.impacts.size(), 1U);
  ImpactRecorder impacts;
  Transient second{slab.model, still_ground(1 * s, 5 * ms), first.state};
  second.attach(impacts);
  second.run();
  ASSERT_EQ(impacts.impacts().size(), 1U);
  EXPECT_NEAR(impacts.impacts()[0].approach_speed, 0.6, 1e-9);
  EXPECT_NEAR(impacts.impacts()[0].tangential_speed, 0.3, 1e-9);
}

TEST(CornerImpact, IntoASquareCornerOfTheMoatStaysOnTheDiagonal) {
  // Both walls at once, mu = 0 and equal arms: the slab does not turn, and returns along the diagonal.
  for (const auto& [options, tolerance] : {std::pair{TransientOptions{}, 1e-3}, std::pair{tight(), 1e-5}}) {
    FreeSlab slab{0.5 * m / s, 0.5 * m / s, rectangle(10 * m, 10 * m)};
    const PlanPosition corner{5 * m, 5 * m};
    for (const auto& [begin, end] : {std::pair{PlanPosition{5.01 * m, -6 * m}, PlanPosition{5.01 * m, 6 * m}},
                                     std::pair{PlanPosition{6 * m, 5.01 * m}, PlanPosition{-6 * m, 5.01 * m}}}) {
      CornerGap<ExactHertzDamp> gap = slab.corner(corner);
      gap.edge_begin = begin;
      gap.edge_end = end;
      add(slab.model, gap);
    }
    const auto [result, state] = slab.run(options);
    const double vx = state.velocity(slab.slab.x);
    // Torques cancel: each wall sees the whole mass.
    EXPECT_NEAR(vx, -restitution * 0.5, tolerance);
    EXPECT_NEAR(state.velocity(slab.slab.y), vx, 1e-12);
    EXPECT_NEAR(state.angular_velocity(slab.slab), 0.0, 1e-12);
    EXPECT_EQ(result.impacts.size(), 2U);
  }
}

TEST(CornerImpact, DampedLinearLawWithAJumpAtTouchKeepsTheEnergy) {
  FreeSlab slab{0.6 * m / s, 0.4 * m / s};
  add(slab.model, CornerGap<ExactKelvin>{.name = "corner",
                                         .corner = PlanPoint{slab.slab, {arm_x * m, arm_y * m}},
                                         .edge_of = ground,
                                         .edge_begin = PlanPosition{10.01 * m, -8 * m},
                                         .edge_end = PlanPosition{10.01 * m, 8 * m},
                                         .law = {.stiffness = 1e8 * N / m, .restitution = restitution},
                                         .friction = 0.3});
  const CaseResult result = slab.run({}).result;
  const EnergyBalance& energy = result.energy;
  EXPECT_EQ(result.impacts.size(), 1U);
  EXPECT_NEAR(energy.kinetic + energy.strain + energy.impact + energy.friction, 0.0, 2e-3 * energy.largest_kinetic);
}

TEST(CornerImpact, CornerBesideTheEdgeDoesNotTouch) {
  // The wall ends at y = 5 m; the corner at y = 6 m passes its end.
  FreeSlab slab{0.6 * m / s};
  CornerGap<ExactHertzDamp> gap = slab.corner();
  gap.edge_end = PlanPosition{10.01 * m, 5 * m};
  add(slab.model, gap);
  const auto [result, state] = slab.run({});
  EXPECT_TRUE(result.impacts.empty());
  EXPECT_NEAR(state.velocity(slab.slab.x), 0.6, 1e-14);
  // It passes the end, at (10.01, 5) m, at a distance of 1 m.
  ASSERT_EQ(result.clearances.size(), 1U);
  EXPECT_NEAR(result.clearances[0].clearance, std::hypot(0.01, 1.0), 1e-12);
  EXPECT_NEAR(result.clearances[0].left, 1.0, 1e-9);
  EXPECT_NEAR(result.clearances[0].time, 0.01 / 0.6, 1e-4);
}

TEST(CornerImpact, ClearanceLeftIsTheDistanceFromTheEdge) {
  // At an angle of 30 degrees towards a wall in front of its corner, to be turned round by a spring before it touches:
  // along the normal of the wall counts. In contact the clearance is negative by the indentation.
  for (const double x : {10.01, 10.4}) {
    FreeSlab slab{0.6 * m / s};
    add(slab.model, PlanSpring<Linear>{.name = "spring",
                                       .lower = PlanPoint{ground, {}},
                                       .upper = PlanPoint{slab.slab, {}},
                                       .law = {.stiffness = Stiffness{mass * 9.0}}});
    CornerGap<ExactHertzDamp> gap = slab.corner();
    gap.edge_begin = PlanPosition{x * m, -8 * m};
    gap.edge_end = PlanPosition{x * m, 8 * m};
    add(slab.model, gap);
    const CaseResult result = slab.run({}).result;
    ASSERT_EQ(result.clearances.size(), 1U);
    if (result.impacts.empty())
      EXPECT_NEAR(result.clearances[0].left, 0.4 - 0.6 / 3.0, 1e-6);
    else
      EXPECT_NEAR(result.clearances[0].left, -result.impacts[0].largest_indentation,
                  1e-6 * result.impacts[0].largest_indentation);
    EXPECT_EQ(result.impacts.empty(), x > 10.1);
  }
}

TEST(CornerImpact, LoadedCornerThatSlidesPastTheEndIsReleased) {
  // Fast along the wall: it leaves the end, y = 6.1 m, after 20 ms of a contact of about 0.15 s.
  FreeSlab slab{0.6 * m / s, 5.0 * m / s};
  CornerGap<ExactHertzDamp> gap = slab.corner();
  gap.edge_begin = PlanPosition{10.01 * m, 0 * m};
  gap.edge_end = PlanPosition{10.01 * m, 6.2 * m};
  add(slab.model, gap);
  const CaseResult result = slab.run({}).result;
  ASSERT_EQ(result.impacts.size(), 1U);
  const Impact& impact = result.impacts[0];
  // Past the end by 1 % of 6.2 m.
  EXPECT_NEAR(impact.start + impact.duration, (0.2 + 0.062) / 5.0, 2e-3);
  EXPECT_GT(impact.energy_lost, 0.0);
  const EnergyBalance& energy = result.energy;
  EXPECT_NEAR(energy.kinetic + energy.strain + energy.impact, 0.0, 1e-3 * energy.impact);
  EXPECT_TRUE(std::isnan(impact.rebound_ratio)) << "it did not rebound";
  EXPECT_EQ(std::ranges::count(result.warnings,
                               "\"corner 1\": the corner left its edge in contact, 1 time. It slid past an end and was "
                               "released; the energy it had stored counts as lost in the impact. Check the outline of "
                               "the wall there."),
            1);
}

}  // namespace
}  // namespace moat
