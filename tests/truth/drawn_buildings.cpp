#include "drawn_buildings.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "impact_cases.hpp"
#include "moat_model.hpp"
#include "plane_frames.hpp"
#include "random_motion.hpp"
#include "random_spring.hpp"
#include "scaled_mass.hpp"

namespace moat::testing {
namespace {

using namespace units;
using std::numbers::pi;

// Measured constants in pascals or joules do not scale with the parameters.
template <class Law>
constexpr bool is_scalable = !std::is_same_v<Law, KikuchiAikenRubber> && !std::is_same_v<Law, HeatedFrictionPendulum> &&
                             !std::is_same_v<Law, HeatedLeadRubber>;

GroundMotion motion_of(const Draw& draw, const View& view) {
  RandomDraws draws{draw.seed ^ 0x6d6f74696f6eU};
  PlainMotion motion = random_motion(draws);
  const auto most = static_cast<std::size_t>(draw.duration / motion.time_step) + 2;
  if (motion.samples.size() > most) motion.samples.resize(most);
  if (view.mirrored)
    for (double& sample : motion.samples) sample = -sample;
  return moat_motion(motion);
}

// Numbers of a building whose drawn parts are common to several families.
struct Parts {
  Parts(const Draw& draw, const View& as_seen) : draws{draw.seed}, view{as_seen} {
    storeys = draw.storeys;
    floor_mass = view.mass * draws.decades(80, 800) * tonne;
    base_mass = draws.uniform(0.5, 1.5) * floor_mass;
    const double root = 2.0 * pi / (storeys * draws.uniform(0.06, 0.14)) * (2.0 * storeys + 1.0) / pi;
    for (int i = 0; i < storeys; ++i) stiffness.push_back(draws.uniform(0.7, 1.3) * root * root * (floor_mass / s / s));
    ratio = draws.decades(0.005, 0.1);
  }
  [[nodiscard]] Mass mass() const { return storeys * floor_mass + base_mass; }
  /// With a yield force of 2 to 8 % of the weight.
  [[nodiscard]] LeadRubberBearing bearing(double share) {
    const Force yield = share * draws.uniform(0.02, 0.08) * mass() * g;
    const Frequency slow = 2.0 * pi / (draws.uniform(1.8, 4.0) * s);
    return {.yield_force = yield, .yield_displacement = 1 * cm, .post_yield_stiffness = share * mass() * slow * slow};
  }

