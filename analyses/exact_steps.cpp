#include "analyses/exact_steps.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unsupported/Eigen/MatrixFunctions>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moat {
namespace {

constexpr int most_terms = 60;
constexpr int most_halvings = 12;
// One building has few combinations of sliding and elastic bearings. Many buildings have many; this limit bounds the
// memory.
constexpr std::size_t most_systems = 256;

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

Eigen::Index filled_up(Eigen::Index rows) { return (rows + rows_at_once - 1) / rows_at_once * rows_at_once; }

double fastest_eigenvalue(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping) {
  const Eigen::Index n = stiffness.rows();
  Eigen::MatrixXd first_order = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  first_order.topRightCorner(n, n).setIdentity();
  first_order.bottomLeftCorner(n, n) = -stiffness;
  first_order.bottomRightCorner(n, n) = -damping;
  return first_order.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

ExactSteps::ExactSteps(Model& model, double grid_interval) : model_{&model}, grid_interval_{grid_interval} {
  check();
  const Eigen::Index count = model.degrees_of_freedom();
  stiffness_ = model.pattern();
  damping_ = model.pattern();
  offset_.setZero(count);
  start_.setZero(2 * count + 3);
  end_.setZero(filled_up(3 * count));
  series_.setZero(count, most_terms);
  restart();
  // A model with too large an eigenvalue is refused before the first step.
  if (!touching_) linearise();
}

void ExactSteps::check() const {
  const Check check{"TransientOptions", ""};
  check.that(!model_->is_plan(), "integrator: ExactBetweenEvents{} takes models on a line; this one moves in plan.",
             "Use Newmark{}, the default.");
  check.that(model_->degrees_of_freedom() <= most_degrees_of_freedom,
             "integrator = ExactBetweenEvents{} is for at most " + std::to_string(most_degrees_of_freedom) +
                 " degrees of freedom; the model has " + std::to_string(model_->degrees_of_freedom()) + ".",
             "Use Newmark{}.");
  for (const auto& block : model_->blocks()) {
    if (block->size() == 0 || block->linear_between_events()) continue;
    const ElementInfo& info = block->info(0);
    check.that(false,
               "integrator = ExactBetweenEvents{} needs elements that are linear between located events, and \"" +
                   info.name + "\" is not.",
               "Use Newmark{}, or a law whose changes of stiffness are located (LeadRubberBearing::locate_yield).");
  }
}

void ExactSteps::restart() {
  linearised_ = false;
  terms_ = 0;
  touching_ = model_->contacts_going_on() > 0;
}

double ExactSteps::next_length() {
  if (!linearised_) linearise();
  return systems_[current_].step;
}

void ExactSteps::linearise() {
  MotionState& trial = model_->trial();
  // At zero displacement and velocity the internal forces are f0. The tangents are those of the current regimes.
  trial.displacement.setZero();
  trial.velocity.setZero();
  model_->evaluate();
  model_->assemble_tangent(0.0, 0.0, 1.0, stiffness_);
  model_->assemble_tangent(0.0, 1.0, 0.0, damping_);
  offset_ = -model_->internal_forces().head(offset_.size()).cwiseQuotient(model_->masses());

  const auto known = std::find_if(systems_.begin(), systems_.end(), [&](const LinearSystem& system) {
    return system.stiffness_values == stiffness_.values && system.damping_values == damping_.values;
  });
  current_ = static_cast<std::size_t>(known - systems_.begin());
  if (known == systems_.end()) {
    if (systems_.size() == most_systems) systems_.clear();
    current_ = systems_.size();
    systems_.push_back(make_system());
  }
  // K and C determine the matrix, except the column of the constant 1, which depends on f0.
  LinearSystem& system = systems_[current_];
  system.transition.col(2 * offset_.size()).head(3 * offset_.size()).noalias() = system.from_constant * offset_;
  linearised_ = true;
}

ExactSteps::LinearSystem ExactSteps::make_system() const {
  const Eigen::Index n = offset_.size();
  LinearSystem system;
  system.stiffness_values = stiffness_.values;
  system.damping_values = damping_.values;
  const Vector inverse_mass = model_->masses().cwiseInverse();
  system.stiffness = inverse_mass.asDiagonal() * Matrix{stiffness_.view()};
  system.damping = inverse_mass.asDiagonal() * Matrix{damping_.view()};

  constexpr double longest_against_fastest = 0.5;
  const double fastest = fastest_eigenvalue(system.stiffness, system.damping);
  system.step = grid_interval_;
  Check{"TransientOptions", ""}.that(
      fastest * std::ldexp(grid_interval_, -most_halvings) <= longest_against_fastest,
      "integrator = ExactBetweenEvents{} would need more than " + std::to_string(1 << most_halvings) +
          " steps from one sample of the motion to the next: the fastest eigenvalue of the model is " +
          to_text(fastest) + " 1/s.",
      "Look for a very stiff spring or damper at a small mass, or use Newmark{}.");
  while (system.step * fastest > longest_against_fastest) system.step *= 0.5;

  // States u, u', the constant acceleration w of every degree of freedom, and the slope s of the ground's:
  // u'' = -M^-1 (K u + C u') + w, w' = -iota s, s' = 0. The states are scaled to (u, h u', h^2 w, h^3 s) over a step of
  // 1. All entries are then of order 1, and the exponential loses no digits.
  const double h = system.step;
  Matrix generator = Matrix::Zero(3 * n + 1, 3 * n + 1);
  generator.block(0, n, n, n).setIdentity();
  generator.block(n, 0, n, n) = -h * h * system.stiffness;
  generator.block(n, n, n, n) = -h * system.damping;
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
  system.from_constant = after.middleCols(2 * n, n);
  system.transition.setZero(filled_up(3 * n), 2 * n + 3);
  auto transition = system.transition.topRows(3 * n);
  transition.leftCols(2 * n) = after.leftCols(2 * n);
  transition.col(2 * n + 1) = -system.from_constant.rowwise().sum();
  transition.col(2 * n + 2) = after.col(3 * n);
  return system;
}

void ExactSteps::begin(const StepTask& step) {
  if (!linearised_) linearise();
  const Eigen::Index n = offset_.size();
  longest_ = step.length;
  ground_ = step.ground_acceleration_at_start.x;
  ground_slope_ = step.ground_jerk.x;
  start_.head(n) = model_->state().displacement.head(n);
  start_.segment(n, n) = model_->state().velocity.head(n);
  start_[2 * n] = 1.0;
  start_[2 * n + 1] = ground_;
  start_[2 * n + 2] = ground_slope_;
  terms_ = 0;
}

bool ExactSteps::solve(const StepTask& part) {
  const double h = part.length;
  const Eigen::Index n = offset_.size();
  const LinearSystem& system = systems_[current_];
  if (h == system.step) {
    multiply(system.transition.data(), system.transition.rows(), system.transition.cols(), start_.data(), end_.data());
  } else {
    if (terms_ == 0) expand();
    evaluate_series(h);
  }
  MotionState& trial = model_->trial();
  trial.time = part.end_time;
  trial.displacement.head(n) = end_.head(n);
  trial.velocity.head(n) = end_.segment(n, n);
  trial.acceleration.head(n) = end_.segment(2 * n, n);
  model_->evaluate();
  model_->evaluate_rates();
  return true;
}

// The Taylor series of u with coefficients U_k of t^k; the coefficients of u' are (k + 1) U_{k+1}. The differential
// equation gives U_{k+2} from U_k and U_{k+1}. Scaled by powers of the longest step they decrease like 1 / (2^k k!).
void ExactSteps::expand() {
  const Eigen::Index n = offset_.size();
  const LinearSystem& system = systems_[current_];
  series_.col(0) = start_.head(n);
  series_.col(1) = longest_ * start_.segment(n, n);
  constexpr double round_off = 1e-17;
  double largest = series_.col(0).lpNorm<Eigen::Infinity>(), largest_rate = series_.col(1).lpNorm<Eigen::Infinity>();
  int small_in_a_row = 0;
  for (terms_ = 2; terms_ < most_terms && small_in_a_row < 2; ++terms_) {
    const auto k = static_cast<double>(terms_ - 2);
    auto next = series_.col(terms_);
    next.noalias() = -longest_ * longest_ * (system.stiffness * series_.col(terms_ - 2));
    next.noalias() -= longest_ * (k + 1.0) * (system.damping * series_.col(terms_ - 1));
    if (terms_ == 2) next += longest_ * longest_ * (offset_.array() - ground_).matrix();
    if (terms_ == 3) next.array() -= longest_ * longest_ * longest_ * ground_slope_;
    next /= (k + 1.0) * (k + 2.0);
    const double size = next.lpNorm<Eigen::Infinity>();
    // The series ends after two negligible terms in a row, because a single term may vanish.
    const bool small = size <= round_off * largest && (k + 2.0) * size <= round_off * largest_rate;
    small_in_a_row = small ? small_in_a_row + 1 : 0;
    largest = std::max(largest, size);
    largest_rate = std::max(largest_rate, (k + 2.0) * size);
  }
}

void ExactSteps::evaluate_series(double h) {
  const Eigen::Index n = offset_.size();
  const double x = h / longest_;
  auto displacement = end_.head(n);
  auto rate = end_.segment(n, n);
  displacement = series_.col(terms_ - 1);
  rate.setZero();
  // Horner's scheme for the series and its derivative. The acceleration follows from the differential equation.
  for (int k = terms_ - 2; k >= 0; --k) {
    rate = x * rate + displacement;
    displacement = x * displacement + series_.col(k);
  }
  rate /= longest_;
  const LinearSystem& system = systems_[current_];
  auto acceleration = end_.segment(2 * n, n);
  acceleration = (offset_.array() - (ground_ + ground_slope_ * h)).matrix();
  acceleration.noalias() -= system.stiffness * displacement;
  acceleration.noalias() -= system.damping * rate;
}

}  // namespace moat
