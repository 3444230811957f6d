// Rayleigh damping of buildings in plan.
#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "solvers/dense.hpp"
#include "structures/plan_building.hpp"

namespace moat {
namespace {

RayleighFactors factors_of_stiffness(double ratio, const Model& model, const std::vector<DiaphragmId>& floors,
                                     Eigen::MatrixXd stiffness) {
  Eigen::VectorXd root_of_mass{stiffness.rows()};
  for (std::size_t i = 0; i < floors.size(); ++i)
    root_of_mass.segment<3>(static_cast<Eigen::Index>(3 * i)).setConstant(std::sqrt(model.diaphragm(floors[i]).mass));
  stiffness.array() /= (root_of_mass * root_of_mass.transpose()).array();
  const auto [values, vectors] = eigen_pairs(stiffness);
  // The share of a mode, of unit length, in translation along a direction.
  const auto share_along = [&](Eigen::Index mode, PlanVector direction) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < stiffness.rows(); i += 3) {
      const double along = dot(direction, {vectors(i, mode), vectors(i + 1, mode)});
      sum += along * along;
    }
    return sum;
  };
  constexpr double half = 0.5 - 1e-9;
  std::vector<double> frequencies;
  PlanVector direction;
  for (Eigen::Index mode = 0; mode < stiffness.rows() && frequencies.size() < 2; ++mode) {
    const double all = share_along(mode, {1.0, 0.0}) + share_along(mode, {0.0, 1.0});
    if (all < half) continue;
    if (frequencies.empty()) {
      PlanVector participation;
      for (Eigen::Index i = 0; i < stiffness.rows(); i += 3)
        participation += root_of_mass[i] * PlanVector{vectors(i, mode), vectors(i + 1, mode)};
      direction = participation / length(participation);
    } else if (share_along(mode, direction) < half * all) {
      continue;
    }
    frequencies.push_back(std::sqrt(values[mode]));
  }
  if (frequencies.empty()) frequencies.push_back(std::sqrt(std::max(values[0], 0.0)));
  if (frequencies.size() < 2) return {0.0, 2.0 * ratio / frequencies[0]};
  return rayleigh_factors(ratio, frequencies[0], frequencies[1]);
}

}  // namespace

Eigen::MatrixXd stiffness_of_floors(const Model& model, const std::vector<DiaphragmId>& floors) {
  std::vector<int> rows;
  for (const DiaphragmId& id : floors)
    for (const NodeId node : id.degrees_of_freedom()) rows.push_back(node.index);
  const Eigen::MatrixXd whole{model.linear_stiffness(StiffnessStage::initial)};
  return whole(rows, rows);
}

RayleighFactors rayleigh_factors_in_plan(double ratio, const Model& model, const std::vector<DiaphragmId>& floors) {
  const Check check{"RayleighDamping", ""};
  check.that(ratio >= 0.0 && ratio < 1.0, "ratio", ratio, "1", ">= 0 and < 1", "5 % of critical is 0.05.");
  check.that(!floors.empty(), "there are no floors.");
  return factors_of_stiffness(ratio, model, floors, stiffness_of_floors(model, floors));
}

}  // namespace moat
