// One piece of a step of sliders one upon another in plan: the displacements at which all carry the same force.
#pragma once

#include <array>
#include <cstddef>

#include "materials/plan/planar_series_of_sliders.hpp"

namespace moat {

/// The part of a displacement beyond a stop, m.
PlanVector beyond_stop(PlanVector displacement, double stop);

/// Rates of a series of sliders while its deformation goes on at a rate.
struct PlanarSliderRates {
  std::array<PlanVector, PlanarSeriesOfSliders::most> displacements{};  ///< m/s, of the sliders
  PlanVector force;                                                     ///< N/s, of all of them
};

/// Returns the rates at a state under a weight, N, at a rate of the deformation, m/s. On its circle a slider slides
/// where it would move along its friction.
PlanarSliderRates rates_of(const PlanarSeriesOfSliders& law, const PlanarSeriesOfSliders::State& state, double weight,
                           PlanVector rate);

/// The force of one slider, with its derivatives by its displacement at the start, by the increment, by its friction at
/// the start, and by the weight at both ends.
struct PlanarSliderForce {
  PlanVector value{};                                      ///< N
  PlanVector friction{};                                   ///< N, a part of it
  PlanMatrix by_place{}, by_increment{};                   ///< N/m
  PlanMatrix by_friction_before{};                         ///< N/N
  PlanVector of_slope{}, by_weight_before{}, by_weight{};  ///< N/N; the first is u_i/R_i
};

/// A piece of a step of all sliders: from their states by an increment of the deformation, while the weight changes.
class PlanarSlidersPiece {
 public:
  using Law = PlanarSeriesOfSliders;  ///< The law of the sliders.

  /// rate: of the deformation, m/s. weight_before, weight: at both ends of the piece, > 0 N.
  PlanarSlidersPiece(const Law& law, const Law::State& from, PlanVector rate, double weight_before, double weight);

  /// Finds equal forces by Newton's method, for a hard step from the increments of the return mapping; false where it
  /// does not converge.
  bool solve(PlanVector increment, bool hard = false);

  std::array<PlanVector, Law::most> increments{};   ///< m, of the displacements
  std::array<PlanarSliderForce, Law::most> forces;  ///< at the end
  std::array<PlanMatrix, Law::most> flexibilities;  ///< m/N, of the sliders
  PlanVector force;                                 ///< N, of all of them
  PlanMatrix stiffness;                             ///< N/m, of all of them

 private:
  // How friction follows a step. That of the return mapping has a potential, so that Newton's method converges from
  // far.
  enum class FrictionRule { return_mapping, exact };

  bool iterate(FrictionRule rule);
  void move(const std::array<PlanVector, Law::most>& corrections, double share, FrictionRule rule);
  [[nodiscard]] double imbalance() const;
  void evaluate(FrictionRule rule);
  [[nodiscard]] PlanarSliderForce force_of(std::size_t i, FrictionRule rule) const;

  const Law& law_;
  const Law::State& from_;
  std::array<PlanVector, Law::most> rates_;
  double weight_before_, weight_;
};

}  // namespace moat
