// Rayleigh damping of buildings in plan.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "structures/plan_building.hpp"
#include "structures/plan_stiffness.hpp"

namespace moat {
namespace {

using Matrix = Eigen::MatrixXd;

RayleighFactors factors_of_stiffness(double ratio, const Model& model, const std::vector<DiaphragmId>& floors,
                                     Matrix stiffness) {
  Eigen::VectorXd root_of_mass{stiffness.rows()};
  for (std::size_t i = 0; i < floors.size(); ++i)
    root_of_mass.segment<3>(static_cast<Eigen::Index>(3 * i)).setConstant(std::sqrt(model.diaphragm(floors[i]).mass));
  for (Eigen::Index i = 0; i < stiffness.rows(); ++i)
    for (Eigen::Index j = 0; j < stiffness.cols(); ++j) stiffness(i, j) /= root_of_mass[i] * root_of_mass[j];
  const Eigen::SelfAdjointEigenSolver<Matrix> solver{stiffness};
  // The share of a mode, of unit length, in translation along a direction, and altogether.
  const auto share_along = [&](Eigen::Index mode, PlanVector direction) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < stiffness.rows(); i += 3) {
      const double along = dot(direction, {solver.eigenvectors()(i, mode), solver.eigenvectors()(i + 1, mode)});
      sum += along * along;
    }
    return sum;
  };
  const auto translation = [&](Eigen::Index mode) {
    return share_along(mode, {1.0, 0.0}) + share_along(mode, {0.0, 1.0});
  };
  constexpr double half = 0.5 - 1e-9;
  std::vector<double> frequencies;
  PlanVector direction;
  for (Eigen::Index mode = 0; mode < stiffness.rows() && frequencies.size() < 2; ++mode) {
    const double all = translation(mode);
    if (all < half) continue;
    if (frequencies.empty()) {
      PlanVector participation;
      for (Eigen::Index i = 0; i < stiffness.rows(); i += 3)
        participation +=
            root_of_mass[i] * PlanVector{solver.eigenvectors()(i, mode), solver.eigenvectors()(i + 1, mode)};
      direction = participation / length(participation);
    } else if (share_along(mode, direction) < half * all) {
      continue;
    }
    frequencies.push_back(std::sqrt(solver.eigenvalues()[mode]));
  }
  if (frequencies.empty()) frequencies.push_back(std::sqrt(std::max(solver.eigenvalues()[0], 0.0)));
  if (frequencies.size() < 2) return {0.0, 2.0 * ratio / frequencies[0]};
  return rayleigh_factors(ratio, frequencies[0], frequencies[1]);
}

}  // namespace

RayleighFactors rayleigh_factors_in_plan(double ratio, const Model& model, const std::vector<DiaphragmId>& floors) {
  const Check check{"RayleighDamping", ""};
  check.that(ratio >= 0.0 && ratio < 1.0, "ratio", ratio, "1", ">= 0 and < 1", "5 % of critical is 0.05.");
  check.that(!floors.empty(), "there are no floors.");
  return factors_of_stiffness(ratio, model, floors, stiffness_of_floors(model, floors));
}

}  // namespace moat
