#include "random_model.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "random_draws.hpp"
#include "random_motion.hpp"
#include "reference_history.hpp"

namespace moat::testing {
namespace {

using std::numbers::pi;

constexpr double gravity = 9.80665;  // m/s^2

bool may_pull(PlainLawKind kind) {
  switch (kind) {
    case PlainLawKind::linear_elastic:
    case PlainLawKind::modified_linear_viscoelastic:
    case PlainLawKind::hertz:
    case PlainLawKind::nonlinear_viscoelastic:
      return false;
    default:
      return true;
  }
}

// The laws whose stiffness is in N/m^1.5 stand behind those in N/m.
bool is_hertz(PlainLawKind kind) { return kind >= PlainLawKind::hertz; }

// Any of the laws between two bodies of about the effective mass, kg; soft to stiff, restitution 0.15 to 0.95.
PlainLaw random_law(RandomDraws& draws, double effective_mass) {
  PlainLaw law;
  law.kind = static_cast<PlainLawKind>(draws.integer(0, plain_law_kinds - 1));
  // Elastic contacts of 20 to 300 ms for buildings, of 1 to 30 ms for light bodies.
  const bool light = effective_mass < 5e4;
  law.stiffness = is_hertz(law.kind) ? draws.decades(1e8, 2e10) : draws.decades(5e7, 5e9);
  if (light) law.stiffness = rounded(law.stiffness * std::max(effective_mass / 5e4, 0.02));
  law.restitution = draws.chance(0.1) ? draws.uniform(0.15, 0.3) : draws.uniform(0.3, 0.95);
  law.damping_ratio = draws.chance(0.1) ? draws.uniform(0.6, 1.2) : draws.uniform(0.02, 0.6);
  if (may_pull(law.kind) && draws.chance(0.25)) law.acts = PlainDamping::may_pull;
  if (law.kind == PlainLawKind::kelvin_by_damping_ratio && law.acts == PlainDamping::may_pull)
    law.damping_ratio = std::min(law.damping_ratio, 0.9);
  if (law.kind == PlainLawKind::modified_hertz_damp_printed) {
    // Below, its damping is many times critical.
    law.restitution = std::max(law.restitution, law.acts == PlainDamping::may_pull ? 0.42 : 0.25);
    if (law.acts == PlainDamping::throughout && draws.chance(0.6)) law.acts = PlainDamping::approach_only;
  }
  return law;
}

struct Building {
  std::string name;
  std::vector<int> nodes;  // bottom to top
  bool isolated = false;
};

class Drawing {
 public:
  explicit Drawing(std::uint64_t seed) : draws_{seed}, bends_{seed ^ 0x9e3779b97f4a7c15U} {}

  PlainModel model() {
    model_.motion = random_motion(draws_);
    const auto intervals = static_cast<double>(model_.motion.samples.size() - 1);
    // Some are followed beyond the last sample, where the ground stops, most of all those that are cut short.
    const bool cut = std::abs(model_.motion.samples.back()) > 0.5;
    const double tail = draws_.chance(cut ? 0.8 : 0.15) ? draws_.uniform(0.5, 2.0) : 0.0;
    model_.end = (intervals + std::round(tail / model_.motion.time_step)) * model_.motion.time_step;
    const double number = draws_.unit();
    const int count = number < 0.45 ? 1 : number < 0.8 ? 2 : 3;
    for (int i = 0; i < count; ++i) add_building(std::string(1, static_cast<char>('A' + i)));
    for (std::size_t i = 0; i + 1 < buildings_.size(); ++i) join(buildings_[i], buildings_[i + 1]);
    for (const Building& building : buildings_)
      if (building.isolated ? draws_.chance(count == 1 ? 0.9 : 0.5) : draws_.chance(count == 1 ? 0.8 : 0.1))
        add_walls(building);
    if (draws_.chance(0.25)) add_light_body(buildings_.front());
    if (draws_.chance(0.15)) add_equipment(buildings_.back());
    set_clearances();
    return model_;
  }

 private:
  int add_node(const std::string& name, double mass) {
    model_.nodes.push_back({name, rounded(mass), 0.0, 0.0});
    return static_cast<int>(model_.nodes.size()) - 1;
  }
  double mass_of(int node) const { return model_.nodes[static_cast<std::size_t>(node)].mass; }

