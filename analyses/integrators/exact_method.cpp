#include "analyses/integrators/exact_method.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/check.hpp"

namespace moat {
namespace {

// One building has few combinations of sliding and elastic bearings. Many buildings have many; with this limit and the
// largest models they take 80 MB.
constexpr std::size_t most_systems = 256;

}  // namespace

ExactMethod::ExactMethod(AnalysisState& state, double longest_step, double tolerance)
    : state_{&state},
      longest_step_{longest_step},
      tolerance_{tolerance},
      stiffness_{state.zero_matrix()},
      damping_{stiffness_} {
  const Check check{"TransientOptions", ""};
  const GroundColumns influence = state.model().ground_influence();
  const auto moved = [&](const double* values) {
    return std::any_of(values, values + state.model().degrees_of_freedom(), [](double share) { return share != 0.0; });
  };
  check.that(!moved(influence.y) && !moved(influence.z),
             "integrator: ExactBetweenEvents{} takes models on a line; the ground moves this one along y or z too.",
             "Use Newmark{}, the default.");
  check.that(state.model().degrees_of_freedom() <= most_degrees_of_freedom,
             "integrator = ExactBetweenEvents{} is for at most " + std::to_string(most_degrees_of_freedom) +
                 " degrees of freedom; the model has " + std::to_string(state.model().degrees_of_freedom()) + ".",
             "Use Newmark{}.");
  for (const auto& block : state.model().blocks()) {
    if (block->size() == 0 || block->kind().linear_between_events) continue;
    const ElementInfo& info = block->info(0);
    check.that(false,
               "integrator = ExactBetweenEvents{} needs elements that are linear between located events, and \"" +
                   info.name + "\" is not.",
               "Use Newmark{}, or a law whose changes of stiffness are located.");
  }
  // A model with too large an eigenvalue is refused before the first step.
  if (applies()) linearise();
}

void ExactMethod::linearise() {
  state_->linearise(stiffness_, damping_, forces_at_rest_);
  choose_system();
}

void ExactMethod::choose_system() {
  const MassMatrix& mass = state_->model().mass_matrix();
  const auto size = static_cast<Eigen::Index>(state_->model().degrees_of_freedom());
  auto known =
      std::ranges::find_if(systems_, [&](const LinearSystem& system) { return system.is_of(stiffness_, damping_); });
  if (known == systems_.end()) {
    if (systems_.size() == most_systems) systems_.clear();
    // The cubic through the ends of a vibration misses it by phase^4/384 of its amplitude.
    const double phase = std::pow(384.0 * cubics_within * tolerance_, 0.25);
    known =
        systems_.emplace(systems_.end(), stiffness_, damping_, mass,
                         Eigen::Map<const Vector>{state_->model().ground_influence().x, size}, longest_step_, phase);
  }
  system_ = &*known;
  offset_ = -forces_at_rest_.head(size);
  mass.solve(offset_.data());
}

// The system is a function of its matrices.
void ExactMethod::archive(StateArchive& archive) {
  bool has_system = system_ != nullptr;
  archive(has_system, stiffness_, damping_, forces_at_rest_);
  if (!archive.reads()) return;
  system_ = nullptr;
  if (has_system) choose_system();
}

double ExactMethod::propose() {
  if (system_ == nullptr) linearise();
  begins_ = true;
  return system_->step();
}

bool ExactMethod::solve(const StepTask& task) {
  if (std::exchange(begins_, false)) path_.begin(*system_, offset_, state_->motion(), task);
  path_.move(task.length, state_->trial());
  state_->trial().time = task.end_time;
  state_->move_ground(task.ground_acceleration);
  state_->evaluate();
  state_->evaluate_rates();
  return true;
}

}  // namespace moat
