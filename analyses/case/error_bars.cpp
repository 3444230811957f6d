#include "analyses/case/error_bars.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string_view>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "output/files/engineering_unit.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "output/recorders/clearance_recorder.hpp"
#include "output/recorders/impact_recorder.hpp"

namespace moat {
namespace {

// Constants of the bars. They were chosen on the random models of ./moat bench accuracy, whose tables in
// docs/verification show how many true errors lie within the bars and how wide these are.

/// Richardson's estimate is multiplied by it, because not all errors shrink to a quarter.
constexpr double caution = 4.0;
/// Replaces `caution` where the impacts differ: the difference of the runs is then the distance of two motions and does
/// not show the convergence of an error. Random models hardly have the case; EstimateErrors tests guard it.
constexpr double caution_of_two_motions = 8.0;
constexpr double richardson = 4.0 / 3.0;
/// The relative difference of a peak counts as at least this share of the median of the peaks of its unit, and of all
/// peaks, because two runs may agree by chance (EstimateErrors.DoesNotTrustAgreementByAccident).
constexpr double share_of_typical = 0.5;
/// An error is at least this share of the tolerance where changes of stiffness are not located, because both
/// runs may step over one.
constexpr double share_of_tolerance = 0.25;
/// Round-off, force tolerance and location leave an error of this share of the peak.
constexpr double round_off = 1e-8;

/// A settled peak is known to this share of its value; engineers ask for no more.
constexpr double settled_within = 0.01;
/// A peak below this share of the largest of its unit is round-off, for example at a node that symmetry keeps at rest.
/// It is judged relative to this share of the largest, and no other peak is judged by it. EstimateErrors.
/// DoesNotCallRoundOffUnsettled guards it from both sides.
constexpr double negligible = 1e-6;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

ScalesOfUnits largest_of_units(const std::vector<Peak>& peaks) {
  ScalesOfUnits largest;
  for (const Peak& peak : peaks) {
    double& known = largest[peak.unit];
    known = std::max(known, peak.magnitude());
  }
  return largest;
}

// The difference of the magnitudes in the two runs, for every peak; NaN where the companion has none. Two runs of one
// model list the same peaks in the same order.
std::vector<double> differences(const std::vector<Peak>& peaks, const std::vector<Peak>& companion) {
  std::vector<double> list(peaks.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < std::min(peaks.size(), companion.size()); ++i)
    if (peaks[i].quantity == companion[i].quantity && peaks[i].where == companion[i].where)
      list[i] = std::abs(peaks[i].magnitude() - companion[i].magnitude());
  return list;
}

void set_errors(std::vector<Peak>& peaks, const std::vector<double>& difference, double factor, double least_share,
                const ScalesOfUnits& largest) {
  std::map<std::string, std::vector<double>> relative_of_unit;
  std::vector<double> relative_of_all;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const double relative = difference[i] / peaks[i].magnitude();
    if (!std::isfinite(relative) || peaks[i].magnitude() < negligible * largest.at(peaks[i].unit)) continue;
    relative_of_unit[peaks[i].unit].push_back(relative);
    relative_of_all.push_back(relative);
  }
  std::map<std::string, double> typical;
  for (const auto& [unit, relative] : relative_of_unit)
    typical[unit] = share_of_typical * std::max(median(relative), median(relative_of_all));
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const double least = typical[peaks[i].unit] * peaks[i].magnitude();
    // std::max returns its first argument where that is not a number.
    const double shown = std::max(difference[i], least);
    const double estimate = std::max(factor * richardson * shown, least_share * peaks[i].magnitude());
    peaks[i].error = estimate + round_off * peaks[i].magnitude();
    if (!std::isfinite(peaks[i].error)) peaks[i].error = std::numeric_limits<double>::quiet_NaN();
    // A force that neither run has is exact.
    if (peaks[i].value == 0.0 && difference[i] == 0.0) peaks[i].error = 0.0;
  }
}

// The largest approach of the two sides of every gap, which is a displacement like others.
std::vector<Peak> approaches_of(const std::vector<GapClearance>& gaps) {
  std::vector<Peak> approaches;
  for (const GapClearance& gap : gaps)
    approaches.push_back({"approach", gap.where, gap.clearance - gap.left, "m", gap.time});
  return approaches;
}

std::map<std::string_view, std::vector<Impact>> by_gap(std::span<const Impact> touches) {
  std::map<std::string_view, std::vector<Impact>> of_gap;
  for (const Impact& touch : touches) of_gap[touch.where].push_back(touch);
  return of_gap;
}

