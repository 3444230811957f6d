// Laws of one component and of two, seen alike.
#pragma once

#include <cmath>
#include <concepts>
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

/// Evaluates the law of a contact at zero rate.
template <class Law>
Response respond_at_rest(const Law& law, const typename Law::State& committed, double indentation) {
  typename Law::State after;
  return law.evaluate(committed, indentation, 0.0, after);
}

/// Keeps a response, number by number: to copy the whole would read memory that was just written, and stall.
template <class Law>
void keep(const Response& answer, Response& kept) {
  kept.force = answer.force;
  kept.stiffness = answer.stiffness;
  kept.damping = answer.damping;
  if constexpr (AxialForceLaw<Law>) kept.by_compression = answer.by_compression;
}
/// Keeps a response of two components.
template <class Law, std::derived_from<PlanarResponse> Any>
void keep(const Any& answer, Any& kept) {
  kept = answer;
}

/// The rate of the force of a law, N/s, at the state and response of an instant, from the rates of its rate, m/s^2, and
/// of its compression, N/s.
template <class Law>
VectorOf<Law> rate_of_force([[maybe_unused]] const Law& law, [[maybe_unused]] const typename Law::State& state,
                            const ResponseOf<Law>& answer, [[maybe_unused]] DeformationAndRate<VectorOf<Law>> motion,
                            VectorOf<Law> second_rate, [[maybe_unused]] double compression_rate) {
  if constexpr (PlanarAxialForceLaw<Law>)
    return answer.force_rate + answer.viscosity * second_rate + compression_rate * answer.rate_by_compression;
  else if constexpr (PlanarLaw<Law>)
    return answer.force_rate + answer.viscosity * second_rate;
  else if constexpr (AxialForceLaw<Law> && requires(double x) { law.force_rate(state, x, x, x, x); })
    return law.force_rate(state, motion.deformation, motion.rate, second_rate, compression_rate);
  else if constexpr (!AxialForceLaw<Law> && requires(double x) { law.force_rate(state, x, x, x); })
    return law.force_rate(state, motion.deformation, motion.rate, second_rate);
  else
    return answer.stiffness * motion.rate + answer.damping * second_rate +
           (AxialForceLaw<Law> ? answer.by_compression * compression_rate : 0.0);
}

/// The size of a stiffness, N/m; in plan the root of the sum of squares.
inline double norm(double stiffness) { return std::abs(stiffness); }
/// Returns the root of the sum of squares.
inline double norm(PlanMatrix a) { return std::sqrt(a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy); }

/// A force with one component as it is, of one with two the length, N.
inline double value_or_length(double force) { return force; }
/// Returns the length of a force in plan.
inline double value_or_length(PlanVector force) { return length(force); }

}  // namespace moat
