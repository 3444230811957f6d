#include "performance/plan_tower.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace moat::performance {

using namespace units;

namespace {

constexpr double half_x = 10.0, half_y = 6.0, clearance = 0.25, friction = 0.2;  // m, 1
constexpr double column_stiffness = 100e6, column_damping = 1e6;                 // N/m, N s/m
constexpr double base_mass = 8e5, floor_mass = 7e5;                              // kg
constexpr double hertz_stiffness = 1e9, restitution = 0.65, grip_stiffness = 5e8;
constexpr PlanVector floor_centre{1.0, 0.6};
const double gyration = std::sqrt((4.0 * half_x * half_x + 4.0 * half_y * half_y) / 12.0);

BiaxialBoucWen bearing_law() {
  return {.characteristic_strength = 184 * kN, .yield_displacement = 10 * mm, .post_yield_stiffness = 1.6 * MN / m};
}

PlanOutline outline() { return rectangle(2.0 * half_x * m, 2.0 * half_y * m); }

}  // namespace

Model plan_tower() {
  Model model;
  const DiaphragmId base = add(model, Diaphragm{.name = "base", .mass = base_mass * kg, .outline = outline()}),
                    floor = add(model, Diaphragm{.name = "floor",
                                                 .mass = floor_mass * kg,
                                                 .centre_of_mass = {floor_centre.x * m, floor_centre.y * m},
                                                 .outline = outline()});
  for (std::size_t i = 0; i < 4; ++i) {
    const PlanPosition at = outline().corners[i];
    for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}})
      add(model,
          PlanSpring<Linear>{.name = "column " + std::to_string(i + 1) + (direction.x > 0.0 ? " x" : " y"),
                             .lower = PlanPoint{base, at},
                             .upper = PlanPoint{floor, at},
                             .direction = direction,
                             .law = {.stiffness = column_stiffness * N / m, .damping = column_damping * N * s / m}});
    add(model, PlanBearing<BiaxialBoucWen>{
                   .name = "bearing " + std::to_string(i + 1), .under = base, .at = at, .law = bearing_law()});
  }
  add(model, PlanMoat{.around = base,
                      .clearance = clearance * m,
                      .law = HertzDamp{.stiffness = hertz_stiffness * N / m_3_2, .restitution = restitution},
                      .friction = {friction, grip_stiffness * N / m}});
  return model;
}

GroundMotion plan_tower_motion() {
  return PlanMotion{near_fault_pulse({.phase = 0.25 * pi}).scaled_to_pga(0.40 * g),
                    near_fault_pulse({.phase = -0.25 * pi}).scaled_to_pga(0.25 * g)};
}

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Row = Eigen::Matrix<double, 1, 6>;

// The displacement of a point of the base along a direction; of the floor relative to the base.
Row row_of_base(PlanVector at, PlanVector direction) {
  Row row = Row::Zero();
  row.head<3>() << direction.x, direction.y, cross(at, direction) / gyration;
  return row;
}
Row row_of_column(PlanVector at, PlanVector direction) {
  Row row = -row_of_base(at, direction);
  row.tail<3>() << direction.x, direction.y, cross(at - floor_centre, direction) / gyration;
  return row;
}

struct Bearing {
  Row x, y;
  SaturatingState committed{}, trial{};
};
struct Contact {
  Row normal, tangent;
  double slip = 0.0, trial_slip = 0.0, approach_speed = 0.0;
  bool touching = false;
  double indentation = 0.0, rate = 0.0;
};

}  // namespace

