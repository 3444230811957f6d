// Linear diaphragms in plan, against closed forms and models on a line.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "analyses/time_history/transient.hpp"
#include "analysis_testing.hpp"
#include "elements/contact/corner_gap.hpp"
#include "elements/line/shear_spring.hpp"
#include "elements/line/spring.hpp"
#include "elements/line/viscous_damper.hpp"
#include "elements/plan/plan_spring.hpp"
#include "elements/plan/planar_spring.hpp"
#include "materials/impact/hertz_damp.hpp"
#include "materials/linear.hpp"
#include "materials/plan/biaxial_bilinear.hpp"
#include "message_of.hpp"
#include "motions/near_fault_pulse.hpp"
#include "motions/plan_motion.hpp"
#include "unlocated_bilinear.hpp"

namespace moat {
namespace {

using namespace units;
using testing::still_ground;

// The slab of the specification: 1.5e6 kg, 20 x 12 m, on four springs of 1.6 MN/m at (+-10, +-6) about the stiffness
// centre at x = e from the centre of mass.
struct Slab {
  explicit Slab(Length eccentricity, Length initial = {}) {
    id = add(
        model,
        Diaphragm{.name = "slab", .mass = 1.5e6 * kg, .size = {20 * m, 12 * m}, .initial_displacement = {{}, initial}});
    int number = 0;
    for (const Length x : {-10 * m, 10 * m})
      for (const Length y : {-6 * m, 6 * m})
        for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}}) {
          const PlanPosition at{x + eccentricity, y};
          add(model, PlanSpring<Linear>{.name = "spring " + std::to_string(++number),
                                        .lower = PlanPoint{ground, at},
                                        .upper = PlanPoint{id, at},
                                        .direction = direction,
                                        .law = {.stiffness = 1.6 * MN / m}});
        }
  }
  Model model;
  DiaphragmId id;
};

TEST(PlanMotionAnalysis, FreeVibrationWithTorsionMeetsTheClosedForm) {
  Slab slab{1 * m, 0.1 * m};
  // Eigenvalues of [A C; C B] in uy and w: A = K/m, B = (K_theta + K e^2)/J, C = K e/(m r).
  const double mass = 1.5e6, stiffness = 4 * 1.6e6, r = std::sqrt((20.0 * 20.0 + 12.0 * 12.0) / 12.0);
  const double torsional = 4 * 1.6e6 * (10.0 * 10.0 + 6.0 * 6.0);
  const double a = stiffness / mass, b = (torsional + stiffness) / (mass * r * r), c = stiffness / (mass * r);
  const double root = std::sqrt(0.25 * (a - b) * (a - b) + c * c);
  const std::array<double, 2> squares{0.5 * (a + b) - root, 0.5 * (a + b) + root};
  EXPECT_NEAR(2.0 * pi / std::sqrt(squares[0]), 3.058473, 1e-6);
  EXPECT_NEAR(2.0 * pi / std::sqrt(squares[1]), 1.746650, 1e-6);
  const auto exact = [&](double t) {
    // uy(0) = 0.1: the modes (c, s) and (-s, c).
    const double angle = 0.5 * std::atan2(2.0 * c, a - b), co = std::cos(angle), si = std::sin(angle);
    const double of_first = a * co * co + b * si * si + 2.0 * c * co * si, other = a + b - of_first;
    const double q1 = 0.1 * co * std::cos(std::sqrt(of_first) * t), q2 = -0.1 * si * std::cos(std::sqrt(other) * t);
    return std::array{co * q1 - si * q2, (si * q1 + co * q2) / r};
  };
  struct Row {
    double time, uy, theta;
  };
  for (const Row& row : {Row{0.5, 0.051329163, -8.020615693e-4}, Row{1.0, -0.046723079, -4.673775713e-4},
                         Row{2.0, -0.056141024, 1.273969390e-3}, Row{5.0, -0.065527339, 1.416375353e-3}}) {
    EXPECT_NEAR(exact(row.time)[0], row.uy, 1e-9) << row.time;
    EXPECT_NEAR(exact(row.time)[1], row.theta, 1e-12) << row.time;
  }

  Transient analysis{slab.model, still_ground(5 * s, 2.5 * ms), {.tolerance = 1e-9}};
  double largest = 0.0, largest_turn = 0.0;
  testing::Watch watch{[&](const StepView& view) {
    const auto [uy, theta] = exact(view.model.state().time);
    largest = std::max(largest, std::abs(view.model.displacement(slab.id.y) - uy));
    largest_turn = std::max(largest_turn, std::abs(view.model.rotation(slab.id) - theta));
    EXPECT_EQ(view.model.displacement(slab.id.x), 0.0);
  }};
  analysis.attach(watch);
  analysis.run();
  EXPECT_LT(largest, 1e-8);
  EXPECT_LT(largest_turn, 1e-9);
  EXPECT_NEAR(slab.model.displacement(slab.id.y), -0.065527339, 2e-8);
  EXPECT_NEAR(slab.model.rotation(slab.id), 1.416375353e-3, 1e-9);
}

