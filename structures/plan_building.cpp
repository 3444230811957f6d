#include "structures/plan_building.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "solvers/dense.hpp"
#include "structures/plan_storeys.hpp"
#include "structures/static_weights.hpp"

namespace moat {
namespace {

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

std::vector<PlanPosition> column_positions(const Check& check, const PlanColumns& columns, const PlanOutline& outline) {
  std::vector<PlanPosition> positions;
  if (columns.whole() != nullptr) return positions;
  for (const ColumnLine& line : columns.lines(check, outline)) positions.push_back(line.at);
  return positions;
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
    std::vector<PlanStorey> storeys;
    for (std::size_t i = 0; i < parts_.floors.size(); ++i) {
      const int number = static_cast<int>(i) + 1;
      const std::string name = "storey " + std::to_string(number);
      const PlanColumns& columns = building_.columns.of(number);
      const PlanOutline& outline = building_.outline.of(number);
      storeys.push_back({prefix_ + name, below(i), parts_.floors[i], building_.storey_height.of(number).si(),
                         springs_of_storey(check_, columns, outline, prefix_ + name)});
      parts_.columns.push_back(column_positions(check_, columns, outline));
      add_springs(model_, storeys.back());
      // No storey above is there yet.
      require_stiffness(name, stiffness_of_floors(model_, {parts_.floors[i]}));
    }
    // About the base's centre of mass, or that of the lowest floor.
    results_ = storey_results(model_, storeys,
                              model_.diaphragm(building_.bearings ? parts_.base : parts_.floors[0]).centre_of_mass);
    const std::optional<RayleighFactors> given = given_factors(building_.damping);
    const RayleighFactors rayleigh =
        given ? *given : rayleigh_factors_in_plan(building_.damping.ratio, model_, parts_.floors);
    for (const PlanStorey& storey : storeys) {
      if (rayleigh.stiffness_factor > 0.0) add_dashpots(model_, storey, rayleigh.stiffness_factor);
      if (rayleigh.mass_factor > 0.0) add_mass_damping(model_, base_, storey.upper, rayleigh.mass_factor);
    }
  }

  void require_stiffness(const std::string& storey, const Eigen::MatrixXd& stiffness) const {
    constexpr double round_off = 1e-9;
    const Eigen::VectorXd values = eigen_pairs(stiffness).values;
    check_.that(values[0] > round_off * values[2],
                storey + " does not resist every motion in plan: the smallest eigenvalue of its stiffness is " +
                    to_text(std::max(values[0], 0.0)) + " N/m.",
                "Give column lines at two places at least, with stiffness along x and along y, or a StoreyStiffness.");
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
