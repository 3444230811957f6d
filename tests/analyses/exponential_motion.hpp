// The motion of a linear system by the exponential of a matrix.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "model/model.hpp"

namespace moat::testing {

/// The tangents of a linear model, which must be prepared.
struct Tangents {
  SparseMatrix stiffness, damping;  ///< df/du, df/dv

  /// Of this model.
  explicit Tangents(const Model& model) : stiffness{model.zero_matrix()}, damping{model.zero_matrix()} {
    model.assemble_tangent(0.0, 0.0, 1.0, stiffness);
    model.assemble_tangent(0.0, 1.0, 0.0, damping);
  }
};

/// u'' = -M^-1 (K u + C u') + offset - (a_g + s t), by the exponential of the first-order system of u, u', a_g and 1.
/// Its series is summed in long double over short parts of the time: another way than that of LinearSystem, with more
/// digits.
struct ExponentialMotion {
  Eigen::MatrixXd stiffness, damping;  ///< M^-1 K, M^-1 C
  Vector offset;                       ///< m/s^2

  /// Of a model with these tangents.
  ExponentialMotion(const Model& model, const Tangents& tangents, Vector its_offset)
      : stiffness{model.masses().cwiseInverse().asDiagonal() * Eigen::MatrixXd{tangents.stiffness}},
        damping{model.masses().cwiseInverse().asDiagonal() * Eigen::MatrixXd{tangents.damping}},
        offset{std::move(its_offset)} {}

  /// (u, u', u'') and the absolute jerk h s after a start (u, u'), under a ground with this acceleration there and this
  /// slope.
  [[nodiscard]] Vector after(double h, const Vector& start, double ground, double slope) const {
    const Eigen::Index n = offset.size();
    using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    Wide rates = Wide::Zero(2 * n + 2, 2 * n + 2);
    rates.block(0, n, n, n).setIdentity();
    rates.block(n, 0, n, n) = -stiffness.cast<long double>();
    rates.block(n, n, n, n) = -damping.cast<long double>();
    rates.block(n, 2 * n, n, 1).setConstant(-1.0L);
    rates.block(n, 2 * n + 1, n, 1) = offset.cast<long double>();
    rates(2 * n, 2 * n + 1) = slope;
    Wide end(2 * n + 2, 1);
    end << start.head(2 * n).cast<long double>(), ground, 1.0L;
    constexpr int parts = 256, terms = 24;
    const Wide over_part = static_cast<long double>(h) / parts * rates;
    for (int part = 0; part < parts; ++part) {
      Wide term = end;
      for (int k = 1; k < terms; ++k) {
        term = over_part * term / static_cast<long double>(k);
        end += term;
      }
    }
    const Wide end_rates = rates * end;
    const Vector velocity = end.block(n, 0, n, 1).cast<double>(),
                 acceleration = end_rates.block(n, 0, n, 1).cast<double>();
    Vector motion(4 * n);
    motion << end.topRows(2 * n).cast<double>(), acceleration, -stiffness * velocity - damping * acceleration;
    return motion;
  }
};

}  // namespace moat::testing
