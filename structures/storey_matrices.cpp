#include "structures/storey_matrices.hpp"

#include "base/check.hpp"

namespace moat {
namespace {

// Motion of a point of a floor from that of its centre of mass.
Eigen::Matrix3d motion_at(const PlanPosition& point, const PlanPosition& centre_of_mass) {
  Eigen::Matrix3d motion = Eigen::Matrix3d::Identity();
  motion(0, 2) = -(point.y - centre_of_mass.y).si();
  motion(1, 2) = (point.x - centre_of_mass.x).si();
  return motion;
}

void check_floor(const Check& check, const StoreyRow& floor) {
  check.positive(floor.name + " mass", floor.mass);
  check.positive(floor.name + " inertia", floor.rotary_inertia);
  check.positive(floor.name + " kx", floor.stiffness_x);
  check.positive(floor.name + " ky", floor.stiffness_y);
  check.positive(floor.name + " k_rotation", floor.rotational_stiffness.si(), "N m/rad");
}

}  // namespace

CondensedStructure storey_matrices(const StoreyTable& storeys) {
  const Check check{"storey_matrices", storeys.source};
  check.that(!storeys.floors.empty(), "there is no floor.", "Give at least one.");
  const auto size = static_cast<Eigen::Index>(3 * storeys.floors.size());
  CondensedStructure matrices{.stiffness = Eigen::MatrixXd::Zero(size, size),
                              .mass = Eigen::MatrixXd::Zero(size, size),
                              .levels = {},
                              .notes = storeys.notes,
                              .eigenvalue_errors = {}};
  Eigen::Index at = 0;
  double height = 0.0;
  for (const StoreyRow& floor : storeys.floors) {
    check_floor(check, floor);
    const double inertia = floor.rotary_inertia.si();
    height += floor.height.si();
    matrices.levels.push_back({.name = floor.name,
                               .height = height,
                               .mass = floor.mass.si(),
                               .rotary_inertia = inertia,
                               .centre_of_mass = floor.centre_of_mass.si(),
                               .outline = floor.outline});
    matrices.mass.diagonal().segment<3>(at) << floor.mass.si(), floor.mass.si(), inertia;
    // The base is held: it has no rows.
    Eigen::Matrix<double, 3, Eigen::Dynamic> deformation = Eigen::MatrixXd::Zero(3, size);
    deformation.middleCols<3>(at) = motion_at(floor.centre_of_rigidity, floor.centre_of_mass);
    if (at > 0)
      deformation.middleCols<3>(at - 3) =
          -motion_at(floor.centre_of_rigidity, storeys.floors[static_cast<std::size_t>(at / 3 - 1)].centre_of_mass);
    const Eigen::Vector3d springs{floor.stiffness_x.si(), floor.stiffness_y.si(), floor.rotational_stiffness.si()};
    matrices.stiffness += deformation.transpose() * springs.asDiagonal() * deformation;
    at += 3;
  }
  return matrices;
}

}  // namespace moat
