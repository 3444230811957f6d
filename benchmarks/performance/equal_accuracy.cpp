#include "performance/equal_accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <moat.hpp>
#include <optional>
#include <set>
#include <tuple>

#include "performance/candidates.hpp"
#include "performance/error_curve.hpp"
#include "performance/measure.hpp"
#include "performance/octave.hpp"

namespace moat::performance {
namespace {

constexpr double fine = 1e-3, coarse = 1e-2;  // the two errors that are read off

struct Case {
  std::string name;
  GroundMotion motion;
};

// A ladder of settings, run once.
struct Curve {
  const Ladder* ladder;
  std::vector<CurvePoint> points;

  [[nodiscard]] const CurvePoint& point(std::size_t setting) const { return points[setting]; }
};

struct Curves {
  const Method* method;
  std::vector<Curve> list;
};

struct LadderReadOff {
  std::size_t curve;
  ReadOff read;
  double seconds;  // by the trial
};

// On the ladders where the error costs least by their trial; which of them is best, timing in turns decides.
std::vector<LadderReadOff> cheapest_read_offs(const Curves& curves, double error) {
  constexpr std::size_t worth_timing = 2;
  std::vector<LadderReadOff> list;
  for (std::size_t i = 0; i < curves.list.size(); ++i) {
    const Curve& curve = curves.list[i];
    if (const auto read = read_off(curve.points, error))
      list.push_back({i, *read, read->time(curve.point(read->looser).seconds, curve.point(read->tighter).seconds)});
  }
  std::sort(list.begin(), list.end(),
            [](const LadderReadOff& x, const LadderReadOff& y) { return x.seconds < y.seconds; });
  if (list.size() > worth_timing) list.resize(worth_timing);
  return list;
}

// Times of one read-off in all rounds, s.
using Times = std::vector<double>;

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

// The time is the shortest of a few, to draw the chart and to find the settings worth timing.
CurvePoint try_out(const Setting& setting, std::size_t index, const Peaks& reference) {
  constexpr int most_runs = 3;
  constexpr double long_time = 0.03;
  CurvePoint point{index, 0.0, 1e9};
  double sum = 0.0;
  for (int run = 0; run < most_runs && sum < long_time; ++run) {
    const double start = seconds();
    const Peaks peaks = setting.run();
    const double taken = seconds() - start;
    point.seconds = std::min(point.seconds, taken);
    sum += taken;
    point.error = largest_error(peaks, reference);
  }
  return point;
}

Curves curves_of(const Method& method, const Peaks& reference) {
  Curves curves{&method, {}};
  for (const Ladder& ladder : method.ladders) {
    curves.list.push_back({&ladder, {}});
    for (std::size_t i = 0; i < ladder.size(); ++i)
      curves.list.back().points.push_back(try_out(ladder[i], i, reference));
  }
  return curves;
}

// All settings that the read-offs need, in turns; what they cost at the error.
class Timing {
 public:
  Timing(const std::vector<Curves>& methods, int rounds) {
    std::vector<Candidate> candidates;
    std::vector<double> repetitions;
    for (const Curves& curves : methods) {
      std::set<Key> wanted;
      for (const double error : {fine, coarse})
        for (const LadderReadOff& each : cheapest_read_offs(curves, error))
          wanted.insert({key(curves, each, each.read.looser), key(curves, each, each.read.tighter)});
      for (const Key& each : wanted) {
        const auto& [name, ladder, setting] = each;
        index_[each] = candidates.size();
        // Long enough for the clock and the processor to settle.
        constexpr double worth_timing = 5e-3;
        const double once = curves.list[ladder].point(setting).seconds;
        const int count = std::clamp(static_cast<int>(worth_timing / once), 1, 20);
        repetitions.push_back(count);
        candidates.push_back({name, [run = (*curves.list[ladder].ladder)[setting].run, count] {
                                for (int i = 0; i < count; ++i) run();
                              }});
      }
    }
    times_ = interleaved_times(candidates, rounds);
    for (std::size_t i = 0; i < times_.size(); ++i)
      for (double& time : times_[i]) time /= repetitions[i];
  }

  [[nodiscard]] Times at(const Curves& curves, const LadderReadOff& best) const {
    const Times& looser = times_[index_.at(key(curves, best, best.read.looser))];
    const Times& tighter = times_[index_.at(key(curves, best, best.read.tighter))];
    Times times;
    for (std::size_t round = 0; round < looser.size(); ++round)
      times.push_back(best.read.time(looser[round], tighter[round]));
    return times;
  }

 private:
  using Key = std::tuple<std::string, std::size_t, std::size_t>;  // method, ladder, setting
  static Key key(const Curves& curves, const LadderReadOff& best, std::size_t setting) {
    return {curves.method->name, best.curve, setting};
  }