BarePlanHistory bare_plan_tower(const GroundMotion& motion, int divisions) {
  const double h = motion.time_step() / divisions;
  const double z = 0.75 * (1.0 - restitution * restitution);
  Vector6 mass, share_x = Vector6::Zero(), share_y = Vector6::Zero();
  mass << base_mass, base_mass, base_mass, floor_mass, floor_mass, floor_mass;
  share_x[0] = share_x[3] = share_y[1] = share_y[4] = 1.0;
  Matrix6 stiffness = Matrix6::Zero();
  std::array<Bearing, 4> bearings;
  std::array<Contact, 8> contacts;
  for (std::size_t i = 0; i < 4; ++i) {
    const PlanVector at = outline().corner(i);
    for (const PlanVector direction : {PlanVector{1.0, 0.0}, PlanVector{0.0, 1.0}}) {
      const Row row = row_of_column(at, direction);
      stiffness += column_stiffness * row.transpose() * row;
    }
    bearings[i].x = row_of_base(at, {1.0, 0.0});
    bearings[i].y = row_of_base(at, {0.0, 1.0});
    for (std::size_t k = 0; k < 2; ++k) {
      const PlanVector normal =
          k == 0 ? PlanVector{at.x > 0.0 ? 1.0 : -1.0, 0.0} : PlanVector{0.0, at.y > 0.0 ? 1.0 : -1.0};
      contacts[2 * i + k].normal = row_of_base(at, normal);
      contacts[2 * i + k].tangent = row_of_base(at, turned_left(normal));
    }
  }
  const Matrix6 damping = column_damping / column_stiffness * stiffness;
  const BiaxialBoucWen law = bearing_law();
  const double wd = 0.25 * h * h, wv = 0.5 * h;
  const Matrix6 constant = Matrix6{mass.asDiagonal()} + wv * damping + wd * stiffness;

  Vector6 u = Vector6::Zero(), v = u, a = u, forces;
  Matrix6 tangent;
  const auto evaluate = [&](const Vector6& u1, const Vector6& v1) {
    forces = stiffness * u1 + damping * v1;
    tangent = constant;
    for (Bearing& bearing : bearings) {
      const PlanVector d{bearing.x * u1, bearing.y * u1}, rate{bearing.x * v1, bearing.y * v1};
      const PlanarResponse response = law.evaluate(bearing.committed, d, rate, h, bearing.trial);
      forces += response.force.x * bearing.x.transpose() + response.force.y * bearing.y.transpose();
      const PlanMatrix slope = wd * response.stiffness + wv * response.damping;
      const Row x = slope.xx * bearing.x + slope.xy * bearing.y, y = slope.yx * bearing.x + slope.yy * bearing.y;
      tangent += bearing.x.transpose() * x + bearing.y.transpose() * y;
    }
    for (Contact& contact : contacts) {
      contact.indentation = contact.normal * u1 - clearance;
      contact.rate = contact.normal * v1;
      const double path = contact.tangent * u1;
      contact.trial_slip = path;
      if (!contact.touching || contact.indentation <= 0.0) continue;
      const double elastic = hertz_stiffness * contact.indentation * std::sqrt(contact.indentation),
                   factor = 1.0 + z * contact.rate / contact.approach_speed;
      const double force = elastic * factor;
      if (force <= 0.0) continue;
      const double along =
          wd * 1.5 * elastic / contact.indentation * factor + wv * elastic * z / contact.approach_speed;
      forces += force * contact.normal.transpose();
      tangent += along * contact.normal.transpose() * contact.normal;
      const double grip = grip_stiffness * (path - contact.slip), limit = friction * force;
      const double held = std::clamp(grip, -limit, limit);
      contact.trial_slip = path - held / grip_stiffness;
      forces += held * contact.tangent.transpose();
      if (held == grip)
        tangent += wd * grip_stiffness * contact.tangent.transpose() * contact.tangent;
      else
        tangent += std::copysign(friction * along, grip) * contact.tangent.transpose() * contact.normal;
    }
  };

  BarePlanHistory history;
  const auto count = static_cast<long>(std::llround(bare_plan_end / h));
  for (long step = 1; step <= count; ++step, ++history.steps) {
    const PlanVector ground = motion.components_at(static_cast<double>(step) * h);
    const Vector6 load = mass.cwiseProduct(ground.x * share_x + ground.y * share_y);
    const Vector6 predicted_u = u + h * v + wd * a, predicted_v = v + wv * a;
    Vector6 a1 = a;
    for (int iteration = 0; iteration < 20; ++iteration, ++history.iterations) {
      evaluate(predicted_u + wd * a1, predicted_v + wv * a1);
      const Vector6 residual = mass.cwiseProduct(a1) + forces + load;
      constexpr double tolerance = 1e-8;
      const double scale = std::max(forces.lpNorm<Eigen::Infinity>(), load.lpNorm<Eigen::Infinity>());
      if (residual.lpNorm<Eigen::Infinity>() <= tolerance * scale) break;
      a1 -= tangent.partialPivLu().solve(residual);
    }
    u = predicted_u + wd * a1;
    v = predicted_v + wv * a1;
    a = a1;
    for (Bearing& bearing : bearings) bearing.committed = bearing.trial;
    for (Contact& contact : contacts) {
      contact.slip = contact.trial_slip;
      const bool inside = contact.indentation > 0.0;
      if (inside && !contact.touching) contact.approach_speed = std::max(contact.rate, 1e-4);
      contact.touching = inside;
    }
    history.largest_base_x = std::max(history.largest_base_x, std::abs(u[0]));
  }
  return history;
}

}  // namespace moat::performance
