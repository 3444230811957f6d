#include "analyses/integrators/linear_system.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/check.hpp"
#include "solvers/dense.hpp"

namespace moat {

LinearSystem::LinearSystem(const SparseMatrix& stiffness, const SparseMatrix& damping, const MassMatrix& mass,
                           const Vector& influence, double longest_step, double wanted_phase)
    : stiffness_{stiffness}, damping_{damping}, step_{longest_step} {
  const Eigen::Index n = influence.size();
  const auto per_mass = [&](const SparseMatrix& matrix) {
    Eigen::MatrixXd solution{matrix};
    for (Eigen::Index column = 0; column < n; ++column) mass.solve(solution.col(column).data());
    return solution;
  };
  rates_.setZero(3 * n + 1, 3 * n + 1);
  rates_.block(0, n, n, n).setIdentity();
  rates_.block(n, 0, n, n) = -step_ * step_ * per_mass(stiffness);
  rates_.block(n, n, n, n) = -step_ * per_mass(damping);
  rates_.block(n, 2 * n, n, n).setIdentity();
  rates_.block(2 * n, 3 * n, n, 1) = influence;

  constexpr int most_steps = 1 << 12;
  // An eigenvalue x of a vector v has x^2 v = -(h^2 M^-1 K + x h M^-1 C) v. A bound from the norms of row sums costs
  // little, and is often enough.
  const auto norm = [&](Eigen::Index column) {
    return rates_.block(n, column, n, n).cwiseAbs().rowwise().sum().maxCoeff();
  };
  const double half_damping = 0.5 * norm(n);
  const double largest_phase = std::min(wanted_phase, longest_phase);
  double phase = half_damping + std::sqrt(half_damping * half_damping + norm(0));
  if (phase > largest_phase) phase = spectral_radius(rates_.topLeftCorner(2 * n, 2 * n));
  Check{"TransientOptions", ""}.that(
      phase <= most_steps * longest_phase,
      "integrator = ExactBetweenEvents{} would need more than " + std::to_string(most_steps) +
          " steps from one sample of the motion to the next: the fastest eigenvalue of the model is " +
          to_text(phase / longest_step) + " 1/s.",
      "Look for a very stiff spring or damper at a small mass, or use Newmark{}.");
  for (; phase > largest_phase; phase *= 0.5) {
    step_ *= 0.5;
    rates_.block(n, 0, n, n) *= 0.25;
    rates_.block(n, n, n, n) *= 0.5;
  }
  over_step_ = exponential(rates_).topRows(2 * n);
}

}  // namespace moat