  std::map<Key, std::size_t> index_;
  std::vector<Times> times_;
};

Spread milliseconds(const Times& times) {
  Spread spread = spread_of(times);
  for (double* value : {&spread.median, &spread.low, &spread.high}) *value *= 1e3;
  return spread;
}

std::string percent(double error) { return to_text(100.0 * error) + " %"; }

std::string describe(const Ladder& ladder, const ReadOff& read) {
  if (read.always_better) return ladder[read.looser].name + ", the cheapest and never as bad as this";
  return ladder[read.looser].name + " ... " + ladder[read.tighter].name;
}

Series series_of(const Curves& curves) {
  // Without a library: dashed. Other integrators on moat's elements: dots.
  const std::string& name = curves.method->name;
  const bool bare = name == method_names::bare_newmark || name == method_names::plain_newmark ||
                    name == method_names::bare_runge_kutta;
  const Series::Style style = bare                                           ? Series::Style::dashed
                              : name.find("on moat's elements") != name.npos ? Series::Style::markers
                                                                             : Series::Style::line;
  Series series{.name = name, .x = {}, .y = {}, .style = style};
  std::vector<CurvePoint> points;
  for (const Curve& curve : curves.list) {
    const auto lasting = with_lasting_errors(curve.points);
    points.insert(points.end(), lasting.begin(), lasting.end());
  }
  for (const CurvePoint& point : lower_envelope(std::move(points))) {
    series.x.push_back(1e3 * point.seconds);
    series.y.push_back(100.0 * point.error);
  }
  return series;
}

const Times* find(const std::map<std::string, Times>& times, const std::string& name) {
  const auto found = times.find(name);
  return found == times.end() ? nullptr : &found->second;
}

class CaseReport {
 public:
  CaseReport(Record& record, const Options& options, const Case& one)
      : record_{&record}, options_{&options}, case_{&one}, prefix_{"equal accuracy, " + one.name + ", "} {}

  void run() {
    const Peaks reference = make_reference();
    const std::vector<Method> all = methods(case_->motion, options_->quick);
    std::vector<Curves> curves;
    for (const Method& method : all) curves.push_back(curves_of(method, reference));
    // A history takes a millisecond: rounds are cheap, and more of them steady the median.
    const Timing timing{curves, 2 * options_->rounds + 1};
    const std::map<std::string, Times> at_fine = costs(curves, timing, fine);
    costs(curves, timing, coarse);
    compare(at_fine);
    std::vector<Series> series;
    for (const Curves& each : curves) series.push_back(series_of(each));
    if (case_->name == (options_->records.empty() ? "pulse" : "GBZ000")) add_octave(reference, at_fine, series);
    record_->chart("equal_accuracy_" + case_->name + ".svg",
                   {{.title = "Five storeys, " + case_->name + ": what a lasting error costs at best",
                     .x_label = "CPU time of the whole history [ms]",
                     .y_label = "largest error of five peaks [%]",
                     .series = series,
                     .logarithmic_x = true,
                     .logarithmic_y = true}},
                   1000, 520);
  }

 private:
  void add(const std::string& name, const Spread& value, const std::string& unit, std::optional<Target> target = {},
           const std::string& detail = {}) {
    record_->add({prefix_ + name, value, unit, target, detail});
  }

  Peaks make_reference() {
    const References found = references(case_->motion);
    constexpr double six_digits = 1e-6;
    add("reference: change of the peaks when the tolerance is ten times looser",
        single(largest_error(found.moat_less_tight, found.moat)), "", Target{six_digits});
    add("reference: difference between moat and the bare equations", single(largest_error(found.bare, found.moat)), "",
        Target{six_digits});
    return found.moat;
  }

  std::map<std::string, Times> costs(const std::vector<Curves>& methods, const Timing& timing, double error) {
    std::map<std::string, Times> result;
    for (const Curves& curves : methods) {
      const std::string& name = curves.method->name;
      std::optional<LadderReadOff> best;
      Times times;
      for (const LadderReadOff& each : cheapest_read_offs(curves, error)) {
        const Times of_each = timing.at(curves, each);
        if (best && spread_of(of_each).median >= spread_of(times).median) continue;
        best = each;
        times = of_each;
      }
      if (!best) {
        record_->note(prefix_ + name + ": no setting is as exact as " + percent(error) + ".");
        continue;
      }
      std::optional<Target> target;
      if (error == fine && name == method_names::moat_adaptive) target = Target{15.0};
      if (error == fine && name == method_names::moat_exact) target = Target{3.0};
      add(name + " at " + percent(error), milliseconds(times), "ms", target,
          describe(*curves.list[best->curve].ladder, best->read));
      result[name] = times;
    }
    return result;
  }

