#include "analyses/time_history/step_solver.hpp"

#include <string>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moat {

StepSolver::StepSolver(AnalysisState& state, const StepSettings& settings, const StepGrid& grid,
                       SolverStatistics& statistics)
    : state_{&state},
      grid_{&grid},
      statistics_{&statistics},
      location_tolerance_{settings.location_tolerance},
      force_tolerance_{settings.newton.tolerance},
      max_cuts_{settings.max_cuts} {}

double StepSolver::solve_next(StepMethod& method) {
  method_ = &method;
  for (;; ++statistics_->repeated_steps) {
    whole_ = grid_->next_step(state_->motion().time, method.propose());
    const double h = solve_cutting(whole_.length);
    if (method.judge(first_part(h))) return h;
  }
}

const StepTask& StepSolver::first_part(double h) {
  if (h == whole_.length) return whole_;
  part_ = grid_->first_part(whole_, h);
  return part_;
}

double StepSolver::solve_cutting(double h) {
  for (int cut = 0; cut <= max_cuts_; ++cut, h *= 0.5) {
    if (solve(h)) return h;
    ++statistics_->rejected_steps;
  }
  give_up(2.0 * h);
}

void StepSolver::give_up(double h) const {
  const NewtonReport report = method_->imbalance();
  const std::string worst{state_->model().node_name(NodeId{report.worst_degree_of_freedom})};
  const double time = state_->motion().time;
  throw ConvergenceError{"The step from t = " + to_text(time) + " s did not converge although it was cut to " +
                             to_text(h) + " s: the forces are out of balance by " + to_text(report.residual) +
                             " of the largest force there (allowed: " + to_text(force_tolerance_) + "), worst at \"" +
                             worst +
                             "\". Check the parameters of the elements there; results up to this time are kept.",
                         time, h, report.residual, worst};
}

}  // namespace moat
