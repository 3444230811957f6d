// The interface of force-deformation laws, and their force with its tangents. Brings the types and checks of which laws
// make their parameters.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/stiffness_stage.hpp"
#include "base/text/type_name.hpp"
#include "base/units.hpp"

namespace moat {

/// Force of a law with both exact tangents.
struct Response {
  double force = 0.0;           ///< N
  double stiffness = 0.0;       ///< dF/d(deformation), N/m
  double damping = 0.0;         ///< dF/d(rate), N s/m
  double by_compression = 0.0;  ///< dF/dN, 1; of an AxialForceLaw
};

/// State of a law without history.
struct NoState {
  friend bool operator==(NoState, NoState) = default;
};

/// The time from the committed state to the instant of evaluation, and the motion at its start.
struct Interval {
  double length = 0.0;             ///< s, >= 0; 0: the committed instant again
  double start_deformation = 0.0;  ///< m
  double start_rate = 0.0;         ///< m/s

  [[nodiscard]] double path(double deformation) const { return deformation - start_deformation; }  ///< m
};

/// The force along the axis of an element, across its deformation: the weight on a bearing.
struct AxialForce {
  /// N, N. Negative where the building has lifted off: its opening times the vertical stiffness. A bearing that cannot
  /// pull has then no force.
  double compression = 0.0;
  double rate_at_start = 0.0;  ///< of N at the start of the interval, N/s
};

/// The parts that all laws have.
template <class Law>
concept LawParts = std::is_trivially_copyable_v<typename Law::State> &&
    std::default_initializable<typename Law::State> &&
    requires(const Law& law, const typename Law::State& committed, double x) {
  { law.stored_energy(committed, x) } -> std::same_as<double>;
  { law.dissipation_rate(committed, x, x) } -> std::same_as<double>;
  { law.linear_stiffness(StiffnessStage::initial) } -> std::same_as<double>;
};

/// A law whose state evolves in time: a damper with a brace, a lead core that heats. Its evaluate() gets the interval
/// of the step. For an interval of length 0 it returns the force of the committed state, and that state as trial.
///
///     Response evaluate(State const& committed, double deformation, double rate, Interval interval, State& trial)
///     const
///
/// Its tangents are those of the step, which differ from the rates of its force in time. A law that knows the latter
/// offers force_rate(state, deformation, rate, second_rate), N/s.
template <class Law>
concept TimeDependentLaw = LawParts<Law> && requires(const Law& law, const typename Law::State& committed,
                                                     typename Law::State& trial, Interval interval, double x) {
  { law.evaluate(committed, x, x, interval, trial) } -> std::same_as<Response>;
};

/// A law that stores k d^2/2 with a k that changes, with N or because it softens. It gives the energy that
/// it stores beyond the work of its force: d0 d1/2 (k1 - k0) in a step, exact beside the mean of both forces, and its
/// power, d^2/2 k'.
///
///     double weight_work(State const& from, double deformation, State const& to, double end_deformation) const   J
///     double weight_power(State const&, double deformation, double rate, double compression_rate) const          W
template <class Law, class Vector>
concept GivesWeightWork = requires(const Law& law, const typename Law::State& state, Vector d, double x) {
  { law.weight_work(state, d, state, d) } -> std::same_as<double>;
  { law.weight_power(state, d, d, x) } -> std::same_as<double>;
};

/// A law that depends on the axial force as well: friction under a weight that changes. Its evaluate() gets the
/// interval of the step and the axial force at the instant of evaluation.
///
///     Response evaluate(State const& committed, double deformation, double rate, Interval interval, AxialForce axial,
///                       State& trial) const
///
/// State::compression is N at the instant of a state. stored_energy() and regime_margin() take it from there: they are
/// given the state at the very instant, not the committed one. If it does not give its weight_work() as above, then
/// weight_lever(from, deformation, to, deformation), m, is the work of the axial force on the building per N of its
/// change, d0 d1/(2 R) of a pendulum.
template <class Law>
concept AxialForceLaw = LawParts<Law> &&
    requires(const Law& law, const typename Law::State& committed, typename Law::State& trial, Interval interval,
             AxialForce axial, double x) {
  { law.evaluate(committed, x, x, interval, axial, trial) } -> std::same_as<Response>;
  requires GivesWeightWork<Law, double> || requires {
    { law.weight_lever(committed, x, trial, x) } -> std::same_as<double>;
  };
  trial.compression = x;
};

/// A force-deformation law: a value without base class that does not depend on nodes, time steps or integrators.
/// Deformation in m, rate in m/s, force in N; springs count tension positive, contacts indentation and compression.
///
///     Response evaluate(State const& committed, double deformation, double rate, State& trial) const
///
/// is pure: the same arguments give the same result, and the committed state is never written. stored_energy() is the
/// recoverable part, J; dissipation_rate() is the power turned into heat, W, >= 0. A rate-independent law may offer
/// dissipated_energy(from, to), the heat between two of its states, J: its rate jumps where it yields, which no
/// quadrature over a step resolves.
template <class Law>
concept ForceLaw = TimeDependentLaw<Law> || AxialForceLaw<Law> ||
    (LawParts<Law>&& requires(const Law& law, const typename Law::State& committed, typename Law::State& trial,
                              double x) {
      { law.evaluate(committed, x, x, trial) } -> std::same_as<Response>;
    });

/// Evaluates a law of any kind.
template <ForceLaw Law>
Response respond(const Law& law, const typename Law::State& committed, double deformation, double rate,
                 [[maybe_unused]] Interval interval, typename Law::State& trial,
                 [[maybe_unused]] AxialForce axial = {}) {
  if constexpr (AxialForceLaw<Law>)
    return law.evaluate(committed, deformation, rate, interval, axial, trial);
  else if constexpr (TimeDependentLaw<Law>)
    return law.evaluate(committed, deformation, rate, interval, trial);
  else
    return law.evaluate(committed, deformation, rate, trial);
}

/// For reports a law may offer its name and its parameters. All laws of moat do; a law of a script without them is
/// listed under the name of its type, without parameters.
///
///     static constexpr std::string_view name = "Friction";
///     std::vector<Parameter> parameters() const { return {{"force", force.si(), "N"}}; }
template <class Law>
std::string_view name_of(const Law& law) {
  if constexpr (requires { law.name(); })
    return law.name();  // of a law that is chosen when the program runs
  else if constexpr (requires { std::string_view{law.name}; })
    return law.name;
  else
    return type_name<Law>();
}
/// Names, values and units of the parameters of a law; none for a law that does not list them.
template <class Law>
std::vector<Parameter> parameters_of(const Law& law) {
  if constexpr (requires { law.parameters(); })
    return law.parameters();
  else
    return {};
}

/// Quantities that a law reports besides its force: a temperature, a friction coefficient. Their rates, per second, are
/// those within the regime of the state.
///
///     static constexpr std::array<ReportedQuantity, 1> quantities{{{"lead_temperature", "K"}}};
///     ReportedValue quantity(std::size_t index, const State& state, double deformation, double rate,
///                            double second_rate) const
template <class Law>
constexpr std::span<const ReportedQuantity> quantities_of(const Law&) {
  if constexpr (requires { Law::quantities; })
    return Law::quantities;
  else
    return {};
}

/// A law that is smooth only between located instants: a contact that touches and separates, a spring that yields.
///
/// regime_margin(), m, is positive while the committed regime lasts and reaches zero where the next one begins; within
/// a regime evaluate() is smooth. It is a length for all laws, because changes are located until it is zero to
/// TransientOptions::location_tolerance. A gap is its own length, a force counts as a deformation of the law's spring,
/// a rate as the distance in a time constant of the law. next_regime() gives the state on the other side. A law under
/// an axial force may take the state of the instant as well, beside the committed state, where its margin does not
/// follow from the state at the instant. It is the compression in the state of that instant (of one, if Repeated):
///
///     double regime_margin(State const& committed, double deformation, double rate, AxialForce axial) const
template <class Law>
concept MarginUnderAxialForce = requires(const Law& law, const typename Law::State& committed, double x,
                                         AxialForce axial) {
  { law.regime_margin(committed, x, x, axial) } -> std::same_as<double>;
};
template <class Law>
concept LawWithRegimes = ForceLaw<Law> && requires(const Law& law, const typename Law::State& committed, double x) {
  requires MarginUnderAxialForce<Law> || requires {
    { law.regime_margin(committed, x, x) } -> std::same_as<double>;
  };
  { law.next_regime(committed, x, x) } -> std::same_as<typename Law::State>;
};

/// A law whose force is linear in deformation and rate within each of its regimes; one without regimes is linear
/// altogether. It declares this with `static constexpr bool linear_within_regimes = true`. A law for which it depends
/// on parameters has `bool is_linear_within_regimes() const` instead.
template <class Law>
concept LinearWithinRegimes = ForceLaw<Law> && Law::linear_within_regimes;

/// A law without history and without regimes that is linear: both tangents are constants.
template <class Law>
concept LawWithConstantTangents =
    LinearWithinRegimes<Law> && !LawWithRegimes<Law> && std::is_empty_v<typename Law::State>;

}  // namespace moat
