// A storey that hardens, weakens beyond its cap, and deteriorates: Ibarra, Medina and Krawinkler.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "materials/response.hpp"

namespace moat {

/// Bilinear hysteresis with a cap and cyclic deterioration, the same in both directions:
///
///     F ^          cap                     U_y = F_y/k_e         yield
///       |       .-'`.   K_pc               U_c = U_y + U_p       cap, F_max = ratio F_y
///       |    .-' K_p `.                    U_c + U_pc            zero, or earlier the residual force
///       |   /          `-------- F_res     U_u                   failure: no force from there on
///     --+--/----------------------> d
///
/// Inside the two bounds the force follows K_u. With E the work so far and E_ref = lambda F_y:
///
///     reversal on a bound:  beta = [(E_p - E_last)/(E_ref - E_p)]^c, E_p = E - F^2/(2 K_u);    K_u times 1 - beta
///     F crosses zero:       beta = [(E - E_last)/(E_ref - E)]^c, E_last = E; on the side that is entered F_y, K_p and
///                           the force of the cap line at d = 0 times 1 - beta, K_pc with (F_y - F_res)
///
/// K_u never falls below K_p. Where the hardening line of a side lies below zero, at large drifts to the other side,
/// the storey has no force. beta > 1 is failure too. All of these are located regimes, so that results do not depend on
/// the steps; a failure is a change of regime whose force drops to zero. Reports `ductility`, |d|/U_y. Stored energy
/// F^2/(2 K_u): where K_u falls, energy that counted as dissipated counts as stored again. Sources: Ibarra, Medina &
/// Krawinkler (2005); Lignos & Krawinkler (2011); rules of IMKBilin of OpenSees.
struct ImkBilinear {
  static constexpr std::string_view name = "ImkBilinear";
  static constexpr std::string_view formula = "hardens, weakens beyond a cap, deteriorates with the energy, fails";
  static constexpr std::string_view assumption = "The same in both directions; a failure lets the force drop to zero.";

  /// k_e > 0 N/m.
  Required<Stiffness> stiffness;
  /// F_y > 0 N.
  Required<Force> yield_force;
  /// U_p, U_pc > 0 m: from yield to the cap, from the cap to zero.
  Required<Length> hardening_drift;
  Required<Length> weakening_drift;  ///< U_pc
  /// U_u > U_y, m: failure.
  Required<Length> ultimate_drift;
  /// F_max/F_y >= 1.
  double cap_ratio = 1.1;
  /// 0 <= F_res/F_y < 1.
  double residual_ratio = 0.0;
  /// lambda > 0 m for strength (with the cap) and for the stiffness of unloading; none if left out.
  Length strength_capacity{};
  Length stiffness_capacity{};  ///< lambda, of the stiffness of unloading
  /// c > 0: exponents of both.
  double strength_exponent = 1.0;
  double stiffness_exponent = 1.0;  ///< c, of the stiffness of unloading

  /// Branches of the backbone, and of the way back to it.
  enum class Branch : int { elastic, slack, hardening, weakening, residual, failed };
  /// One direction of the backbone.
  struct Side {
    double yield = 0.0, hardening = 0.0, cap = 0.0, weakening = 0.0;  ///< F_y, K_p, force of the cap line at 0, K_pc

    friend bool operator==(const Side&, const Side&) = default;
  };
  struct State {
    double deformation = 0.0, force = 0.0;     ///< m, N
    double work = 0.0, work_at_zero = 0.0;     ///< E, E_last, J
    double softened = 1.0;                     ///< K_u/k_e
    std::array<double, 2> weakened{1.0, 1.0};  ///< F_y over that at first, right and left
    std::array<double, 2> lowered{1.0, 1.0};   ///< the cap line over that at first
    Branch branch = Branch::elastic;           ///< That it is on.
    int side = 0;   ///< sign of the force since it last crossed zero; 0 before the first yield
    int bound = 0;  ///< of the bound it follows: +1, -1

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 1> quantities{{{.name = "ductility", .unit = "1"}}};
  static constexpr double time_of_rate = 1.0, threshold = 1e-10;  ///< s, m

