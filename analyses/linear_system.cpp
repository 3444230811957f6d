#include "analyses/linear_system.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

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

// Rows `row` to `row` + 4 fours of A x + B z + ... The compiler keeps sums in registers where their indices are
// constants.
template <std::size_t... fours>
[[gnu::always_inline]] inline void multiply_rows(std::index_sequence<fours...>, Eigen::Index rows, Eigen::Index row,
                                                 const std::initializer_list<Columns>& parts, double* __restrict y) {
  FourRows sums[sizeof...(fours)]{};
  for (const Columns& columns : parts)
    for (Eigen::Index column = 0; column < columns.count; ++column) {
      const auto* entries = reinterpret_cast<const FourRows*>(columns.entries + column * rows + row);
      ((sums[fours] += entries[fours] * columns.factors[column]), ...);
    }
  ((reinterpret_cast<FourRows*>(y + row)[fours] = sums[fours]), ...);
}

// Functions with this are compiled for newer processors as well, and the version is chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MOAT_FOR_NEWER_PROCESSORS __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define MOAT_FOR_NEWER_PROCESSORS
#endif

// y = A x + B z + ... for columns whose number of rows is a multiple of rows_at_once.
[[gnu::always_inline]] inline void multiply_columns(Eigen::Index rows, const std::initializer_list<Columns>& parts,
                                                    double* __restrict y) {
  static_assert(rows_at_once == 8);
  Eigen::Index row = 0;
  for (; rows - row >= 24; row += 24) multiply_rows(std::make_index_sequence<6>{}, rows, row, parts, y);
  if (rows - row == 16) multiply_rows(std::make_index_sequence<4>{}, rows, row, parts, y);
  if (rows - row == 8) multiply_rows(std::make_index_sequence<2>{}, rows, row, parts, y);
}

MOAT_FOR_NEWER_PROCESSORS
void multiply(Eigen::Index rows, std::initializer_list<Columns> parts, double* __restrict y) {
  multiply_columns(rows, parts, y);
}

// The largest magnitudes of a term of a series.
struct TermSize {
  double displacement, velocity;
};

[[gnu::always_inline]] inline double largest_of(const FourRows& magnitudes) {
  return std::max(std::max(magnitudes[0], magnitudes[1]), std::max(magnitudes[2], magnitudes[3]));
}