  RandomDraws draws;
  const View& view;
  int storeys;
  Mass floor_mass, base_mass;
  std::vector<Stiffness> stiffness;
  double ratio;
};

void add_walls(Model& model, Parts& parts, const Draw& draw, NodeId base) {
  const Length clearance = parts.draws.uniform(2, 20) * cm;
  const double side = parts.draws.unit();
  std::optional<FlexibleWall> wall;
  if (parts.draws.chance(0.3)) {
    const Mass mass = parts.draws.uniform(0.05, 0.3) * parts.base_mass;
    const Frequency fast = parts.draws.uniform(30, 200) / s;
    wall = FlexibleWall{.mass = mass, .stiffness = mass * fast * fast, .damping = 0.1 * mass * fast};
    if (parts.draws.chance(0.5)) {
      HyperbolicBackfill soil = HyperbolicBackfill::typical();
      scale_mass(soil, parts.view.mass);
      wall->backfill = soil;
    }
  }
  const bool mirrored = parts.view.mirrored;
  const Sides sides = side < 0.3   ? (mirrored ? Sides::right : Sides::left)
                      : side < 0.6 ? (mirrored ? Sides::left : Sides::right)
                                   : Sides::both;
  if (!draw.walls) return;
  int chosen = parts.draws.integer(0, AllImpactLaws::size - 1);
  const double soft = parts.draws.decades(1e8, 1e10), restitution = parts.draws.uniform(0.3, 0.95);
  AllImpactLaws::for_each([&]<class Law>() {
    if (chosen-- == 0)
      add(model, Moat<Law>{.around = base,
                           .clearance = clearance,
                           .law = impact_law<Law>(soft * parts.view.mass, restitution),
                           .sides = sides,
                           .wall = wall});
  });
}

// Laws of dampers, and of forces that do not hold a building, stand beside bearings.
template <class Law>
bool holds(const Law& law) {
  if constexpr (DamperLaw<Law>)
    return false;
  else
    return secant_stiffness(force_law(law), 0.02) > 0.0 && secant_stiffness(force_law(law), 0.2) > 0.0;
}

template <class Law>
Isolation isolation_of(Parts& parts, bool beside_bearings) {
  Law law = random_spring<Law>(parts.draws);
  const bool alone = holds(law) && !beside_bearings;
  Isolator<Law> isolator{.name = "drawn", .law = law};
  if constexpr (!WeightBearing<Law> && !DamperLaw<Law>) {
    // So many that the building's period is about 2.5 s, or less on a stiff one.
    const double wanted = parts.mass().si() / parts.view.mass * std::pow(2.0 * pi / 2.5, 2);
    const double one = std::abs(secant_stiffness(law, 0.1));
    if (one > 0.0) isolator.count = static_cast<int>(std::clamp(wanted / one, 1.0, 500.0));
  }
  scale_mass(isolator.law, parts.view.mass);
  const auto drawn = [&] {
    if constexpr (DamperLaw<Law>)
      return Isolation{isolator.law};
    else
      return Isolation{isolator};
  };
  if (alone) return drawn();
  const LeadRubberBearing bearing = parts.bearing(1.0);
  if constexpr (DamperLaw<Law>)
    return parts.view.reversed ? Isolation{isolator.law, bearing} : Isolation{bearing, isolator.law};
  else
    return parts.view.reversed ? Isolation{isolator, bearing} : Isolation{bearing, isolator};
}

template <class Chosen>
Problem on_a_law(const Draw& draw, const View& view, Chosen is_chosen) {
  Parts parts{draw, view};
  ShearBuilding building{.storeys = parts.storeys,
                         .floor_mass = parts.floor_mass,
                         .storey_stiffness = parts.stiffness,
                         .damping = {.ratio = parts.ratio},
                         .base_mass = parts.base_mass,
                         .p_delta = parts.draws.chance(0.2)};
  if (parts.draws.chance(0.3)) {
    YieldingStorey storey{.stiffness = parts.stiffness[0],
                          .yield_force = parts.draws.uniform(0.05, 0.3) * parts.mass() * g,
                          .hardening_ratio = parts.draws.uniform(0.0, 0.1)};
    building.storey_stiffness = Stiffness{};
    building.storey = StoreyLaw{storey};
  }
  int laws = 0;
  AllSpringLaws::for_each([&]<class Law>() { laws += is_chosen.template operator()<Law>() ? 1 : 0; });
  int chosen = parts.draws.integer(0, laws - 1);
  const bool beside = parts.draws.chance(0.3);
  AllSpringLaws::for_each([&]<class Law>() {
    if (is_chosen.template operator()<Law>() && chosen-- == 0) building.isolation = isolation_of<Law>(parts, beside);
  });
  Problem problem{Model{}, motion_of(draw, view)};
  const Building added = add(problem.model, building);
  add_walls(problem.model, parts, draw, added.base);
  return problem;
}

std::vector<Draw> smaller(const Draw& draw) {
  std::vector<Draw> list;
  const auto with = [&](auto change) {
    list.push_back(draw);
    change(list.back());
  };
  if (draw.walls) with([](Draw& each) { each.walls = false; });
  if (draw.storeys > 1) with([](Draw& each) { each.storeys = 1; });
  if (draw.storeys > 2) with([](Draw& each) { --each.storeys; });
  if (draw.duration > 0.5) with([](Draw& each) { each.duration *= 0.5; });
  return list;
}

}  // namespace

rc::Gen<Draw> draws() {
  return drawn_by(
      [](std::uint64_t seed) {
        RandomDraws numbers{seed ^ 0x73697a65U};
        return Draw{seed, numbers.integer(1, 6), numbers.chance(0.8), numbers.uniform(3.0, 10.0)};
      },
      smaller);
}

// Soil behind walls has its place there.
Problem building_on_any_law(const Draw& draw, const View& view) {
  return on_a_law(draw, view, []<class Law>() { return !std::is_same_v<Law, HyperbolicBackfill>; });
}

Problem building_on_a_scalable_law(const Draw& draw, const View& view) {
  return on_a_law(draw, view, []<class Law>() { return is_scalable<Law> && !std::is_same_v<Law, HyperbolicBackfill>; });
}

Problem building_that_overturns(const Draw& draw, const View& view) {
  Parts parts{draw, view};
  AxialForces axial{.base_height = parts.draws.uniform(0.5, 1.5) * m};
  const bool shakes_upwards = parts.draws.chance(0.5);
  if (shakes_upwards && parts.draws.chance(0.5)) {
    axial.vertical_period = parts.draws.uniform(0.05, 0.2) * s;
    axial.vertical_damping = 0.1;
  }
  const Length half_width = parts.draws.uniform(8, 15) * m;
  Problem problem{Model{}, motion_of(draw, view)};
  if (shakes_upwards) {
    const double share = parts.draws.uniform(0.1, 0.4);
    std::vector<double> upwards;
    const GroundMotion along_x = motion_of(draw, {});
    for (const double sample : along_x.samples()) upwards.push_back(share * sample);
    problem.motion = problem.motion.with_component_z(upwards);
  }
  int laws = 0;
  AllSpringLaws::for_each([&]<class Law>() { laws += BearsChangingWeight<Law> && is_scalable<Law> ? 1 : 0; });
  int chosen = parts.draws.integer(0, laws - 1);
  AllSpringLaws::for_each([&]<class Law>() {
    if constexpr (BearsChangingWeight<Law> && is_scalable<Law>) {
      if (chosen-- != 0) return;
      const Length side = view.mirrored ? -half_width : half_width;
      Isolator<Law> one{.name = "one", .law = random_spring<Law>(parts.draws), .at = -side};
      Isolator<Law> other{.name = "other", .law = random_spring<Law>(parts.draws), .at = side};
      scale_mass(one.law, view.mass);
      scale_mass(other.law, view.mass);
      const Building added =
          add(problem.model, ShearBuilding{.storeys = parts.storeys,
                                           .floor_mass = parts.floor_mass,
                                           .storey_stiffness = parts.stiffness,
                                           .damping = {.ratio = parts.ratio},
                                           .base_mass = parts.base_mass,
                                           .isolation = view.reversed ? Isolation{other, one} : Isolation{one, other},
                                           .storey_height = 3.5 * m,
                                           .axial_forces = axial});
      add_walls(problem.model, parts, draw, added.base);
    }
  });
  return problem;
}

// The flexibility of storeys that shear, and of a cantilever.
Problem building_of_a_matrix(const Draw& draw, const View& view) {
  Parts parts{draw, view};
  const Eigen::Index n = parts.storeys;
  Eigen::MatrixXd flexibility{n, n};
  double shear = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    shear += 1.0 / parts.stiffness[static_cast<std::size_t>(i)].si();
    for (Eigen::Index j = i; j < n; ++j) flexibility(i, j) = flexibility(j, i) = shear;
  }
  const double bending = parts.draws.uniform(0.0, 1.0) * shear / std::pow(static_cast<double>(n), 3);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto low = static_cast<double>(std::min(i, j) + 1), high = static_cast<double>(std::max(i, j) + 1);
      flexibility(i, j) += bending * low * low * (3.0 * high - low);
    }
  Eigen::MatrixXd stiffness = flexibility.inverse();
  stiffness = 0.5 * (stiffness + stiffness.transpose().eval());
  Superstructure building{.stiffness = in_units(stiffness, {.force = N, .length = m}),
                          .freedoms = per_floor(Freedoms::x),
                          .damping = ModalDamping{parts.ratio},
                          .base = SuperstructureBase{.mass = parts.base_mass},
                          .isolation = parts.bearing(1.0)};
  for (int i = 1; i <= parts.storeys; ++i) building.floors.push_back({.height = 3.5 * i * m, .mass = parts.floor_mass});
  Problem problem{Model{}, motion_of(draw, view)};
  const SuperstructureParts added = add(problem.model, building);
  add_walls(problem.model, parts, draw, added.base.x);
  return problem;
}