// A base and a floor with eccentric masses, bilinear bearings of two components, in a moat; everything turned by an
// angle about the origin, or mirrored at the x axis.
struct Tower {
  explicit Tower(double angle, bool mirrored = false, double friction = 0.0) {
    const auto place = [&](double x, double y) { return turned({x * m, (mirrored ? -y : y) * m}, angle); };
    const auto direction = [&](double x, double y) {
      const double c = std::cos(angle), si = std::sin(angle), v = mirrored ? -y : y;
      return PlanVector{c * x - si * v, si * x + c * v};
    };
    const PlanOutline outline = turned(rectangle(20 * m, 12 * m), angle);
    base = add(model, Diaphragm{.name = "base", .mass = 800 * tonne, .outline = outline});
    floor = add(model, Diaphragm{.name = "floor",
                                 .mass = 700 * tonne,
                                 .rotary_inertia = 700 * tonne * 45.3333 * m * m,
                                 .centre_of_mass = place(1.0, 0.6),
                                 .outline = outline});
    int number = 0;
    for (const double x : {-10.0, 10.0})
      for (const double y : {-6.0, 6.0}) {
        ++number;
        const PlanPosition at = place(x, y);
        for (int axis = 0; axis < 2; ++axis)
          add(model, PlanSpring<Linear>{.name = "column " + std::to_string(number) + (axis == 0 ? " x" : " y"),
                                        .lower = PlanPoint{base, at},
                                        .upper = PlanPoint{floor, at},
                                        .direction = axis == 0 ? direction(1, 0) : direction(0, 1),
                                        .law = {.stiffness = 100 * MN / m, .damping = 1 * MN * s / m}});
        add(model,
            PlanBearing<BiaxialBilinear>{
                .name = "bearing " + std::to_string(number),
                .under = base,
                .at = at,
                .law = {.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m}});
      }
    const PlanOutline walls = turned(rectangle(20.5 * m, 12.5 * m), angle);
    for (std::size_t corner = 0; corner < 4; ++corner)
      for (std::size_t wall = 0; wall < 4; ++wall) {
        const PlanVector begin = walls.corner(wall), end = walls.corner(wall + 1), at = outline.corner(corner);
        const PlanVector normal = -turned_left(end - begin) / length(end - begin);
        if (dot(begin - at, normal) > 1.0) continue;
        add(model, CornerGap<HertzDamp>{.name = "corner " + std::to_string(corner) + " wall " + std::to_string(wall),
                                        .corner = PlanPoint{base, outline.corners[corner]},
                                        .edge_of = ground,
                                        .edge_begin = walls.corners[wall],
                                        .edge_end = walls.corners[(wall + 1) % 4],
                                        .law = {.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                                        .friction = {friction, 5e8 * N / m}});
      }
  }
  Model model;
  DiaphragmId base, floor;
};

GroundMotion pulse(double phase, Acceleration pga) {
  return near_fault_pulse({.phase = phase, .quiet_after = 4 * s}).scaled_to_pga(pga);
}

struct Row {
  PlanVector base, floor;
  double base_turn, floor_turn;
};
// At the ends of adapted steps.
std::vector<Row> rows_of(Tower& tower, const GroundMotion& motion) {
  std::vector<Row> rows;
  Transient analysis{tower.model, motion};
  testing::Watch watch{[&](const StepView& view) {
    if (!view.on_grid) return;
    const Model& model = view.model;
    rows.push_back({{model.displacement(tower.base.x), model.displacement(tower.base.y)},
                    {model.displacement(tower.floor.x), model.displacement(tower.floor.y)},
                    model.rotation(tower.base),
                    model.rotation(tower.floor)});
  }};
  analysis.attach(watch);
  analysis.run();
  return rows;
}

TEST(PlanMotionAnalysis, TurnedModelAndMotionTurnTheResults) {
  constexpr double angle = 37.0 * deg;
  const GroundMotion first = pulse(0.25 * pi, 0.4 * g), second = pulse(-0.25 * pi, 0.25 * g);
  for (const double friction : {0.0, 0.2}) {
    Tower plain{0.0, false, friction}, other{angle, false, friction};
    const std::vector<Row> rows = rows_of(plain, PlanMotion{first, second}),
                           turned_rows = rows_of(other, PlanMotion{first, second, angle});
    ASSERT_EQ(rows.size(), turned_rows.size());
    const double c = std::cos(angle), si = std::sin(angle);
    double largest = 0.0, size = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto turn = [&](PlanVector v) { return PlanVector{c * v.x - si * v.y, si * v.x + c * v.y}; };
      largest = std::max({largest, length(turn(rows[i].base) - turned_rows[i].base),
                          length(turn(rows[i].floor) - turned_rows[i].floor),
                          10.0 * std::abs(rows[i].base_turn - turned_rows[i].base_turn)});
      size = std::max(size, length(rows[i].base));
    }
    EXPECT_GT(size, 0.25);
    // Round-off grows in contact: steps that end at located touches differ in their last digits.
    EXPECT_LT(largest, 1e-9) << friction;
  }
}

