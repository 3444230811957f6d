#include <deque>
#include <memory>
#include <moat.hpp>

#include "output/energy_ledger.hpp"
#include "output/history_recorder.hpp"
#include "output/impact_recorder.hpp"
#include "output/peak_recorder.hpp"
#include "performance/bare_loops.hpp"
#include "performance/measure.hpp"
#include "performance/moat_five_storeys.hpp"
#include "performance/sections.hpp"

namespace moat::performance {

using namespace units;

namespace {

constexpr int divisions = 2;  // of the interval of 5 ms

/// Average acceleration: the mathematics of the bare loop.
TransientOptions fixed_step(const GroundMotion& motion) {
  return {.integrator = Newmark::average_acceleration(), .step = motion.time_step() / divisions * s};
}

struct With {
  bool peaks = false, energy = false, impacts = false, histories = false;
};

/// A history that is ready to run, with observers that CaseRun attaches.
struct Prepared {
  Prepared(const GroundMotion& motion, With with)
      : model{five_storey_model()},
        transient{model, motion, fixed_step(motion)},
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
Candidate stepping(const GroundMotion& motion, With with, int runs) {
  auto waiting = std::make_shared<std::deque<std::unique_ptr<Prepared>>>();
  for (int i = 0; i < runs; ++i) waiting->push_back(std::make_unique<Prepared>(motion, with));
  auto done = std::make_shared<std::deque<std::unique_ptr<Prepared>>>();
  return {"", [waiting, done] {
            waiting->front()->transient.run();
            done->push_back(std::move(waiting->front()));
            waiting->pop_front();
          }};
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

}  // namespace

void overhead(Record& record, const Options& options) {
  record.section("overhead");
  const GroundMotion motion = near_fault_pulse().scaled_to_pga(0.4 * g);
  const int runs = options.rounds + 1;
  const auto times =
      interleaved_times({{"", [&] { static_cast<void>(bare_newmark(motion, divisions)); }},
                         stepping(motion, {}, runs),
                         stepping(motion, {.peaks = true}, runs),
                         stepping(motion, {.energy = true}, runs),
                         stepping(motion, {.energy = true, .impacts = true}, runs),
                         stepping(motion, {.energy = true, .histories = true}, runs),
                         stepping(motion, {.peaks = true, .energy = true, .impacts = true, .histories = true}, runs)},
                        options.rounds);
  const auto &bare = times[0], &alone = times[1], &peaks = times[2], &energy = times[3], &impacts = times[4],
             &histories = times[5], &all = times[6];

  const BareHistory counted = bare_newmark(motion, divisions);
  Prepared same{motion, {}};
  same.transient.run();
  const SolverStatistics& statistics = same.transient.statistics();
  Table table{{"Per step", "Time [ns]"}};
  const auto add = [&](const std::string& name, const std::vector<double>& seconds) {
    const Spread per_step = scaled(spread_of(seconds), 1e9 / static_cast<double>(statistics.accepted_steps));
    table.put(name, "Time [ns]", cell(record.add({"overhead, " + name, per_step, "ns"})));
  };
  add("bare Newmark, peaks of five numbers", bare);
  add("moat, no observer", alone);
  add("moat, all that a script records", all);
  add("- of this: peaks of all channels", difference(peaks, alone));
  add("- energy ledger, with the accounts of the elements", difference(energy, alone));
  add("- impacts", difference(impacts, energy));
  add("- histories", difference(histories, energy));
  record.table(table);

  const Target bound{3.0};
  const Figure& ratio =
      record.add({"overhead, moat with peaks of all channels / bare Newmark", ratio_of(peaks, bare), "", bound});
  record.note("moat with peaks of all channels / bare Newmark: " + cell(ratio) + ", target " + text(bound) + ".");
  record.add({"overhead, moat with all that a script records / bare Newmark", ratio_of(all, bare)});
  record.note("Default pulse at 0.4 g, fixed step of " + short_text(1e3 * motion.time_step() / divisions) +
              " ms, without setting up. Both take " + std::to_string(statistics.accepted_steps) + " (bare: " +
              std::to_string(counted.steps) + ") steps with " + std::to_string(statistics.newton_iterations) +
              " (bare: " + std::to_string(counted.iterations) + ") iterations.");
}

}  // namespace moat::performance