// A term (U, V) of a series from the one before: `share` times V and the rates of (U, V), which the parts add up to.
// U and V have filled-up rows.
MOAT_FOR_NEWER_PROCESSORS
TermSize add_term(Eigen::Index rows, std::initializer_list<Columns> rates, double share, const double* last,
                  double* __restrict next) {
  multiply_columns(rows, rates, next + rows);
  const auto* last_velocities = reinterpret_cast<const FourRows*>(last + rows);
  auto* displacements = reinterpret_cast<FourRows*>(next);
  auto* velocities = reinterpret_cast<FourRows*>(next + rows);
  FourRows displacement{}, velocity{};
  const auto keep_larger = [](FourRows& largest, const FourRows& value) {
    const FourRows magnitude = value < 0.0 ? -value : value;
    largest = magnitude > largest ? magnitude : largest;
  };
  for (Eigen::Index i = 0; i < rows / 4; ++i) {
    displacements[i] = share * last_velocities[i];
    velocities[i] *= share;
    keep_larger(displacement, displacements[i]);
    keep_larger(velocity, velocities[i]);
  }
  return {largest_of(displacement), largest_of(velocity)};
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
  const Eigen::Index n = rates_.cols() / 2, rows = half.from_start.rows(),
                     steps = half.from_start.cols() - 2 * n - first_ground - 1, motions = first_ground + steps + 1;
  const auto move_on = [&](const Matrix& middle, Eigen::Index column, Matrix& end, Eigen::Index column_of_end) {
    multiply(rows, {{half.from_start.col(motions).data(), 2 * n, middle.col(column).data()}},
             end.col(column_of_end).data());
  };
  Transition whole{Matrix::Zero(rows, n), Matrix::Zero(rows, motions + steps + 2 * n)};
  for (Eigen::Index i = 0; i < n; ++i) move_on(half.from_constant, i, whole.from_constant, i);
  whole.from_constant += half.from_constant;
  for (Eigen::Index i = first_ground; i < motions; ++i) move_on(half.from_start, i, whole.from_start, i);
  whole.from_start.middleCols(first_ground + steps, steps + 1) += half.from_start.middleCols(first_ground, steps + 1);
  for (Eigen::Index i = 0; i < 2 * n; ++i) move_on(half.from_start, motions + i, whole.from_start, motions + steps + i);
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

LinearMotionSeries::LinearMotionSeries(Eigen::Index count) : count_{count}, rows_{LinearSystem::filled_up(count)} {
  coefficients_.setZero(2 * rows_, most_terms);
  state_.setZero(2 * rows_);
  constant_.setZero(rows_);
  rates_.setZero(rows_);
  velocity_.setZero(2 * rows_);
}

// With coefficients U_k of (t/h)^k in u, those of h u' are V_k = (k + 1) U_{k+1}, and those of its rate (k + 1) V_{k+1}
// follow from U_k and V_k by the differential equation. They decrease like 1 / (2^k k!).
void LinearMotionSeries::expand(const LinearSystem& system, const double* start, double ground, double slope,
                                double longest) {
  const Eigen::Index n = count_, rows = rows_;
  const double h = system.step(), *of_displacement = system.scaled_rates(), *of_velocity = of_displacement + n * rows;
  system_ = &system;
  ground_ = ground;
  slope_ = slope;
  coefficients_.col(0).head(n) = Eigen::Map<const Vector>{start, n};
  coefficients_.col(0).segment(rows, n) = h * Eigen::Map<const Vector>{start + n, n};
  constexpr double round_off = 1e-16, one = 1.0;
  TermSize largest{}, size{coefficients_.col(0).head(rows).lpNorm<Eigen::Infinity>(),
                           coefficients_.col(0).tail(rows).lpNorm<Eigen::Infinity>()};
  const double x = longest / h;
  double power = 1.0;
  int small_in_a_row = 0;
  // The series ends after two negligible terms in a row, because a single term may vanish.
  for (terms_ = 1; terms_ < most_terms && small_in_a_row < 2; ++terms_) {
    largest = {std::max(largest.displacement, size.displacement), std::max(largest.velocity, size.velocity)};
    const double* last = coefficients_.col(terms_ - 1).data();
    if (terms_ == 1) constant_.head(n) = h * h * (system.offset().array() - ground);
    if (terms_ == 2) constant_.head(n).setConstant(-h * h * h * slope);
    size = add_term(
        rows,
        {{constant_.data(), terms_ <= 2 ? 1 : 0, &one}, {of_displacement, n, last}, {of_velocity, n, last + rows}},
        1.0 / terms_, last, coefficients_.col(terms_).data());
    power *= x;
    const bool small = power * size.displacement <= round_off * largest.displacement &&
                       power * size.velocity <= round_off * largest.velocity;
    size = {power * size.displacement, power * size.velocity};
    small_in_a_row = small ? small_in_a_row + 1 : 0;
  }
}

void LinearMotionSeries::evaluate(double h, double* result) {
  const Eigen::Index n = count_, rows = rows_;
  const double step = system_->step(), x = h / step;
  std::array<double, most_terms> powers;
  powers[0] = 1.0;
  for (std::size_t k = 1; k < static_cast<std::size_t>(terms_); ++k) powers[k] = x * powers[k - 1];
  multiply(2 * rows, {{coefficients_.data(), terms_, powers.data()}}, state_.data());
  const double *of_displacement = system_->scaled_rates(), *of_velocity = of_displacement + n * rows;
  const auto find_rates = [&](const double* state) {
    multiply(rows, {{of_displacement, n, state}, {of_velocity, n, state + rows}}, rates_.data());
  };
  // The acceleration follows from the differential equation, and the jerk from its rate.
  find_rates(state_.data());
  const double per_step = 1.0 / step, ground = ground_ + slope_ * h;
  const double *state = state_.data(), *rates = rates_.data(), *offset = system_->offset().data();
  double* velocity = velocity_.data();
  for (Eigen::Index i = 0; i < n; ++i) {
    result[i] = state[i];
    result[n + i] = velocity[i] = per_step * state[rows + i];
    result[2 * n + i] = per_step * per_step * rates[i] + offset[i] - ground;
    velocity[rows + i] = step * result[2 * n + i];
  }
  find_rates(velocity);
  for (Eigen::Index i = 0; i < n; ++i) result[3 * n + i] = per_step * per_step * rates[i];
}

}  // namespace moat
