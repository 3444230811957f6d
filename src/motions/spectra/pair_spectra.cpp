#include "motions/spectra/pair_spectra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/check.hpp"
#include "base/hermite.hpp"
#include "base/plan_vector.hpp"
#include "motions/motion_measures.hpp"
#include "motions/oscillators.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {
namespace {

constexpr std::size_t degrees_of_half_turn = 180;
using Directions = std::array<double, degrees_of_half_turn>;  // a value for each

PlanVector direction(double degrees) {
  const double angle = degrees * std::numbers::pi / degrees_of_half_turn;
  return {std::cos(angle), std::sin(angle)};
}

/// A piece of a path: the cubic with these control points, from the first to the last one.
struct PathStep {
  std::array<PlanVector, 4> points;
};

/// The pseudo-accelerations of an oscillator under both components, and its free vibration over one period after their
/// end.
std::vector<PathStep> path_of(const GroundMotion& motion, double period, double damping_ratio) {
  using Pair = Eigen::Array2d;
  const double substeps = oscillator_steps(period, motion.time_step());
  const Oscillators<Pair> both{Pair::Constant(period), damping_ratio};
  const OscillatorStep<Pair> step{both, motion.time_step() / substeps};
  std::vector<PathStep> path;
  OscillatorState<Pair> now;
  const auto advance = [&](const Pair& ground_0, const Pair& ground_1) {
    const OscillatorState<Pair> start = now;
    const Pair rate = (ground_0 - ground_1) / step.length, forced = both.forced(ground_0, rate);
    now = step.after({start.value - forced, start.rate - rate}, forced, rate);
    const Pair second = start.value + step.length / 3.0 * start.rate, third = now.value - step.length / 3.0 * now.rate;
    path.push_back({{{{start.value[0], start.value[1]},
                      {second[0], second[1]},
                      {third[0], third[1]},
                      {now.value[0], now.value[1]}}}});
  };
  for (std::size_t i = 1; i < motion.samples().size(); ++i) {
    const Pair start{motion.samples()[i - 1], motion.samples_y()[i - 1]};
    const Pair rise = Pair{motion.samples()[i], motion.samples_y()[i]} - start;
    for (double k = 0.0; k < substeps; ++k)
      advance(start + (k / substeps) * rise, start + ((k + 1.0) / substeps) * rise);
  }
  for (double time = 0.0; time < period; time += step.length) advance(Pair::Zero(), Pair::Zero());
  return path;
}

/// A polygon inside the convex hull of a path and its mirror image through the origin. Its corners are the points of
/// the path that are farthest in equally spaced directions.
class Polygon {
 public:
  Polygon(const std::vector<PathStep>& path, std::size_t directions) {
    std::vector<PlanVector> corners;
    for (std::size_t k = 0; k < directions; ++k) {
      const PlanVector normal =
          direction(static_cast<double>(degrees_of_half_turn * k) / static_cast<double>(directions));
      PlanVector farthest;
      double largest = 0.0;
      for (const PathStep& step : path) {
        const double along = dot(normal, step.points.back());
        if (std::abs(along) <= largest) continue;
        largest = std::abs(along);
        farthest = along < 0.0 ? -step.points.back() : step.points.back();
      }
      if (corners.empty() || corners.back() != farthest) corners.push_back(farthest);
      longest_ = std::max(longest_, length(farthest));
    }
    if (corners.back() != -corners.front()) corners.push_back(-corners.front());
    for (std::size_t k = 1; k < corners.size(); ++k) {
      const PlanVector edge = corners[k] - corners[k - 1];
      edges_.push_back({edge, cross(corners[k], edge)});
      area_ += edges_.back().area;
    }
  }

  /// Whether all of a step lies inside: a cubic lies in the hull of its control points.
  [[nodiscard]] bool holds(const PathStep& step) const {
    return std::ranges::all_of(step.points, [&](PlanVector point) { return holds(point); });
  }

 private:
  struct Edge {
    PlanVector along;
    double area;  // of the parallelogram with a corner
  };

  [[nodiscard]] bool holds(PlanVector point) const {
    // The area of a path along one line is round-off.
    constexpr double flat = 1e-9;
    if (area_ <= flat * longest_ * longest_) return length(point) < longest_;
    return std::ranges::all_of(
        edges_, [&](const Edge& edge) { return std::abs(cross(point, edge.along)) < (1.0 - flat) * edge.area; });
  }

