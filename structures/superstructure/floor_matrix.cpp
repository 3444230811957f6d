#include "structures/superstructure/floor_matrix.hpp"

#include <algorithm>

#include "structures/superstructure/matrix_checks.hpp"

namespace moat {

std::vector<Freedom> freedoms_of(const Superstructure& structure, const Check& check, std::string_view field,
                                 const std::vector<std::string>& names, Eigen::Index rows, int floors) {
  return names.empty() ? structure.freedoms.list(check, field, static_cast<int>(rows), floors)
                       : freedoms_named(check, names);
}

Eigen::MatrixXd floor_matrix(const Superstructure& structure, const Check& check, std::string_view field,
                             const MatrixInUnits& matrix, StructureSystem& system) {
  const bool is_mass = field == "mass";
  if (!is_mass)
    check.positive("force unit of " + std::string{field}, matrix.force, "N", "Give .force, for example kN.");
  const double unit = is_mass ? matrix.mass : matrix.force / matrix.length;
  system.notes.insert(system.notes.end(), matrix.notes.begin(), matrix.notes.end());
  const int count = static_cast<int>(system.floors.size());
  const std::vector<Freedom> rows = freedoms_of(structure, check, field, matrix.names, matrix.values.rows(), count);
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(std::ssize(rows));
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].direction == FloorDirection::rotation) factors[static_cast<Eigen::Index>(i)] = matrix.length;
  const Eigen::MatrixXd si = factors.asDiagonal() * (unit * matrix.values) * factors.asDiagonal();
  std::vector<int> positions = positions_of(check, rows, count, system.in_plan);
  if (is_mass) {
    const double round_off = 1e-9 * si.diagonal().maxCoeff();
    for (int row = 0; row < std::ssize(rows); ++row)
      check.that(rows[static_cast<std::size_t>(row)].floor > 0 || si(row, positions).isZero(round_off),
                 "mass couples " + rows[static_cast<std::size_t>(row)].name() + " with floors.",
                 "Give masses of the floors alone; the base has its own.");
    return si(positions, positions);
  }
  if (rows.size() == positions.size() && system.bases.size() < 2) return si(positions, positions);
  std::vector<SystemFloor> feet = system.bases;
  if (feet.empty()) feet.push_back({.centre_of_mass = system.origin()});
  std::vector<std::string> names = system.names;
  for (const int position : positions_of_base(check, rows, static_cast<int>(feet.size()), system.in_plan)) {
    positions.push_back(position);
    names.push_back(rows[static_cast<std::size_t>(position)].name());
  }
  const Eigen::MatrixXd whole = si(positions, positions), floors = system.rigid_motion(system.floors);
  Eigen::MatrixXd rigid{whole.rows(), floors.cols()};
  rigid << floors, system.rigid_motion(feet);
  // A building on the ground does not say about which point its foot turns.
  const Eigen::Index motions = system.is_isolated() ? rigid.cols() : std::min<Eigen::Index>(rigid.cols(), 2);
  check_rigid({check, field, names}, whole, rigid.leftCols(motions),
              field == "damping" ? "The factor alphaM of OpenSees damps motion against the ground; that of moat acts "
                                   "against the base. Give the damping of the building held at its base."
                                 : "The base may stand elsewhere in the order, or a support was left in.",
              system.notes);
  return whole;
}

}  // namespace moat
