#include "structures/plan_building.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "elements/plan/plan_spring.hpp"
#include "elements/plan/rotation_link.hpp"
#include "materials/linear.hpp"
#include "materials/viscous.hpp"
#include "solvers/dense.hpp"
#include "structures/static_weights.hpp"

namespace moat {
namespace {

// A spring of a storey: at a place along a direction, N/m, or against rotation, N m/rad.
struct StoreySpring {
  std::string name;
  double stiffness;
  PlanPosition at{};
  PlanVector direction{};  // zero: against rotation

  [[nodiscard]] bool turns() const { return direction == PlanVector{}; }
};

const PlanOutline& outline_of_base(const PlanBuilding& building) {
  return building.base_outline.empty() ? building.outline.of(1) : building.base_outline;
}

void check_parameters(const PlanBuilding& building) {
  const Check check{"PlanBuilding", building.name};
  check.that(building.storeys >= 1, "storeys", building.storeys, "", ">= 1");
  building.outline.check_count(check, "outline", building.storeys);
  building.mass_offset.check_count(check, "mass_offset", building.storeys);
  building.rotary_inertia.check_count(check, "rotary_inertia", building.storeys);
  for (int floor = 1; floor <= building.storeys; ++floor) {
    const std::string of_floor = " of floor " + std::to_string(floor);
    building.outline.of(floor).check(check, building.outline.is_list() ? "outline" + of_floor : "outline");
    check.not_negative("rotary_inertia" + of_floor, building.rotary_inertia.of(floor));
  }
  if (!building.base_outline.empty()) building.base_outline.check(check, "base_outline");
  check.not_negative("base_rotary_inertia", building.base_rotary_inertia);
  building.floor_mass.check(check, "floor_mass", building.storeys);
  building.storey_height.check(check, "storey_height", building.storeys);
  if (building.axial_forces) {
    check_axial_forces(check, *building.axial_forces, building.storey_height.is_given());
    check.that(static_cast<bool>(building.bearings), "axial_forces are asked without bearings.",
               "Give .bearings, or leave .axial_forces out.");
  }
  building.columns.check_count(check, "columns", building.storeys);
  if (building.bearings)
    check.positive("base_mass", building.base_mass, "A building on bearings needs the mass of its base floor.");
  else
    check.that(building.base_mass == Mass{}, "base_mass", building.base_mass.si(), "kg",
               "left out without bearings: the ground is the base", "Give .bearings, or leave out .base_mass.");
}

std::vector<StoreySpring> springs_of_storey(const Check& check, const PlanColumns& columns, const PlanOutline& outline,
                                            const std::string& storey) {
  std::vector<StoreySpring> springs;
  const auto add_both = [&](PlanPosition at, Stiffness x, Stiffness y, const std::string& name) {
    if (x.si() > 0.0) springs.push_back({name + " x", x.si(), at, {1.0, 0.0}});
    if (y.si() > 0.0) springs.push_back({name + " y", y.si(), at, {0.0, 1.0}});
  };
  if (const StoreyStiffness* whole = columns.whole()) {
    check.positive(storey + " columns.x", whole->x);
    check.positive(storey + " columns.y", whole->y);
    check.positive(storey + " columns.rotation", whole->rotation.si(), "N m/rad");
    add_both(whole->centre_of_rigidity, whole->x, whole->y, storey);
    springs.push_back({storey + " rotation", whole->rotation.si()});
    return springs;
  }
  int number = 0;
  for (const ColumnLine& line : columns.lines(check, outline)) {
    const std::string name = storey + " column " + std::to_string(++number);
    check.not_negative(name + " stiffness along x", line.column.along_x());
    check.not_negative(name + " stiffness along y", line.column.along_y());
    add_both(line.at, line.column.along_x(), line.column.along_y(), name);
  }
  return springs;
}

std::vector<PlanPosition> column_positions(const Check& check, const PlanColumns& columns, const PlanOutline& outline) {
  std::vector<PlanPosition> positions;
  if (columns.whole() != nullptr) return positions;
  for (const ColumnLine& line : columns.lines(check, outline)) positions.push_back(line.at);
  return positions;
}

// A law between two floors, at a place along a direction.
template <class Law>
PlanSpring<Law> unreported(const std::string& name, NodeId lower, NodeId upper, PlanPosition at, PlanVector direction,
                           const Law& law) {
  return {.name = name,
          .lower = PlanPoint{lower, at},
          .upper = PlanPoint{upper, at},
          .direction = direction,
          .law = law,
          .deformation_quantity = "",
          .force_quantity = ""};
}

void add_spring(Model& model, const StoreySpring& spring, NodeId lower, NodeId upper) {
  if (spring.turns())
    add(model, RotationSpring{spring.name, lower, upper, Energy{spring.stiffness}});
  else
    add(model, unreported(spring.name, lower, upper, spring.at, spring.direction,
                          Linear{.stiffness = Stiffness{spring.stiffness}}));
}

void add_dashpot(Model& model, const StoreySpring& beside, double factor, NodeId lower, NodeId upper) {
  const std::string name = beside.name + " damping";
  const double damping = factor * beside.stiffness;
  if (beside.turns())
    add(model, RotationDamper{name, lower, upper, Quantity<1, 4, -1>{damping}});
  else
    add(model,
        unreported(name, lower, upper, beside.at, beside.direction, Viscous{.damping = DampingCoefficient{damping}}));
}

// The forces of springs between two floors that are sums over their displacements: each spring counts with a factor.
class StoreyForce {
 public:
  StoreyForce(const Model& model, NodeId lower, DiaphragmId upper) : model_{model}, lower_{lower}, upper_{upper} {}

