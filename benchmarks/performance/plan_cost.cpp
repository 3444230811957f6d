#include <deque>
#include <memory>
#include <moat.hpp>

#include "output/peak_recorder.hpp"
#include "performance/measure.hpp"
#include "performance/plan_tower.hpp"
#include "performance/sections.hpp"

namespace moat::performance {

using namespace units;

namespace {

constexpr int divisions = 2;  // of the interval of 5 ms

TransientOptions fixed_step(const GroundMotion& motion) {
  return {.integrator = Newmark::average_acceleration(), .step = motion.time_step() / divisions * s, .end = 12 * s};
}

// A history that is ready to run.
struct Prepared {
  Prepared(const GroundMotion& motion, bool with_peaks)
      : model{plan_tower()}, transient{model, motion, fixed_step(motion)}, peaks{model} {
    if (with_peaks) transient.attach(peaks);
  }

  Model model;
  Transient transient;
  PeakRecorder peaks;
};

// Histories that were set up beforehand, so that only their steps are timed.
Candidate stepping(const GroundMotion& motion, bool with_peaks, int runs) {
  auto waiting = std::make_shared<std::deque<std::unique_ptr<Prepared>>>();
  for (int i = 0; i < runs; ++i) waiting->push_back(std::make_unique<Prepared>(motion, with_peaks));
  auto done = std::make_shared<std::deque<std::unique_ptr<Prepared>>>();
  return {"", [waiting, done] {
            waiting->front()->transient.run();
            done->push_back(std::move(waiting->front()));
            waiting->pop_front();
          }};
}

}  // namespace

void plan_cost(Record& record, const Options& options) {
  record.section("plan");
  const GroundMotion motion = plan_tower_motion();
  const int runs = options.rounds + 1;
  const auto times = interleaved_times({{"", [&] { static_cast<void>(bare_plan_tower(motion, divisions)); }},
                                        stepping(motion, false, runs),
                                        stepping(motion, true, runs)},
                                       options.rounds);
  const BarePlanHistory counted = bare_plan_tower(motion, divisions);
  Prepared same{motion, true};
  same.transient.run();
  const SolverStatistics& statistics = same.transient.statistics();
  Table table{{"Per step", "Time [ns]"}};
  const auto add_row = [&](const std::string& name, const std::vector<double>& seconds, long steps) {
    const Spread per_step = scaled(spread_of(seconds), 1e9 / static_cast<double>(steps));
    table.put(name, "Time [ns]", cell(record.add({"plan, " + name, per_step, "ns"})));
  };
  add_row("bare Newmark in plan", times[0], counted.steps);
  add_row("moat in plan, no observer", times[1], statistics.accepted_steps);
  add_row("moat in plan, peaks of all channels", times[2], statistics.accepted_steps);
  record.table(table);

  const double steps_ratio = static_cast<double>(counted.steps) / static_cast<double>(statistics.accepted_steps);
  const Target bound{3.0};
  const Figure& ratio =
      record.add({"plan, moat / bare Newmark, per step", scaled(ratio_of(times[1], times[0]), steps_ratio), "", bound});
  record.note("moat / bare Newmark, per step: " + cell(ratio) + ", target " + text(bound) + ".");
  record.note("Tower of two floors in a moat with friction 0.2 (docs/verification.md), fixed step of " +
              short_text(1e3 * motion.time_step() / divisions) + " ms, without setting up. moat takes " +
              std::to_string(statistics.accepted_steps) + " (bare: " + std::to_string(counted.steps) + ") steps with " +
              std::to_string(statistics.newton_iterations) + " (bare: " + std::to_string(counted.iterations) +
              ") iterations; the bare loop does not locate touches. Largest displacement of the base along x: " +
              short_text(100.0 * same.peaks.peaks().front().magnitude()) +
              " (bare: " + short_text(100.0 * counted.largest_base_x) + ") cm.");
}

}  // namespace moat::performance