  void add_spring(const std::string& name, int lower, int upper, double stiffness) {
    model_.springs.push_back({name, PlainSpring::Kind::storey, lower, upper, rounded(stiffness), 0.0});
  }
  void add_dashpot(const std::string& name, int lower, int upper, double damping) {
    if (damping > 0.0) model_.dashpots.push_back({name, lower, upper, rounded(damping)});
  }

  void add_bearing(const std::string& name, int lower, int upper, double carried_mass) {
    PlainBearing bearing{.name = name, .lower = lower, .upper = upper};
    bearing.yield_force = rounded(draws_.uniform(0.02, 0.08) * carried_mass * gravity);
    bearing.yield_displacement = draws_.decades(0.003, 0.025);
    const double frequency = 2.0 * pi / draws_.uniform(1.5, 4.0);
    const double initial = bearing.yield_force / bearing.yield_displacement;
    bearing.post_yield_stiffness = rounded(std::min(carried_mass * frequency * frequency, 0.5 * initial));
    draws_.chance(0.5);  // Nothing depends on it, but without it the seeds would have other models.
    model_.bearings.push_back(bearing);
    if (draws_.chance(0.3))
      add_dashpot(name + " damping", lower, upper, 2.0 * draws_.uniform(0.005, 0.1) * carried_mass * frequency);
  }

  // A storey that yields, with the stiffness of an elastic one.
  void add_yielding_storey(const std::string& name, int lower, int upper, double stiffness, double carried_mass) {
    PlainBearing storey{.name = name, .lower = lower, .upper = upper, .kind = PlainBearing::Kind::storey};
    storey.yield_force = rounded(draws_.decades(0.05, 0.5) * carried_mass * gravity);
    storey.yield_displacement = rounded(storey.yield_force / stiffness);
    storey.post_yield_stiffness = rounded(draws_.uniform(0.0, 0.1) * storey.yield_force / storey.yield_displacement);
    model_.bearings.push_back(storey);
  }

  void add_building(const std::string& name) {
    Building building{.name = name, .nodes = {}, .isolated = draws_.chance(0.65)};
    const int count = draws_.integer(1, 9);
    const double floor_mass = 1e3 * draws_.decades(60.0, 800.0);
    for (int i = 0; i < count; ++i) {
      const int floor = building.isolated ? i : i + 1;
      building.nodes.push_back(add_node(name + (floor == 0 ? " base" : " floor " + std::to_string(floor)),
                                        floor_mass * draws_.uniform(0.8, 1.2)));
    }
    // A uniform shear building of so many storeys has this first period.
    const int storeys = building.isolated ? count - 1 : count;
    const double period = storeys * draws_.uniform(0.06, 0.14);
    const double angle = pi / (2.0 * (2.0 * storeys + 1.0));
    const double root = storeys == 0 ? 0.0 : pi / period / std::sin(angle);  // sqrt(k/m)
    const double ratio = draws_.decades(0.005, 0.1);
    const double first = 2.0 * root * std::sin(angle), second = 2.0 * root * std::sin(3.0 * angle);
    const int soft = storeys > 2 && draws_.chance(0.1) ? draws_.integer(1, storeys - 1) : -1;
    const bool yields = draws_.chance(building.isolated ? 0.1 : 0.4);
    if (building.isolated) add_bearing(name + " bearings", plain_ground, building.nodes[0], mass_above(building, 0));
    const int bottom = building.isolated ? building.nodes[0] : plain_ground;
    const std::size_t first_spring = model_.springs.size();
    for (int storey = 0; storey < storeys; ++storey) {
      const auto n = static_cast<std::size_t>(building.isolated ? storey + 1 : storey);
      const int lower = n == 0 ? plain_ground : building.nodes[n - 1], upper = building.nodes[n];
      const std::string of = name + " storey " + std::to_string(storey + 1);
      const double stiffness = root * root * floor_mass * draws_.uniform(0.8, 1.2);
      if (storey == soft) {
        add_bearing(of + " bearings", lower, upper, mass_above(building, n));
        continue;
      }
      if (yields)
        add_yielding_storey(of, lower, upper, stiffness, mass_above(building, n));
      else
        add_spring(of, lower, upper, stiffness);
      const bool single = storeys == 1;
      add_dashpot(of + " damping", lower, upper, 2.0 * ratio / (single ? first : first + second) * stiffness);
      if (!single)
        add_dashpot(name + " floor " + std::to_string(storey + 1) + " damping", bottom, upper,
                    2.0 * ratio * first * second / (first + second) * mass_of(upper));
    }
    if (storeys > 1 && !yields && soft < 0 && bends_.chance(0.3)) bend(name, bottom, first_spring);
    buildings_.push_back(building);
  }