// When the speeds of an impact first differ by more than `settled_within` of the fastest approach, s; infinite if they
// never do. Compared are impacts of gaps that have equally many in both runs, in their order.
double divergence(std::span<const Impact> touches, std::span<const Impact> of_companion) {
  double fastest = 0.0;
  for (const Impact& touch : touches) fastest = std::max(fastest, touch.approach_speed);
  double first = std::numeric_limits<double>::infinity();
  const auto others = by_gap(of_companion);
  for (const auto& [gap, own] : by_gap(touches)) {
    const auto other = others.find(gap);
    if (other == others.end() || other->second.size() != own.size()) continue;
    for (std::size_t i = 0; i < own.size(); ++i)
      if (std::abs(own[i].approach_speed - other->second[i].approach_speed) > settled_within * fastest)
        first = std::min(first, own[i].start);
  }
  return first;
}

// The impacts of a run beside those of its companion.
struct ImpactComparison {
  ImpactComparison(std::span<const Impact> touches, std::span<const Impact> of_companion)
      : count{touches.size()},
        companion_count{of_companion.size()},
        diverges_at{divergence(touches, of_companion)},
        same{count == companion_count && !std::isfinite(diverges_at)} {}

  std::size_t count, companion_count;
  double diverges_at;  // s; infinite: never
  bool same;
};

double factor_of(const ImpactComparison& impacts) { return impacts.same ? caution : caution_of_two_motions; }

double relative_error(const Peak& peak) {
  return peak.magnitude() > 0.0 ? peak.error / peak.magnitude() : std::numeric_limits<double>::infinity();
}

// The worst first. An error that is not known is not settled either.
std::vector<Peak> unsettled_of(const std::vector<Peak>& peaks, const ScalesOfUnits& of_unit) {
  std::vector<Peak> unsettled;
  for (const Peak& peak : peaks) {
    const double scale = std::max(peak.magnitude(), negligible * of_unit.at(peak.unit));
    if (!(peak.error <= settled_within * scale)) unsettled.push_back(peak);
  }
  std::ranges::stable_sort(unsettled, std::ranges::greater{}, [](const Peak& peak) {
    const double relative = relative_error(peak);
    return std::isnan(relative) ? std::numeric_limits<double>::infinity() : relative;
  });
  return unsettled;
}

std::string in_percent(const Peak& peak) {
  const double relative = relative_error(peak);
  if (std::isnan(relative)) return "not known";
  if (relative > 1.0) return "more than 100 %";
  return with_decimals(100.0 * relative, relative < 0.1 ? 1 : 0) + " %";
}

std::string reason_of(const ImpactComparison& impacts, const std::vector<Peak>& unsettled, std::size_t all) {
  constexpr std::size_t most_named = 4;
  std::string text;
  if (impacts.count != impacts.companion_count)
    text = "with finer steps it has " + std::to_string(impacts.companion_count) +
           (impacts.companion_count == 1 ? " impact instead of " : " impacts instead of ") +
           std::to_string(impacts.count);
  if (std::isfinite(impacts.diverges_at))
    text += (text.empty() ? "" : "; ") + std::string{"from t = "} + with_decimals(impacts.diverges_at, 2) +
            " s on, impacts with finer steps have other speeds, by more than 1 % of the fastest, so that bars of later "
            "peaks may be too small";
  else if (!text.empty() && unsettled.empty())
    text += "; all peaks are known to 1 % nevertheless";
  if (!text.empty() && !unsettled.empty()) text += "; ";
  if (unsettled.empty()) return text;
  text += std::to_string(unsettled.size()) + " of " + std::to_string(all) + " peaks " +
          (unsettled.size() == 1 ? "is" : "are") + " not settled, with an error above 1 %: ";
  for (std::size_t i = 0; i < std::min(most_named, unsettled.size()); ++i)
    text += (i == 0 ? "" : ", ") + in_words(unsettled[i].quantity) + " of \"" + unsettled[i].where + "\" (" +
            in_percent(unsettled[i]) + ")";
  if (unsettled.size() > most_named) text += " and " + std::to_string(unsettled.size() - most_named) + " more";
  return text;
}

}  // namespace

TransientOptions companion_options(const TransientOptions& options, double longest_step) {
  TransientOptions companion = options;
  companion.step = 0.5 * options.step;
  companion.tolerance = std::max(options.tolerance / 16.0, TransientOptions::least_tolerance);
  companion.steps_per_contact = 2 * options.steps_per_contact;
  companion.largest_step = 0.5 * longest_step * units::s;
  return companion;
}

std::string companion_description(const TransientOptions& companion) {
  if (companion.step.si() > 0.0) return "The same case with a fixed step of " + to_text(companion.step.si()) + " s.";
  return "The same case with a tolerance of " + to_text(companion.tolerance) + ", " +
         std::to_string(companion.steps_per_contact) + " steps per contact and steps of at most " +
         to_text(companion.largest_step.si()) + " s.";
}

