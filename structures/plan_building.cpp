#include "structures/plan_building.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>

#include "base/check.hpp"
#include "elements/plan/plan_spring.hpp"
#include "elements/plan/rotation_link.hpp"
#include "materials/linear.hpp"
#include "materials/viscous.hpp"

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

void check_parameters(const PlanBuilding& building) {
  const Check check{"PlanBuilding", building.name};
  building.outline.value().check(check, "outline");
  check.that(building.storeys >= 1, "storeys", building.storeys, "", ">= 1");
  building.floor_mass.check(check, "floor_mass", building.storeys);
  building.storey_height.check(check, "storey_height", building.storeys);
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
    add(model_, building);
    return parts_;
  }

 private:
  DiaphragmId diaphragm(const std::string& part, Mass mass, PlanPosition offset, Length height) {
    const PlanOutline& outline = building_.outline;
    const PlanVector centre = outline.centroid();
    return add(model_, Diaphragm{.name = prefix_ + part,
                                 .mass = mass,
                                 .centre_of_mass = {Length{centre.x} + offset.x, Length{centre.y} + offset.y},
                                 .outline = outline,
                                 .height = height});
  }

  void add_diaphragms() {
    parts_.name = building_.name;
    Length height{};
    if (building_.bearings) {
      parts_.base = diaphragm("base", building_.base_mass, building_.base_mass_offset, height);
      base_ = parts_.base;
    }
    for (int floor = 1; floor <= building_.storeys; ++floor) {
      height += building_.storey_height.of(floor);
      parts_.floors.push_back(
          diaphragm("floor " + std::to_string(floor), building_.floor_mass.of(floor), building_.mass_offset, height));
    }
  }

  [[nodiscard]] NodeId below(std::size_t floor) const { return floor == 0 ? base_ : parts_.floors[floor - 1].x; }

  void add_storeys() {
    std::vector<std::vector<StoreySpring>> storeys;
    for (std::size_t i = 0; i < parts_.floors.size(); ++i) {
      const std::string storey = "storey " + std::to_string(i + 1);
      storeys.push_back(springs_of_storey(check_, building_.columns.of(static_cast<int>(i) + 1), building_.outline,
                                          prefix_ + storey));
      for (const StoreySpring& spring : storeys.back()) add_spring(model_, spring, below(i), parts_.floors[i]);
      // No storey above is there yet.
      require_stiffness(storey, stiffness_of_floors(model_, {parts_.floors[i]}));
    }
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

  void require_stiffness(const std::string& storey, const Eigen::MatrixXd& stiffness) const {
    constexpr double round_off = 1e-9;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{stiffness, Eigen::EigenvaluesOnly};
    check_.that(solver.eigenvalues()[0] > round_off * solver.eigenvalues()[2],
                storey + " does not resist every motion in plan: the smallest eigenvalue of its stiffness is " +
                    to_text(std::max(solver.eigenvalues()[0], 0.0)) + " N/m.",
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
    const auto bearings = building_.bearings->placed(check_, building_.outline);
    check_.that(!bearings.empty(), "bearings: the list is empty.", "Give at least one bearing.");
    double mass = building_.base_mass.si();
    for (int floor = 1; floor <= building_.storeys; ++floor) mass += building_.floor_mass.of(floor).si();
    const Force share = Mass{mass / static_cast<double>(bearings.size())} * units::g;
    int number = 0;
    for (const PlanBearings::Placed& bearing : bearings)
      bearing.add_to(model_, {prefix_ + "bearing " + std::to_string(++number), prefix_ + "bearings"}, parts_.base,
                     bearing.at, share);
  }

  Model& model_;
  const PlanBuilding& building_;
  Check check_;
  std::string prefix_;
  NodeId base_ = ground;
  PlanBuildingParts parts_;
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
  const PlanOutline& outline = building.outline;
  outline.check(check, "outline");
  const auto extent = [&](Length PlanPosition::*component) {
    const auto [low, high] = std::ranges::minmax(outline.corners, {}, component);
    return high.*component - low.*component;
  };
  const Length x = share_of_x * extent(&PlanPosition::x), y = share_of_y * extent(&PlanPosition::y);
  for (PlanPosition* offset : {&building.mass_offset, &building.base_mass_offset}) {
    offset->x += x;
    offset->y += y;
  }
  return building;
}

std::array<PlanBuilding, 4> accidental_eccentricities(const PlanBuilding& building, double share) {
  return {with_eccentricity(building, share, 0.0), with_eccentricity(building, -share, 0.0),
          with_eccentricity(building, 0.0, share), with_eccentricity(building, 0.0, -share)};
}

}  // namespace moat