TEST(PlanMotionAnalysis, MirroredModelAndMotionMirrorTheResults) {
  const GroundMotion first = pulse(0.25 * pi, 0.4 * g), second = pulse(-0.25 * pi, 0.25 * g);
  Tower plain{0.0, false, 0.2}, other{0.0, true, 0.2};
  const std::vector<Row> rows = rows_of(plain, PlanMotion{first, second}),
                         mirrored = rows_of(other, PlanMotion{first, second.scaled_by(-1.0)});
  ASSERT_EQ(rows.size(), mirrored.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_NEAR(rows[i].base.x, mirrored[i].base.x, 1e-9);
    ASSERT_NEAR(rows[i].base.y, -mirrored[i].base.y, 1e-9);
    ASSERT_NEAR(rows[i].base_turn, -mirrored[i].base_turn, 1e-10);
  }
}

// Symmetric, under a motion along x: the model on a line with the sums of its stiffnesses.
TEST(PlanMotionAnalysis, SymmetricModelEqualsTheModelOnALine) {
  const GroundMotion motion = pulse(0.25 * pi, 0.4 * g);
  Model line;
  const NodeId line_base = add(line, Node{.name = "base", .mass = 800 * tonne}),
               line_floor = add(line, Node{.name = "floor", .mass = 700 * tonne});
  add(line, ShearSpring{.name = "columns", .lower = line_base, .upper = line_floor, .stiffness = 400 * MN / m});
  add(line, ViscousDamper{.name = "damping", .lower = line_base, .upper = line_floor, .damping = 4 * MN * s / m});
  // As those in plan, it has no located yields.
  add(line, Spring<testing::UnlocatedBilinear>{
                .name = "bearings",
                .lower = ground,
                .upper = line_base,
                .law = {.yield_force = 8e5, .yield_displacement = 0.01, .post_yield_stiffness = 6.4e6}});
  const HertzDamp law{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65};
  add(line, Gap{.name = "left", .place = "moat", .left = ground, .right = line_base, .clearance = 25 * cm, .law = law});
  add(line,
      Gap{.name = "right", .place = "moat", .left = line_base, .right = ground, .clearance = 25 * cm, .law = law});

  Model plan;
  const PlanOutline outline = rectangle(20 * m, 12 * m);
  const DiaphragmId base = add(plan, Diaphragm{.name = "base", .mass = 800 * tonne, .outline = outline}),
                    floor = add(plan, Diaphragm{.name = "floor", .mass = 700 * tonne, .outline = outline});
  int number = 0;
  for (const PlanPosition& at : outline.corners) {
    const std::string index = std::to_string(++number);
    for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}})
      add(plan, PlanSpring<Linear>{.name = "column " + index + (direction.x > 0.0 ? " x" : " y"),
                                   .lower = PlanPoint{base, at},
                                   .upper = PlanPoint{floor, at},
                                   .direction = direction,
                                   .law = {.stiffness = 100 * MN / m, .damping = 1 * MN * s / m}});
    add(plan,
        PlanBearing<BiaxialBilinear>{
            .name = "bearing " + index,
            .under = base,
            .at = at,
            .law = {.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m}});
    // Half of the law of the face at each of its two corners.
    const bool right = at.x > 0 * m;
    const PlanPosition low{(right ? 10.25 : -10.25) * m, -6.25 * m}, high{low.x, 6.25 * m};
    add(plan, CornerGap<HertzDamp>{.name = "corner " + index,
                                   .place = "moat",
                                   .corner = PlanPoint{base, at},
                                   .edge_of = ground,
                                   .edge_begin = right ? low : high,
                                   .edge_end = right ? high : low,
                                   .law = law,
                                   .friction = 0.4,
                                   .share = 0.5});
  }
  // Every step of the same length, so that both are the same equations.
  const CaseOptions options{.transient = {.step = 1.25 * ms}, .error_bars = ErrorBarMode::never};
  const CaseResult on_line = run_case(line, motion, options), in_plan = run_case(plan, motion, options);
  const auto peak = [](const CaseResult& result, const std::string& quantity, const std::string& where) {
    for (const Peak& each : result.peaks)
      if (each.quantity == quantity && each.where == where) return each.value;
    ADD_FAILURE() << "no " << quantity << " at " << where;
    return 0.0;
  };
  EXPECT_EQ(on_line.impacts.size() * 2, in_plan.impacts.size());
  ASSERT_GE(on_line.impacts.size(), 2U);
  for (const std::string where : {"base", "floor"}) {
    for (const std::string quantity : {"displacement", "velocity", "absolute_acceleration"})
      EXPECT_NEAR(peak(in_plan, quantity + "_x", where) / peak(on_line, quantity, where), 1.0, 1e-10) << quantity;
    EXPECT_NEAR(peak(in_plan, "displacement_y", where), 0.0, 1e-12);
    EXPECT_NEAR(peak(in_plan, "rotation", where), 0.0, 1e-12);
  }
  EXPECT_NEAR(2.0 * peak(in_plan, "impact_force", "moat") / peak(on_line, "impact_force", "moat"), 1.0, 1e-10);
  EXPECT_NEAR(in_plan.energy.input / on_line.energy.input, 1.0, 1e-10);
  EXPECT_NEAR(in_plan.energy.impact / on_line.energy.impact, 1.0, 1e-10);
}

