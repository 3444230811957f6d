#include "materials/plan/planar_sliders_piece.hpp"

#include <algorithm>
#include <cmath>

#include "materials/plan/circular_friction.hpp"

namespace moat {
namespace {

using Law = PlanarSeriesOfSliders;
using Vectors = std::array<PlanVector, Law::most>;
constexpr PlanMatrix one = PlanMatrix::diagonal(1.0);

PlanMatrix inverse(PlanMatrix a) { return 1.0 / (a.xx * a.yy - a.xy * a.yx) * PlanMatrix{a.yy, -a.xy, -a.yx, a.xx}; }
// The derivative of the part of a displacement beyond a stop.
PlanMatrix slope_beyond_stop(PlanVector u, double stop) {
  const double size = length(u);
  if (size <= stop) return {};
  return PlanMatrix::diagonal(1.0 - stop / size) + stop / (size * size * size) * PlanMatrix::product(u, u);
}
PlanMatrix spring_tangent(const Law& law, std::size_t i, PlanVector u, double weight) {
  const SeriesOfSliders::Branch& branch = law.line.branches[i];
  return branch.stiffness / law.static_weight * weight * (one + slope_beyond_stop(u, branch.first_stop)) +
         law.line.stop_stiffness * slope_beyond_stop(u, branch.capacity);
}

// The end of the return mapping.
SaturatingSlip::Step return_mapping(PlanVector z0, PlanVector stretch, double per_reach) {
  const PlanVector tried = z0 + per_reach * stretch;
  const double size = std::max(length(tried), 1.0);
  SaturatingSlip::Step step{};
  step.z = tried / size;
  step.by_increment = per_reach / size * (size > 1.0 ? one + -1.0 * PlanMatrix::product(step.z, step.z) : one);
  return step;
}

}  // namespace

PlanVector beyond_stop(PlanVector displacement, double stop) {
  const double size = length(displacement);
  return size > stop ? (1.0 - stop / size) * displacement : PlanVector{};
}

PlanarSliderRates rates_of(const Law& law, const Law::State& state, double weight, PlanVector rate) {
  PlanarSliderRates rates;
  // On its circle a slider slides where it would move along its friction. First all of them stick.
  for (std::size_t iteration = 0; iteration <= law.line.count + 1; ++iteration) {
    std::array<PlanMatrix, Law::most> flexibilities;
    PlanMatrix flexibility;
    for (std::size_t i = 0; i < law.line.count; ++i) {
      const auto& [u, q] = state.sliders[i];
      const double limit = law.line.branches[i].friction / law.static_weight * weight;
      const PlanMatrix sticking = spring_tangent(law, i, u, weight) + PlanMatrix::diagonal(law.line.elastic_stiffness);
      flexibilities[i] = inverse(sticking);
      constexpr double round_off = 1e-9;
      if (length(q) >= limit * (1.0 - round_off) && dot(q, flexibilities[i] * rates.force) > 0.0)
        flexibilities[i] = inverse(sticking + -law.line.elastic_stiffness / dot(q, q) * PlanMatrix::product(q, q));
      flexibility = flexibility + flexibilities[i];
    }
    const PlanVector before = rates.force;
    rates.force = inverse(flexibility) * rate;
    for (std::size_t i = 0; i < law.line.count; ++i) rates.displacements[i] = flexibilities[i] * rates.force;
    if (rates.force == before) break;
  }
  return rates;
}

PlanarSlidersPiece::PlanarSlidersPiece(const Law& law, const Law::State& from, PlanVector rate, double weight_before,
                                       double weight)
    : law_{law},
      from_{from},
      rates_{rates_of(law, from, weight_before, rate).displacements},
      weight_before_{weight_before},
      weight_{weight} {}

bool PlanarSlidersPiece::solve(PlanVector increment, bool hard) {
  increments = rates_of(law_, from_, weight_before_, increment).displacements;
  if (hard) iterate(FrictionRule::return_mapping);
  return iterate(FrictionRule::exact);
}

bool PlanarSlidersPiece::iterate(FrictionRule rule) {
  constexpr int most_iterations = 40, most_halvings = 10;
  evaluate(rule);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    Vectors corrections;
    bool converges = true;
    for (std::size_t i = 0; i < law_.line.count; ++i) {
      const PlanVector missing = force - forces[i].value, place = from_.sliders[i].displacement + increments[i];
      corrections[i] = flexibilities[i] * missing;
      const double scale = length(force) + law_.line.branches[i].friction / law_.static_weight * weight_;
      constexpr double close = 1e-13, round_off = 1e-15;
      converges =
          converges && (length(missing) <= close * scale || length(corrections[i]) <= round_off * length(place));
    }
    if (converges) return true;
    const double before = imbalance();
    double share = 1.0;
    move(corrections, share, rule);
    for (int i = 0; i < most_halvings && imbalance() > (1.0 - 0.2 * share) * before; ++i) {
      share *= 0.5;
      move(corrections, -share, rule);
    }
  }
  return false;
}