  std::vector<Edge> edges_;
  double area_ = 0.0, longest_ = 0.0;
};

/// The largest distance of a path from the origin in every direction.
Directions largest_of(std::vector<PathStep> path) {
  // Steps inside such a polygon are largest in no direction. The first removes most of them, the second one of more
  // corners most of the others.
  for (const std::size_t directions : {6U, 90U}) {
    const Polygon polygon{path, directions};
    std::erase_if(path, [&](const PathStep& step) { return polygon.holds(step); });
  }
  Directions largest{};
  for (std::size_t degree = 0; degree < degrees_of_half_turn; ++degree) {
    const PlanVector normal = direction(static_cast<double>(degree));
    for (const auto& [points] : path) {
      const double value_0 = dot(normal, points[0]), value_1 = dot(normal, points[3]);
      const double rate_0 = 3.0 * (dot(normal, points[1]) - value_0), rate_1 = 3.0 * (value_1 - dot(normal, points[2]));
      largest[degree] = std::max({largest[degree], std::abs(value_0), std::abs(value_1)});
      // Steps are short against the period: without a change of sign of the rate there is no extremum inside.
      if (rate_0 * rate_1 >= 0.0) continue;
      const HermiteCubic cubic{value_0, rate_0, value_1, rate_1, 1.0};
      largest[degree] = std::max(largest[degree], std::abs(cubic.value(cubic.turn())));
    }
  }
  return largest;
}

// A rigid oscillator feels the ground itself, which is linear between samples.
std::vector<PathStep> ground_of(const GroundMotion& motion) {
  std::vector<PathStep> path;
  for (std::size_t i = 0; i < motion.samples().size(); ++i) {
    const PlanVector at{motion.samples()[i], motion.samples_y()[i]};
    path.push_back({{at, at, at, at}});
  }
  return path;
}

}  // namespace

std::string name_of(PairSpectrum spectrum) {
  constexpr const char* names[]{"first component", "second component", "SRSS",    "SRSS/1.3",
                                "geometric mean",  "RotD50",           "RotD100", "each component"};
  return names[static_cast<std::size_t>(spectrum)];
}

std::vector<double> PairSpectra::of(PairSpectrum spectrum) const {
  const std::vector<double>* all[]{&first, &second, &srss, &srss, &geometric_mean, &rotd50, &rotd100, &first};
  std::vector<double> values = *all[static_cast<std::size_t>(spectrum)];
  if (spectrum == PairSpectrum::srss_over_1_3)
    for (double& value : values) value /= 1.3;
  if (spectrum == PairSpectrum::each_component) values.insert(values.end(), second.begin(), second.end());
  return values;
}

PairSpectra pair_spectra(const PlanMotion& motion, std::span<const Time> periods, double damping_ratio) {
  PlanMotion horizontal = motion;
  horizontal.vertical.reset();
  horizontal.vertical_factor.reset();
  const GroundMotion pair = horizontal.resolved();
  check_oscillators(Check{"pair_spectra", pair.name()}, periods, damping_ratio, pair.time_step());
  PairSpectra spectra;
  spectra.damping_ratio = damping_ratio;
  for (const Time each : periods) {
    const double period = each.si();
    Directions values = largest_of(period == 0.0 ? ground_of(pair) : path_of(pair, period, damping_ratio));
    const double first = values[0], second = values[degrees_of_half_turn / 2];
    std::ranges::sort(values);
    spectra.period.push_back(period);
    spectra.first.push_back(first);
    spectra.second.push_back(second);
    spectra.srss.push_back(std::hypot(first, second));
    spectra.geometric_mean.push_back(std::sqrt(first * second));
    spectra.rotd50.push_back(0.5 * (values[degrees_of_half_turn / 2 - 1] + values[degrees_of_half_turn / 2]));
    spectra.rotd100.push_back(values.back());
  }
  return spectra;
}

std::vector<Time> periods_between(Time shortest, Time longest) {
  const Check check{"periods_between", ""};
  check.positive("shortest", shortest);
  check.that(longest > shortest, "longest", longest.si(), "s", "> " + to_text(shortest.si()) + " s");
  constexpr double largest_ratio = 1.02;
  return spaced_periods(shortest, longest,
                        1 + static_cast<int>(std::ceil(std::log(longest / shortest) / std::log(largest_ratio))));
}

}  // namespace moat
