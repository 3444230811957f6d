#include "performance/sundials_model_problem.hpp"

#include <algorithm>

#include "performance/sundials_vectors.hpp"

namespace moat::performance {
namespace {

constexpr Eigen::Index freedoms = floors + 1;

// Events are met this much beyond the change (m or m/s), lest change_regimes() find itself before it: the middle of the
// band in which a step of moat ends.
constexpr double beyond_change = 5e-13;

SundialsModelProblem& problem_of(void* data) { return *static_cast<SundialsModelProblem*>(data); }

}  // namespace

SundialsModelProblem::SundialsModelProblem(const Model& model, const GroundMotion& ground_motion)
    : motion{&ground_motion},
      model_{model},
      inverse_masses_{model.masses().head(freedoms).cwiseInverse()},
      stiffness_{model.pattern()},
      damping_{model.pattern()} {
  if (model.degrees_of_freedom() != freedoms)
    throw InputError{"SundialsModelProblem: the model is not the building of five storeys. Use five_storey_model()."};
  for (const auto& block : model_.blocks())
    if (block->size() > 0 && block->info(0).kind == ElementKind::gap) gaps_ = block.get();
}

void SundialsModelProblem::put_into_trial(double t, const realtype* y) {
  MotionState& trial = model_.trial();
  trial.time = t;
  std::copy(y, y + freedoms, trial.displacement.data());
  std::copy(y + freedoms, y + 2 * freedoms, trial.velocity.data());
}

void SundialsModelProblem::evaluate(double t, const realtype* y) {
  put_into_trial(t, y);
  model_.evaluate();
}

int SundialsModelProblem::rate(realtype t, N_Vector y, N_Vector ydot, void* data) {
  SundialsModelProblem& problem = problem_of(data);
  const realtype* from = NV_DATA_S(y);
  realtype* to = NV_DATA_S(ydot);
  problem.evaluate(t, from);
  const double ground = problem.motion->acceleration_at(t);
  for (Eigen::Index i = 0; i < freedoms; ++i) {
    to[i] = from[freedoms + i];
    to[freedoms + i] = -problem.inverse_masses_[i] * problem.model_.internal_forces()[i] - ground;
  }
  return 0;
}

int SundialsModelProblem::jacobian(realtype t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector,
                                   N_Vector) {
  SundialsModelProblem& problem = problem_of(data);
  problem.put_into_trial(t, NV_DATA_S(y));
  problem.model_.evaluate();
  problem.model_.assemble_tangent(0.0, 0.0, 1.0, problem.stiffness_);
  problem.model_.assemble_tangent(0.0, 1.0, 0.0, problem.damping_);
  for (int i = 0; i < freedoms; ++i) SM_ELEMENT_D(matrix, i, freedoms + i) = 1.0;
  const auto scatter = [&](const SparseMatrix& tangent, Eigen::Index shift) {
    for (int column = 0; column < tangent.size; ++column)
      for (int k = tangent.column_starts[static_cast<std::size_t>(column)];
           k < tangent.column_starts[static_cast<std::size_t>(column) + 1]; ++k) {
        const int row = tangent.row_indices[static_cast<std::size_t>(k)];
        SM_ELEMENT_D(matrix, freedoms + row, shift + column) =
            -problem.inverse_masses_[row] * tangent.values[static_cast<std::size_t>(k)];
      }
  };
  scatter(problem.stiffness_, 0);
  scatter(problem.damping_, freedoms);
  return 0;
}

int SundialsModelProblem::margins(realtype t, N_Vector y, realtype* margin, void* data) {
  SundialsModelProblem& problem = problem_of(data);
  problem.put_into_trial(t, NV_DATA_S(y));
  problem.model_.evaluate();
  const double step = t - problem.model_.state().time;
  margin[0] = std::min(problem.model_.scan_regimes(step, 0.0).margin + beyond_change, 1.0);
  return 0;
}

Peaks SundialsModelProblem::sample(double t, const realtype* y) {
  evaluate(t, y);
  constexpr Eigen::Index top = floors;
  const auto forces = gaps_->forces();
  const Vector& internal = model_.internal_forces();
  // Absolute accelerations.
  return {y[0], y[top], -inverse_masses_[0] * internal[0], -inverse_masses_[top] * internal[top],
          std::max(forces[0], forces[1])};
}

void SundialsModelProblem::change_regimes(double t, const realtype* y, const std::array<int, sides>&) {
  put_into_trial(t, y);
  model_.evaluate();
  model_.commit();
  changes_.clear();
  model_.change_regimes(changes_);
  peaks.restart(t, sample(t, y));
}

}  // namespace moat::performance