TEST(PlanMotionAnalysis, WarnsOfBearingsOutsideAndOfLargeRotations) {
  Model model;
  const DiaphragmId slab = add(
      model,
      Diaphragm{.name = "slab", .mass = 800 * tonne, .outline = rectangle(20 * m, 12 * m), .initial_rotation = 0.02});
  for (const double x : {-10.0, 10.5})
    for (const double y : {-6.0, 6.0})
      add(model,
          PlanBearing<BiaxialBilinear>{
              .name = "bearing " + std::to_string(x) + " " + std::to_string(y),
              .under = slab,
              .at = {x * m, y * m},
              .law = {.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.6 * MN / m}});
  const CaseResult result = run_case(model, still_ground(0.1 * s));
  int outside = 0, rotations = 0;
  for (const std::string& warning : result.warnings) {
    const std::string y = outside == 0 ? "-6" : "6";
    outside += warning == "Bearing \"bearing 10.500000 " + y + ".000000\" at (10.5, " + y +
                              ") m is outside the outline of \"slab\". Correct its position or the outline."
                   ? 1
                   : 0;
    // r theta^2/2 with r = 11.66 m.
    rotations += warning.find("at its corners they neglect 2.33") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(outside, 2);
  EXPECT_EQ(rotations, 1);
}

TEST(PlanMotionAnalysis, LineModelRefusesTwoComponents) {
  Model line;
  add(line, Node{.name = "node", .mass = 1 * kg});
  const GroundMotion first = pulse(0.0, 0.3 * g);
  EXPECT_NE(testing::message_of([&] {
              const Transient analysis{line, PlanMotion{first, first}};
            })
                .find("the motion has two components, and the model moves on a line. Give one component, or make the "
                      "model of diaphragms."),
            std::string::npos);
}

TEST(PlanMotionAnalysis, ComponentsActAtTheirAngle) {
  const GroundMotion first = pulse(0.0, 0.3 * g), second = pulse(1.0, 0.2 * g);
  const GroundMotion both = PlanMotion{first, second, 30 * deg};
  ASSERT_TRUE(both.has_two_components());
  for (std::size_t i = 0; i < both.samples().size(); i += 37) {
    const double a = first.samples()[i], b = second.samples()[i];
    EXPECT_NEAR(both.samples()[i], a * std::cos(pi / 6) - b * std::sin(pi / 6), 1e-14);
    EXPECT_NEAR(both.samples_y()[i], a * std::sin(pi / 6) + b * std::cos(pi / 6), 1e-14);
  }
}

}  // namespace
}  // namespace moat
