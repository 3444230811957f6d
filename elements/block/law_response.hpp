// Laws of one component and of two, seen alike.
#pragma once

#include <type_traits>

#include "materials/plan/planar_response.hpp"
#include "materials/response.hpp"

namespace moat {

/// The type of deformations and forces of a law.
template <class Law>
using VectorOf = std::conditional_t<PlanarLaw<Law>, PlanVector, double>;

/// The type of its response.
template <class Law>
using ResponseOf = std::conditional_t<PlanarAxialForceLaw<Law>, PlanarAxialResponse,
                                      std::conditional_t<PlanarLaw<Law>, PlanarResponse, Response>>;

/// Deformation and rate at one instant.
template <class Vector>
struct DeformationAndRate {
  Vector deformation{}, rate{};  ///< m, m/s
};

/// Evaluates a law `length` s after its committed state, at which it had the motion `start`, under an axial force.
template <class Law>
ResponseOf<Law> respond_over(const Law& law, const typename Law::State& committed,
                             DeformationAndRate<VectorOf<Law>> now, DeformationAndRate<VectorOf<Law>> start,
                             double length, AxialForce axial, typename Law::State& trial) {
  if constexpr (PlanarAxialForceLaw<Law>)
    return law.evaluate(committed, now.deformation, now.rate, length, axial, trial);
  else if constexpr (PlanarLaw<Law>)
    return law.evaluate(committed, now.deformation, now.rate, length, trial);
  else
    return respond(law, committed, now.deformation, now.rate, {length, start.deformation, start.rate}, trial, axial);
}

}  // namespace moat
