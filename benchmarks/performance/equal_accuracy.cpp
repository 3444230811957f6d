#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <moat.hpp>
#include <optional>
#include <utility>

#include "measuring/error_curve.hpp"
#include "measuring/measure.hpp"
#include "performance/methods.hpp"
#include "performance/moat_five_storeys.hpp"
#include "performance/octave.hpp"
#include "performance/sections.hpp"

namespace moat::performance {
namespace {

namespace names = method_names;

constexpr double fine = 1e-3, coarse = 1e-2;  // the two errors that are read off
constexpr const char* octave_motion = "GBZ000";

struct Case {
  std::string name;
  GroundMotion motion;
};

std::vector<Case> cases(Record& record, const Options& options) {
  using namespace units;
  std::vector<Case> list{{"pulse", near_fault_pulse().scaled_to_pga(0.4 * g)}};
  if (options.records.empty()) {
    record.note("MOAT_RECORDS is not set: GBZ000, JEN022 and WVC270 are left out, and only the pulse is computed.");
    return list;
  }
  for (const auto& [name, file] :
       {std::pair{"GBZ000", "RSN1161_KOCAELI_GBZ000.AT2"}, std::pair{"JEN022", "RSN982_NORTHR_JEN022.AT2"},
        std::pair{"WVC270", "RSN803_LOMAP_WVC270.AT2"}})
    list.push_back({name, read_motion(options.records / file).scaled_to_pga(0.4 * g)});
  return list;
}

std::string percent(double error) { return short_text(100.0 * error) + " %"; }

// A ladder of settings, each run once.
struct Curve {
  const Ladder* ladder;
  std::vector<CurvePoint> points;
};

// The time is the shortest of a few runs: it decides which settings are worth timing in turns.
Curve tried_out(const Ladder& ladder, const Peaks& reference) {
  constexpr int most_runs = 3;
  constexpr double long_time = 0.03;
  Curve curve{&ladder, {}};
  for (std::size_t i = 0; i < ladder.size(); ++i) {
    CurvePoint point{i, 0.0, 1e9};
    double sum = 0.0;
    for (int run = 0; run < most_runs && sum < long_time; ++run) {
      const double start = seconds();
      const Peaks peaks = ladder[i].run();
      const double taken = seconds() - start;
      point.seconds = std::min(point.seconds, taken);
      sum += taken;
      point.error = largest_error(peaks, reference);
    }
    curve.points.push_back(point);
  }
  return curve;
}

// The two settings between which an error is read off.
struct Choice {
  const Setting *looser, *tighter;
  double looser_seconds, tighter_seconds;  // by the trial
  ReadOff read;

  [[nodiscard]] std::string description() const {
    return read.always_better ? looser->name + ", the cheapest and never as bad as this"
                              : looser->name + " ... " + tighter->name;
  }
};

// One on each ladder that gets so exact; times in turns decide between them.
std::vector<Choice> choices(const std::vector<Curve>& curves, double error) {
  std::vector<Choice> list;
  for (const auto& [ladder, points] : curves)
    if (const auto read = read_off(points, error))
      list.push_back({&(*ladder)[read->looser], &(*ladder)[read->tighter], points[read->looser].seconds,
                      points[read->tighter].seconds, *read});
  return list;
}

using Times = std::vector<double>;  // of all rounds, s

// Settings in turns.
class Timing {
 public:
  void add(const Setting& setting, double seconds_by_trial) {
    if (!index_.try_emplace(&setting, candidates_.size()).second) return;
    // Long enough for the clock and the processor to settle.
    constexpr double worth_timing = 5e-3;
    const int count = std::clamp(static_cast<int>(worth_timing / seconds_by_trial), 1, 20);
    repetitions_.push_back(count);
    candidates_.push_back({setting.name, [&setting, count] {
                             for (int i = 0; i < count; ++i) setting.run();
                           }});
  }
  void run(int rounds) {
    times_ = interleaved_times(candidates_, rounds);
    for (std::size_t i = 0; i < times_.size(); ++i)
      for (double& time : times_[i]) time /= repetitions_[i];
  }
  [[nodiscard]] Times of(const Choice& choice) const {
    const Times &looser = times_[index_.at(choice.looser)], &tighter = times_[index_.at(choice.tighter)];
    Times times;
    for (std::size_t round = 0; round < looser.size(); ++round)
      times.push_back(choice.read.time(looser[round], tighter[round]));
    return times;
  }

 private:
  std::map<const Setting*, std::size_t> index_;
  std::vector<Candidate> candidates_;
  std::vector<int> repetitions_;
  std::vector<Times> times_;
};

class Report {
 public:
  Report(Record& record, const Options& options)
      : record_{&record}, options_{&options}, cases_{cases(record, options)} {
    for (auto* header : {&times_header_, &targets_header_})
      for (const Case& each : cases_) header->push_back(each.name);
    times_.emplace(times_header_);
    targets_.emplace(targets_header_);
  }

  void run() {
    for (const Case& each : cases_) run(each);
    record_->table(*times_);
    record_->table(*targets_);
  }

