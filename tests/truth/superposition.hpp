// Modal superposition of a linear system under accelerations that are linear between samples: an independent program.
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

namespace moat::testing {

/// M u'' + C u' + K u = -L a_g(t), from rest. A column of L and of the samples is one component of the ground.
struct LinearSystem {
  Eigen::MatrixXd mass, damping, stiffness, influence;
};

/// (u, u') at every sample, a column each. Modes of the first-order system are complex, so that damping may be any:
///
///     z' = A z - B a,   q' = l q + b (a0 + s t)   exactly   q(h) = e q0 + b (a0 (e - 1)/l + s (e - 1 - l h)/l^2)
///
/// with e = exp(l h). No eigenvalue l may be zero or of multiplicity.
inline Eigen::MatrixXd superposed(const LinearSystem& system, double interval, const Eigen::MatrixXd& samples) {
  using Complex = std::complex<double>;
  const Eigen::Index n = system.mass.rows();
  const Eigen::LDLT<Eigen::MatrixXd> mass{system.mass};
  Eigen::MatrixXd first_order = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  first_order.topRightCorner(n, n).setIdentity();
  first_order.bottomLeftCorner(n, n) = -mass.solve(system.stiffness);
  first_order.bottomRightCorner(n, n) = -mass.solve(system.damping);
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(2 * n, system.influence.cols());
  load.bottomRows(n) = -mass.solve(system.influence);
  const Eigen::EigenSolver<Eigen::MatrixXd> modes{first_order};
  const Eigen::MatrixXcd shapes = modes.eigenvectors();
  const Eigen::MatrixXcd loads = shapes.fullPivLu().solve(load.cast<Complex>());
  Eigen::VectorXcd q = Eigen::VectorXcd::Zero(2 * n);
  Eigen::MatrixXd states = Eigen::MatrixXd::Zero(2 * n, samples.cols());
  for (Eigen::Index i = 1; i < samples.cols(); ++i) {
    const Eigen::VectorXcd start = loads * samples.col(i - 1).cast<Complex>(),
                           slope = loads * (samples.col(i) - samples.col(i - 1)).cast<Complex>() / interval;
    for (Eigen::Index k = 0; k < 2 * n; ++k) {
      const Complex l = modes.eigenvalues()[k], e = std::exp(l * interval);
      q[k] = e * q[k] + start[k] * (e - 1.0) / l + slope[k] * (e - 1.0 - l * interval) / (l * l);
    }
    states.col(i) = (shapes * q).real();
  }
  return states;
}

}  // namespace moat::testing