  // A frame that bends: a cantilever in series with its storeys. The springs are those between all of its floors.
  void bend(const std::string& name, int bottom, std::size_t first_spring) {
    const std::vector<PlainSpring> storeys{model_.springs.begin() + static_cast<std::ptrdiff_t>(first_spring),
                                           model_.springs.end()};
    const auto n = static_cast<Eigen::Index>(storeys.size());
    Eigen::MatrixXd flexibility{n, n};
    double shear = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      shear += 1.0 / storeys[static_cast<std::size_t>(i)].stiffness;
      for (Eigen::Index j = i; j < n; ++j) flexibility(i, j) = flexibility(j, i) = shear;
    }
    const double share = bends_.uniform(0.1, 2.0) * shear / (2.0 * std::pow(static_cast<double>(n), 3));
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        const auto low = static_cast<double>(std::min(i, j) + 1), high = static_cast<double>(std::max(i, j) + 1);
        flexibility(i, j) += share * low * low * (3.0 * high - low);
      }
    const Eigen::MatrixXd stiffness = flexibility.inverse();
    model_.springs.resize(first_spring);
    const auto add = [&](int lower, int upper, double value) {
      model_.springs.push_back({name + " frame", PlainSpring::Kind::frame, lower, upper, value, 0.0});
    };
    for (Eigen::Index i = 0; i < n; ++i) {
      const int floor = storeys[static_cast<std::size_t>(i)].upper;
      add(bottom, floor, stiffness.row(i).sum());
      for (Eigen::Index j = 0; j < i; ++j)
        add(storeys[static_cast<std::size_t>(j)].upper, floor, -0.5 * (stiffness(i, j) + stiffness(j, i)));
    }
  }

  double mass_above(const Building& building, std::size_t from) const {
    double sum = 0.0;
    for (std::size_t i = from; i < building.nodes.size(); ++i) sum += mass_of(building.nodes[i]);
    return sum;
  }

  // A gap whose clearance is set later, from how far its ends would move without it.
  void add_gap(const std::string& name, const std::string& place, PlainPoint left, PlainPoint right,
               const PlainLaw& law) {
    model_.gaps.push_back({name, place, left, right, 0.0, law});
  }
  static PlainPoint at(int node) { return {node, plain_ground, 0.0}; }
  static PlainPoint fixed() { return {}; }

  double effective_mass(double one, double other) const { return one * other / (one + other); }

  PlainPoint point_near(const Building& building, std::size_t level) {
    const std::size_t n = std::min(level, building.nodes.size() - 1);
    if (n + 1 < building.nodes.size() && draws_.chance(0.35))
      return {building.nodes[n], building.nodes[n + 1], draws_.uniform(0.1, 0.9)};
    return at(building.nodes[n]);
  }

  void join(const Building& left, const Building& right) {
    const std::size_t levels = std::min(left.nodes.size(), right.nodes.size());
    const PlainLaw law = random_law(draws_, 0.5 * mass_of(left.nodes[0]));
    const bool all = draws_.chance(0.3);
    const std::size_t one =
        draws_.chance(0.6) ? levels - 1 : static_cast<std::size_t>(draws_.integer(0, static_cast<int>(levels) - 1));
    for (std::size_t level = 0; level < levels; ++level) {
      if (!all && level != one) continue;
      const std::string name = left.name + " to " + right.name + " " + std::to_string(level + 1);
      add_gap(name, name, point_near(left, level), point_near(right, level), law);
    }
  }