PeaksAndImpacts compute_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                              std::initializer_list<StepObserver*> observers, const std::function<bool()>& stop,
                              RunUnderWay* under_way) {
  Transient transient{model, motion, options};
  PeakRecorder peaks{model};
  ImpactRecorder touches{false};
  ClearanceRecorder clearances{model};
  transient.attach(peaks);
  transient.attach(touches);
  transient.attach(clearances);
  for (StepObserver* observer : observers)
    if (observer != nullptr) transient.attach(*observer);
  RunUnderWay alone;
  if (under_way == nullptr) under_way = &alone;
  const auto end = [](RunUnderWay* run) { run->end(); };
  const std::unique_ptr<RunUnderWay, decltype(end)> until_the_end{under_way, end};
  under_way->begin(transient);
  transient.run(stop);
  if (!transient.finished()) throw Error{"it was stopped."};
  return {peaks.peaks(), touches.impacts(), transient.statistics(), clearances.clearances(), transient.collapsed()};
}

ScalesOfUnits scales_of_run(const std::vector<Peak>& peaks, const Model& model, const GroundMotion& motion,
                            const TransientOptions& options) {
  ScalesOfUnits scales = largest_of_units(peaks);
  double mass = 0.0;
  for (int place = 0; place < model.nodes(); ++place) mass += model.mass(model.node(place));
  const double pga = motion.peak_acceleration().si();
  const auto raise = [&](const char* unit, double scale) { return scales[unit] = std::max(scales[unit], scale); };
  const double length = raise("m", options.location_tolerance.si() / negligible);
  const double force = raise("N", mass * pga);
  const double acceleration = raise("m/s^2", std::max(pga, force / mass));
  const double speed = raise("m/s", std::sqrt(length * acceleration));
  raise("N m", force);  // of an arm of 1 m
  for (const PlacedDiaphragm& diaphragm : model.diaphragms()) {
    raise("rad", length / diaphragm.gyration);
    raise("rad/s", speed / diaphragm.gyration);
    raise("rad/s^2", acceleration / diaphragm.gyration);
    raise("N m", force * diaphragm.gyration);
  }
  for (const char* unit : {"1", "K", "degC"}) raise(unit, 1.0);
  return scales;
}

ErrorBars estimate_errors(std::vector<Peak>& peaks, std::span<const Impact> touches, const PeaksAndImpacts& companion,
                          double least_share, const ScalesOfUnits& scales) {
  const ImpactComparison impacts{touches, companion.touches};
  ScalesOfUnits of_unit = largest_of_units(peaks);
  for (const auto& [unit, scale] : scales) of_unit[unit] = std::max(of_unit[unit], scale);
  set_errors(peaks, differences(peaks, companion.peaks), factor_of(impacts), least_share, of_unit);
  ErrorBars bars;
  bars.checked = true;
  bars.companion_impacts = impacts.companion_count;
  bars.companion_solver = companion.solver;
  bars.unsettled_peaks = unsettled_of(peaks, of_unit);
  bars.unsettled = !impacts.same || !bars.unsettled_peaks.empty();
  bars.reason = reason_of(impacts, bars.unsettled_peaks, peaks.size());
  return bars;
}

void estimate_clearance_errors(PeaksAndImpacts& main, const PeaksAndImpacts& companion, double least_share) {
  std::vector<Peak>& peaks = main.peaks;
  std::vector<Peak> approaches = approaches_of(main.clearances);
  std::vector<double> difference = differences(peaks, companion.peaks);
  std::ranges::copy(differences(approaches, approaches_of(companion.clearances)), std::back_inserter(difference));
  // Behind the peaks, of which large models have too many for a copy, and whose own errors stay.
  const std::size_t count = peaks.size();
  std::vector<double> own;
  for (const Peak& peak : peaks) own.push_back(peak.error);
  peaks.reserve(count + approaches.size());
  std::ranges::move(approaches, std::back_inserter(peaks));
  set_errors(peaks, difference, factor_of({main.touches, companion.touches}), least_share, largest_of_units(peaks));
  for (std::size_t i = 0; i < main.clearances.size(); ++i) main.clearances[i].error = peaks[count + i].error;
  peaks.erase(peaks.begin() + static_cast<std::ptrdiff_t>(count), peaks.end());
  for (std::size_t i = 0; i < count; ++i) peaks[i].error = own[i];
}

double least_share_of_errors(const Model& model, const TransientOptions& options) {
  const bool adapted = options.step.si() <= 0.0 && !is_exact(options.integrator);
  const bool bends = std::ranges::any_of(model.blocks(), [](const auto& block) {
    return block->size() > 0 && !block->kind().has_regimes && !block->kind().linear_between_events;
  });
  return adapted && bends ? share_of_tolerance * options.tolerance : 0.0;
}

bool companion_is_cheap(const Model& model, double solves) {
  constexpr double most_evaluations = 2e5;
  double elements = 0.0;
  for (const auto& block : model.blocks()) elements += static_cast<double>(block->size());
  return solves * elements <= most_evaluations;
}

}  // namespace moat
