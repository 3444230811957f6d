#include "performance/overhead.hpp"

#include <moat.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>

#include "output/channels.hpp"
#include "output/energy_ledger.hpp"
#include "output/history_recorder.hpp"
#include "output/impact_recorder.hpp"
#include "output/peak_recorder.hpp"
#include "performance/allocation_counter.hpp"
#include "performance/bare_step.hpp"
#include "performance/function_timer.hpp"
#include "performance/measure.hpp"
#include "performance/moat_five_storeys.hpp"
#include "solvers/factorisation.hpp"
#include "solvers/newton.hpp"

namespace moat::performance {

using namespace units;

namespace {

constexpr double step_length = 0.0025;

TransientOptions fixed_step() { return {.step = step_length * s}; }

/// A history that is ready to run, with some of the observers that CaseRun attaches.
struct Prepared {
  struct With {
    bool energy = false, peaks = false, impacts = false, histories = false;
  };

  Prepared(const GroundMotion& motion, With with)
      : model{five_storey_model(false)},
        transient{model, motion, fixed_step()},
        peaks{model},
        histories{model, motion.time_step(), &energy} {
    if (with.energy) transient.attach(energy);
    if (with.peaks) transient.attach(peaks);
    if (with.impacts) transient.attach(impacts);
    if (with.histories) transient.attach(histories);
  }

  Model model;
  Transient transient;
  EnergyLedger energy;
  PeakRecorder peaks;
  ImpactRecorder impacts;
  HistoryRecorder histories;
};

/// Histories that were set up beforehand, so that only their steps are timed.
Candidate stepping(const GroundMotion& motion, Prepared::With with, int runs) {
  auto waiting = std::make_shared<std::deque<std::unique_ptr<Prepared>>>();
  for (int i = 0; i < runs; ++i) waiting->push_back(std::make_unique<Prepared>(motion, with));
  auto done = std::make_shared<std::deque<std::unique_ptr<Prepared>>>();
  return {"", [waiting, done] {
            waiting->front()->transient.run();
            done->push_back(std::move(waiting->front()));
            waiting->pop_front();
          }};
}

/// A system whose residual vanishes after one step: what is left is the solver's own work.
class Trivial final : public NonlinearSystem {
 public:
  int size() const override { return 6; }
  bool compute_residual(const Vector& x, Vector& residual) override {
    residual = x;
    return true;
  }
  const Vector& residual_scales() const override { return scales_; }
  bool compute_direction(const Vector& residual, Vector& direction) override {
    direction = -residual;
    return true;
  }

 private:
  Vector scales_ = Vector::Ones(6);
};

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b, double factor) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back((a[i] - b[i]) * factor);
  return result;
}

Spread scaled(Spread value, double factor) {
  return {value.median * factor, value.low * factor, value.high * factor, value.count};
}

/// How often a step calls what it is made of.
struct CallsPerStep {
  double evaluations = 0.0, iterations = 0.0, factorisations = 0.0, solves = 0.0;

  explicit CallsPerStep(const SolverStatistics& statistics) {
    const auto steps = static_cast<double>(statistics.accepted_steps);
    iterations = static_cast<double>(statistics.newton_iterations) / steps;
    solves = 1.0 + static_cast<double>(statistics.event_solves + statistics.rejected_steps) / steps;
    factorisations = static_cast<double>(statistics.factorisations) / steps;
    evaluations = solves + iterations;
  }
};

/// Functions of one step at a state in the middle of a history. Returns their sum per step, ns.
double show_functions(Record& record, const GroundMotion& motion, const CallsPerStep& calls, int repetitions) {
  Model model = five_storey_model(false);
  Transient transient{model, motion, fixed_step()};
  while (model.state().time < 3.0) transient.advance();

  const StepScheme scheme;
  SparseMatrix tangents[2] = {model.pattern(), model.pattern()};
  const auto assemble = [&](double h, SparseMatrix& matrix) {
    model.assemble_tangent(1.0, scheme.velocity_weight(h), scheme.displacement_weight(h), matrix);
  };
  assemble(step_length, tangents[0]);
  assemble(0.5 * step_length, tangents[1]);
  SparseMatrix assembled = model.pattern();
  Factorisation changing, kept;
  if (!kept.factorise(tangents[0])) throw Error{"The tangent of the building could not be factorised."};
  int turn = 0;
  bool good = true;
  Vector right_hand_side = Vector::Ones(model.degrees_of_freedom());
  Trivial trivial;
  NewtonSolver newton{trivial, {}};
  Vector start(6);
  RegimeScan scan;

  struct Timed {
    TimedFunction function;
    double calls;
  };
  const std::vector<Timed> list{
      {{"evaluate", [&] { model.evaluate(); }}, calls.evaluations},
      {{"assemble", [&] { assemble(step_length, assembled); }}, calls.iterations},
      {{"factorise, tangent changed", [&] { good = changing.factorise(tangents[turn++ % 2]) && good; }},
       calls.factorisations},
      {{"factorise, tangent unchanged", [&] { good = kept.factorise(tangents[0]) && good; }},
       calls.iterations - calls.factorisations},
      {{"solve", [&] { kept.solve(right_hand_side); }}, calls.iterations},
      {{"NOX, its own work in one iteration",
        [&] {
          start.setOnes();
          good = newton.solve(start).converged && good;
        }},
       calls.solves},
      {{"look for events", [&] { scan = model.scan_regimes(step_length, -5e-13); }}, calls.solves},
      {{"commit with energy of the elements",
        [&] {
          model.trial().time = model.state().time + step_length;
          model.commit();
        }},
       1.0},
  };
  std::vector<TimedFunction> functions;
  for (const Timed& each : list) functions.push_back(each.function);
  const std::vector<Spread> times = nanoseconds_per_call(functions, repetitions);
  if (!good) throw Error{"A tangent of the building could not be factorised."};
  double sum = 0.0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    record.add({"overhead, " + list[i].function.name + ", per call", times[i], "ns"});
    record.add({"overhead, " + list[i].function.name + ", per step", scaled(times[i], list[i].calls), "ns"});
    sum += times[i].median * list[i].calls;
  }
  return sum;
}

