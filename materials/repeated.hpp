// Equal laws side by side, or a share of a law.
#pragma once

#include <span>

#include "materials/response.hpp"

namespace moat {

/// `count` equal laws side by side: the same deformation, `count` times the force, stiffness and energies. States,
/// regimes and reported quantities are those of one of them. A count below 1 is a share: several points of a face
/// divide the law of the face among them.
///
/// The axial force of evaluate(), and its rates, are those on all of them; each carries an equal share of it. The
/// compression in a state, and that of regime_margin(), is the share of one.
template <ForceLaw Law>
struct Repeated {
  Law law;             ///< one of them
  double count = 1.0;  ///< > 0

  using State = typename Law::State;

  /// Returns the name of the law.
  [[nodiscard]] std::string_view name() const { return name_of(law); }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    std::vector<Parameter> list = parameters_of(law);
    list.push_back({"count", count, "1"});
    return list;
  }

  Response evaluate(const State& committed, double deformation, double rate, State& trial) const
      requires(!TimeDependentLaw<Law> && !AxialForceLaw<Law>) {
    return times(law.evaluate(committed, deformation, rate, trial));
  }
  Response evaluate(const State& committed, double deformation, double rate, Interval interval,
                    State& trial) const requires TimeDependentLaw<Law> {
    return times(law.evaluate(committed, deformation, rate, interval, trial));
  }
  Response evaluate(const State& committed, double deformation, double rate, Interval interval, AxialForce axial,
                    State& trial) const requires AxialForceLaw<Law> {
    Response all = times(law.evaluate(committed, deformation, rate, interval,
                                      {axial.compression / count, axial.rate_at_start / count}, trial));
    all.by_compression /= count;
    return all;
  }
  /// Answers as one of them, because each has its share of N.
  double weight_lever(const State& from, double deformation, const State& to, double end_deformation) const
      requires(AxialForceLaw<Law> && !GivesWeightWork<Law, double>) {
    return law.weight_lever(from, deformation, to, end_deformation);
  }
  double weight_work(const State& from, double deformation, const State& to,
                     double end_deformation) const requires GivesWeightWork<Law, double> {
    return count * law.weight_work(from, deformation, to, end_deformation);
  }
  double weight_power(const State& state, double deformation, double rate,
                      double compression_rate) const requires GivesWeightWork<Law, double> {
    return count * law.weight_power(state, deformation, rate, compression_rate / count);
  }
  double force_rate(const State& state, double deformation, double rate, double second_rate) const requires
      requires(const Law& each) {
    each.force_rate(state, deformation, rate, second_rate);
  }
  { return count * law.force_rate(state, deformation, rate, second_rate); }
  double force_rate(const State& state, double deformation, double rate, double second_rate,
                    double compression_rate) const requires requires(const Law& each) {
    each.force_rate(state, deformation, rate, second_rate, compression_rate);
  }
  { return count * law.force_rate(state, deformation, rate, second_rate, compression_rate / count); }

  double stored_energy(const State& committed, double deformation) const {
    return count * law.stored_energy(committed, deformation);
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    return count * law.dissipation_rate(committed, deformation, rate);
  }
  double dissipated_energy(const State& from, const State& to) const requires requires(const Law& each) {
    each.dissipated_energy(from, to);
  }
  { return count * law.dissipated_energy(from, to); }
  double linear_stiffness(StiffnessStage stage) const { return count * law.linear_stiffness(stage); }

  static constexpr bool linear_within_regimes = LinearWithinRegimes<Law>;
  /// Returns the answer of the law.
  [[nodiscard]] bool is_linear_within_regimes() const requires requires(const Law& each) {
    each.is_linear_within_regimes();
  }
  { return law.is_linear_within_regimes(); }

  double regime_margin(const State& committed, double deformation, double rate) const
      requires(LawWithRegimes<Law> && !MarginUnderAxialForce<Law>) {
    return law.regime_margin(committed, deformation, rate);
  }
  double regime_margin(const State& committed, double deformation, double rate,
                       AxialForce axial) const requires MarginUnderAxialForce<Law> {
    return law.regime_margin(committed, deformation, rate, axial);
  }
  State next_regime(const State& committed, double deformation, double rate) const requires LawWithRegimes<Law> {
    return law.next_regime(committed, deformation, rate);
  }
  /// Returns the duration of a contact under the mass that one of them carries, s.
  double contact_duration(double effective_mass, double approach_speed) const requires requires {
    law.contact_duration(effective_mass, approach_speed);
  }
  { return law.contact_duration(effective_mass / count, approach_speed); }
  ReportedValue quantity(std::size_t index, const State& state, double deformation, double rate,
                         double second_rate) const requires requires(const Law& each) {
    each.quantity(index, state, deformation, rate, second_rate);
  }
  { return law.quantity(index, state, deformation, rate, second_rate); }

 private:
  [[nodiscard]] Response times(Response one) const {
    return {count * one.force, count * one.stiffness, count * one.damping, count * one.by_compression};
  }
};

/// Returns the quantities of the law.
template <class Law>
constexpr std::span<const ReportedQuantity> quantities_of(const Repeated<Law>& repeated) {
  return quantities_of(repeated.law);
}

}  // namespace moat
