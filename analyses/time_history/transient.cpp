#include "analyses/time_history/transient.hpp"

#include <algorithm>
#include <ctime>
#include <exception>
#include <utility>

#include "analyses/events/event_location.hpp"
#include "analyses/integrators/integrators.hpp"
#include "analyses/time_history/model_checks.hpp"
#include "analyses/time_history/weight_warnings.hpp"
#include "base/check.hpp"
#include "base/error.hpp"
#include "base/sha256.hpp"
#include "base/text/rows.hpp"
#include "motions/motion_files.hpp"
#include "motions/vertical_motion.hpp"

namespace moat {
namespace {

// All by which the analysis that wrote a state is known again: names, laws, matrices, start, motion and method.
std::string identity_of(const Transient& transient) {
  const Model& model = transient.model();
  std::string bytes;
  const auto add_text = [&](std::string_view text) { bytes.append(text).push_back('\0'); };
  const auto add_numbers = [&](const double* numbers, Eigen::Index count) {
    bytes.append(reinterpret_cast<const char*>(numbers), static_cast<std::size_t>(count) * sizeof *numbers);
  };
  for (int i = 0; i < model.nodes(); ++i) add_text(model.node_name(model.node(i)));
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) {
      const LawAsGiven law = block->law(e);
      add_text(block->info(e).name);
      add_text(law.name);
      add_numbers(&block->info(e).offset, 1);
      for (const Parameter& each : law.parameters) add_numbers(&each.value, 1);
    }
  SparseMatrix masses = model.zero_matrix(), stiffness = masses, damping = masses;
  model.mass_matrix().add_to(1.0, masses);
  Vector forces;
  AnalysisState{model}.linearise(stiffness, damping, forces);
  for (const SparseMatrix* matrix : {&masses, &stiffness, &damping})
    add_numbers(matrix->valuePtr(), matrix->nonZeros());
  const MotionState start = model.initial_motion();
  for (const Vector* each : {&start.displacement, &start.velocity}) add_numbers(each->data(), each->size());
  const double end = transient.end_time();
  add_numbers(&end, 1);
  add_text(hash_of(transient.motion()));
  for (const std::string& each : transient.assumptions()) add_text(each);
  return sha256_of(bytes);
}

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

Transient::Transient(const Model& model, GroundMotion motion, TransientOptions options)
    : Transient{model, std::move(motion), AnalysisState{model}, options} {}

Transient::Transient(const Model& model, GroundMotion motion, AnalysisState state, TransientOptions options)
    : state_{std::move(state)},
      motion_{std::make_shared<const GroundMotion>(std::move(motion))},
      options_{checked(options, *motion_)},
      settings_{settings_of(options_, *motion_)},
      grid_{*motion_, state_.time(), options.end.si() > 0.0 ? options.end.si() : motion_->duration()},
      step_{state_, settings_, grid_, statistics_},
      chatter_{options_.max_events_per_second} {
  check_start(model, state_, *motion_, grid_.end());
  for (WeightOnBearings& weight : state_.weights()) {
    const AxialForces& asked = weight.options();
    if (asked.vertical_period.si() == 0.0) continue;
    const auto mode = std::make_shared<const VerticalMotion>(*motion_, asked.vertical_period, asked.vertical_damping);
    while (settings_.longest_step > mode->longest_step()) settings_.longest_step *= 0.5;
    weight.move_in([mode](double time) { return std::pair{mode->acceleration(time), mode->rate(time)}; });
  }
  methods_ = methods_of(options_.integrator, state_, settings_);
  method_ = methods_.by_preference.front().get();
  check_held(state_);
  check_gap_directions(model);
  state_.begin_motion(motion_);
  restart(false);
  change_regimes_at_end();
  // All energies count from here, those of the elements too.
  if (state_.keeps_energy_accounts()) state_.start_energy_accounts();
}

Transient::~Transient() = default;

void Transient::attach(StepObserver& observer) {
  if (observer.needs_energy_accounts() && !state_.keeps_energy_accounts()) state_.start_energy_accounts();
  observers_.add(observer);
}

StepView Transient::view(bool on_grid) const {
  return {state_.model(), state_, grid_.ground_acceleration(), on_grid, method_->work_rule()};
}

void Transient::advance() {
  if (!state_.fits_model())
    throw InputError{"Transient: the model was added to while it is being analysed. Make a new Transient after that."};
  try {
    take_and_report_step();
  } catch (...) {
    state_.return_to_committed_state();
    throw;
  }
}

void Transient::take_and_report_step() {
  observers_.start(view(true));
  if (grid_.reaches_end_of_motion(state_.time())) end_motion();
  if (!state_.weights().empty() && state_.turn_ground(grid_.rate_behind(state_.time()).z))
    observers_.event(view(false), {});
  method_ = std::ranges::find_if(methods_.by_preference, [](const auto& each) { return each->applies(); })->get();
  double h = step_.solve_next(*method_);
  const RegimeScan seen = step_.scan(h);
  // A cut step may end before its change, so that the next one finds it. A change that several cuts do not reach, or
  // that does not happen where it is located, is passed by a whole step.
  constexpr int most_vain_cuts = 8;
  const long events = statistics_.events;
  const bool is_inside =
      seen.crossed && options_.events == EventTreatment::located && !is_located(seen, step_.location_tolerance());
  const bool cuts = is_inside && vain_cuts_ < most_vain_cuts;
  if (is_inside && !cuts) ++statistics_.passed_changes;
  if (cuts) h = locate_change(step_, h, seen);
  commit(step_.first_part(h));
  observers_.step(view(h == step_.whole().length));
  if (seen.crossed) change_regimes_at_end();
  vain_cuts_ = cuts && statistics_.events == events ? vain_cuts_ + 1 : 0;
}

void Transient::commit(const StepTask& step) {
  state_.commit(method_->work_rule());
  grid_.accepted(step);
  ++statistics_.accepted_steps;
  statistics_.longest_step = std::max(statistics_.longest_step, step.length);
  for (const auto& method : methods_.by_preference) method->accepted(step);
  collapse_.look(state_);
}

// The force may jump at the committed state. With the acceleration before the jump methods would lose their order.
void Transient::restart(bool touched) {
  state_.balance_committed_state(grid_.ground_acceleration());
  for (const auto& method : methods_.by_preference) method->restart(touched);
}

void Transient::change_regimes_at_end() {
  // A force that jumps makes axial forces jump, and these may end other regimes.
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds; ++round) {
    changes_.clear();
    state_.change_regimes(changes_);
    if (changes_.empty()) return;
    restart(std::ranges::any_of(changes_, &RegimeChange::touched));
    statistics_.events += static_cast<long>(changes_.size());
    chatter_.count(state_, changes_);
    observers_.event(view(false), changes_);
    if (!state_.feels_accelerations()) return;
  }
}

