#include "structures/superstructure/storey_results.hpp"

#include "solvers/dense.hpp"

#include "structures/frame/constraints.hpp"

namespace moat {
namespace {

// Displacements of the floors, and elastic forces on them, per displacement of own rows and base: a column for each.
struct PerDisplacement {
  Eigen::MatrixXd displacements, forces;  // 1, N/m
};

PerDisplacement per_displacement(const StructureSystem& system, bool has_base) {
  const Eigen::Index rows = system.mass.rows(), of_base = has_base ? system.carried.cols() : 0;
  if (system.shapes.size() > 0) {
    const Eigen::Index modes = system.shapes.cols();
    PerDisplacement result{Eigen::MatrixXd::Zero(rows, modes + of_base), Eigen::MatrixXd::Zero(rows, modes + of_base)};
    result.displacements << system.shapes, system.carried.leftCols(of_base);
    const Eigen::MatrixXd modal_mass = projected(system.shapes, system.mass, system.shapes);
    result.forces.leftCols(modes) =
        product(product(system.mass, system.shapes), solve_definite(modal_mass, system.modal_stiffness.asDiagonal()));
    return result;
  }
  PerDisplacement result{Eigen::MatrixXd::Identity(rows, rows + of_base), Eigen::MatrixXd::Zero(rows, rows + of_base)};
  result.forces << system.stiffness, product(-system.stiffness, system.carried.leftCols(of_base));
  return result;
}

}  // namespace

std::vector<StoreyResult> storey_results(const StructureSystem& system, const StructureRows& rows,
                                         const std::string& tower, const std::string& prefix) {
  const PerDisplacement per = per_displacement(system, !rows.base.empty());
  std::vector<NodeId> nodes = rows.own;
  nodes.insert(nodes.end(), rows.base.begin(), rows.base.end());
  std::vector<StoreyResult> results;
  const auto add = [&](const std::string& quantity, const std::string& place, const char* unit,
                       const Eigen::VectorXd& weights) {
    StoreyResult result{quantity, place, unit};
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (const double weight = weights[static_cast<Eigen::Index>(i)]; weight != 0.0)
        result.displacements.push_back({nodes[i], weight});
    results.push_back(std::move(result));
  };
  int number = 0;
  for (int i = 0; i < std::ssize(system.floors); ++i) {
    if (system.floors[static_cast<std::size_t>(i)].tower != tower) continue;
    const int below = level_below(system.floors, static_cast<std::size_t>(i));
    const std::string place = prefix + "storey " + std::to_string(++number);
    const double foot = below < 0 ? 0.0 : system.floors[static_cast<std::size_t>(below)].height;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(6, per.forces.cols());
    for (std::size_t j = 0; j < system.floor_of_row.size(); ++j) {
      int upper = system.floor_of_row[j];
      while (upper > i) upper = level_below(system.floors, static_cast<std::size_t>(upper));
      if (upper != i) continue;
      const auto row = static_cast<Eigen::Index>(j);
      Eigen::Matrix<double, 6, 1> motion = system.motions.row(row).transpose();
      motion[3] += foot * motion[1];
      motion[4] -= foot * motion[0];
      sums += motion * per.forces.row(row);
    }
    const auto sum = [&](int motion) -> Eigen::VectorXd { return sums.row(motion).transpose(); };
    if (!system.in_plan) {
      Eigen::VectorXd drift = per.displacements.row(i).transpose();
      if (below >= 0)
        drift -= per.displacements.row(below).transpose();
      else if (!rows.base.empty())
        drift[static_cast<Eigen::Index>(rows.own.size())] -= 1.0;
      add("drift", place, "m", drift);
      add("storey_shear", place, "N", sum(0));
      add("overturning_moment", place, "N m", sum(4));
      continue;
    }
    add("storey_shear_x", place, "N", sum(0));
    add("storey_shear_y", place, "N", sum(1));
    add("storey_torque", place, "N m", sum(5));
    add("overturning_moment_x", place, "N m", sum(4));
    add("overturning_moment_y", place, "N m", -sum(3));
  }
  return results;
}

}  // namespace moat
