// High-damping rubber of Grant, Fenves and Whittaker.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/gauss.hpp"
#include "materials/course.hpp"
#include "materials/response.hpp"

namespace moat {

/// High-damping rubber bearing: a stiffening elastic part that wears, and a hysteretic part that decays towards a
/// bound.
///
///     F = F1 + F2,   U = |d|,   n = direction of motion
///     F1 = K_S1 K_M (a1 + a2 U^2 + a3 U^4) d
///     F2 = R n - delta mu,   R = b1 + K_S2 b2 U^2,   mu = sgn(R n - F2 at the start),   d(delta) = -b3 delta |dd|
///     K_S1 = exp(-c1 D_S^3),  K_S2 = exp(-c2 D_S^3)     scragging: never heals
///     K_M = c3 + (1 - c3) exp(-c4 D_M^3)                Mullins' effect: D_M grows while U falls
///
/// D_S grows where U falls below the smallest value of the last large cycles: thresholds D+ and D- follow U. A monotone
/// move is exact for any length of the step, also through zero; turns, zero and the threshold D- are located. The
/// parameters are those of one specimen and one unit: scale them by area and height. Energy: that of F1 as it is now is
/// stored, the rest dissipated, by quadrature over the move. BiaxialGrantRubber has the same parts in two components.
/// Source: Grant, Fenves & Whittaker (2004); OpenSees, HDR, whose decay of delta is of first order.
struct GrantRubber {
  static constexpr std::string_view name = "GrantRubber";
  static constexpr std::string_view formula =
      "elastic with odd powers up to d^5, wearing; hysteretic part decays to R(d)";
  static constexpr std::string_view assumption =
      "Fitted to one specimen and scaled by area and height. Scragging never heals.";

  using PerArea = decltype(1.0 / (units::m * units::m));               ///< 1/m^2
  using PerVolume = decltype(1.0 / (units::m * units::m * units::m));  ///< 1/m^3

  /// a1 > 0 N/m; a2 N/m^3; a3 >= 0 N/m^5. F1 must grow with d: a2^2 <= 20/9 a1 a3.
  Required<Stiffness> a1;
  Required<decltype(Stiffness{} * PerArea{})> a2;              ///< N/m^3
  Required<decltype(Stiffness{} * PerArea{} * PerArea{})> a3;  ///< N/m^5
  /// b1 >= 0 N; b2 >= 0 N/m^2; b3 > 0 1/m.
  Required<Force> b1;
  Required<decltype(Force{} * PerArea{})> b2;  ///< N/m^2
  Required<decltype(1.0 / units::m)> b3;       ///< 1/m
  /// c1, c2, c4 >= 0 1/m^3; 0 < c3 <= 1.
  PerVolume c1{};
  PerVolume c2{};   ///< 1/m^3
  double c3 = 1.0;  ///< 1
  PerVolume c4{};   ///< 1/m^3
  /// > 0 m: up to which the parameters were fitted; 0 if unknown. A larger one brings a warning.
  Length fitted_deformation{};

  /// The thresholds and the wear so far, m.
  struct Damage {
    double upper = 0.0;      ///< D+
    double lower = 0.0;      ///< D-
    double scragging = 0.0;  ///< D_S
    double mullins = 0.0;    ///< D_M

    friend bool operator==(const Damage&, const Damage&) = default;
  };
  struct State {
    double deformation = 0.0;  ///< m
    double hysteretic = 0.0;   ///< F2, N
    Damage damage{};           ///< Thresholds and wear so far.
    double heat = 0.0;         ///< J, dissipated so far
    Course course{};           ///< Where the next corner of the loop lies.

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 1> quantities{{{"fitted_strain_share", "1"}}};

  /// A specimen of 176 mm with 20 layers of 2.286 mm.
  static GrantRubber typical() {
    using namespace units;
    return {.a1 = 234856.6921 * N / m,
            .a2 = -4777446.405 * N / (m * m * m),
            .a3 = 252445116.1 * N / (m * m * m * m * m),
            .b1 = 3327.2536 * N,
            .b2 = 1399628.929 * N / (m * m),
            .b3 = 74.29133858 / m,
            .c1 = 103.740365 / (m * m * m),
            .c2 = 360.0400902 / (m * m * m),
            .c3 = 0.8743,
            .c4 = 1159.451138 / (m * m * m)};
  }