void Transient::end_motion() {
  if (!grid_.end_motion()) return;
  restart(false);
  observers_.event(view(false), {});
}

void Transient::finish() {
  // Observers would ask the state for elements that only the model has by now.
  if (state_.fits_model()) observers_.finish(view(true));
}

void Transient::run(const std::function<bool()>& stop) {
  counted_until_ = process_seconds();
  const auto end = [&] {
    count_time();
    counted_until_.reset();
    finish();
  };
  observers_.start(view(true));
  try {
    while (!finished() && !(stop && stop())) advance();
  } catch (...) {
    try {
      end();
    } catch (const std::exception&) {
      // The first failure counts.
    }
    throw;
  }
  end();
}

void Transient::count_time() {
  if (!counted_until_) return;
  const double now = process_seconds();
  statistics_.cpu_seconds += now - std::exchange(*counted_until_, now);
}

void Transient::archive(StateArchive& archive) {
  count_time();
  if (identity_.empty()) identity_ = identity_of(*this);
  archive.require_same(identity_, "The saved state is that of another model, motion or method.");
  if (archive.reads()) observers_.start(view(true));
  archive(state_, statistics_, grid_, chatter_, collapse_, vain_cuts_);
  auto method = std::ranges::find(methods_.by_preference, method_, &std::unique_ptr<StepMethod>::get) -
                methods_.by_preference.begin();
  archive(method);
  method_ = methods_.by_preference.at(static_cast<std::size_t>(method)).get();
  for (const auto& each : methods_.by_preference) each->archive(archive);
  observers_.archive(archive);
}

SolverStatistics Transient::statistics() const {
  SolverStatistics sum = statistics_;
  for (const auto& method : methods_.by_preference) method->add_costs(sum);
  return sum;
}

std::vector<std::string> Transient::assumptions() const {
  std::vector<std::string> list;
  if (!methods_.reason.empty()) list.push_back(methods_.reason);
  std::string steps;
  for (const auto& method : methods_.by_preference) steps += method->description();
  list.push_back(steps + ".");
  list.push_back(options_.events == EventTreatment::located
                     ? "Touch and separation located until the gap is zero to " +
                           to_text(options_.location_tolerance.si()) + " m, acceleration recomputed there."
                     : "Touch and separation at the end of the step that crosses them, up to a step too late; "
                       "acceleration recomputed there.");
  list.push_back(
      "Ground acceleration linear between samples and zero after the last one; the system starts at rest at the first "
      "sample unless initial values are given.");
  if (!state_.weights().empty())
    list.push_back(
        "Axial forces of bearings follow overturning and vertical motion: rigid slab on vertical springs, no vertical "
        "degree of freedom of a bearing, no impact where a lifted bearing lands, no rotary inertia of floors about "
        "horizontal axes.");
  for (const WeightOnBearings& weight : state_.weights())
    if (weight.eccentricity() > 0.0)
      list.push_back(weight.building() + (weight.building().empty() ? "" : " ") +
                     "bearings: their weights put the load " + to_text(weight.eccentricity()) +
                     " m from the centre of mass.");
  return list;
}

std::vector<std::string> Transient::warnings() const {
  std::vector<std::string> list;
  if (collapse_.collapsed()) list.push_back(collapse_.warning());
  if (statistics_.passed_changes > 0)
    list.push_back(
        counted(statistics_.passed_changes, "change") +
        " of regime could not be located: several cuts in succession did not reach the change, and a whole step "
        "passed it. Take a smaller largest_step or a tighter tolerance, or a shorter fixed step.");
  for (std::string& warning : weight_warnings(state_, !finished())) list.push_back(std::move(warning));
  for (const auto& method : methods_.by_preference)
    for (std::string& warning : method->warnings()) list.push_back(std::move(warning));
  return list;
}

}  // namespace moat