  void add(const StoreySpring& spring, double factor) {
    for (const auto& [body, sign] : {std::pair{lower_, -1.0}, {upper_.x, 1.0}}) {
      const PlacedDiaphragm* floor = body == ground ? nullptr : model_.diaphragm_of(body);
      if (floor == nullptr) continue;
      const PlanVector arm = PlanVector{spring.at.x.si(), spring.at.y.si()} - floor->centre_of_mass;
      const double force = sign * factor * spring.stiffness;
      weights_[floor->id.x] += force * spring.direction.x;
      weights_[floor->id.y] += force * spring.direction.y;
      weights_[floor->id.r] += force * (spring.turns() ? 1.0 : cross(arm, spring.direction)) / floor->gyration;
    }
  }
  void append_to(std::vector<MotionShare>& list, double factor) const {
    for (const auto& [node, weight] : weights_) list.push_back({node, factor * weight});
  }
  [[nodiscard]] std::vector<MotionShare> shares() const {
    std::vector<MotionShare> list;
    append_to(list, 1.0);
    return list;
  }

 private:
  const Model& model_;
  NodeId lower_;
  DiaphragmId upper_;
  std::map<NodeId, double> weights_;
};

class Builder {
 public:
  Builder(Model& model, const PlanBuilding& building)
      : model_{model},
        building_{building},
        check_{"PlanBuilding", building.name},
        prefix_{building.name.empty() ? "" : building.name + " "} {}

  PlanBuildingParts build() {
    add_diaphragms();
    add_storeys();
    add_bearings();
    Building building{.name = building_.name, .base = base_};
    for (const DiaphragmId& floor : parts_.floors) building.floors.push_back(floor);
    building.storey_results = results_;
    building.axial_forces = building_.axial_forces;
    add(model_, building);
    return parts_;
  }

 private:
  DiaphragmId diaphragm(const std::string& part, Mass mass, RotaryInertia rotary_inertia, const PlanOutline& outline,
                        PlanPosition offset, Length height) {
    const PlanVector centre = outline.centroid();
    return add(model_, Diaphragm{.name = prefix_ + part,
                                 .mass = mass,
                                 .rotary_inertia = rotary_inertia,
                                 .centre_of_mass = {Length{centre.x} + offset.x, Length{centre.y} + offset.y},
                                 .outline = outline,
                                 .height = height});
  }