  void check(const Check& check) const {
    check.positive("a1", a1);
    check.finite("a2", a2.si(), "N/m^3");
    check.not_negative("a3", a3.si(), "N/m^5");
    // dF1/dd = a1 + 3 a2 x + 5 a3 x^2 >= 0 for all x = d^2.
    check.that(a2.si() >= 0.0 || 9.0 * a2.si() * a2.si() <= 20.0 * a1.si() * a3.si(), "a2", a2.si(), "N/m^3",
               "so that a1 + 3 a2 d^2 + 5 a3 d^4 >= 0 at every d", "The elastic force must grow with d.");
    check.not_negative("b1", b1);
    check.not_negative("b2", b2.si(), "N/m^2");
    check.positive("b3", b3.si(), "1/m");
    check.not_negative("c1", c1.si(), "1/m^3");
    check.not_negative("c2", c2.si(), "1/m^3");
    check.above_up_to("c3", c3, 0.0, 1.0, "1");
    check.not_negative("c4", c4.si(), "1/m^3");
    check.not_negative("fitted_deformation", fitted_deformation);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"a1", a1.si(), "N/m"},
            {"a2", a2.si(), "N/m^3"},
            {"a3", a3.si(), "N/m^5"},
            {"b1", b1.si(), "N"},
            {"b2", b2.si(), "N/m^2"},
            {"b3", b3.si(), "1/m"},
            {"c1", c1.si(), "1/m^3"},
            {"c2", c2.si(), "1/m^3"},
            {"c3", c3, "1"},
            {"c4", c4.si(), "1/m^3"},
            {"fitted_deformation", fitted_deformation.si(), "m"}};
  }

