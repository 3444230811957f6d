// High-damping rubber of Grant, Fenves and Whittaker.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "base/units.hpp"
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
/// move is exact for any length of the step, also through zero. The parameters are those of one specimen and one unit:
/// scale them by area and height. Energy: that of F1 as it is now is stored, the rest dissipated, by quadrature over
/// the move. Source: Grant, Fenves & Whittaker (2004), uniaxial; OpenSees, HDR, whose decay of delta is of first order.
struct GrantRubber {
  static constexpr std::string_view name = "GrantRubber";
  static constexpr std::string_view formula =
      "elastic with odd powers up to d^5, wearing; hysteretic part decays to R(d)";

  using PerArea = decltype(1.0 / (units::m * units::m));
  using PerVolume = decltype(1.0 / (units::m * units::m * units::m));

  /// a1 > 0 N/m; a2 N/m^3; a3 >= 0 N/m^5. F1 must grow with d: a2^2 <= 20/9 a1 a3.
  Required<Stiffness> a1;
  Required<decltype(Stiffness{} * PerArea{})> a2;
  Required<decltype(Stiffness{} * PerArea{} * PerArea{})> a3;
  /// b1 >= 0 N; b2 >= 0 N/m^2; b3 > 0 1/m.
  Required<Force> b1;
  Required<decltype(Force{} * PerArea{})> b2;
  Required<decltype(1.0 / units::m)> b3;
  /// c1, c2, c4 >= 0 1/m^3; 0 < c3 <= 1.
  PerVolume c1{};
  PerVolume c2{};
  double c3 = 1.0;
  PerVolume c4{};

  struct State {
    double deformation = 0.0;  ///< m
    double hysteretic = 0.0;   ///< F2, N
    double upper = 0.0;        ///< D+, m
    double lower = 0.0;        ///< D-, m
    double scragging = 0.0;    ///< D_S, m
    double mullins = 0.0;      ///< D_M, m
    double heat = 0.0;         ///< J, dissipated so far

