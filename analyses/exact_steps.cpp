#include "analyses/exact_steps.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/hermite.hpp"

namespace moat {
namespace {

// One building has few combinations of sliding and elastic bearings. Many buildings have many; this limit bounds the
// memory.
constexpr std::size_t most_systems = 256;

}  // namespace

ExactSteps::ExactSteps(Model& model, StepControl& control)
    : model_{&model},
      control_{&control},
      stiffness_{model.zero_matrix()},
      damping_{stiffness_},
      earlier_{model.state()},
      middle_{model.state()},
      fastest_{Vector::Zero(earlier_.velocity.size())} {
  const Check check{"TransientOptions", ""};
  check.that(!model.is_plan(), "integrator: ExactBetweenEvents{} takes models on a line; this one moves in plan.",
             "Use Newmark{}, the default.");
  check.that(model.degrees_of_freedom() <= most_degrees_of_freedom,
             "integrator = ExactBetweenEvents{} is for at most " + std::to_string(most_degrees_of_freedom) +
                 " degrees of freedom; the model has " + std::to_string(model.degrees_of_freedom()) + ".",
             "Use Newmark{}.");
  for (const auto& block : model.blocks()) {
    if (block->size() == 0 || block->linear_between_events()) continue;
    const ElementInfo& info = block->info(0);
    check.that(false,
               "integrator = ExactBetweenEvents{} needs elements that are linear between located events, and \"" +
                   info.name + "\" is not.",
               "Use Newmark{}, or a law whose changes of stiffness are located.");
  }
  // A model with too large an eigenvalue is refused before the first step.
  if (applies()) linearise();
  control.use_share_of_tolerance(share_in_contact);
}

void ExactSteps::linearise() {
  model_->linearise(stiffness_, damping_, forces_at_rest_);
  const Vector& masses = model_->masses();
  auto known =
      std::ranges::find_if(systems_, [&](const LinearSystem& system) { return system.is_of(stiffness_, damping_); });
  if (known == systems_.end()) {
    if (systems_.size() == most_systems) systems_.clear();
    // The cubic through the ends of a vibration misses it by phase^4/384 of its amplitude.
    const double phase = std::pow(384.0 * cubics_within * control_->tolerance(), 0.25);
    known =
        systems_.emplace(systems_.end(), stiffness_, damping_, masses, control_->grid_interval(), std::min(0.5, phase));
  }
  system_ = &*known;
  offset_ = -forces_at_rest_.head(masses.size()).cwiseQuotient(masses);
}

double ExactSteps::next_length() {
  if (system_ == nullptr) linearise();
  const double piece = system_->step();
  wanted_ = std::max(wanted_, piece);
  // Shorter for a while after a change of regime, which is no reason to want less.
  const double longest = std::min(control_->longest_exact_step(), static_cast<double>(LinearPath::most_pieces) * piece);
  return std::min(wanted_, std::max(piece, longest));
}

void ExactSteps::begin(const StepTask& step) {
  if (system_ == nullptr) linearise();
  path_.begin(*system_, offset_, model_->state(), step);
}

void ExactSteps::move_to_end(const StepTask& part) {
  path_.move(part.length, model_->trial());
  model_->trial().time = part.end_time;
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

bool ExactSteps::accepts(const StepTask& step, std::span<const RegimeChange>) {
  const Instant start{model_->state(), path_.ground_at(0)}, end{model_->trial(), path_.ground_at(path_.pieces())};
  fastest_ = fastest_.cwiseMax(end.motion.velocity.cwiseAbs());
  const double earlier_length = std::exchange(earlier_length_, 0.0);
  // A single piece is short enough: linearise().
  for (Eigen::Index piece = 1; piece < path_.pieces(); ++piece) {
    path_.move(path_.start_of(piece), middle_);
    if (meets(start, end, {middle_, path_.ground_at(piece)}, cubics_within)) continue;
    while (wanted_ >= step.length) wanted_ *= 0.5;
    return false;
  }
  if (wanted_ > step.length) return true;  // longer steps are wanted already
  // The cubic over the last two steps is judged with a reserve, so that lengths do not alternate.
  constexpr double reserve = 0.5;
  if (earlier_length == step.length && meets({earlier_, earlier_ground_}, end, start, reserve * cubics_within)) {
    wanted_ = 2.0 * step.length;
    return true;
  }
  earlier_length_ = step.length;
  earlier_ground_ = start.ground_acceleration;
  earlier_ = start.motion;
  return true;
}

// Whether the cubics of velocities and absolute accelerations between two instants meet those at an instant between
// them, to so many tolerances of the scales.
bool ExactSteps::meets(const Instant& from, const Instant& to, const Instant& there, double tolerances) {
  // Velocities this much below those of the fastest node may be round-off.
  constexpr double round_off = 1e-6;
  const double allowed = tolerances * control_->tolerance(), least_velocity = round_off * fastest_.maxCoeff();
  const Vector& scales = control_->acceleration_scales();
  const MotionState &start = from.motion, &end = to.motion, &middle = there.motion;
  const double h = end.time - start.time;
  const HermiteCubicsAt cubics{(middle.time - start.time) / h, h};
  for (Eigen::Index i = 0; i < model_->degrees_of_freedom(); ++i) {
    const double velocity =
                     cubics.value(start.velocity[i], start.acceleration[i], end.velocity[i], end.acceleration[i]),
                 acceleration = cubics.value(start.acceleration[i] + from.ground_acceleration, start.jerk[i],
                                             end.acceleration[i] + to.ground_acceleration, end.jerk[i]);
    if (std::abs(velocity - middle.velocity[i]) > allowed * std::max(fastest_[i], least_velocity) ||
        std::abs(acceleration - middle.acceleration[i] - there.ground_acceleration) > allowed * scales[i])
      return false;
  }
  return true;
}

}  // namespace moat