  void add_walls(const Building& building) {
    const int node = building.isolated ? building.nodes[0] : building.nodes.back();
    const double side = draws_.unit();
    const bool flexible = draws_.chance(0.35);
    const double wall_mass = 1e3 * draws_.decades(0.5, 200.0);
    const double frequency = draws_.decades(20.0, 400.0), ratio = draws_.chance(0.3) ? 0.0 : draws_.uniform(0.01, 0.1);
    const PlainLaw law = random_law(draws_, flexible ? effective_mass(mass_of(node), wall_mass) : mass_of(node));
    const std::string place = building.name + " moat";
    const auto face = [&](const std::string& name) {
      if (!flexible) return fixed();
      const int wall = add_node(name + " wall", wall_mass);
      model_.springs.push_back({name + " wall", PlainSpring::Kind::wall, plain_ground, wall,
                                rounded(wall_mass * frequency * frequency),
                                rounded(2.0 * ratio * wall_mass * frequency)});
      return at(wall);
    };
    if (side < 0.65) {
      const PlainPoint wall = face(place + " left");
      add_gap(place + " left", place, wall, at(node), law);
    }
    if (side > 0.35) {
      const PlainPoint wall = face(place + " right");
      add_gap(place + " right", place, at(node), wall, law);
    }
  }

  // A body of its own on the ground, beside the first building or, uncoupled, beside a wall.
  void add_light_body(const Building& building) {
    const double mass = draws_.decades(100.0, 1e4);
    const int body = add_node("body", mass);
    const double frequency = 2.0 * pi / draws_.uniform(0.15, 1.0);
    add_spring("body support", plain_ground, body, mass * frequency * frequency);
    add_dashpot("body damping", plain_ground, body, 2.0 * draws_.uniform(0.005, 0.1) * mass * frequency);
    const PlainPoint other = draws_.chance(0.5) ? fixed() : at(building.nodes.back());
    add_gap("body gap", "body gap", at(body), other, random_law(draws_, mass));
  }

  // A body on springs on a floor, with a stop.
  void add_equipment(const Building& building) {
    const double mass = draws_.decades(100.0, 1e4);
    const int body = add_node("equipment", mass), floor = building.nodes.back();
    const double frequency = 2.0 * pi / draws_.uniform(0.1, 0.6);
    add_spring("equipment support", floor, body, mass * frequency * frequency);
    add_dashpot("equipment damping", floor, body, 2.0 * draws_.uniform(0.01, 0.05) * mass * frequency);
    add_gap("equipment stop", "equipment stop", at(floor), at(body), random_law(draws_, mass));
  }

  void set_clearances() {
    PlainModel open = model_;
    open.gaps.clear();
    const ReferenceResult free = reference_history(open, {.largest_phase = 0.3, .tolerance = 1e-6});
    const auto peak = [&](const std::string& quantity, const std::string& where) {
      for (const ReferencePeak& each : free.peaks)
        if (each.quantity == quantity && each.where == where) return each.value;
      return 0.0;
    };
    const auto reach = [&](const PlainPoint& point) {
      const auto of = [&](int node) {
        return node == plain_ground ? 0.0 : peak("displacement", model_.nodes[static_cast<std::size_t>(node)].name);
      };
      return (1.0 - point.share) * of(point.node) + point.share * of(point.other);
    };
    // Gaps of the same place have the same clearance.
    std::string place;
    double share = 0.0;
    for (PlainGap& gap : model_.gaps) {
      if (gap.place != place) share = draws_.uniform(0.15, 1.0);
      place = gap.place;
      const bool neighbours = gap.left.node != plain_ground && gap.right.node != plain_ground;
      const double way =
          gap.name == "equipment stop" ? peak("drift", "equipment support") : reach(gap.left) + reach(gap.right);
      const bool wall = gap.name.find("moat") != std::string::npos;
      gap.clearance = std::max(rounded(share * (neighbours && !wall ? 0.8 : 1.0) * way, 3), 1e-3);
    }
  }

  RandomDraws draws_, bends_;
  PlainModel model_;
  std::vector<Building> buildings_;
};

}  // namespace

PlainModel random_model(std::uint64_t seed) { return Drawing{seed}.model(); }

}  // namespace moat::testing