  /// A storey with a yield drift of 1 cm that loses its strength at 16 cm.
  static ImkBilinear typical() {
    using namespace units;
    return {.stiffness = 200 * MN / m,
            .yield_force = 2 * MN,
            .hardening_drift = 3 * cm,
            .weakening_drift = 12 * cm,
            .ultimate_drift = 25 * cm,
            .residual_ratio = 0.2,
            .strength_capacity = 0.6 * m,
            .stiffness_capacity = 0.6 * m};
  }

  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check.positive("yield_force", yield_force);
    check.positive("hardening_drift", hardening_drift);
    check.positive("weakening_drift", weakening_drift);
    check.that(ultimate_drift.si() > yield_drift(), "ultimate_drift", ultimate_drift.si(), "m",
               "above the yield drift yield_force / stiffness = " + to_text(yield_drift()) + " m");
    check.between("cap_ratio", cap_ratio, 1.0, 10.0, "1", "1.05 to 1.2 is usual.");
    check.that(residual_ratio >= 0.0 && residual_ratio < 1.0, "residual_ratio", residual_ratio, "1", ">= 0 and < 1");
    check.that((cap_ratio - 1.0) * yield_force.si() / hardening_drift.si() < stiffness.si(), "cap_ratio", cap_ratio,
               "1", "so that the storey hardens with less than its stiffness", "Give a longer hardening_drift.");
    check.not_negative("strength_capacity", strength_capacity);
    check.not_negative("stiffness_capacity", stiffness_capacity);
    check.positive("strength_exponent", strength_exponent, "1");
    check.positive("stiffness_exponent", stiffness_exponent, "1");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness.si(), "N/m"},
            {"yield_force", yield_force.si(), "N"},
            {"hardening_drift", hardening_drift.si(), "m"},
            {"weakening_drift", weakening_drift.si(), "m"},
            {"ultimate_drift", ultimate_drift.si(), "m"},
            {"cap_ratio", cap_ratio, "1"},
            {"residual_ratio", residual_ratio, "1"},
            {"strength_capacity", strength_capacity.si(), "m"},
            {"stiffness_capacity", stiffness_capacity.si(), "m"},
            {"strength_exponent", strength_exponent, "1"},
            {"stiffness_exponent", stiffness_exponent, "1"}};
  }

  Response evaluate(const State& committed, double deformation, double, State& trial) const {
    trial = committed;
    trial.deformation = deformation;
    const Response response = respond_on(committed, deformation);
    trial.force = response.force;
    trial.work += 0.5 * (committed.force + response.force) * (deformation - committed.deformation);
    return response;
  }
  double stored_energy(const State& committed, double) const {
    return 0.5 * committed.force * committed.force / unloading(committed);
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    if (committed.branch == Branch::elastic || committed.branch == Branch::failed) return 0.0;
    return committed.force * rate;
  }
  double dissipated_energy(const State& from, const State& to) const {
    return to.work - stored_energy(to, 0.0) - (from.work - stored_energy(from, 0.0));
  }
  double linear_stiffness(StiffnessStage stage) const {
    return stage == StiffnessStage::initial ? stiffness.si() : first_side().hardening;
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    if (committed.branch == Branch::failed) return std::numeric_limits<double>::infinity();
    const double force = respond_on(committed, deformation).force, soft = unloading(committed);
    double margin = ultimate_drift.si() - std::abs(deformation);
    if (committed.side != 0) margin = std::min(margin, committed.side * force / soft);
    if (committed.branch == Branch::elastic) {
      for (const int side : {1, -1})
        margin = std::min(margin, (bound(committed, side, side * deformation) - side * force) / soft);
    } else {
      margin = std::min(margin, committed.bound * rate * time_of_rate);
      const Side side = side_of(committed, committed.bound);
      const double x = committed.bound * deformation;
      if (committed.branch == Branch::slack) margin = std::min(margin, -hardening_of(side, x) / soft);
      if (committed.branch == Branch::hardening)
        margin = std::min(margin, (fall_of(side, x) - hardening_of(side, x)) / soft);
      if (committed.branch == Branch::weakening)
        margin = std::min(margin, (side.cap - side.weakening * x - residual()) / soft);
    }
    return margin + threshold;
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    State next;
    evaluate(committed, deformation, rate, next);
    const double soft = unloading(committed);
    if (std::abs(deformation) >= ultimate_drift.si()) return failed(next);
    if (committed.side != 0 && committed.side * next.force / soft <= -threshold) return cross_zero(next);
    if (committed.branch != Branch::elastic && committed.bound * rate * time_of_rate <= -threshold) return turn(next);
    // Onto a bound, or from one part of it to the next.
    int side = committed.bound;
    if (committed.branch == Branch::elastic) {
      const auto room = [&](int each) { return bound(next, each, each * deformation) - each * next.force; };
      side = room(1) < room(-1) ? 1 : -1;
    }
    const Side of = side_of(next, side);
    const double x = side * deformation;
    next.bound = side;
    if (next.side == 0) next.side = side;
    const double line = hardening_of(of, x);
    next.branch = committed.branch == Branch::elastic && line < 0.0           ? Branch::slack
                  : line < fall_of(of, x) - threshold * soft                  ? Branch::hardening
                  : of.cap - of.weakening * x > residual() + threshold * soft ? Branch::weakening
                                                                              : Branch::residual;
    if (committed.branch == Branch::hardening && next.branch == Branch::hardening) next.branch = Branch::weakening;
    if (committed.branch == Branch::weakening) next.branch = Branch::residual;
    next.force = respond_on(next, deformation).force;
    return next;
  }
  ReportedValue quantity(std::size_t, const State&, double deformation, double rate, double) const {
    return {deformation / yield_drift(), rate / yield_drift()};
  }

 private:
  [[nodiscard]] double yield_drift() const { return yield_force.si() / stiffness.si(); }
  [[nodiscard]] double residual() const { return residual_ratio * yield_force.si(); }
  [[nodiscard]] double unloading(const State& state) const { return state.softened * stiffness.si(); }
  [[nodiscard]] Side first_side() const {
    const double cap = cap_ratio * yield_force.si(), weakening = cap / weakening_drift.si();
    return {yield_force.si(), (cap - yield_force.si()) / hardening_drift.si(),
            cap + weakening * (yield_drift() + hardening_drift.si()), weakening};
  }
  [[nodiscard]] Side side_of(const State& state, int direction) const {
    Side side = first_side();
    const std::size_t i = direction > 0 ? 0 : 1;
    side.yield *= state.weakened[i];
    side.hardening *= state.weakened[i];
    side.cap *= state.lowered[i];
    side.weakening *= std::max(side.yield - residual(), 0.0) / (yield_force.si() - residual());
    return side;
  }
  // The hardening line and the falling line of one side, N; x is in its direction.
  [[nodiscard]] double hardening_of(const Side& side, double x) const {
    return side.yield + side.hardening * (x - side.yield / stiffness.si());
  }
  [[nodiscard]] double fall_of(const Side& side, double x) const {
    return std::max(side.cap - side.weakening * x, residual());
  }
  [[nodiscard]] double bound(const State& state, int direction, double x) const {
    const Side side = side_of(state, direction);
    return std::min(std::max(hardening_of(side, x), 0.0), fall_of(side, x));
  }

  [[nodiscard]] Response respond_on(const State& state, double deformation) const {
    const double x = state.bound * deformation;
    const Side side = side_of(state, state.bound);
    switch (state.branch) {
      case Branch::elastic:
        return {state.force + unloading(state) * (deformation - state.deformation), unloading(state), 0.0};
      case Branch::hardening:
        return {state.bound * hardening_of(side, x), side.hardening, 0.0};
      case Branch::weakening:
        return {state.bound * (side.cap - side.weakening * x), -side.weakening, 0.0};
      case Branch::residual:
        return {state.bound * residual(), 0.0, 0.0};
      case Branch::slack:
      case Branch::failed:
        break;
    }
    return {};
  }

  // 1 - beta, or 0 where the energy is used up.
  static double kept(double energy, double reference, double exponent, double spent) {
    if (reference <= 0.0) return 1.0;
    if (spent >= reference) return 0.0;
    return std::max(1.0 - std::pow(std::max(energy, 0.0) / (reference - spent), exponent), 0.0);
  }
  static State failed(State state) {
    state.branch = Branch::failed;
    state.force = 0.0;
    return state;
  }
  [[nodiscard]] State turn(State state) const {
    const double spent = state.work - 0.5 * state.force * state.force / unloading(state);
    const double share =
        kept(spent - state.work_at_zero, stiffness_capacity.si() * yield_force.si(), stiffness_exponent, spent);
    if (share <= 0.0) return failed(state);
    state.softened = std::max(state.softened * share, first_side().hardening / stiffness.si());
    state.branch = Branch::elastic;
    state.bound = 0;
    return state;
  }
  [[nodiscard]] State cross_zero(State state) const {
    const double share =
        kept(state.work - state.work_at_zero, strength_capacity.si() * yield_force.si(), strength_exponent, state.work);
    if (share <= 0.0) return failed(state);
    state.side = -state.side;
    const std::size_t entered = state.side > 0 ? 0 : 1;
    state.weakened[entered] *= share;
    state.lowered[entered] *= share;
    state.work_at_zero = state.work;
    return state;
  }
};

}  // namespace moat
