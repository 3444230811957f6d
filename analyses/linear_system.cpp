#include "analyses/linear_system.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

#include "base/check.hpp"

namespace moat {
namespace {

using Matrix = Eigen::MatrixXd;

constexpr int most_terms = 60;
constexpr int most_halvings = 12;

// The first column of a transition that belongs to a ground's acceleration; before it the constant 1.
constexpr Eigen::Index first_ground = 1;

// Rows of a transition are filled up to a multiple of this.
constexpr Eigen::Index rows_at_once = 8;

using FourRows = double __attribute__((vector_size(32), aligned(8), may_alias));

// Some columns of a matrix with the numbers that they are multiplied by.
struct Columns {
  const double* entries;
  Eigen::Index count;
  const double* factors;
};

// Rows `row` to `row` + 4 fours of A x + B z + ...
template <int fours>
[[gnu::always_inline]] inline void multiply_rows(Eigen::Index rows, Eigen::Index row,
                                                 const std::initializer_list<Columns>& parts, double* __restrict y) {
  FourRows sums[fours]{};
  for (const Columns& columns : parts)
    for (Eigen::Index column = 0; column < columns.count; ++column) {
      const auto* entries = reinterpret_cast<const FourRows*>(columns.entries + column * rows + row);
      for (int i = 0; i < fours; ++i) sums[i] += entries[i] * columns.factors[column];
    }
  for (int i = 0; i < fours; ++i) reinterpret_cast<FourRows*>(y + row)[i] = sums[i];
}

// y = A x + B z + ... for columns whose number of rows is a multiple of rows_at_once. The function is compiled for
// newer processors as well, and the version is chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("default", "arch=x86-64-v3")))
#endif
void multiply(Eigen::Index rows, std::initializer_list<Columns> parts, double* __restrict y) {
  static_assert(rows_at_once == 8);
  Eigen::Index row = 0;
  for (; rows - row >= 24; row += 24) multiply_rows<6>(rows, row, parts, y);
  if (rows - row == 16) multiply_rows<4>(rows, row, parts, y);
  if (rows - row == 8) multiply_rows<2>(rows, row, parts, y);
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

Eigen::Index LinearSystem::filled_up(Eigen::Index rows) {
  return (rows + rows_at_once - 1) / rows_at_once * rows_at_once;
}

LinearSystem::LinearSystem(const SparseMatrix& stiffness, const SparseMatrix& damping, const Vector& masses,
                           double longest_step, double largest_phase)
    : stiffness_values_{stiffness.values}, damping_values_{damping.values}, step_{longest_step} {
  const Vector inverse_mass = masses.cwiseInverse();
  const Matrix of_stiffness = inverse_mass.asDiagonal() * Matrix{stiffness.view()},
               of_damping = inverse_mass.asDiagonal() * Matrix{damping.view()};

  constexpr double longest_against_fastest = 0.5;
  // The bound costs much less than the eigenvalues, and is often enough.
  const double bound = bound_of_eigenvalues(of_stiffness, of_damping),
               fastest = bound * longest_step <= largest_phase ? bound : fastest_eigenvalue(of_stiffness, of_damping);
  Check{"TransientOptions", ""}.that(
      fastest * std::ldexp(longest_step, -most_halvings) <= longest_against_fastest,
      "integrator = ExactBetweenEvents{} would need more than " + std::to_string(1 << most_halvings) +
          " steps from one sample of the motion to the next: the fastest eigenvalue of the model is " +
          to_text(fastest) + " 1/s.",
      "Look for a very stiff spring or damper at a small mass, or use Newmark{}.");
  while (step_ * fastest > largest_phase) step_ *= 0.5;
  const Eigen::Index n = masses.size();
  rates_.setZero(filled_up(n), 2 * n);
  rates_.topLeftCorner(n, n) = -step_ * step_ * of_stiffness;
  rates_.topRightCorner(n, n) = -step_ * of_damping;
  transitions_.push_back(of_one_step());
  for (std::size_t steps = 2; steps <= most_steps_at_once; steps *= 2)
    transitions_.push_back(twice(transitions_.back()));
  set_offset(Vector::Zero(n));
}

// The motion over one step from unit values of all that it starts from, one by one.
LinearSystem::Transition LinearSystem::of_one_step() {
  const Eigen::Index n = rates_.cols() / 2, rows = result_size(n);
  LinearMotionSeries series{n};
  Vector start = Vector::Zero(2 * n);
  const auto find_motion = [&](double ground, double slope, double* motion) {
    series.expand(*this, start.data(), ground, slope, step_);
    series.evaluate(step_, motion);
  };
  Transition one{Matrix::Zero(rows, n), Matrix::Zero(rows, first_ground + 2 + 2 * n)};
  offset_.setZero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    offset_[i] = 1.0;
    find_motion(0.0, 0.0, one.from_constant.col(i).data());
    offset_[i] = 0.0;
  }
  find_motion(1.0, -1.0 / step_, one.from_start.col(first_ground).data());
  find_motion(0.0, 1.0 / step_, one.from_start.col(first_ground + 1).data());
  for (Eigen::Index i = 0; i < 2 * n; ++i) {
    start[i] = 1.0;
    find_motion(0.0, 0.0, one.from_start.col(first_ground + 2 + i).data());
    start[i] = 0.0;
  }
  return one;
}

// The end of the first half is the start of the second.
LinearSystem::Transition LinearSystem::twice(const Transition& half) const {
  const Eigen::Index n = rates_.cols() / 2, steps = half.from_start.cols() - 2 * n - first_ground - 1;
  const auto from_motion = half.from_start.rightCols(2 * n);
  const auto grounds = half.from_start.middleCols(first_ground, steps + 1);
  Transition whole;
  whole.from_constant = half.from_constant;
  whole.from_constant.noalias() += from_motion * half.from_constant.topRows(2 * n);
  whole.from_start.setZero(half.from_start.rows(), first_ground + 2 * steps + 1 + 2 * n);
  whole.from_start.middleCols(first_ground, steps + 1).noalias() = from_motion * grounds.topRows(2 * n);
  whole.from_start.middleCols(first_ground + steps, steps + 1) += grounds;
  whole.from_start.rightCols(2 * n).noalias() = from_motion * from_motion.topRows(2 * n);
  return whole;
}

void LinearSystem::set_offset(const Vector& offset) {
  offset_ = offset;
  for (Transition& transition : transitions_) {
    auto from_offset = transition.from_start.col(0);
    from_offset.setZero();
    // Few nodes have forces at rest.
    for (Eigen::Index i = 0; i < offset.size(); ++i)
      if (offset[i] != 0.0) from_offset += offset[i] * transition.from_constant.col(i);
  }
}

void LinearSystem::advance(std::size_t doublings, const double* start, const double* ground, double* end) const {
  const Matrix& from_start = transitions_[doublings].from_start;
  const Eigen::Index rows = from_start.rows(), grounds = (Eigen::Index{1} << doublings) + 1;
  const double* columns = from_start.data();
  constexpr double one = 1.0;
  multiply(rows,
           {{columns, 1, &one},
            {columns + first_ground * rows, grounds, ground},
            {columns + (first_ground + grounds) * rows, rates_.cols(), start}},
           end);
}

void LinearSystem::scaled_rates(const double* state, double* result) const {
  multiply(rates_.rows(), {{rates_.data(), rates_.cols(), state}}, result);
}

LinearMotionSeries::LinearMotionSeries(Eigen::Index count) : count_{count} {
  coefficients_.setZero(LinearSystem::filled_up(2 * count), most_terms);
  state_.setZero(coefficients_.rows());
  rates_.setZero(LinearSystem::filled_up(count));
}

// With coefficients U_k of (t/h)^k in u, those of h u' are V_k = (k + 1) U_{k+1}, and those of its rate (k + 1) V_{k+1}
// follow from U_k and V_k by the differential equation. They decrease like 1 / (2^k k!).
void LinearMotionSeries::expand(const LinearSystem& system, const double* start, double ground, double slope,
                                double longest) {
  const Eigen::Index n = count_;
  const double h = system.step();
  system_ = &system;
  ground_ = ground;
  slope_ = slope;
  coefficients_.col(0).head(n) = Eigen::Map<const Vector>{start, n};
  coefficients_.col(0).segment(n, n) = h * Eigen::Map<const Vector>{start + n, n};
  constexpr double round_off = 1e-16;
  double size = coefficients_.col(0).head(n).lpNorm<Eigen::Infinity>(), largest = 0.0;
  double rate = coefficients_.col(0).segment(n, n).lpNorm<Eigen::Infinity>(), largest_rate = 0.0;
  const double x = longest / h;
  double power = 1.0;
  int small_in_a_row = 0;
  // The series ends after two negligible terms in a row, because a single term may vanish.
  for (terms_ = 1; terms_ < most_terms && small_in_a_row < 2; ++terms_) {
    largest = std::max(largest, size);
    largest_rate = std::max(largest_rate, rate);
    const double* last = coefficients_.col(terms_ - 1).data();
    double* next = coefficients_.col(terms_).data();
    system.scaled_rates(last, rates_.data());
    auto rates = rates_.head(n);
    if (terms_ == 1) rates += h * h * (system.offset().array() - ground).matrix();
    if (terms_ == 2) rates.array() -= h * h * h * slope;
    const double share = 1.0 / terms_;
    power *= x;
    size = rate = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      next[i] = share * last[n + i];
      next[n + i] = share * rates_[i];
      size = std::max(size, std::abs(next[i]));
      rate = std::max(rate, std::abs(next[n + i]));
    }
    size *= power;
    rate *= power;
    const bool small = size <= round_off * largest && rate <= round_off * largest_rate;
    small_in_a_row = small ? small_in_a_row + 1 : 0;
  }
}

void LinearMotionSeries::evaluate(double h, double* result) {
  const Eigen::Index n = count_;
  const double step = system_->step(), x = h / step;
  std::array<double, most_terms> powers;
  powers[0] = 1.0;
  for (int k = 1; k < terms_; ++k) powers[k] = x * powers[k - 1];
  multiply(coefficients_.rows(), {{coefficients_.data(), terms_, powers.data()}}, state_.data());
  // The acceleration follows from the differential equation.
  system_->scaled_rates(state_.data(), rates_.data());
  const double per_step = 1.0 / step, ground = ground_ + slope_ * h;
  const double *state = state_.data(), *rates = rates_.data(), *offset = system_->offset().data();
  for (Eigen::Index i = 0; i < n; ++i) {
    result[i] = state[i];
    result[n + i] = per_step * state[n + i];
    result[2 * n + i] = per_step * per_step * rates[i] + offset[i] - ground;
  }
}

}  // namespace moat
