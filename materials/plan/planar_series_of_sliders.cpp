#include "materials/plan/planar_series_of_sliders.hpp"

#include <algorithm>
#include <limits>

#include "materials/plan/circular_friction.hpp"

namespace moat {
namespace {

using Law = PlanarSeriesOfSliders;
using Vectors = std::array<PlanVector, Law::most>;
constexpr PlanMatrix one = PlanMatrix::diagonal(1.0);

PlanMatrix inverse(PlanMatrix a) { return 1.0 / (a.xx * a.yy - a.xy * a.yx) * PlanMatrix{a.yy, -a.xy, -a.yx, a.xx}; }
// The part of a displacement beyond a stop, m, and its derivative.
PlanVector beyond(PlanVector u, double stop) {
  const double size = length(u);
  return size > stop ? (1.0 - stop / size) * u : PlanVector{};
}
PlanMatrix slope_beyond(PlanVector u, double stop) {
  const double size = length(u);
  if (size <= stop) return {};
  return PlanMatrix::diagonal(1.0 - stop / size) + stop / (size * size * size) * PlanMatrix::product(u, u);
}
PlanMatrix spring_tangent(const Law& law, std::size_t i, PlanVector u, double weight) {
  const SeriesOfSliders::Branch& branch = law.line.branches[i];
  return branch.stiffness / law.static_weight * weight * (one + slope_beyond(u, branch.first_stop)) +
         law.line.stop_stiffness * slope_beyond(u, branch.capacity);
}

// The rates of all displacements while the deformation goes on at its rate, and that of the force.
struct Rates {
  Vectors displacements{};
  PlanVector force;
};
Rates rates_of(const Law& law, const Law::State& state, double weight, PlanVector rate) {
  Rates rates;
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

// The force of one slider, with its derivatives by its displacement at the start, by the increment, by its friction at
// the start, and by the weight at both ends.
struct SliderForce {
  PlanVector value{}, friction{};
  PlanMatrix by_place{}, by_increment{}, by_friction_before{};
  PlanVector of_slope{}, by_weight_before{}, by_weight{};
};

// How friction follows a step. That of the return mapping has a potential, so that Newton's method converges from far.
enum class FrictionRule { return_mapping, exact };

// The end of the return mapping.
SaturatingSlip::Step return_mapping(PlanVector z0, PlanVector stretch, double per_reach) {
  const PlanVector tried = z0 + per_reach * stretch;
  const double size = std::max(length(tried), 1.0);
  SaturatingSlip::Step step{};
  step.z = tried / size;
  step.by_increment = per_reach / size * (size > 1.0 ? one + -1.0 * PlanMatrix::product(step.z, step.z) : one);
  return step;
}

// A step of all sliders, or a piece of one: from their states by an increment of the deformation, while the weight
// changes.
class Piece {
 public:
  Piece(const Law& law, const Law::State& from, PlanVector rate, double weight_before, double weight)
      : law_{law},
        from_{from},
        rates_{rates_of(law, from, weight_before, rate).displacements},
        weight_before_{weight_before},
        weight_{weight} {}

  // Finds equal forces by Newton's method, for a hard step from the increments of the return mapping; false where it
  // does not converge.
  bool solve(PlanVector increment, bool hard = false) {
    increments = rates_of(law_, from_, weight_before_, increment).displacements;
    if (hard) iterate(FrictionRule::return_mapping);
    return iterate(FrictionRule::exact);
  }

  Vectors increments{};
  std::array<SliderForce, Law::most> forces;
  std::array<PlanMatrix, Law::most> flexibilities;
  PlanVector force;
  PlanMatrix stiffness;

 private:
  bool iterate(FrictionRule rule) {
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
  void move(const Vectors& corrections, double share, FrictionRule rule) {
    for (std::size_t i = 0; i < law_.line.count; ++i) increments[i] += share * corrections[i];
    evaluate(rule);
  }
  [[nodiscard]] double imbalance() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < law_.line.count; ++i) {
      const PlanVector missing = force - forces[i].value;
      sum += dot(missing, missing);
    }
    return sum;
  }
  // The force is that at which the tangents of all sliders make the displacements add up.
  void evaluate(FrictionRule rule) {
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
  [[nodiscard]] SliderForce force_of(std::size_t i, FrictionRule rule) const {
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
    SliderForce slider{.friction = friction.force, .by_friction_before = friction.by_force_before};
    if (sheds)
      slider.by_friction_before =
          slider.by_friction_before + 1.0 / elastic * friction.by_increment *
                                          ((1.0 - limit / size) * one + limit / size * PlanMatrix::product(way, way));
    slider.of_slope = curvature * (u + beyond(u, branch.first_stop));
    slider.value = weight_ * slider.of_slope + law_.line.stop_stiffness * beyond(u, branch.capacity) + friction.force;
    slider.by_place = spring_tangent(law_, i, u, weight_);
    slider.by_increment = slider.by_place + friction.by_increment;
    slider.by_weight_before = 0.5 * coefficient * friction.by_mean;
    slider.by_weight = slider.of_slope +
                       coefficient * (friction.by_limit + -1.0 / elastic * friction.by_increment * way) +
                       slider.by_weight_before;
    return slider;
  }

  const Law& law_;
  const Law::State& from_;
  Vectors rates_;
  double weight_before_, weight_;
};

// The derivatives of a vector by the deformation and by the weight at the end of the step.
struct Derivative {
  PlanMatrix by_deformation{};
  PlanVector by_weight{};

  friend Derivative operator+(Derivative a, Derivative b) {
    return {a.by_deformation + b.by_deformation, a.by_weight + b.by_weight};
  }
  friend Derivative operator*(PlanMatrix factor, Derivative a) {
    return {factor * a.by_deformation, factor * a.by_weight};
  }
};

// Follows a step in equal pieces; false where one of them does not converge. The weight before is that at the end
// where the friction `starts` again.
bool follow(const Law& law, const Law::State& committed, PlanVector increment, PlanVector rate, double weight_before,
            double weight, bool starts, int pieces, Law::State& trial, PlanarAxialResponse& response) {
  trial = committed;
  std::array<Derivative, Law::most> displacements{}, frictions{};
  bool converges = true;
  for (int k = 0; k < pieces; ++k) {
    const double begin = double(k) / pieces, end = double(k + 1) / pieces;
    const auto at = [&](double share) { return weight_before + share * (weight - weight_before); };
    const Law::State from = trial;
    Piece piece{law, from, rate, at(begin), at(end)};
    if (!piece.solve(increment / pieces)) converges = piece.solve(increment / pieces, true) && converges;
    // First the derivatives of all forces at fixed increments, then those of the common force and of the increments.
    std::array<Derivative, Law::most> at_fixed;
    Derivative force{PlanMatrix::diagonal(1.0 / pieces), {}};
    for (std::size_t i = 0; i < law.line.count; ++i) {
      const SliderForce& slider = piece.forces[i];
      at_fixed[i] =
          slider.by_place * displacements[i] + slider.by_friction_before * frictions[i] +
          Derivative{{}, (starts ? 1.0 : begin) * slider.by_weight_before + (starts ? 1.0 : end) * slider.by_weight};
      force = force + piece.flexibilities[i] * at_fixed[i];
    }
    force = piece.stiffness * force;
    for (std::size_t i = 0; i < law.line.count; ++i) {
      const SliderForce& slider = piece.forces[i];
      displacements[i] = displacements[i] + piece.flexibilities[i] * (force + -1.0 * one * at_fixed[i]);
      frictions[i] =
          force + -1.0 * slider.by_place * displacements[i] + Derivative{{}, (starts ? -1.0 : -end) * slider.of_slope};
      trial.sliders[i] = {trial.sliders[i].displacement + piece.increments[i], slider.friction};
    }
    response.force = piece.force;
    response.stiffness = force.by_deformation;
    response.by_compression = force.by_weight;
  }
  response.force_rate = rates_of(law, trial, weight, rate).force;
  return converges;
}

}  // namespace

PlanarAxialResponse PlanarSeriesOfSliders::evaluate(const State& committed, PlanVector deformation, PlanVector rate,
                                                    double, AxialForce axial, State& trial) const {
  const double least = 0.01 * static_weight, compression = std::max(axial.compression, 0.0),
               weight = std::max(compression, least);
  const bool starts = committed.compression <= 0.0;
  const double before = starts ? weight : std::max(committed.compression, least);
  // The friction of the law under W/100, of which a light bearing has a share.
  State from = committed;
  if (!starts && committed.compression < least)
    for (Slider& slider : from.sliders) slider.friction_force = least / committed.compression * slider.friction_force;
  PlanVector increment = deformation;
  for (const Slider& slider : committed.sliders) increment = increment - slider.displacement;
  PlanarAxialResponse response;
  constexpr int most_pieces = 64;
  int pieces = 1;
  while (!follow(*this, from, increment, rate, before, weight, starts, pieces, trial, response)) {
    pieces *= 2;
    if (pieces <= most_pieces) continue;
    // The step is too long: no number is accepted.
    response.force.x = std::numeric_limits<double>::quiet_NaN();
    return response;
  }
  if (compression < least) {
    const double share = compression / least;
    response.by_compression = compression > 0.0 ? response.force / least : PlanVector{};
    response.force = share * response.force;
    response.stiffness = share * response.stiffness;
    response.force_rate = share * response.force_rate;
    for (Slider& slider : trial.sliders) slider.friction_force = share * slider.friction_force;
  }
  response.rate_by_compression = response.by_compression;
  trial.compression = axial.compression;
  trial.heat = committed.heat;
  for (std::size_t i = 0; i < line.count; ++i) {
    const Slider &old = committed.sliders[i], &now = trial.sliders[i];
    const PlanVector slip =
        now.displacement - old.displacement - (now.friction_force - old.friction_force) / line.elastic_stiffness;
    trial.heat += 0.5 * dot(old.friction_force + now.friction_force, slip);
  }
  return response;
}

double PlanarSeriesOfSliders::stored_energy(const State& committed, PlanVector deformation) const {
  double energy = std::max(committed.compression, 0.0) * weight_lever(committed, deformation, committed, deformation);
  for (std::size_t i = 0; i < line.count; ++i) {
    const auto& [u, q] = committed.sliders[i];
    const PlanVector pressed = beyond(u, line.branches[i].capacity);
    energy += 0.5 * dot(q, q) / line.elastic_stiffness + 0.5 * line.stop_stiffness * dot(pressed, pressed);
  }
  return energy;
}

double PlanarSeriesOfSliders::weight_lever(const State& from, PlanVector, const State& to, PlanVector) const {
  double lever = 0.0;
  for (std::size_t i = 0; i < line.count; ++i) {
    const PlanVector u0 = from.sliders[i].displacement, u1 = to.sliders[i].displacement;
    const double stop = line.branches[i].first_stop;
    lever += 0.5 * line.branches[i].stiffness / static_weight * (dot(u0, u1) + dot(beyond(u0, stop), beyond(u1, stop)));
  }
  return lever;
}

}  // namespace moat
