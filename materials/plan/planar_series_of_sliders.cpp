#include "materials/plan/planar_series_of_sliders.hpp"

#include <algorithm>
#include <limits>

#include "materials/plan/planar_sliders_piece.hpp"

namespace moat {
namespace {

using Law = PlanarSeriesOfSliders;

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
  for (int k = 0; k < pieces; ++k) {
    const double begin = double(k) / pieces, end = double(k + 1) / pieces;
    const auto at = [&](double share) { return weight_before + share * (weight - weight_before); };
    const Law::State from = trial;
    PlanarSlidersPiece piece{law, from, rate, at(begin), at(end)};
    if (!piece.solve(increment / pieces) && !piece.solve(increment / pieces, true)) return false;
    // First the derivatives of all forces at fixed increments, then those of the common force and of the increments.
    std::array<Derivative, Law::most> at_fixed;
    Derivative force{PlanMatrix::diagonal(1.0 / pieces), {}};
    for (std::size_t i = 0; i < law.line.count; ++i) {
      const PlanarSliderForce& slider = piece.forces[i];
      at_fixed[i] =
          slider.by_place * displacements[i] + slider.by_friction_before * frictions[i] +
          Derivative{{}, (starts ? 1.0 : begin) * slider.by_weight_before + (starts ? 1.0 : end) * slider.by_weight};
      force = force + piece.flexibilities[i] * at_fixed[i];
    }
    force = piece.stiffness * force;
    for (std::size_t i = 0; i < law.line.count; ++i) {
      const PlanarSliderForce& slider = piece.forces[i];
      displacements[i] = displacements[i] + piece.flexibilities[i] * (force + PlanMatrix::diagonal(-1.0) * at_fixed[i]);
      frictions[i] =
          force + -1.0 * slider.by_place * displacements[i] + Derivative{{}, (starts ? -1.0 : -end) * slider.of_slope};
      trial.sliders[i] = {trial.sliders[i].displacement + piece.increments[i], slider.friction};
    }
    response.force = piece.force;
    response.stiffness = force.by_deformation;
    response.by_compression = force.by_weight;
  }
  response.force_rate = rates_of(law, trial, weight, rate).force;
  return true;
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
    const PlanVector pressed = beyond_stop(u, line.branches[i].capacity);
    energy += 0.5 * dot(q, q) / line.elastic_stiffness + 0.5 * line.stop_stiffness * dot(pressed, pressed);
  }
  return energy;
}

double PlanarSeriesOfSliders::weight_lever(const State& from, PlanVector, const State& to, PlanVector) const {
  double lever = 0.0;
  for (std::size_t i = 0; i < line.count; ++i) {
    const PlanVector u0 = from.sliders[i].displacement, u1 = to.sliders[i].displacement;
    const double stop = line.branches[i].first_stop;
    lever += 0.5 * line.branches[i].stiffness / static_weight *
             (dot(u0, u1) + dot(beyond_stop(u0, stop), beyond_stop(u1, stop)));
  }
  return lever;
}

}  // namespace moat
