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

// The phase of a vibration over which the cubic through its ends meets it to this share of its amplitude: the error is
// phase^4/384.
double largest_phase(double share) { return std::min(0.5, std::pow(384.0 * share, 0.25)); }

}  // namespace

ExactSteps::ExactSteps(Model& model, StepControl& control)
    : model_{&model}, control_{&control}, path_{model.degrees_of_freedom()} {
  check();
  stiffness_ = model.pattern();
  damping_ = model.pattern();
  earlier_.motion = model.state();
  fastest_.setZero(earlier_.motion.velocity.size());
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
               "Use Newmark{}, or a law whose changes of stiffness are located.");
  }
}

void ExactSteps::restart() {
  linearised_ = false;
  earlier_.length = 0.0;
  touching_ = model_->contacts_going_on() > 0;
}

void ExactSteps::linearise() {
  model_->linearise(stiffness_, damping_, forces_at_rest_);
  const auto known =
      std::ranges::find_if(systems_, [&](const LinearSystem& system) { return system.is_of(stiffness_, damping_); });
  current_ = static_cast<std::size_t>(known - systems_.begin());
  const Vector& masses = model_->masses();
  if (known == systems_.end()) {
    if (systems_.size() == most_systems) systems_.clear();
    current_ = systems_.size();
    systems_.emplace_back(stiffness_, damping_, masses, control_->grid_interval(),
                          largest_phase(cubics_within * control_->tolerance()));
  }
  offset_ = -forces_at_rest_.head(masses.size()).cwiseQuotient(masses);
  systems_[current_].set_offset(offset_);
  linearised_ = true;
}

double ExactSteps::next_length() {
  if (!linearised_) linearise();
  const double piece = systems_[current_].step();
  wanted_ = std::max(wanted_, piece);
  // Shorter for a while after a change of regime, which is no reason to want less.
  const double longest = std::min(control_->longest_exact_step(), static_cast<double>(LinearPath::most_pieces) * piece);
  return std::min(wanted_, std::max(piece, longest));
}

void ExactSteps::begin(const StepTask& step) {
  if (!linearised_) linearise();
  path_.begin(systems_[current_], model_->state(), step);
}

bool ExactSteps::solve(const StepTask& part) {
  move_to_end(part);
  complete();
  return true;
}

bool ExactSteps::look(const StepTask& part) {
  move_to_end(part);
  model_->evaluate_regimes();
  return true;
}

// Forces on nodes are needed behind a touch, and Transient::balance() computes them there.
void ExactSteps::complete() { model_->evaluate_elements(); }

void ExactSteps::move_to_end(const StepTask& part) {
  const double* end = path_.at(part.length);
  const Eigen::Index n = model_->degrees_of_freedom();
  MotionState& trial = model_->trial();
  trial.time = part.end_time;
  std::copy_n(end, n, trial.displacement.data());
  std::copy_n(end + n, n, trial.velocity.data());
  std::copy_n(end + 2 * n, n, trial.acceleration.data());
  std::copy_n(end + 3 * n, n, trial.jerk.data());
}

bool ExactSteps::accepts(const StepTask& step, std::span<const RegimeChange>) {
  fastest_ = fastest_.cwiseMax(model_->trial().velocity.cwiseAbs());
  constexpr double round_off = 1e-6;
  least_velocity_ = round_off * fastest_.maxCoeff();
  if (!interpolates(step)) {
    while (wanted_ >= step.length) wanted_ *= 0.5;
    earlier_.length = 0.0;
    return false;
  }
  if (would_interpolate_doubled(step)) wanted_ = 2.0 * step.length;
  earlier_.length = 0.0;
  if (wanted_ > step.length) return true;  // longer steps are wanted already
  earlier_.length = step.length;
  earlier_.ground_acceleration = step.ground_acceleration_at_start.x;
  earlier_.motion = model_->state();
  return true;
}

// Whether the cubics of all nodes between two motions, h s apart, meet this motion (u, u', u'') at `time`, to `allowed`
// of the scales. Each motion has its acceleration of the ground, m/s^2.
bool ExactSteps::meets(const MotionOnGround& from, const MotionOnGround& to, double h, double time,
                       const double* motion, double ground_there, double allowed) {
  const HermiteCubicsAt cubics{time / h, h};
  const Eigen::Index n = model_->degrees_of_freedom();
  const double *v0 = from.motion->velocity.data(), *a0 = from.motion->acceleration.data(),
               *j0 = from.motion->jerk.data(), *v1 = to.motion->velocity.data(), *a1 = to.motion->acceleration.data(),
               *j1 = to.motion->jerk.data(), *scales = control_->acceleration_scales().data(),
               *fastest = fastest_.data();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double velocity = cubics.value(v0[i], a0[i], v1[i], a1[i]),
                 acceleration = cubics.value(a0[i] + from.ground, j0[i], a1[i] + to.ground, j1[i]);
    if (std::abs(velocity - motion[n + i]) > allowed * std::max(fastest[i], least_velocity_) ||
        std::abs(acceleration - (motion[2 * n + i] + ground_there)) > allowed * scales[i])
      return false;
  }
  return true;
}

// Whether the cubics through both ends of the step meet the exact motion inside. A single piece is short enough:
// largest_phase().
bool ExactSteps::interpolates(const StepTask& step) {
  const std::size_t parts = path_.parts();
  const MotionOnGround from{&model_->state(), path_.ground_at(0)}, to{&model_->trial(), path_.ground_at(parts)};
  for (std::size_t part = 1; part < parts; ++part)
    if (!meets(from, to, step.length, path_.start_of(part), path_.motion(part), path_.ground_at(part),
               cubics_within * control_->tolerance()))
      return false;
  return true;
}

// Whether the same holds for a step from the start of the step before, with a reserve, so that lengths do not
// alternate.
bool ExactSteps::would_interpolate_doubled(const StepTask& step) {
  if (earlier_.length != step.length || wanted_ > step.length) return false;
  constexpr double reserve = 0.5;
  const MotionOnGround from{&earlier_.motion, earlier_.ground_acceleration},
      to{&model_->trial(), path_.ground_at(path_.parts())};
  return meets(from, to, 2.0 * step.length, step.length, path_.motion(0), path_.ground_at(0),
               reserve * cubics_within * control_->tolerance());
}

}  // namespace moat
