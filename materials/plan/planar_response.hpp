// The interface of force-deformation laws of two components.
#pragma once

#include <concepts>
#include <type_traits>

#include "base/plan_vector.hpp"
#include "materials/response.hpp"

namespace moat {

/// Force of a law of two components with its tangents, which need not be symmetric.
struct PlanarResponse {
  PlanVector force{};      ///< N
  PlanMatrix stiffness{};  ///< dF/d(deformation) of the whole increment from the committed state, N/m
  PlanMatrix damping{};    ///< dF/d(rate), N s/m: the rate at the end bends the path of the increment
  /// The rate of the force while the deformation goes on at its rate, N/s. Of a law with history it is not stiffness
  /// times rate, except where the increment is short.
  PlanVector force_rate{};
  /// The viscosity of a law whose force follows the speed, N s/m: its part in the rate of the force is this times the
  /// rate of the rate. `damping` is that of the whole step, with the bend of its path.
  PlanMatrix viscosity{};
};

/// The response of a law of two components that takes an axial force N.
struct PlanarAxialResponse : PlanarResponse {
  PlanVector by_compression{};  ///< dF/dN of the step, 1
  /// The part of N' in the rate of the force at the end, 1. Of a law with history it is not by_compression.
  PlanVector rate_by_compression{};
};

/// A law of two components that depends on the axial force as well: an AxialForceLaw on vectors.
///
///     PlanarAxialResponse evaluate(State const& committed, PlanVector deformation, PlanVector rate, double interval,
///                                  AxialForce axial, State& trial) const
template <class Law>
concept PlanarAxialForceLaw = requires(const Law& law, const typename Law::State& committed, typename Law::State& trial,
                                       AxialForce axial, PlanVector d) {
  { law.evaluate(committed, d, d, 0.0, axial, trial) } -> std::same_as<PlanarAxialResponse>;
  requires GivesWeightWork<Law, PlanVector> || requires {
    { law.weight_lever(committed, d, trial, d) } -> std::same_as<double>;
  };
  trial.compression = axial.compression;
};

/// A force-deformation law of two components, x and y: the same functions as of a ForceLaw (materials/response.hpp), on
/// vectors. The state keeps the committed deformation and its rate; evaluate() takes the path from there for the cubic
/// through both ends and their rates, `interval` s long; 0 is the committed instant again, or a straight path. The
/// force depends on the path alone, not on its speed. dissipated_energy(from, to) is the heat between two states, J;
/// linear_stiffness() that of a linear analysis, in all directions alike, N/m.
template <class Law>
concept PlanarLaw = std::is_trivially_copyable_v<typename Law::State> &&
    std::default_initializable<typename Law::State> &&
    requires(const Law& law, const typename Law::State& committed, typename Law::State& trial, PlanVector d) {
  requires PlanarAxialForceLaw<Law> || requires {
    { law.evaluate(committed, d, d, 0.0, trial) } -> std::convertible_to<PlanarResponse>;
  };
  { law.stored_energy(committed, d) } -> std::same_as<double>;
  { law.dissipated_energy(committed, committed) } -> std::same_as<double>;
  { law.linear_stiffness(StiffnessStage::initial) } -> std::same_as<double>;
};

}  // namespace moat
