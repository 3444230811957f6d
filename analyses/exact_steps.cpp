#include "analyses/exact_steps.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/check.hpp"
#include "base/hermite.hpp"

namespace moat {
namespace {

// One building has few combinations of sliding and elastic bearings. Many buildings have many; this limit bounds the
// memory.
constexpr std::size_t most_systems = 256;

}  // namespace

ExactSteps::ExactSteps(Model& model, StepControl& control)
    : model_{&model}, control_{&control}, path_{model.degrees_of_freedom()} {
  check();
  const Eigen::Index count = model.degrees_of_freedom();
  stiffness_ = model.pattern();
  damping_ = model.pattern();
  fastest_.setZero(count);
  for (Vector* vector : {&earlier_.velocity, &earlier_.acceleration, &earlier_.jerk}) vector->setZero(count);
  restart();
  // A model with too large an eigenvalue is refused before the first step.
  if (!touching_) linearise();
  control.use_share_of_tolerance(share_in_contact);
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
  earlier_.length = 0.0;
  touching_ = model_->contacts_going_on() > 0;
}

void ExactSteps::linearise() {
  MotionState& trial = model_->trial();
  // At zero displacement and velocity the internal forces are f0. The tangents are those of the current regimes.
  trial.displacement.setZero();
  trial.velocity.setZero();
  model_->evaluate();
  model_->assemble_tangent(0.0, 0.0, 1.0, stiffness_);
  model_->assemble_tangent(0.0, 1.0, 0.0, damping_);
  const auto known =
      std::ranges::find_if(systems_, [&](const LinearSystem& system) { return system.is_of(stiffness_, damping_); });
  current_ = static_cast<std::size_t>(known - systems_.begin());
  const Vector& masses = model_->masses();
  if (known == systems_.end()) {
    if (systems_.size() == most_systems) systems_.clear();
    current_ = systems_.size();
    systems_.emplace_back(stiffness_, damping_, masses, control_->grid_interval());
  }
  offset_ = -model_->internal_forces().head(masses.size()).cwiseQuotient(masses);
  systems_[current_].set_offset(offset_);
  linearised_ = true;
}

double ExactSteps::next_length() {
  if (!linearised_) linearise();
  const double piece = systems_[current_].step();
  const double longest = control_->longest_exact_step();
  wanted_ = std::clamp(wanted_, piece,
                       std::max(piece, std::min(longest, static_cast<double>(LinearPath::most_pieces) * piece)));
  return wanted_;
}

void ExactSteps::begin(const StepTask& step) {
  if (!linearised_) linearise();
  path_.begin(systems_[current_], model_->state(), step);
}

bool ExactSteps::solve(const StepTask& part) {
  const double* end = path_.at(part.length);
  const Eigen::Index n = model_->degrees_of_freedom();
  MotionState& trial = model_->trial();
  trial.time = part.end_time;
  std::copy_n(end, n, trial.displacement.data());
  std::copy_n(end + n, n, trial.velocity.data());
  std::copy_n(end + 2 * n, n, trial.acceleration.data());
  model_->evaluate();
  model_->evaluate_rates();
  return true;
}

bool ExactSteps::accepts(const StepTask& step, std::span<const RegimeChange>) {
  fastest_ = fastest_.cwiseMax(model_->trial().velocity.cwiseAbs());
  if (!interpolates(step)) {
    while (wanted_ >= step.length) wanted_ *= 0.5;
    earlier_.length = 0.0;
    return false;
  }
  if (would_interpolate_doubled(step)) wanted_ = 2.0 * step.length;
  const MotionState& start = model_->state();
  earlier_.length = step.length;
  earlier_.ground_acceleration = step.ground_acceleration_at_start.x;
  earlier_.velocity = start.velocity;
  earlier_.acceleration = start.acceleration;
  earlier_.jerk = start.jerk;
  return true;
}

// Whether the cubics through both ends of the step meet the exact velocities and accelerations inside.
bool ExactSteps::interpolates(const StepTask& step) const {
  const std::size_t pieces = path_.pieces();
  if (pieces == 1) return true;
  const Eigen::Index n = model_->degrees_of_freedom();
  const Vector& scales = control_->acceleration_scales();
  const MotionState &from = model_->state(), &to = model_->trial();
  const double h = step.length, allowed = cubics_within * control_->tolerance();
  for (Eigen::Index i = 0; i < n; ++i) {
    const HermiteCubic velocity{from.velocity[i], from.acceleration[i], to.velocity[i], to.acceleration[i], h};
    const HermiteCubic acceleration{from.acceleration[i] + path_.ground_at(0), from.jerk[i],
                                    to.acceleration[i] + path_.ground_at(pieces), to.jerk[i], h};
    const double allowed_velocity = allowed * fastest_[i], allowed_acceleration = allowed * scales[i];
    for (std::size_t piece = 1; piece < pieces; ++piece) {
      const double x = path_.start_of(piece) / h;
      if (std::abs(velocity.value(x) - path_.velocity(piece, i)) > allowed_velocity) return false;
      if (std::abs(acceleration.value(x) - path_.absolute_acceleration(piece, i)) > allowed_acceleration) return false;
    }
  }
  return true;
}

// Whether the same holds for a step from the start of the step before, with a reserve, so that lengths do not
// alternate.
bool ExactSteps::would_interpolate_doubled(const StepTask& step) const {
  if (earlier_.length != step.length || wanted_ > step.length) return false;
  const Vector& scales = control_->acceleration_scales();
  const MotionState &middle = model_->state(), &to = model_->trial();
  const double ground_before = earlier_.ground_acceleration, ground_middle = path_.ground_at(0),
               ground_after = path_.ground_at(path_.pieces());
  constexpr double reserve = 0.5;
  const double allowed = reserve * cubics_within * control_->tolerance(), h = 2.0 * step.length;
  for (Eigen::Index i = 0; i < scales.size(); ++i) {
    const HermiteCubic velocity{earlier_.velocity[i], earlier_.acceleration[i], to.velocity[i], to.acceleration[i], h};
    if (std::abs(velocity.value(0.5) - middle.velocity[i]) > allowed * fastest_[i]) return false;
    const HermiteCubic acceleration{earlier_.acceleration[i] + ground_before, earlier_.jerk[i],
                                    to.acceleration[i] + ground_after, to.jerk[i], h};
    if (std::abs(acceleration.value(0.5) - (middle.acceleration[i] + ground_middle)) > allowed * scales[i])
      return false;
  }
  return true;
}

}  // namespace moat