  void add_diaphragms() {
    parts_.name = building_.name;
    Length height{};
    if (building_.bearings) {
      parts_.base = diaphragm("base", building_.base_mass, building_.base_rotary_inertia, outline_of_base(building_),
                              building_.base_mass_offset, height);
      base_ = parts_.base;
    }
    for (int floor = 1; floor <= building_.storeys; ++floor) {
      height += building_.storey_height.of(floor);
      parts_.floors.push_back(diaphragm("floor " + std::to_string(floor), building_.floor_mass.of(floor),
                                        building_.rotary_inertia.of(floor), building_.outline.of(floor),
                                        building_.mass_offset.of(floor), height));
    }
  }

  [[nodiscard]] NodeId below(std::size_t floor) const { return floor == 0 ? base_ : parts_.floors[floor - 1].x; }

  void add_storeys() {
    std::vector<std::vector<StoreySpring>> storeys;
    for (std::size_t i = 0; i < parts_.floors.size(); ++i) {
      const std::string storey = "storey " + std::to_string(i + 1);
      const int number = static_cast<int>(i) + 1;
      const PlanColumns& columns = building_.columns.of(number);
      storeys.push_back(springs_of_storey(check_, columns, building_.outline.of(number), prefix_ + storey));
      parts_.columns.push_back(column_positions(check_, columns, building_.outline.of(number)));
      for (const StoreySpring& spring : storeys.back()) add_spring(model_, spring, below(i), parts_.floors[i]);
      // No storey above is there yet.
      require_stiffness(storey, stiffness_of_floors(model_, {parts_.floors[i]}));
    }
    results_ = storey_results(storeys);
    const std::optional<RayleighFactors> given = given_factors(building_.damping);
    const RayleighFactors rayleigh =
        given ? *given : rayleigh_factors_in_plan(building_.damping.ratio, model_, parts_.floors);
    for (std::size_t i = 0; i < storeys.size(); ++i) {
      for (const StoreySpring& spring : storeys[i])
        if (rayleigh.stiffness_factor > 0.0)
          add_dashpot(model_, spring, rayleigh.stiffness_factor, below(i), parts_.floors[i]);
      if (rayleigh.mass_factor > 0.0) add_mass_damping(i, rayleigh.mass_factor);
    }
  }

  // Shears and torque of the columns of every storey, and the moments of the forces on all floors above its lower one.
  // The torque is about the base's centre of mass, or that of the lowest floor.
  [[nodiscard]] std::vector<StoreyResult> storey_results(const std::vector<std::vector<StoreySpring>>& storeys) const {
    const PlanVector origin = model_.diaphragm(building_.bearings ? parts_.base : parts_.floors[0]).centre_of_mass;
    std::vector<StoreyResult> results;
    std::vector<MotionShare> moment_x, moment_y;
    for (std::size_t i = storeys.size(); i-- > 0;) {
      StoreyForce shear_x{model_, below(i), parts_.floors[i]}, shear_y = shear_x, torque = shear_x;
      for (const StoreySpring& spring : storeys[i]) {
        const PlanVector arm = PlanVector{spring.at.x.si(), spring.at.y.si()} - origin;
        shear_x.add(spring, spring.direction.x);
        shear_y.add(spring, spring.direction.y);
        torque.add(spring, spring.turns() ? 1.0 : cross(arm, spring.direction));
      }
      const double height = building_.storey_height.of(static_cast<int>(i) + 1).si();
      shear_x.append_to(moment_x, height);
      shear_y.append_to(moment_y, height);
      const auto add = [&](const char* quantity, const char* unit, std::vector<MotionShare> shares) {
        const std::string place = prefix_ + "storey " + std::to_string(i + 1);
        results.push_back({.quantity = quantity, .place = place, .unit = unit, .displacements = std::move(shares)});
      };
      add("overturning_moment_y", "N m", moment_y);
      add("overturning_moment_x", "N m", moment_x);
      add("storey_torque", "N m", torque.shares());
      add("storey_shear_y", "N", shear_y.shares());
      add("storey_shear_x", "N", shear_x.shares());
    }
    std::ranges::reverse(results);
    return results;
  }