Problem building_of_a_frame(const Draw& draw, const View& view) {
  Parts parts{draw, view};
  const auto section = [&](double least, double most) {
    const Length side = parts.draws.uniform(least, most) * m;
    return RectangularSection{.b = side, .h = side};
  };
  Frame frame = plane_frame({.storeys = std::vector<Length>(static_cast<std::size_t>(parts.storeys), 3.5 * m),
                             .bay = parts.draws.uniform(4, 8) * m,
                             .bays = parts.draws.integer(1, 3),
                             .columns = {section(0.5, 1.0)},
                             .beam = section(0.4, 0.8),
                             .E = view.mass * 30 * GPa});
  for (FrameLevel& level : frame.levels) level.mass = 0.1 * parts.floor_mass;
  parts.floor_mass = 0.1 * parts.floor_mass;
  parts.base_mass = 0.1 * parts.base_mass;
  Problem problem{Model{}, motion_of(draw, view)};
  const SuperstructureParts added =
      add(problem.model, Superstructure{.condensed = frame.condensed(),
                                        .damping = ModalDamping{parts.ratio},
                                        .base = SuperstructureBase{.mass = parts.base_mass},
                                        .isolation = parts.bearing(1.0)});
  add_walls(problem.model, parts, draw, added.base.x);
  return problem;
}

}  // namespace moat::testing
