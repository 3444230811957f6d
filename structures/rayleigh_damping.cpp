#include "structures/rayleigh_damping.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

#include "base/check.hpp"

namespace moat {

RayleighFactors rayleigh_factors(double ratio, double first_angular_frequency, double second_angular_frequency) {
  const Check check{"RayleighDamping", ""};
  check.that(ratio >= 0.0 && ratio < 1.0, "ratio", ratio, "1", ">= 0 and < 1", "5 % of critical is 0.05.");
  check.positive("first angular frequency", first_angular_frequency, "1/s");
  check.positive("second angular frequency", second_angular_frequency, "1/s");
  const double sum = first_angular_frequency + second_angular_frequency;
  return {2.0 * ratio * first_angular_frequency * second_angular_frequency / sum, 2.0 * ratio / sum};
}

RayleighFactors rayleigh_factors_of_chain(double ratio, std::span<const Mass> masses,
                                          std::span<const Stiffness> stiffnesses) {
  const Check check{"RayleighDamping", ""};
  check.that(!masses.empty() && masses.size() == stiffnesses.size(),
             "a chain needs at least one storey and one stiffness per mass.");
  check.that(ratio >= 0.0 && ratio < 1.0, "ratio", ratio, "1", ">= 0 and < 1", "5 % of critical is 0.05.");
  const auto count = static_cast<Eigen::Index>(masses.size());
  // M^-1/2 K M^-1/2 of a chain is tridiagonal.
  Eigen::VectorXd diagonal{count}, beside{count - 1};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto storey = static_cast<std::size_t>(i);
    const bool top = i + 1 == count;
    diagonal[i] = (stiffnesses[storey].si() + (top ? 0.0 : stiffnesses[storey + 1].si())) / masses[storey].si();
    if (!top) beside[i] = -stiffnesses[storey + 1].si() / std::sqrt(masses[storey].si() * masses[storey + 1].si());
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  const double first = std::sqrt(solver.eigenvalues()[0]);
  if (count == 1) return {0.0, 2.0 * ratio / first};
  return rayleigh_factors(ratio, first, std::sqrt(solver.eigenvalues()[1]));
}

}  // namespace moat