  void compare(const std::map<std::string, Times>& times) {
    const auto ratio = [&](const char* numerator, const char* denominator, std::optional<Target> target = {}) {
      const Times *above = find(times, numerator), *below = find(times, denominator);
      if (above != nullptr && below != nullptr)
        add(std::string{numerator} + " / " + denominator + " at " + percent(fine), ratio_of(*above, *below), "",
            target);
    };
    const char* best = nullptr;
    double least = 0.0;
    for (const char* name : {method_names::cvode_bdf, method_names::cvode_adams, method_names::arkode})
      if (const Times* found = find(times, name); found != nullptr)
        if (const double median = spread_of(*found).median; best == nullptr || median < least) {
          best = name;
          least = median;
        }
    const Times* adaptive = find(times, method_names::moat_adaptive);
    if (best != nullptr && adaptive != nullptr)
      add("best of CVODE and ARKODE, equations written by hand / moat adaptive at " + percent(fine),
          ratio_of(*find(times, best), *adaptive), "", Target{5.0, false}, best);
    ratio(method_names::cvode_bdf, method_names::moat_adaptive);
    ratio(method_names::cvode_on_model, method_names::moat_adaptive);
    ratio(method_names::arkode_on_model, method_names::moat_adaptive);
    ratio(method_names::moat_adaptive, method_names::plain_newmark, Target{3.0});
    ratio(method_names::moat_adaptive, method_names::bare_newmark, Target{3.0});
    ratio(method_names::moat_exact, method_names::bare_runge_kutta, Target{1.5});
  }

  void add_octave(const Peaks& reference, const std::map<std::string, Times>& times, std::vector<Series>& series) {
    if (!octave_is_installed()) {
      record_->note("GNU Octave (octave-cli) is not installed: its ode45 and ode23s are left out.");
      return;
    }
    const std::filesystem::path messages = options_->folder / "octave_messages.txt";
    std::filesystem::remove(messages);
    Ladder ode45;
    Curve curve{&ode45, {}};
    for (const OctaveSetting& setting : octave_settings(options_->quick)) {
      const std::string name = setting.solver + ", tolerance " + to_text(setting.relative_tolerance) +
                               ", steps at most " + to_text(setting.intervals_per_step) + " intervals";
      const std::optional<OctaveRun> run = octave_run(case_->motion, setting, messages);
      if (!run) {
        record_->note("GNU Octave could not compute the building with " + name + "; it says why in " +
                      messages.filename().string() + ", beside the figures.");
        continue;
      }
      const double error = largest_error(run->peaks, reference);
      add("GNU Octave, " + name, single(run->seconds), "s", {}, "error " + percent(error) + ", timed once");
      if (setting.solver != "ode45") continue;
      curve.points.push_back({curve.points.size(), error, run->seconds});
      ode45.push_back({name, {}});
    }
    const auto read = read_off(curve.points, fine);
    const Times* adaptive = find(times, method_names::moat_adaptive);
    if (!read || adaptive == nullptr) {
      record_->note(prefix_ + "GNU Octave: no setting is as exact as " + percent(fine) + ".");
      return;
    }
    const Method method{"GNU Octave ode45", {}};
    series.push_back(series_of({&method, {curve}}));
    series.back().style = Series::Style::markers;
    const double cost = read->time(curve.point(read->looser).seconds, curve.point(read->tighter).seconds);
    add("GNU Octave / moat adaptive at " + percent(fine), ratio_of(Times(adaptive->size(), cost), *adaptive), "",
        Target{300.0, false}, "Octave timed once, by its own clock: " + describe(ode45, *read));
  }

  // Octave locates events on straight lines; a tighter tolerance keeps them in place. From loose to tight, as a ladder.
  static std::vector<OctaveSetting> octave_settings(bool quick) {
    if (quick) return {{"ode45", 1e-5, 20.0}, {"ode45", 1e-6, 20.0}};
    return {{"ode45", 1e-4, 20.0}, {"ode45", 1e-5, 20.0}, {"ode45", 1e-6, 20.0}, {"ode23s", 1e-2, 4.0}};
  }

  Record* record_;
  const Options* options_;
  const Case* case_;
  std::string prefix_;
};

}  // namespace

void equal_accuracy(Record& record, const Options& options) {
  record.section("equal-accuracy", "Equal accuracy: one building of five storeys");
  for (const Case& one : cases(record, options)) CaseReport{record, options, one}.run();
  record.note(
      "OpenSees needs about 300 ms for 0.1 % on GBZ000 (measured elsewhere, not in this run): a hundredth of that is "
      "3 ms.");
}

}  // namespace moat::performance
