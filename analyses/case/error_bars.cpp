#include "analyses/case/error_bars.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "output/files/engineering_unit.hpp"

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

// A peak of the main run: its magnitude, and the difference from the companion's, NaN where the companion has none.
struct ComparedPeak {
  std::string_view unit;
  double magnitude, difference;
};

// Two runs of one model list the same peaks in the same order.
std::vector<ComparedPeak> compared(const std::vector<Peak>& peaks, const std::vector<Peak>& companion) {
  std::vector<ComparedPeak> list;
  list.reserve(peaks.size());
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const Peak& peak = peaks[i];
    const bool found =
        i < companion.size() && peak.quantity == companion[i].quantity && peak.where == companion[i].where;
    list.push_back(
        {peak.unit, peak.magnitude(),
         found ? std::abs(peak.magnitude() - companion[i].magnitude()) : std::numeric_limits<double>::quiet_NaN()});
  }
  return list;
}

std::vector<double> errors_of(const std::vector<ComparedPeak>& peaks, double factor, double least_share,
                              const ScalesOfUnits& largest) {
  std::map<std::string_view, std::vector<double>> relative_of_unit;
  std::vector<double> relative_of_all;
  for (const auto& [unit, magnitude, difference] : peaks) {
    const double relative = difference / magnitude;
    if (!std::isfinite(relative) || magnitude < negligible * largest.at(std::string{unit})) continue;
    relative_of_unit[unit].push_back(relative);
    relative_of_all.push_back(relative);
  }
  std::map<std::string_view, double> typical;
  const double typical_of_all = relative_of_all.empty() ? 0.0 : median(relative_of_all);
  for (const auto& [unit, relative] : relative_of_unit)
    typical[unit] = share_of_typical * std::max(median(relative), typical_of_all);
  std::vector<double> errors;
  for (const auto& [unit, magnitude, difference] : peaks) {
    // std::max returns its first argument where that is not a number.
    const double shown = std::max(difference, typical[unit] * magnitude);
    const double estimate = std::max(factor * richardson * shown, least_share * magnitude);
    const double error = estimate + round_off * magnitude;
    // A force that neither run has is exact.
    errors.push_back(magnitude == 0.0 && difference == 0.0 ? 0.0
                     : std::isfinite(error)                ? error
                                                           : std::numeric_limits<double>::quiet_NaN());
  }
  return errors;
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
  const std::vector<double> errors =
      errors_of(compared(peaks, companion.peaks), factor_of(impacts), least_share, of_unit);
  for (std::size_t i = 0; i < peaks.size(); ++i) peaks[i].error = errors[i];
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
  const std::vector<Peak> approaches = approaches_of(main.clearances);
  std::vector<ComparedPeak> all = compared(main.peaks, companion.peaks);
  std::ranges::copy(compared(approaches, approaches_of(companion.clearances)), std::back_inserter(all));
  ScalesOfUnits largest = largest_of_units(main.peaks);
  for (const Peak& each : approaches) largest[each.unit] = std::max(largest[each.unit], each.magnitude());
  const std::vector<double> errors = errors_of(all, factor_of({main.touches, companion.touches}), least_share, largest);
  for (std::size_t i = 0; i < approaches.size(); ++i) main.clearances[i].error = errors[main.peaks.size() + i];
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