    friend bool operator==(const State&, const State&) = default;
  };

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
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"a1", a1.si(), "N/m"},   {"a2", a2.si(), "N/m^3"}, {"a3", a3.si(), "N/m^5"}, {"b1", b1.si(), "N"},
            {"b2", b2.si(), "N/m^2"}, {"b3", b3.si(), "1/m"},   {"c1", c1.si(), "1/m^3"}, {"c2", c2.si(), "1/m^3"},
            {"c3", c3, "1"},          {"c4", c4.si(), "1/m^3"}};
  }

  Response evaluate(const State& committed, double deformation, double rate, State& trial) const {
    const double moved = deformation - committed.deformation;
    const double direction = moved != 0.0 ? std::copysign(1.0, moved) : rate < 0.0 ? -1.0 : 1.0;
    const Moved end = move(committed, deformation, direction, trial);
    if (moved == 0.0) {
      trial = committed;
    } else {
      // In two parts where the move passes zero: U has a corner there.
      const bool passes = committed.deformation * deformation < 0.0;
      trial.heat = committed.heat + heat_of(committed, committed.deformation, passes ? 0.0 : deformation, direction);
      if (passes) trial.heat += heat_of(committed, 0.0, deformation, direction);
    }
    return {end.elastic + end.hysteretic, end.stiffness, 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    return wear(committed) * potential(deformation);
  }
  double dissipation_rate(const State& committed, double, double rate) const { return committed.hysteretic * rate; }
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const {
    return a1.si() + (stage == StiffnessStage::initial ? b1.si() * b3.si() : 0.0);
  }

 private:
  struct Moved {
    double elastic, hysteretic, stiffness;  // N, N, N/m
    double wear_slope;                      // d(K_S1 K_M)/dd, 1/m
  };

  static double cube(double x) { return x * x * x; }
  [[nodiscard]] double secant(double u) const { return a1.si() + a2.si() * u * u + a3.si() * u * u * u * u; }
  [[nodiscard]] double potential(double d) const {
    const double x = d * d;
    return x * (a1.si() / 2.0 + x * (a2.si() / 4.0 + x * a3.si() / 6.0));
  }
  [[nodiscard]] double scragged_elastic(const State& state) const { return std::exp(-c1.si() * cube(state.scragging)); }
  [[nodiscard]] double scragged_bound(const State& state) const { return std::exp(-c2.si() * cube(state.scragging)); }
  [[nodiscard]] double softened(const State& state) const {
    return c3 + (1.0 - c3) * std::exp(-c4.si() * cube(state.mullins));
  }
  [[nodiscard]] double wear(const State& state) const { return scragged_elastic(state) * softened(state); }
  [[nodiscard]] double bound(const State& state, double u) const {
    return b1.si() + scragged_bound(state) * b2.si() * u * u;
  }

  static void rise(State& state, double u) {
    if (u <= state.upper) return;
    state.lower += u - state.upper;
    state.upper = u;
  }
  static void fall(State& state, double from, double to) {
    state.mullins += from - to;
    if (to >= state.lower) return;
    state.scragging += state.lower - to;
    state.lower = to;
  }

  // Forces after a monotone move, with the state there but for its heat.
  Moved move(const State& start, double deformation, double direction, State& end) const {
    end = start;
    const double before = std::abs(start.deformation), u = std::abs(deformation);
    const bool passes = start.deformation * deformation < 0.0, falls = passes || u < before;
    if (falls) fall(end, before, passes ? 0.0 : u);
    if (!falls || passes) rise(end, u);
    // Derivatives by d at the end: U and the damages that still grow there.
    const bool falling = direction * deformation < 0.0;
    const double u_slope = falling ? -1.0 : 1.0;  // times direction
    const double mullins_slope = falling ? 1.0 : 0.0;
    const double scragging_slope = falling && u <= end.lower ? 1.0 : 0.0;
    const double k_s1 = scragged_elastic(end), k_s2 = scragged_bound(end), k_m = softened(end);
    const double k_s1_slope = -3.0 * c1.si() * end.scragging * end.scragging * k_s1 * scragging_slope,
                 k_s2_slope = -3.0 * c2.si() * end.scragging * end.scragging * k_s2 * scragging_slope,
                 k_m_slope = -3.0 * c4.si() * end.mullins * end.mullins * (k_m - c3) * mullins_slope;
    const double wear_slope = direction * (k_s1_slope * k_m + k_s1 * k_m_slope);

    const double start_bound = bound(start, before), end_bound = bound(end, u);
    const double gap = start_bound * direction - start.hysteretic, side = gap < 0.0 ? -1.0 : 1.0;
    const double left = std::abs(gap) * std::exp(-b3.si() * std::abs(deformation - start.deformation));
    end.hysteretic = end_bound * direction - left * side;
    end.deformation = deformation;
    // d(F2)/dd = n dR/dd + b3 n delta mu.
    const double bound_slope = direction * b2.si() * (k_s2_slope * u * u + 2.0 * k_s2 * u * u_slope);
    const double tangent = a1.si() + 3.0 * a2.si() * u * u + 5.0 * a3.si() * u * u * u * u;
    const double elastic = k_s1 * k_m * secant(u) * deformation;
    return {elastic, end.hysteretic,
            k_s1 * k_m * tangent + wear_slope * secant(u) * deformation + direction * bound_slope +
                b3.si() * direction * left * side,
            wear_slope};
  }

  // The integral of F2 dd and of the loss of stored energy by wear, by Gauss's rule with five points.
  [[nodiscard]] double heat_of(const State& start, double from, double to, double direction) const {
    constexpr std::array<double, 5> points{0.04691007703066802, 0.23076534494715845, 0.5, 0.7692346550528415,
                                           0.953089922969332};
    constexpr std::array<double, 5> weights{0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                            0.23931433524968324, 0.11846344252809454};
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      State there;
      const double d = from + points[i] * (to - from);
      const Moved moved = move(start, d, direction, there);
      sum += weights[i] * (moved.hysteretic - moved.wear_slope * potential(d));
    }
    return sum * (to - from);
  }
};

}  // namespace moat
