#include "structures/superstructure/superstructure.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "elements/matrix/linear_structure.hpp"
#include "solvers/dense.hpp"
#include "structures/frame/constraints.hpp"
#include "structures/superstructure/condensed_rows.hpp"
#include "structures/superstructure/storey_results.hpp"
#include "structures/superstructure/structure_floors.hpp"
#include "structures/superstructure/structure_system.hpp"

namespace moat {
namespace {

std::vector<NodeId> nodes_of(const DiaphragmId& floor, bool in_plan) {
  return in_plan ? std::vector<NodeId>{floor.x, floor.y, floor.r} : std::vector<NodeId>{floor.x};
}

// Adds the parts of one superstructure.
class Builder {
 public:
  Builder(Model& model, const Superstructure& structure)
      : model_{model},
        structure_{structure},
        system_{system_of(structure, existing_bases(model, structure))},
        prefix_{structure.name.empty() ? "" : structure.name + " "} {}

  SuperstructureParts build() {
    check_supports();
    parts_.name = structure_.name;
    parts_.modes = system_.modes;
    parts_.notes = system_.notes;
    const std::vector<std::string>& of_bearings = structure_.bearings.notes();
    parts_.notes.insert(parts_.notes.end(), of_bearings.begin(), of_bearings.end());
    if (structure_.base) {
      parts_.base = add_own("base", system_.bases.front());
      base_ = nodes_of(parts_.base, system_.in_plan);
    } else if (!structure_.on.empty()) {
      parts_.base = structure_.on.front();
      for (const DiaphragmId& slab : structure_.on)
        for (const NodeId node : nodes_of(slab, system_.in_plan)) base_.push_back(node);
    }
    if (system_.shapes.size() > 0)
      add_modes();
    else
      add_matrices();
    add_isolators();
    std::vector<std::string> towers;
    for (const SystemFloor& floor : system_.floors)
      if (std::ranges::count(towers, floor.tower) == 0) towers.push_back(floor.tower);
    for (const std::string& tower : towers) add_building(tower);
    for (const std::string& note : parts_.notes)
      model_.add_note((structure_.name.empty() ? "Building" : structure_.name) + ": " + note);
    return std::move(parts_);
  }

 private:
  void check_supports() const {
    const Check check{"Superstructure", structure_.name};
    if (structure_.axial_forces) {
      check_axial_forces(check, *structure_.axial_forces, true);
      check.that(bool{structure_.bearings} || structure_.isolation,
                 "axial_forces are asked without bearings of its own.",
                 "Give them to the building that has the bearings.");
      if (structure_.base && structure_.base->carried.si() > 0.0 && structure_.bearings)
        for (const PlanBearings::Placed& bearing :
             std::vector<PlanBearings::Placed>{structure_.bearings.placed(check, system_.bases.front().outline)})
          check.that(bearing.weight.si() > 0.0,
                     "axial_forces: the base carries other buildings, and the centre of their mass is not known.",
                     "Give the weight of each bearing.");
    }
    if (!structure_.on.empty()) {
      check.that(!structure_.base && !structure_.bearings && !structure_.isolation,
                 "it stands on the base of another building, and base or bearings are given.",
                 "That base has them already.");
      for (const DiaphragmId& base : structure_.on) {
        check.that(!base.x.is_follower(), "it stands on a floor that is given by modes.",
                   "Give the base of that building, or the matrix of both together.");
        check.that(system_.in_plan == (model_.diaphragm_of(base) != nullptr),
                   system_.in_plan ? "on is no diaphragm." : "on is a diaphragm, and the building moves on a line.",
                   "Give the base of a building of the same kind.");
      }
      return;
    }
    check.that(structure_.base.has_value() == (bool{structure_.bearings} || structure_.isolation),
               structure_.base ? "base is given without bearings." : "bearings are given without base.",
               "Give both, or none: the building then stands on the ground.");
    if (!structure_.base) return;
    check.that(bool{structure_.bearings} == system_.in_plan,
               system_.in_plan ? "isolation is for a building on a line." : "bearings are for a building in plan.",
               system_.in_plan ? "Give .bearings." : "Give .isolation.");
    check.that(bool{structure_.bearings} != structure_.isolation.has_value(), "bearings and isolation are given.",
               "Give one of them.");
  }

  // The building that counts this base or slab already; null if there is none.
  [[nodiscard]] const Building* building_of(NodeId slab) const {
    const auto found = std::ranges::find_if(model_.buildings(), [&](const Building& each) {
      const std::vector<NodeId> nodes = each.nodes();
      return std::ranges::find(nodes, slab) != nodes.end();
    });
    return found == model_.buildings().end() ? nullptr : &*found;
  }