  void require_stiffness(const std::string& storey, const Eigen::MatrixXd& stiffness) const {
    constexpr double round_off = 1e-9;
    const Eigen::VectorXd values = eigen_pairs(stiffness).values;
    check_.that(values[0] > round_off * values[2],
                storey + " does not resist every motion in plan: the smallest eigenvalue of its stiffness is " +
                    to_text(std::max(values[0], 0.0)) + " N/m.",
                "Give column lines at two places at least, with stiffness along x and along y, or a StoreyStiffness.");
  }

  // On the motion of a floor relative to the rigid motion of the base, at the floor's centre of mass.
  void add_mass_damping(std::size_t i, double factor) {
    const PlacedDiaphragm floor = model_.diaphragm(parts_.floors[i]);
    const PlanPosition centre{Length{floor.centre_of_mass.x}, Length{floor.centre_of_mass.y}};
    const std::string name = floor.name + " damping";
    for (const auto& [component, direction] :
         {std::pair{" x", PlanVector{1.0, 0.0}}, std::pair{" y", PlanVector{0.0, 1.0}}})
      add(model_, unreported(name + component, base_, floor.id, centre, direction,
                             Viscous{.damping = DampingCoefficient{factor * floor.mass}}));
    add(model_, RotationDamper{name + " rotation", base_, floor.id,
                               Quantity<1, 4, -1>{factor * floor.mass * floor.gyration * floor.gyration}});
  }

  void add_bearings() {
    if (!building_.bearings) return;
    double mass = 0.0;
    PlanVector moment{};
    for (const DiaphragmId& id : parts_.diaphragms()) {
      const PlacedDiaphragm& floor = model_.diaphragm(id);
      mass += floor.mass;
      moment += floor.mass * floor.centre_of_mass;
    }
    building_.bearings.add_under(model_, check_, prefix_, parts_.base, outline_of_base(building_),
                                 Mass{mass} * units::g, building_.axial_forces, moment / mass);
  }

  Model& model_;
  const PlanBuilding& building_;
  Check check_;
  std::string prefix_;
  NodeId base_ = ground;
  PlanBuildingParts parts_;
  std::vector<StoreyResult> results_;
};

}  // namespace

std::vector<DiaphragmId> PlanBuildingParts::diaphragms() const {
  std::vector<DiaphragmId> list;
  if (base.specified()) list.push_back(base);
  list.insert(list.end(), floors.begin(), floors.end());
  return list;
}

PlanBuildingParts add(Model& model, const PlanBuilding& building) {
  check_parameters(building);
  const std::string floor = building.name.empty() ? "floor 1" : building.name + " floor 1";
  Check{"PlanBuilding", building.name}.that(!model.has_node(floor + ":x"),
                                            "the model has a diaphragm \"" + floor + "\" already.",
                                            "Give every building its own .name.");
  return Builder{model, building}.build();
}

PlanBuilding with_eccentricity(PlanBuilding building, double share_of_x, double share_of_y) {
  const Check check{"with_eccentricity", building.name};
  check.between("share_of_x", share_of_x, -0.5, 0.5, "1", "5 % is 0.05.");
  check.between("share_of_y", share_of_y, -0.5, 0.5, "1", "5 % is 0.05.");
  check_parameters(building);
  const auto moved = [&](PlanPosition offset, const PlanOutline& outline) -> PlanPosition {
    const auto extent = [&](Length PlanPosition::*component) {
      const auto [low, high] = std::ranges::minmax(outline.corners, {}, component);
      return high.*component - low.*component;
    };
    return {offset.x + share_of_x * extent(&PlanPosition::x), offset.y + share_of_y * extent(&PlanPosition::y)};
  };
  std::vector<PlanPosition> offsets;
  for (int floor = 1; floor <= building.storeys; ++floor)
    offsets.push_back(moved(building.mass_offset.of(floor), building.outline.of(floor)));
  building.mass_offset = offsets;
  building.base_mass_offset = moved(building.base_mass_offset, outline_of_base(building));
  return building;
}

std::array<PlanBuilding, 4> accidental_eccentricities(const PlanBuilding& building, double share) {
  return {with_eccentricity(building, share, 0.0), with_eccentricity(building, -share, 0.0),
          with_eccentricity(building, 0.0, share), with_eccentricity(building, 0.0, -share)};
}

}  // namespace moat