 private:
  void run(const Case& each) {
    column_ = each.name;
    const References found = references(each.motion);
    constexpr double six_digits = 1e-6;
    judge("difference of the reference from one with a tolerance ten times looser",
          single(largest_error(found.moat_less_tight, found.moat)), Target{six_digits});
    judge("difference of the reference from the bare equations", single(largest_error(found.bare, found.moat)),
          Target{six_digits});
    const std::vector<Method> all = methods(each.motion, options_->quick);
    std::map<std::string, std::vector<Curve>> curves;
    Timing timing;
    for (const Method& method : all) {
      for (const Ladder& ladder : method.ladders) curves[method.name].push_back(tried_out(ladder, found.moat));
      for (const double error : {fine, coarse})
        for (const Choice& choice : choices(curves[method.name], error)) {
          timing.add(*choice.looser, choice.looser_seconds);
          timing.add(*choice.tighter, choice.tighter_seconds);
        }
    }
    // A history takes a millisecond: rounds are cheap, and more of them steady the median.
    timing.run(2 * options_->rounds + 1);
    std::map<std::string, Times> at_fine;
    for (const double error : {coarse, fine})
      for (const Method& method : all) {
        const Times times = cost(method.name, choices(curves[method.name], error), timing, error);
        if (error == fine && !times.empty()) at_fine[method.name] = times;
      }
    compare(at_fine);
    show_steps(each);
    if (each.name == octave_motion) compare_octave(each, found.moat, at_fine);
  }

  // Rows of histories are ends of steps.
  void show_steps(const Case& each) {
    const Model model = five_storey_model();
    for (const auto& [recorded, words] :
         {std::pair{Recorded::five_peaks, "five peaks"}, std::pair{Recorded::everything, "everything recorded"}}) {
      const std::string name = std::string{"steps of moat exact between events, default options, "} + words;
      const auto steps =
          static_cast<double>(moat_steps(model, each.motion, {.integrator = ExactBetweenEvents{}}, recorded));
      targets_->put(name, column_, cell(add(name, single(steps), "")));
    }
  }

  const Figure& add(const std::string& name, const Spread& value, const std::string& unit,
                    std::optional<Target> target = {}, const std::string& detail = {}) {
    return record_->add({"equal accuracy, " + column_ + ", " + name, value, unit, target, detail});
  }
  void judge(const std::string& name, const Spread& value, Target target, const std::string& unit = {},
             const std::string& detail = {}) {
    const Figure& figure = add(name, value, unit, target, detail);
    targets_->put(name + (unit.empty() ? "" : " [" + unit + "]") + ": " + text(target), column_, cell(figure));
  }

  // The cheapest of the choices; nothing where there is none.
  Times cost(const std::string& name, const std::vector<Choice>& list, const Timing& timing, double error) {
    const Choice* best = nullptr;
    Times times;
    for (const Choice& each : list) {
      const Times of_each = timing.of(each);
      if (best != nullptr && spread_of(of_each).median >= spread_of(times).median) continue;
      best = &each;
      times = of_each;
    }
    if (best == nullptr) {
      record_->note(column_ + ", " + name + ": no setting is as exact as " + percent(error) + ".");
      return {};
    }
    const Spread in_ms = scaled(spread_of(times), 1e3);
    const Figure& figure = add(name + " at " + percent(error), in_ms, "ms", {}, best->description());
    if (error == fine) times_->put(name, column_, cell(figure));
    return times;
  }

  void compare(const std::map<std::string, Times>& times) {
    const auto at_most_ms = [&](const char* name, double bound) {
      if (times.contains(name)) judge(std::string{name}, scaled(spread_of(times.at(name)), 1e3), Target{bound}, "ms");
    };
    const auto ratio = [&](const char* above, const char* below, std::optional<Target> target = {}) {
      if (!times.contains(above) || !times.contains(below)) return;
      const std::string name = std::string{above} + " / " + below;
      const Spread value = ratio_of(times.at(above), times.at(below));
      if (target)
        judge(name, value, *target);
      else
        add(name, value, "");
    };
    at_most_ms(names::moat_recorded, 15.0);
    at_most_ms(names::moat_exact_recorded, 3.0);
    ratio(names::moat_exact, names::bare_runge_kutta, Target{1.5});
    const char* best = nullptr;
    for (const char* name : {names::cvode_bdf, names::cvode_adams, names::arkode})
      if (times.contains(name) &&
          (best == nullptr || spread_of(times.at(name)).median < spread_of(times.at(best)).median))
        best = name;
    if (best != nullptr && times.contains(names::moat_adaptive))
      judge("best of CVODE and ARKODE / moat adaptive", ratio_of(times.at(best), times.at(names::moat_adaptive)),
            Target{5.0, false}, "", best);
    ratio(names::cvode_on_model, names::moat_adaptive);
    ratio(names::arkode_on_model, names::moat_adaptive);
  }

  void compare_octave(const Case& each, const Peaks& reference, const std::map<std::string, Times>& times) {
    const std::optional<OctaveRun> run = octave_run(each.motion, options_->folder);
    if (!run) return record_->note("GNU Octave (octave-cli) is not installed: its ode45 is left out.");
    const std::string detail = "ode45, timed once, error " + percent(largest_error(run->peaks, reference));
    times_->put("GNU Octave, " + detail, column_, short_text(1e3 * run->seconds));
    add("GNU Octave", single(1e3 * run->seconds), "ms", {}, detail);
    if (!times.contains(names::moat_adaptive)) return;
    const Times& adaptive = times.at(names::moat_adaptive);
    judge("GNU Octave / moat adaptive", ratio_of(Times(adaptive.size(), run->seconds), adaptive), Target{300.0, false});
  }

  Record* record_;
  const Options* options_;
  std::vector<Case> cases_;
  std::vector<std::string> times_header_{"CPU time in ms for an error of 0.1 %"};
  std::vector<std::string> targets_header_{"At 0.1 %"};
  std::optional<Table> times_, targets_;
  std::string column_;
};

}  // namespace

void equal_accuracy(Record& record, const Options& options) {
  record.section("equal-accuracy");
  Report{record, options}.run();
}

}  // namespace moat::performance