  // A tower is a building on the floor below it.
  void add_building(const std::string& tower) {
    const bool separated = !structure_.name.empty() && !tower.empty();
    Building building{.name = structure_.name + (separated ? " " : "") + tower};
    if (system_.is_isolated()) building.base = parts_.base;
    for (std::size_t i = 0; i < system_.floors.size(); ++i) {
      if (system_.floors[i].tower != tower) continue;
      const int below = level_below(system_.floors, i);
      if (building.floors.empty() && below >= 0) building.base = parts_.floors[static_cast<std::size_t>(below)];
      building.floors.push_back(parts_.floors[i]);
    }
    const Building* const carrying = building.base == ground ? nullptr : building_of(building.base);
    building.shares_base = carrying != nullptr;
    if (tower == system_.floors[0].tower) {
      building.modes = parts_.modes;
      building.axial_forces = structure_.axial_forces;
      add_slabs(building, carrying);
    }
    building.storey_results = storey_results(system_, rows_, tower, building.name.empty() ? "" : building.name + " ");
    add(model_, std::move(building));
  }
  void add_slabs(Building& building, const Building* carrying) {
    for (std::size_t i = 1; i < structure_.on.size(); ++i) {
      const NodeId slab = structure_.on[i];
      const Building* const its = building_of(slab);
      if (its == nullptr)
        building.slabs.push_back(slab);
      else if (its != carrying)
        parts_.notes.push_back(
            "\"" + std::string{model_.body_name(slab)} +
            "\" belongs to another building than the first slab, whose base shear counts the inertia "
            "of all floors alone.");
    }
  }

  // A node or diaphragm with degrees of freedom of its own.
  DiaphragmId add_own(const std::string& part, const SystemFloor& floor) {
    if (system_.in_plan) return add(model_, diaphragm(part, floor));
    return {.x = add(model_, node(part, floor))};
  }
  [[nodiscard]] Node node(const std::string& part, const SystemFloor& floor) const {
    return {.name = prefix_ + part,
            .mass = Mass{floor.mass},
            .height = Length{floor.height},
            .half_width = Length{floor.half_width}};
  }
  [[nodiscard]] Diaphragm diaphragm(const std::string& part, const SystemFloor& floor) const {
    return {.name = prefix_ + part,
            .mass = Mass{floor.mass},
            .rotary_inertia = RotaryInertia{floor.rotary_inertia},
            .centre_of_mass = {Length{floor.centre_of_mass.x}, Length{floor.centre_of_mass.y}},
            .outline = floor.outline,
            .height = Length{floor.height}};
  }

  void add_matrices() {
    for (std::size_t i = 0; i < system_.floors.size(); ++i) {
      parts_.floors.push_back(add_own(system_.floors[i].name, system_.floors[i]));
      for (const NodeId each : nodes_of(parts_.floors[i], system_.in_plan)) rows_.own.push_back(each);
    }
    rows_.base = base_;
    Eigen::MatrixXd coupled = system_.mass;
    for (Eigen::Index i = 0; i < coupled.rows(); ++i)
      coupled(i, i) -= model_.mass(rows_.own[static_cast<std::size_t>(i)]);
    const double round_off = 1e-12 * system_.mass.diagonal().maxCoeff();
    if (coupled.cwiseAbs().maxCoeff() > round_off) model_.add_mass(rows_.own, coupled);
    if (system_.between_bases.size() > 0)
      add(model_, LinearStructure{.name = prefix_ + "slabs",
                                  .nodes = {base_.begin() + system_.per_floor(), base_.end()},
                                  .base = {base_.begin(), base_.begin() + system_.per_floor()},
                                  .carried = system_.bases_rigid,
                                  .stiffness = system_.between_bases});
    add(model_, LinearStructure{.name = prefix_ + "superstructure",
                                .nodes = rows_.own,
                                .base = base_,
                                .carried = base_.empty() ? Eigen::MatrixXd{} : system_.carried,
                                .stiffness = system_.stiffness,
                                .damping = system_.damping});
  }