  Response evaluate(const State& committed, double deformation, double rate, State& trial) const {
    const double start = committed.deformation, moved = deformation - start;
    const double direction = moved != 0.0 ? std::copysign(1.0, moved) : rate < 0.0 ? -1.0 : 1.0;
    const bool passes = start * deformation < 0.0, falls = direction * deformation < 0.0;
    const double u = std::abs(deformation);
    const Radii radii{std::abs(start), passes ? 0.0 : falls ? u : std::abs(start), u};
    trial = {.deformation = deformation,
             .damage = worn(committed.damage, radii),
             .course = course_of_step(*this, committed, start, moved)};
    const Wear wear = wear_of(trial.damage, radii, committed.damage.lower);
    const double gap = bound(wear_of(committed.damage), std::abs(start)) * direction - committed.hysteretic;
    const double left = gap * std::exp(-b3.si() * std::abs(moved));
    trial.hysteretic = bound(wear, u) * direction - left;
    trial.heat = committed.heat + (moved == 0.0 ? 0.0 : heat_of(committed, trial, gap, direction));

    // d(lowest U)/dd is that of U while U falls, else 0.
    const double u_slope = falls ? -direction : direction, lowest_slope = falls ? u_slope : 0.0;
    const double stiffness = wear.elastic * tangent(u) + wear.elastic_slope * lowest_slope * secant(u) * deformation +
                             direction * bound_slope(wear, u, u_slope, lowest_slope) + b3.si() * direction * left;
    return {wear.elastic * secant(u) * deformation + trial.hysteretic, stiffness, 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    return wear_of(committed.damage).elastic * potential(deformation * deformation);
  }
  double dissipation_rate(const State& committed, double, double rate) const { return committed.hysteretic * rate; }
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const {
    return a1.si() + (stage == StiffnessStage::initial ? b1.si() * b3.si() : 0.0);
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    return committed.course.margin(deformation, rate);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    return next_on_course(*this, committed, deformation, rate);
  }
  /// While U falls: where scragging begins, and zero, where Mullins' effect stops.
  [[nodiscard]] double next_corner(const State& state, double from, int direction) const {
    const double left = -direction * from;  // until zero
    if (left <= 0.0) return direction * std::numeric_limits<double>::infinity();
    return left > state.damage.lower ? -direction * state.damage.lower : 0.0;
  }

  /// The largest deformation so far over fitted_deformation; 0 without.
  ReportedValue quantity(std::size_t, const State& state, double deformation, double rate, double) const {
    const double fitted = fitted_deformation.si();
    if (fitted <= 0.0) return {};
    const bool grows = std::abs(deformation) >= state.damage.upper && deformation * rate > 0.0;
    return {state.damage.upper / fitted, grows ? std::abs(rate) / fitted : 0.0};
  }

  /// A move of |d|: from `start` it falls to `lowest`, then rises to `end`.
  struct Radii {
    double start, lowest, end;  ///< m
  };
  /// K_S1 K_M and K_S2, with their derivatives by the lowest |d| of the move, 1/m.
  struct Wear {
    double elastic;              ///< K_S1 K_M
    double bound;                ///< K_S2
    double elastic_slope = 0.0;  ///< Derivative of K_S1 K_M.
    double bound_slope = 0.0;    ///< Derivative of K_S2.
  };
  /// Thresholds and wear after a move.
  [[nodiscard]] static Damage worn(Damage damage, const Radii& radii) {
    damage.mullins += radii.start - radii.lowest;
    if (radii.lowest < damage.lower) {
      damage.scragging += damage.lower - radii.lowest;
      damage.lower = radii.lowest;
    }
    if (radii.end > damage.upper) {
      damage.lower += radii.end - damage.upper;
      damage.upper = radii.end;
    }
    return damage;
  }
  /// At rest, without derivatives.
  [[nodiscard]] Wear wear_of(const Damage& damage) const {
    return {std::exp(-c1.si() * cube(damage.scragging)) * softened(damage),
            std::exp(-c2.si() * cube(damage.scragging))};
  }
  /// At the end of a move that began with the threshold D- at `lower`.
  [[nodiscard]] Wear wear_of(const Damage& damage, const Radii& radii, double lower) const {
    Wear wear = wear_of(damage);
    const double scragging_slope = radii.lowest <= lower ? -1.0 : 0.0, square = damage.scragging * damage.scragging;
    const double softening_slope = 3.0 * c4.si() * damage.mullins * damage.mullins * (softened(damage) - c3);
    wear.elastic_slope = wear.elastic * (softening_slope / softened(damage) - 3.0 * c1.si() * square * scragging_slope);
    wear.bound_slope = -3.0 * c2.si() * square * wear.bound * scragging_slope;
    return wear;
  }
  /// F1/(K_S1 K_M d), N/m.
  [[nodiscard]] double secant(double u) const { return a1.si() + u * u * (a2.si() + a3.si() * u * u); }
  /// d(F1/(K_S1 K_M))/d|d|, N/m.
  [[nodiscard]] double tangent(double u) const { return a1.si() + u * u * (3.0 * a2.si() + 5.0 * a3.si() * u * u); }
  /// The energy of F1/(K_S1 K_M) at a square of |d|, J.
  [[nodiscard]] double potential(double square) const {
    return square * (a1.si() / 2.0 + square * (a2.si() / 4.0 + square * a3.si() / 6.0));
  }
  /// R, N.
  [[nodiscard]] double bound(const Wear& wear, double u) const { return b1.si() + wear.bound * b2.si() * u * u; }
  /// The derivative of R, N/m, from those of |d| and of the lowest |d| of the move.
  [[nodiscard]] double bound_slope(const Wear& wear, double u, double u_slope, double lowest_slope) const {
    return b2.si() * u * (2.0 * wear.bound * u_slope + wear.bound_slope * lowest_slope * u);
  }
  /// The work of F1 and of R along a part of a straight move over `distance` m, by Gauss's rule with five points on
  /// panels over which the wear changes little.
  /// `damage` is that at the start of the part; `deformation(share)` gives |d| and its derivative by the distance.
  template <class Deformation>
  [[nodiscard]] double smooth_work(const Damage& damage, double distance, const Deformation& deformation) const {
    const double start = deformation(0.0).first, fastest = std::cbrt(std::max({c1.si(), c2.si(), c4.si()}));
    const int panels = 1 + static_cast<int>(4.0 * distance * fastest);
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel)
      Gauss::visit(0.0, 1.0, [&](double x, double weight) {
        const auto [u, slope] = deformation((panel + x) / panels);
        const Wear wear = wear_of(worn(damage, {start, std::min(start, u), u}));
        sum += weight * (wear.elastic * secant(u) * u * slope + bound(wear, u));
      });
    return sum * distance / panels;
  }
  /// The work of the decaying part over a straight move; `along`, N, is the component of R n - F2 at its start in the
  /// direction of the move.
  [[nodiscard]] double decaying_work(double along, double distance) const {
    return along * std::expm1(-b3.si() * distance) / b3.si();
  }

 private:
  static double cube(double x) { return x * x * x; }
  [[nodiscard]] double softened(const Damage& damage) const {
    return c3 + (1.0 - c3) * std::exp(-c4.si() * cube(damage.mullins));
  }

  // In parts where the move passes zero or D-: the wear has corners there.
  [[nodiscard]] double heat_of(const State& from, const State& to, double gap, double direction) const {
    double work = decaying_work(direction * gap, std::abs(to.deformation - from.deformation));
    Damage damage = from.damage;
    for (double d = from.deformation; d != to.deformation;) {
      double end = next_corner({.damage = damage}, d, direction > 0.0 ? 1 : -1);
      if (direction * (to.deformation - end) < 0.0) end = to.deformation;
      const auto path = [&](double share) {
        const double at = d + share * (end - d);
        return std::pair{std::abs(at), direction * at < 0.0 ? -1.0 : 1.0};
      };
      work += smooth_work(damage, std::abs(end - d), path);
      damage = worn(damage, {std::abs(d), std::min(std::abs(d), std::abs(end)), std::abs(end)});
      d = end;
    }
    return work - stored_energy(to, to.deformation) + stored_energy(from, from.deformation);
  }
};

}  // namespace moat
