#include "structures/superstructure/condensed_rows.hpp"

#include "structures/storey_matrices.hpp"
#include "structures/superstructure/matrix_checks.hpp"

namespace moat {

Superstructure with_condensed_rows(const Superstructure& structure) {
  Superstructure given = structure;
  if (structure.storeys) {
    Check{"Superstructure", structure.name}.that(!structure.condensed, "storeys and condensed are given.",
                                                 "Give one of them.");
    given.condensed = storey_matrices(*structure.storeys);
    if (const std::optional<StoreyRow>& base = structure.storeys->base; base && !given.base)
      given.base = SuperstructureBase{.mass = base->mass,
                                      .rotary_inertia = base->rotary_inertia,
                                      .centre_of_mass = base->centre_of_mass,
                                      .outline = base->outline};
  } else if (const Level* base = given.condensed ? given.condensed->base() : nullptr;
             base != nullptr && !given.base && (given.bearings || given.isolation)) {
    given.base = SuperstructureBase{.mass = Mass{base->mass},
                                    .rotary_inertia = RotaryInertia{base->rotary_inertia},
                                    .centre_of_mass = {Length{base->centre_of_mass.x}, Length{base->centre_of_mass.y}}};
  }
  return given;
}

std::vector<Level> levels_of_floors(const CondensedStructure& condensed) {
  return {condensed.levels.begin() + (condensed.base() != nullptr ? 1 : 0), condensed.levels.end()};
}

void add_kept_motions(const CondensedStructure& condensed, StructureSystem& system) {
  const PlanVector moved = system.in_plan ? system.origin() : PlanVector{};
  const int of_base = condensed.base() != nullptr ? 1 : 0;
  Eigen::Index at = system.motions.rows();
  system.motions.conservativeResize(at + std::ssize(condensed.kept), Eigen::NoChange);
  for (const KeptMotion& motion : condensed.kept) {
    auto row = system.motions.row(at++);
    row = motion.rigid.transpose();
    row[3] -= moved.y * row[2];
    row[4] += moved.x * row[2];
    row[5] += moved.y * row[0] - moved.x * row[1];
    system.floor_of_row.push_back(static_cast<int>(motion.level) - of_base);
    system.names.push_back(motion.name);
  }
}

void check_base_level(const Superstructure& structure, const Check& check, const StructureSystem& system) {
  const Level* level = structure.condensed ? structure.condensed->base() : nullptr;
  if (level == nullptr) return;
  const auto n = structure.condensed->mass.rows() - system.per_floor();
  check.that(structure.condensed->mass.bottomLeftCorner(n, system.per_floor()).isZero(0.0),
             "masses couple the level " + level->name + " with others.",
             "Leave this level out, or take another Vanishing.");
  check.that(level->mass == 0.0 || (structure.base && structure.base->mass.si() == level->mass),
             "the level " + level->name + " at the feet has mass, and is not the base.",
             "Give bearings, and leave out .base or give this mass there.");
}

Eigen::MatrixXd condensed_stiffness(const CondensedStructure& condensed, const Check& check,
                                    const Eigen::MatrixXd& rigid, StructureSystem& system) {
  if (const Level* level = condensed.base()) {
    std::vector<std::string> names;
    for (int k = 0; k < system.per_floor(); ++k) names.push_back(Freedom{0, static_cast<FloorDirection>(k)}.name());
    names.insert(names.end(), system.names.begin(), system.names.end());
    Eigen::MatrixXd of_all{condensed.stiffness.rows(), rigid.cols()};
    of_all << system.rigid_motion({{.centre_of_mass = level->centre_of_mass}}), rigid;
    check_rigid({check, "stiffness", names}, condensed.stiffness, of_all,
                "The model holds its feet, or other nodes, against the ground.", system.notes);
  }
  return condensed.stiffness.bottomRightCorner(rigid.rows(), rigid.rows());
}

void move_in_all_modes(const Eigen::MatrixXd& shapes, Eigen::Index kept, StructureSystem& system) {
  system.shapes = shapes * shapes.cwiseAbs().colwise().maxCoeff().cwiseInverse().asDiagonal();
  system.modal_stiffness = (system.shapes.transpose() * system.stiffness * system.shapes).diagonal();
  const Eigen::MatrixXd damping = system.shapes.transpose() * system.damping * system.shapes;
  system.damping = 0.5 * (damping + damping.transpose());
  const Eigen::MatrixXd along = system.motions.bottomRows(kept).leftCols<2>();
  const double mass = (along.transpose() * system.mass.bottomRightCorner(kept, kept) * along).diagonal().maxCoeff();
  if (mass > 0.0)
    system.notes.push_back("total_base_shear leaves out the inertia of motions that are kept, " + to_text(mass / 1e3) +
                           " t; storey shears have it.");
}

}  // namespace moat
