#include "analyses/linear_system.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <unsupported/Eigen/MatrixFunctions>

#include "base/check.hpp"

namespace moat {
namespace {

using Matrix = Eigen::MatrixXd;

constexpr int most_terms = 60;
constexpr int most_halvings = 12;

// Rows of a transition are filled up to a multiple of this.
constexpr Eigen::Index rows_at_once = 8;

using FourRows = double __attribute__((vector_size(32), aligned(8), may_alias));

// y = A x for a matrix in columns whose number of rows is a multiple of rows_at_once. Steps between events spend most
// of their time here. The function is therefore compiled for newer processors as well, and the version is chosen when
// the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("default", "arch=x86-64-v3")))
#endif
void multiply(const double* __restrict matrix, Eigen::Index rows, Eigen::Index columns, const double* __restrict x,
              double* __restrict y) {
  for (Eigen::Index row = 0; row < rows; row += rows_at_once) {
    FourRows first{}, second{};
    for (Eigen::Index column = 0; column < columns; ++column) {
      const auto* entries = reinterpret_cast<const FourRows*>(matrix + column * rows + row);
      first += entries[0] * x[column];
      second += entries[1] * x[column];
    }
    auto* sums = reinterpret_cast<FourRows*>(y + row);
    sums[0] = first;
    sums[1] = second;
  }
}

// An eigenvalue x of a vector v has x^2 v = -(K + x C) v, so that |x|^2 <= |K| + |x| |C| in the norm of row sums.
double bound_of_eigenvalues(const Matrix& stiffness, const Matrix& damping) {
  const auto norm = [](const Matrix& matrix) { return matrix.cwiseAbs().rowwise().sum().maxCoeff(); };
  const double half_damping = 0.5 * norm(damping);
  return half_damping + std::sqrt(half_damping * half_damping + norm(stiffness));
}

double fastest_eigenvalue(const Matrix& stiffness, const Matrix& damping) {
  const Eigen::Index n = stiffness.rows();
  Matrix first_order = Matrix::Zero(2 * n, 2 * n);
  first_order.topRightCorner(n, n).setIdentity();
  first_order.bottomLeftCorner(n, n) = -stiffness;
  first_order.bottomRightCorner(n, n) = -damping;
  return first_order.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

Eigen::Index LinearSystem::result_size(Eigen::Index degrees_of_freedom) {
  return (3 * degrees_of_freedom + rows_at_once - 1) / rows_at_once * rows_at_once;
}

LinearSystem::LinearSystem(const SparseMatrix& stiffness, const SparseMatrix& damping, const Vector& masses,
                           double longest_step, double largest_phase)
    : stiffness_values_{stiffness.values}, damping_values_{damping.values}, step_{longest_step} {
  const Vector inverse_mass = masses.cwiseInverse();
  stiffness_ = inverse_mass.asDiagonal() * Matrix{stiffness.view()};
  damping_ = inverse_mass.asDiagonal() * Matrix{damping.view()};
  offset_.setZero(masses.size());

  constexpr double longest_against_fastest = 0.5;
  // The bound costs much less than the eigenvalues, and is often enough.
  const double bound = bound_of_eigenvalues(stiffness_, damping_),
               fastest = bound * longest_step <= largest_phase ? bound : fastest_eigenvalue(stiffness_, damping_);
  Check{"TransientOptions", ""}.that(
      fastest * std::ldexp(longest_step, -most_halvings) <= longest_against_fastest,
      "integrator = ExactBetweenEvents{} would need more than " + std::to_string(1 << most_halvings) +
          " steps from one sample of the motion to the next: the fastest eigenvalue of the model is " +
          to_text(fastest) + " 1/s.",
      "Look for a very stiff spring or damper at a small mass, or use Newmark{}.");
  while (step_ * fastest > largest_phase) step_ *= 0.5;
  make_transition();
}

void LinearSystem::make_transition() {
  const Eigen::Index n = stiffness_.rows();
  // States u, u', the constant acceleration w of every degree of freedom, and the slope s of the ground's:
  // u'' = -M^-1 (K u + C u') + w, w' = -iota s, s' = 0. The states are scaled to (u, h u', h^2 w, h^3 s) over a step of
  // 1. All entries are then of order 1, and the exponential loses no digits.
  const double h = step_;
  Matrix generator = Matrix::Zero(3 * n + 1, 3 * n + 1);
  generator.block(0, n, n, n).setIdentity();
  generator.block(n, 0, n, n) = -h * h * stiffness_;
  generator.block(n, n, n, n) = -h * damping_;
  generator.block(n, 2 * n, n, n).setIdentity();
  generator.block(2 * n, 3 * n, n, 1).setConstant(-1.0);
  const Matrix exponential = generator.exp();
  // The rows of (u, h u', h^2 u'') at the end; then the scaling is removed.
  Matrix after(3 * n, 3 * n + 1);
  after.topRows(2 * n) = exponential.topRows(2 * n);
  after.bottomRows(n).noalias() = generator.middleRows(n, n) * exponential;
  after.middleCols(n, n) *= h;
  after.middleCols(2 * n, n) *= h * h;
  after.col(3 * n) *= h * h * h;
  after.middleRows(n, n) /= h;
  after.bottomRows(n) /= h * h;
  from_constant_ = after.middleCols(2 * n, n);
  transition_.setZero(result_size(n), LinearStart::motion + 2 * n);
  auto transition = transition_.topRows(3 * n);
  transition.col(LinearStart::ground) = -from_constant_.rowwise().sum();
  transition.col(LinearStart::slope) = after.col(3 * n);
  transition.middleCols(LinearStart::motion, 2 * n) = after.leftCols(2 * n);
}

void LinearSystem::set_offset(const Vector& offset) {
  offset_ = offset;
  transition_.col(LinearStart::one).head(3 * offset.size()).noalias() = from_constant_ * offset;
}

void LinearSystem::advance(const double* start, double* result) const {
  multiply(transition_.data(), transition_.rows(), transition_.cols(), start, result);
}

LinearMotionSeries::LinearMotionSeries(Eigen::Index count) { coefficients_.setZero(count, most_terms); }

// With coefficients U_k of t^k in u, those of u' are (k + 1) U_{k+1}. The differential equation gives U_{k+2} from U_k
// and U_{k+1}. Scaled by powers of the longest time they decrease like 1 / (2^k k!).
void LinearMotionSeries::expand(const LinearSystem& system, const double* start, double longest) {
  const Eigen::Index n = coefficients_.rows();
  const Eigen::Map<const Vector> displacement{start + LinearStart::motion, n},
      velocity{start + LinearStart::motion + n, n};
  system_ = &system;
  longest_ = longest;
  ground_ = start[LinearStart::ground];
  slope_ = start[LinearStart::slope];
  coefficients_.col(0) = displacement;
  coefficients_.col(1) = longest * velocity;
  constexpr double round_off = 1e-17;
  double largest = coefficients_.col(0).lpNorm<Eigen::Infinity>(),
         largest_rate = coefficients_.col(1).lpNorm<Eigen::Infinity>();
  int small_in_a_row = 0;
  for (terms_ = 2; terms_ < most_terms && small_in_a_row < 2; ++terms_) {
    const auto k = static_cast<double>(terms_ - 2);
    auto next = coefficients_.col(terms_);
    next.noalias() = -longest * longest * (system.stiffness() * coefficients_.col(terms_ - 2));
    next.noalias() -= longest * (k + 1.0) * (system.damping() * coefficients_.col(terms_ - 1));
    if (terms_ == 2) next += longest * longest * (system.offset().array() - ground_).matrix();
    if (terms_ == 3) next.array() -= longest * longest * longest * slope_;
    next /= (k + 1.0) * (k + 2.0);
    const double size = next.lpNorm<Eigen::Infinity>();
    // The series ends after two negligible terms in a row, because a single term may vanish.
    const bool small = size <= round_off * largest && (k + 2.0) * size <= round_off * largest_rate;
    small_in_a_row = small ? small_in_a_row + 1 : 0;
    largest = std::max(largest, size);
    largest_rate = std::max(largest_rate, (k + 2.0) * size);
  }
}

void LinearMotionSeries::evaluate(double h, double* result) const {
  const Eigen::Index n = coefficients_.rows();
  const double x = h / longest_;
  Eigen::Map<Vector> displacement{result, n}, rate{result + n, n}, acceleration{result + 2 * n, n};
  displacement = coefficients_.col(terms_ - 1);
  rate.setZero();
  // Horner's scheme for the series and its derivative. The acceleration follows from the differential equation.
  for (int k = terms_ - 2; k >= 0; --k) {
    rate = x * rate + displacement;
    displacement = x * displacement + coefficients_.col(k);
  }
  rate /= longest_;
  acceleration = (system_->offset().array() - (ground_ + slope_ * h)).matrix();
  acceleration.noalias() -= system_->stiffness() * displacement;
  acceleration.noalias() -= system_->damping() * rate;
}

}  // namespace moat
