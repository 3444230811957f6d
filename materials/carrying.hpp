// A law that takes an axial force, under a constant weight.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "materials/response.hpp"

namespace moat {

/// A law on a line or in plan that takes an axial force, with a compression that does not change.
template <class Law>
struct Carrying {
  static constexpr std::string_view name = Law::name;

  Law law;                   ///< Knows the force under a changing weight.
  double compression = 0.0;  ///< > 0 N

  using State = typename Law::State;

  void check(const Check& check) const { law.check(check); }
  [[nodiscard]] std::vector<Parameter> parameters() const { return law.parameters(); }

  /// Vectors are numbers on a line; `time` is an Interval there, and its length in plan.
  template <class Vector, class Time>
  auto evaluate(const State& committed, Vector deformation, Vector rate, Time time, State& trial) const
      -> decltype(law.evaluate(committed, deformation, rate, time, AxialForce{}, trial)) {
    return law.evaluate(committed, deformation, rate, time, AxialForce{compression}, trial);
  }
  /// Returns the recoverable energy, J.
  template <class Vector>
  auto stored_energy(const State& committed, Vector deformation) const
      -> decltype(law.stored_energy(committed, deformation)) {
    return law.stored_energy(committed, deformation);
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const requires AxialForceLaw<Law> {
    return law.dissipation_rate(committed, deformation, rate);
  }
  double dissipated_energy(const State& from, const State& to) const { return law.dissipated_energy(from, to); }
  template <class Vector>
  double weight_work(const State& from, Vector deformation, const State& to,
                     Vector end_deformation) const requires GivesWeightWork<Law, Vector> {
    return law.weight_work(from, deformation, to, end_deformation);
  }
  template <class Vector>
  double weight_power(const State& state, Vector deformation, Vector rate,
                      double compression_rate) const requires GivesWeightWork<Law, Vector> {
    return law.weight_power(state, deformation, rate, compression_rate);
  }
  template <class Vector>
  ReportedValue quantity(std::size_t index, const State& state, Vector deformation, Vector rate,
                         Vector second_rate) const requires requires {
    Law::quantities;
  }
  { return law.quantity(index, state, deformation, rate, second_rate); }
  double linear_stiffness(StiffnessStage stage) const { return law.linear_stiffness(stage); }
  double regime_margin(const State& committed, double deformation, double rate) const requires AxialForceLaw<Law> {
    if constexpr (MarginUnderAxialForce<Law>) {
      return law.regime_margin(committed, deformation, rate, AxialForce{compression});
    } else {
      State there;
      evaluate(committed, deformation, rate, Interval{}, there);
      return law.regime_margin(there, deformation, rate);
    }
  }
  State next_regime(const State& committed, double deformation, double rate) const requires AxialForceLaw<Law> {
    return law.next_regime(committed, deformation, rate);
  }
};

/// Returns the quantities of the law.
template <class Law>
constexpr std::span<const ReportedQuantity> quantities_of(const Carrying<Law>& carrying) {
  return quantities_of(carrying.law);
}

}  // namespace moat