/// Largest difference of a peak from the bare loop's, relative.
double largest_difference(const Prepared& history, const BareHistory& bare) {
  // Peaks share a place; the bare loop keeps them by channel.
  const Channels channels{history.model};
  double largest = 0.0;
  for (const Peak& peak : history.peaks.peaks()) {
    double value = 0.0;
    for (std::size_t i = 0; i < channels.list().size(); ++i)
      if (channels.list()[i].quantity == peak.quantity && channels.list()[i].place == peak.where)
        value = std::max(value, bare.peaks[i]);
    if (value > 0.0) largest = std::max(largest, std::abs(peak.magnitude() / value - 1.0));
  }
  return largest;
}

void show_heap_requests(Record& record, const GroundMotion& motion) {
  Prepared history{motion, {.energy = true, .peaks = true}};
  constexpr double warm = 2.0;
  while (history.model.state().time < warm) history.transient.advance();
  const long before = heap_requests(), steps = history.transient.statistics().accepted_steps;
  const long events = history.transient.statistics().events;
  while (!history.transient.finished()) history.transient.advance();
  const double count = static_cast<double>(heap_requests() - before);
  record.add({"overhead, heap requests in " + std::to_string(history.transient.statistics().accepted_steps - steps) +
                  " steps with " + std::to_string(history.transient.statistics().events - events) +
                  " events after the first 2 s",
              single(count), "", Target{0.0}});
}

}  // namespace

void overhead(Record& record, const Options& options) {
  record.section("overhead", "Overhead: the general path beside a loop written for one building");
  record.note(
      "Five-storey building in its moat, default pulse at 0.4 g, fixed step of 2.5 ms; the steps alone, without "
      "setting up. The bare loop does the same: touches located, energies, peaks of all channels, histories.");
  const GroundMotion motion = near_fault_pulse().scaled_to_pga(0.4 * g);
  const int runs = options.rounds + 1;

  const BareHistory bare = bare_history(motion, step_length);
  Prepared full{motion, {true, true, true, true}};
  full.transient.run();
  const SolverStatistics statistics = full.transient.statistics();
  const CallsPerStep calls{statistics};
  record.add({"overhead, accepted steps", single(static_cast<double>(statistics.accepted_steps)), ""});
  record.add({"overhead, accepted steps of the bare loop", single(static_cast<double>(bare.steps)), ""});
  record.add({"overhead, Newton iterations", single(static_cast<double>(statistics.newton_iterations)), ""});
  record.add({"overhead, Newton iterations of the bare loop", single(static_cast<double>(bare.newton_iterations)), ""});
  record.add({"overhead, largest difference of a peak from the bare loop's", single(largest_difference(full, bare)), "",
              Target{1e-8}});

  const auto times =
      interleaved_times({{"bare", [&] { static_cast<void>(bare_history(motion, step_length)); }},
                         stepping(motion, {.energy = true, .peaks = true, .impacts = true, .histories = true}, runs),
                         stepping(motion, {}, runs),
                         stepping(motion, {.energy = true}, runs),
                         stepping(motion, {.peaks = true}, runs),
                         stepping(motion, {.impacts = true}, runs),
                         stepping(motion, {.energy = true, .histories = true}, runs)},
                        options.rounds);
  const auto &bare_times = times[0], &full_times = times[1], &alone = times[2];
  const double to_nanoseconds = 1e9 / static_cast<double>(statistics.accepted_steps);
  record.add({"overhead, full path over bare loop", ratio_of(full_times, bare_times), "", Target{3.0}});
  record.add({"overhead, full path without observers over bare loop", ratio_of(alone, bare_times), ""});
  record.add({"overhead, bare loop, per step", scaled(spread_of(bare_times), to_nanoseconds), "ns"});
  record.add({"overhead, full path, per step", scaled(spread_of(full_times), to_nanoseconds), "ns"});
  record.add({"overhead, energy ledger, per step", spread_of(difference(times[3], alone, to_nanoseconds)), "ns"});
  record.add({"overhead, peaks, per step", spread_of(difference(times[4], alone, to_nanoseconds)), "ns"});
  record.add({"overhead, impacts, per step", spread_of(difference(times[5], alone, to_nanoseconds)), "ns"});
  record.add({"overhead, histories with energies every second step, per step",
              spread_of(difference(times[6], times[3], to_nanoseconds)), "ns"});
  const double functions = show_functions(record, motion, calls, options.rounds);
  record.add({"overhead, step equations, step control and the rest, per step",
              single(spread_of(alone).median * to_nanoseconds - functions), "ns"});
  show_heap_requests(record, motion);
}

}  // namespace moat::performance