  // The modes are coordinates q beside the base, and the floors follow both.
  void add_modes() {
    const Eigen::MatrixXd load = projected(system_.shapes, system_.mass, system_.carried);
    Eigen::MatrixXd mass = projected(system_.shapes, system_.mass, system_.shapes);
    mass = 0.5 * (mass + mass.transpose()).eval();
    // On the ground the coordinates are driven by M_q^-1 L; on a base its motion drives them.
    const Eigen::MatrixXd driven = solve_definite(mass, load);
    const Eigen::VectorXd lifted =
        solve_definite(mass, projected(system_.shapes, system_.mass, system_.motions.col(2)));
    GeneralisedBody body{
        .name = prefix_ + "modes", .coordinates = {}, .mass = mass, .height = Length{system_.floors.back().height}};
    for (Eigen::Index k = 0; k < mass.rows(); ++k) {
      GeneralisedCoordinate coordinate{.name = "mode " + std::to_string(k + 1)};
      coordinate.ground_influence.z = lifted[k];
      if (base_.empty()) coordinate.ground_influence = {driven(k, 0), system_.in_plan ? driven(k, 1) : 0.0, lifted[k]};
      body.coordinates.push_back(std::move(coordinate));
    }
    rows_.own = add(model_, body);
    if (!base_.empty()) couple_with_base(load);
    add(model_, LinearStructure{.name = prefix_ + "superstructure",
                                .nodes = rows_.own,
                                .stiffness = system_.modal_stiffness.asDiagonal(),
                                .damping = system_.damping});
    for (std::size_t i = 0; i < system_.floors.size(); ++i) add_following_floor(i);
  }

  void couple_with_base(const Eigen::MatrixXd& load) {
    const Eigen::Index n = load.rows(), m = load.cols();
    Eigen::MatrixXd coupled = Eigen::MatrixXd::Zero(n + m, n + m);
    coupled.topRightCorner(n, m) = load;
    coupled.bottomLeftCorner(m, n) = load.transpose();
    const Eigen::MatrixXd carried_mass = projected(system_.carried, system_.mass, system_.carried);
    coupled.bottomRightCorner(m, m) = 0.5 * (carried_mass + carried_mass.transpose());
    std::vector<NodeId> both = rows_.own;
    both.insert(both.end(), base_.begin(), base_.end());
    model_.add_mass(both, coupled);
  }

  void add_following_floor(std::size_t i) {
    constexpr std::array along{GroundVector{1.0, 0.0, 0.0}, GroundVector{0.0, 1.0, 0.0}, GroundVector{}};
    Follower motion;
    for (int k = 0; k < system_.per_floor(); ++k) {
      const auto row = static_cast<Eigen::Index>(i) * system_.per_floor() + k;
      std::vector<MotionShare> shares;
      for (std::size_t j = 0; j < base_.size(); ++j)
        if (const double weight = system_.carried(row, static_cast<Eigen::Index>(j)); weight != 0.0)
          shares.push_back({base_[j], weight});
      for (std::size_t j = 0; j < rows_.own.size(); ++j)
        shares.push_back({rows_.own[j], system_.shapes(row, static_cast<Eigen::Index>(j))});
      motion.shares.push_back(std::move(shares));
      motion.ground_influence.push_back(along[static_cast<std::size_t>(k)]);
    }
    const std::string& part = system_.floors[i].name;
    if (system_.in_plan)
      parts_.floors.push_back(add(model_, diaphragm(part, system_.floors[i]), std::move(motion)));
    else
      parts_.floors.push_back({.x = add(model_, node(part, system_.floors[i]), std::move(motion))});
  }

  void add_isolators() {
    if (!structure_.base) return;
    Check{"Superstructure", structure_.name}.not_negative("carried of the base", structure_.base->carried);
    double mass = system_.bases.front().mass;
    PlanVector moment = mass * system_.bases.front().centre_of_mass;
    for (const SystemFloor& floor : system_.floors) {
      mass += floor.mass;
      moment += floor.mass * floor.centre_of_mass;
    }
    const PlanVector centre = moment / mass;
    mass += structure_.base->carried.si();
    const Force weight = Mass{mass} * units::g;
    if (structure_.isolation)
      structure_.isolation->add_to(model_, prefix_, parts_.base, weight, structure_.axial_forces);
    if (!structure_.bearings) return;
    const Check check{"Superstructure", structure_.name};
    structure_.bearings.add_under(model_, check, prefix_, parts_.base, system_.bases.front().outline, weight,
                                  structure_.axial_forces, centre);
  }

  Model& model_;
  const Superstructure& structure_;  // outlives this object
  const StructureSystem system_;
  const std::string prefix_;
  SuperstructureParts parts_;
  std::vector<NodeId> base_;
  StructureRows rows_;
};

}  // namespace

std::vector<double> SuperstructureParts::periods() const {
  std::vector<double> list;
  for (const ParticipatingMass& mode : modes) list.push_back(mode.period);
  return list;
}

StructureModes structure_modes(const ModesFromFile& file, const StructureModes& units) {
  StructureModes modes = units;
  modes.periods.clear();
  modes.eigenvalues.assign(file.eigenvalues.begin(), file.eigenvalues.end());
  modes.shapes = file.shapes;
  modes.ratios = file.ratios;
  modes.names = file.names;
  modes.notes = file.notes;
  return modes;
}

SuperstructureParts add(Model& model, const Superstructure& structure) {
  const Superstructure given = with_condensed_rows(structure);
  return Builder{model, given}.build();
}

}  // namespace moat
