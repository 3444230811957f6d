// The results of an analysis, and how two of them differ.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "moat.hpp"

namespace moat::testing {

/// A model, its motion, and the end of its analysis, 0 s: that of the motion.
struct Problem {
  Model model;
  GroundMotion motion;
  Time end{};
};

struct Outcome {
  std::vector<Peak> peaks;
  std::vector<Impact> impacts;
  EnergyBalance energy;
  SolverStatistics solver;
  MotionState end;
};

/// Runs an analysis. A case in which a building rocks, or in which no balance exists because a bearing is far beyond
/// its capacity, has no results, and is drawn again.
inline void run_or_draw_again(Transient& analysis) {
  try {
    analysis.run();
  } catch (const RockingError&) {
    RC_DISCARD("The building rocks.");
  } catch (const ConvergenceError&) {
    const auto is_without_balance = [](const std::string& each) {
      return each.find("no balance") != std::string::npos;
    };
    if (std::ranges::none_of(analysis.warnings(), is_without_balance)) throw;
    RC_DISCARD("There is no balance of forces.");
  }
}

/// Runs an analysis with its recorders, as run_or_draw_again().
inline Outcome outcome_of(const Problem& problem, TransientOptions options = {}) {
  if (options.end.si() == 0.0) options.end = problem.end;
  Transient analysis{problem.model, problem.motion, options};
  EnergyLedger energy;
  PeakRecorder peaks{problem.model};
  ImpactRecorder impacts;
  for (StepObserver* each : std::initializer_list<StepObserver*>{&energy, &peaks, &impacts}) analysis.attach(*each);
  run_or_draw_again(analysis);
  return {peaks.peaks(), impacts.impacts(), energy.at_end(), analysis.statistics(), analysis.state().motion()};
}

/// Gives the peaks of a run of `options` their error bars, as a case does.
inline void add_error_bars(Outcome& outcome, const Problem& problem, const TransientOptions& options = {}) {
  const Outcome finer = outcome_of(problem, companion_options(options, outcome.solver.longest_step));
  estimate_errors(outcome.peaks, outcome.impacts, {finer.peaks, finer.impacts, finer.solver},
                  least_share_of_errors(problem.model, options));
}

/// The peak that differs most.
struct Difference {
  double share = 0.0;
  std::string peak;

  friend bool operator<=(const Difference& difference, double bound) { return difference.share <= bound; }
  friend std::ostream& operator<<(std::ostream& out, const Difference& difference) {
    return out << difference.share << " of " << difference.peak;
  }
};

/// The factor between a peak and that of another run; none: it is not compared.
using PeakRule = std::function<std::optional<double>(const Peak&)>;
inline std::optional<double> same_magnitude(const Peak&) { return 1.0; }

/// Compares the magnitudes of the peaks, times the factors of `rule`, at the places to which `moved` leads. A
/// difference counts as far as it exceeds the error bars of both peaks, where they have them. It is a share of the
/// larger value, but of no less than a thousandth of the largest peak of the quantity, and a millionth of the largest
/// in the unit: results promise nothing about smaller ones.
inline Difference difference_of_peaks(const Outcome& one, const Outcome& other, const PeakRule& rule = same_magnitude,
                                      const std::function<std::string(std::string)>& moved = std::identity{}) {
  std::map<std::string, double> of_quantity, of_unit;
  std::map<std::string, Peak> found;
  for (const Peak& peak : one.peaks)
    for (double* largest : {&of_quantity[peak.quantity], &of_unit[peak.unit]})
      *largest = std::max(*largest, rule(peak).value_or(0.0) * peak.magnitude());
  for (const Peak& peak : other.peaks) found[peak.quantity + " " + peak.where] = peak;
  RC_ASSERT(!one.peaks.empty());
  Difference worst;
  for (const Peak& peak : one.peaks) {
    const std::optional<double> factor = rule(peak);
    if (!factor) continue;
    const Peak& same = found[peak.quantity + " " + moved(peak.where)];
    const double expected = *factor * peak.magnitude(), value = same.magnitude();
    const auto bar = [](double error) { return std::isnan(error) ? 0.0 : error; };
    const double apart = std::abs(value - expected) - *factor * bar(peak.error) - bar(same.error);
    const double scale = std::max({value, expected, 1e-3 * of_quantity[peak.quantity], 1e-6 * of_unit[peak.unit]});
    const double share = scale == 0.0 ? 0.0 : apart / scale;
    if (share > worst.share || std::isnan(share))
      worst = {share, peak.quantity + " " + peak.where + ": " + to_text(expected) + " and " + to_text(value)};
  }
  return worst;
}

/// Bound for two runs of which one has other roundings. Forces balance to TransientOptions::force_tolerance, 1e-8, and
/// impacts, one after the other, enlarge the rest.
inline constexpr double equal_but_for_rounding = 1e-6;

/// Whether two runs of one model took the same steps. Roundings may decide whether a step is halved.
inline bool same_steps(const Outcome& one, const Outcome& other) {
  return one.solver.accepted_steps == other.solver.accepted_steps && one.solver.events == other.solver.events;
}

/// Bound of peaks with the default tolerance, in nine models of ten (docs/verification/random_models.md).
inline constexpr double accurate = 1e-3;

}  // namespace moat::testing
