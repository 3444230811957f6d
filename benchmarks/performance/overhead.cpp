#include <deque>
#include <memory>
#include <moat.hpp>

#include "measuring/measure.hpp"
#include "output/energy_ledger.hpp"
#include "output/history_recorder.hpp"
#include "output/impact_recorder.hpp"
#include "output/peak_recorder.hpp"
#include "performance/bare_loops.hpp"
#include "performance/moat_five_storeys.hpp"
#include "performance/plan_tower.hpp"
#include "performance/sections.hpp"

namespace moat::performance {

using namespace units;

namespace {

constexpr int divisions = 2;  // of the interval of 5 ms

struct With {
  bool peaks = false, energy = false, impacts = false, histories = false;
};

/// The same problem for moat and for a bare loop.
struct Problem {
  std::string name;
  Model model;
  GroundMotion motion;
  Time end{};  ///< 0: that of the motion
  std::function<void()> bare = {};
};

/// A history that is ready to run, with observers that CaseRun attaches. Average acceleration in fixed steps: the
/// mathematics of the bare loops.
struct Prepared {
  Prepared(const Problem& problem, With with)
      : model{problem.model},
        transient{model,
                  problem.motion,
                  {.integrator = Newmark::average_acceleration(),
                   .step = problem.motion.time_step() / divisions * s,
                   .end = problem.end}},
        peaks{model},
        histories{model, problem.motion.time_step(), &energy} {
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
Candidate stepping(const Problem& problem, With with, int runs) {
  auto waiting = std::make_shared<std::deque<std::unique_ptr<Prepared>>>();
  for (int i = 0; i < runs; ++i) waiting->push_back(std::make_unique<Prepared>(problem, with));
  auto done = std::make_shared<std::deque<std::unique_ptr<Prepared>>>();
  return {"", [waiting, done] {
            waiting->front()->transient.run();
            done->push_back(std::move(waiting->front()));
            waiting->pop_front();
          }};
}

using Times = std::vector<double>;  // of all rounds, s

/// Of the bare loop, then of moat with each of these observers.
std::vector<Times> times_in_turns(const Problem& problem, const std::vector<With>& list, int rounds) {
  std::vector<Candidate> candidates{{"", problem.bare}};
  for (const With& with : list) candidates.push_back(stepping(problem, with, rounds + 1));
  return interleaved_times(candidates, rounds);
}

Times difference(const Times& a, const Times& b) {
  Times result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

struct Row {
  std::string name;
  Times times;
  long steps;
};

void put_table(Record& record, const Problem& problem, const std::vector<Row>& rows) {
  Table table{{"Per step", "Time [ns]"}};
  for (const auto& [name, times, steps] : rows) {
    const Spread per_step = scaled(spread_of(times), 1e9 / static_cast<double>(steps));
    table.put(name, "Time [ns]", cell(record.add({problem.name + ", " + name, per_step, "ns"})));
  }
  record.table(table);
}

void judge(Record& record, const Problem& problem, const std::string& ratio, const Spread& value) {
  const Target bound{3.0};
  const Figure& figure = record.add({problem.name + ", " + ratio, value, "", bound});
  record.note(ratio + ": " + cell(figure) + ", target " + text(bound) + ".");
}

// "Steps of 2.5 ms, without setting up. moat takes 10 steps with 20 iterations, the bare loop 10 with 19."
template <class History>
std::string counts(const Problem& problem, const SolverStatistics& moat, const History& bare) {
  return "Fixed steps of " + short_text(1e3 * problem.motion.time_step() / divisions) +
         " ms, without setting up. moat takes " + std::to_string(moat.accepted_steps) + " steps with " +
         std::to_string(moat.newton_iterations) + " iterations, the bare loop " + std::to_string(bare.steps) +
         " with " + std::to_string(bare.iterations) + ".";
}

}  // namespace

void overhead(Record& record, const Options& options) {
  record.section("overhead");
  Problem problem{"overhead", five_storey_model(), near_fault_pulse().scaled_to_pga(0.4 * g)};
  BareHistory bare_history;
  problem.bare = [&] { bare_history = bare_newmark(problem.motion, divisions); };
  const With everything{.peaks = true, .energy = true, .impacts = true, .histories = true};
  const auto times = times_in_turns(problem,
                                    {{},
                                     {.peaks = true},
                                     {.energy = true},
                                     {.energy = true, .impacts = true},
                                     {.energy = true, .histories = true},
                                     everything},
                                    options.rounds);
  const Times &bare = times[0], &alone = times[1], &peaks = times[2], &energy = times[3], &impacts = times[4],
              &histories = times[5], &all = times[6];
  Prepared same{problem, {}};
  same.transient.run();
  const SolverStatistics& statistics = same.transient.statistics();
  const long steps = statistics.accepted_steps;
  put_table(record, problem,
            {{"bare Newmark, peaks of five numbers", bare, steps},
             {"moat, no observer", alone, steps},
             {"moat, all that a script records", all, steps},
             {"- of this: peaks of all channels", difference(peaks, alone), steps},
             {"- energy ledger, with the accounts of the elements", difference(energy, alone), steps},
             {"- impacts", difference(impacts, energy), steps},
             {"- histories", difference(histories, energy), steps}});
  judge(record, problem, "moat with peaks of all channels / bare Newmark", ratio_of(peaks, bare));
  record.add({"overhead, moat with all that a script records / bare Newmark", ratio_of(all, bare)});
  record.note("Default pulse at 0.4 g. " + counts(problem, statistics, bare_history));
}

void plan_cost(Record& record, const Options& options) {
  record.section("plan");
  Problem problem{"plan", plan_tower(), plan_tower_motion(), bare_plan_end * s};
  BarePlanHistory bare;
  problem.bare = [&] { bare = bare_plan_tower(problem.motion, divisions); };
  const auto times = times_in_turns(problem, {{}, {.peaks = true}}, options.rounds);
  Prepared same{problem, {.peaks = true}};
  same.transient.run();
  const SolverStatistics& statistics = same.transient.statistics();
  const long steps = statistics.accepted_steps;
  put_table(record, problem,
            {{"bare Newmark in plan", times[0], bare.steps},
             {"moat in plan, no observer", times[1], steps},
             {"moat in plan, peaks of all channels", times[2], steps}});
  judge(record, problem, "moat / bare Newmark, per step",
        scaled(ratio_of(times[1], times[0]), static_cast<double>(bare.steps) / static_cast<double>(steps)));
  record.note(
      "Tower of two floors in a moat with friction 0.2 (docs/verification.md). " + counts(problem, statistics, bare) +
      " Largest displacement of the base along x: " + short_text(100.0 * same.peaks.peaks().front().magnitude()) +
      " (bare: " + short_text(100.0 * bare.largest_base_x) + ") cm.");
}

}  // namespace moat::performance
