// Towers in plan drawn at random.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "moat.hpp"

namespace moat::testing {

/// How a tower is built and seen; the numbers come from its seed.
struct TowerOptions {
  Angle turn{};           ///< of everything and of the motion, about the origin
  bool walls = true;      ///< around the base
  double mass = 1.0;      ///< factor of masses, stiffnesses and forces
  bool reversed = false;  ///< bearings and columns in the opposite order
  /// Another law of its bearings, one at a position; empty: lead-rubber bearings or a Bouc-Wen law.
  std::function<PlanBearings::Placed(PlanPosition at)> bearing{};
  std::optional<AxialForces> axial_forces{};  ///< of its bearings
};

/// One to four storeys, eccentric, on six bearings, and a near-fault pulse along two axes.
struct Tower {
  Model model;
  GroundMotion motion;
};

inline Tower random_tower(unsigned seed, const TowerOptions& options = {}) {
  using namespace units;
  std::mt19937 generator{seed};
  const auto between = [&](double lowest, double highest) {
    return std::uniform_real_distribution<>{lowest, highest}(generator);
  };
  const Angle turn = options.turn;
  const double unit = options.mass;
  const Length width = between(10, 30) * m, depth = between(8, 20) * m;
  const auto place = [&](double x, double y) { return turned({x * width, y * depth}, turn); };
  const Angle quarter = std::numbers::pi / 4 * rad;
  const Time period = between(0.8, 2.0) * s;
  const int storeys = static_cast<int>(between(1, 4.99));
  const Mass floor_mass = unit * between(200, 900) * tonne, base_mass = unit * between(300, 900) * tonne;
  const double offset_x = between(-0.08, 0.08), offset_y = between(-0.08, 0.08);
  const StoreyColumn column{.stiffness = unit * between(50, 200) * MN / m};
  const Force strength = unit * between(100, 300) * kN;
  const Stiffness post_yield = unit * between(1, 2.5) * MN / m;
  const bool rounded = between(0, 1) < 0.5;
  std::vector<ColumnLine> columns;
  std::vector<PlanBearings::Placed> bearings;
  for (const double x : {-0.5, 0.0, 0.5})
    for (const double y : {-0.5, 0.5}) {
      columns.push_back({place(x, y), column});
      if (options.bearing)
        bearings.push_back(options.bearing(place(x, y)));
      else if (rounded)
        bearings.emplace_back(place(x, y), BiaxialBoucWen{.characteristic_strength = strength,
                                                          .yield_displacement = 1 * cm,
                                                          .post_yield_stiffness = post_yield});
      else
        bearings.emplace_back(place(x, y), LeadRubberBearing{.yield_force = strength,
                                                             .yield_displacement = 1 * cm,
                                                             .post_yield_stiffness = post_yield});
    }
  if (options.reversed) {
    std::ranges::reverse(columns);
    std::ranges::reverse(bearings);
  }
  Model model;
  const auto added = add(model, PlanBuilding{.outline = turned(rectangle(width, depth), turn),
                                             .storeys = storeys,
                                             .floor_mass = floor_mass,
                                             .mass_offset = place(offset_x, offset_y),
                                             .columns = PlanColumns{columns},
                                             .damping = RayleighDamping{.ratio = 0.05},
                                             .base_mass = base_mass,
                                             .bearings = PlanBearings{bearings},
                                             .storey_height = 3.5 * m,
                                             .axial_forces = options.axial_forces});
  const PlanMoat<HertzDamp> walls{
      .around = added.base,
      .clearance = between(8, 25) * cm,
      .law = HertzDamp{.stiffness = unit * between(0.5e9, 3e9) * N / m_3_2, .restitution = between(0.4, 0.8)},
      .friction = between(0.0, 0.6)};
  if (options.walls) add(model, walls);
  const double degrees = between(0, 359), second = between(0.3, 1.0);
  const PlanMotion motion{near_fault_pulse({.pulse_period = period, .phase = quarter}),
                          near_fault_pulse({.pulse_period = period, .phase = -quarter}).scaled_by(second)};
  PlanMotion scaled = motion.scaled_to_larger_pga(between(0.3, 0.6) * g);
  scaled.incidence = std::fmod(degrees + turn / deg, 360.0) * deg;
  return {std::move(model), scaled.resolved()};
}

}  // namespace moat::testing