void PlanarSlidersPiece::move(const Vectors& corrections, double share, FrictionRule rule) {
  for (std::size_t i = 0; i < law_.line.count; ++i) increments[i] += share * corrections[i];
  evaluate(rule);
}

double PlanarSlidersPiece::imbalance() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < law_.line.count; ++i) {
    const PlanVector missing = force - forces[i].value;
    sum += dot(missing, missing);
  }
  return sum;
}

// The force is that at which the tangents of all sliders make the displacements add up.
void PlanarSlidersPiece::evaluate(FrictionRule rule) {
  PlanMatrix flexibility;
  PlanVector weighted;
  for (std::size_t i = 0; i < law_.line.count; ++i) {
    forces[i] = force_of(i, rule);
    flexibilities[i] = inverse(forces[i].by_increment);
    flexibility = flexibility + flexibilities[i];
    weighted += flexibilities[i] * forces[i].value;
  }
  stiffness = inverse(flexibility);
  force = stiffness * weighted;
}

PlanarSliderForce PlanarSlidersPiece::force_of(std::size_t i, FrictionRule rule) const {
  const SeriesOfSliders::Branch& branch = law_.line.branches[i];
  const double curvature = branch.stiffness / law_.static_weight, coefficient = branch.friction / law_.static_weight;
  const PlanVector u = from_.sliders[i].displacement + increments[i];
  const double limit = coefficient * weight_, mean = 0.5 * coefficient * (weight_before_ + weight_),
               elastic = law_.line.elastic_stiffness;
  // Where the circle shrinks, the slip that this needs at a displacement that rests counts as an increment: a slider
  // that moves back needs less of it.
  const PlanVector before = from_.sliders[i].friction_force;
  const double size = length(before);
  const bool sheds = size > limit;
  const PlanVector way = sheds ? before / size : PlanVector{},
                   increment = increments[i] + (sheds ? (size - limit) / elastic : 0.0) * way;
  const CircularFriction friction =
      CircularFriction::after(before, limit, mean, elastic, [&](const SaturatingSlip& slip, PlanVector z0) {
        return rule == FrictionRule::exact ? slip.advance(z0, increment, {}, rates_[i], 0.0)
                                           : return_mapping(z0, increment, elastic / limit);
      });
  PlanarSliderForce slider{.friction = friction.force, .by_friction_before = friction.by_force_before};
  if (sheds)
    slider.by_friction_before =
        slider.by_friction_before + 1.0 / elastic * friction.by_increment *
                                        ((1.0 - limit / size) * one + limit / size * PlanMatrix::product(way, way));
  slider.of_slope = curvature * (u + beyond_stop(u, branch.first_stop));
  slider.value =
      weight_ * slider.of_slope + law_.line.stop_stiffness * beyond_stop(u, branch.capacity) + friction.force;
  slider.by_place = spring_tangent(law_, i, u, weight_);
  slider.by_increment = slider.by_place + friction.by_increment;
  slider.by_weight_before = 0.5 * coefficient * friction.by_mean;
  slider.by_weight = slider.of_slope +
                     coefficient * (friction.by_limit + -1.0 / elastic * friction.by_increment * way) +
                     slider.by_weight_before;
  return slider;
}

}  // namespace moat
