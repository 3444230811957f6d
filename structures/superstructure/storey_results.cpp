#include "structures/superstructure/storey_results.hpp"

#include <Eigen/Cholesky>

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
    const Eigen::MatrixXd heavy = system.mass * system.shapes, modal_mass = system.shapes.transpose() * heavy;
    result.forces.leftCols(modes) =
        heavy * modal_mass.llt().solve(Eigen::MatrixXd{system.modal_stiffness.asDiagonal()});
    return result;
  }
  PerDisplacement result{Eigen::MatrixXd::Identity(rows, rows + of_base), Eigen::MatrixXd::Zero(rows, rows + of_base)};
  result.forces << system.stiffness, -system.stiffness * system.carried.leftCols(of_base);
  return result;
}

}  // namespace

std::vector<StoreyResult> storey_results(const StructureSystem& system, const StructureRows& rows,
                                         const std::string& prefix) {
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
  const PlanVector origin = system.origin();
  const int step = system.per_floor();
  for (std::size_t i = 0; i < system.floors.size(); ++i) {
    const std::string place = prefix + "storey " + std::to_string(i + 1);
    const double foot = i == 0 ? 0.0 : system.floors[i - 1].height;
    Eigen::VectorXd shear[2], moment[2], torque = Eigen::VectorXd::Zero(per.forces.cols());
    for (int d = 0; d < 2; ++d) shear[d] = moment[d] = torque;
    for (std::size_t j = i; j < system.floors.size(); ++j) {
      const SystemFloor& floor = system.floors[j];
      const auto row = static_cast<Eigen::Index>(j) * step;
      for (int d = 0; d < (system.in_plan ? 2 : 1); ++d) {
        const Eigen::VectorXd force = per.forces.row(row + d).transpose();
        shear[d] += force;
        moment[d] += (floor.height - foot) * force;
      }
      if (!system.in_plan) continue;
      const PlanVector arm = floor.centre_of_mass - origin;
      torque += floor.gyration() * per.forces.row(row + 2).transpose() + arm.x * per.forces.row(row + 1).transpose() -
                arm.y * per.forces.row(row).transpose();
    }
    if (!system.in_plan) {
      Eigen::VectorXd drift = per.displacements.row(static_cast<Eigen::Index>(i)).transpose();
      if (i > 0)
        drift -= per.displacements.row(static_cast<Eigen::Index>(i) - 1).transpose();
      else if (!rows.base.empty())
        drift[static_cast<Eigen::Index>(rows.own.size())] -= 1.0;
      add("drift", place, "m", drift);
      add("storey_shear", place, "N", shear[0]);
      add("overturning_moment", place, "N m", moment[0]);
      continue;
    }
    add("storey_shear_x", place, "N", shear[0]);
    add("storey_shear_y", place, "N", shear[1]);
    add("storey_torque", place, "N m", torque);
    add("overturning_moment_x", place, "N m", moment[0]);
    add("overturning_moment_y", place, "N m", moment[1]);
  }
  return results;
}

}  // namespace moat
