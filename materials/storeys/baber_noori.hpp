// A storey that degrades: Bouc, Wen, Baber and Noori.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "materials/course.hpp"
#include "materials/integrate.hpp"
#include "materials/response.hpp"

namespace moat {

/// A storey whose stiffness and strength degrade with the energy that it dissipated, and whose loops may pinch:
///
///     F = alpha k d + (1 - alpha) k z
///     dz/dd = h(z) [A - |z|^n (gamma + beta sgn(z dd)) nu]/eta,     beta + gamma = d_y^-n, both equal
///     A = 1 - dA e,   nu = 1 + dnu e,   eta = 1 + deta e,           e = integral of (1 - alpha) k z dd, J
///     h = 1 - zeta1 exp(-(z sgn(dd) - q z_u)^2/zeta2^2),            z_u = [A/(nu (beta + gamma))]^(1/n)
///     zeta1 = zeta0 (1 - exp(-p e)),   zeta2 = (psi0 + dpsi e)(lambda + zeta1)
///
/// Without pinching (zeta0 = 0) h = 1. (z, e) follow the drift by a Runge-Kutta method with an error below 1e-12, so
/// that results hardly depend on the length of steps, which end where the motion turns; the tangent is the right-hand
/// side at the end. Stored energy: alpha k d^2/2; the rest of the work counts as dissipated, and part of it comes back
/// where z unloads. Sources: Baber & Wen (1981), Baber & Noori (1986), BoucWenMaterial of OpenSees.
struct BaberNoori {
  static constexpr std::string_view name = "BaberNoori";
  static constexpr std::string_view formula = "Bouc-Wen whose stiffness and strength fall with the energy; may pinch";
  static constexpr std::string_view assumption =
      "All work but that of the part alpha k counts as dissipated, though some of it comes back.";

  /// k > 0 N/m.
  Required<Stiffness> stiffness;
  /// 0 <= alpha < 1.
  double hardening_ratio = 0.05;
  /// d_y > 0 m.
  Required<Length> yield_drift;
  /// 1 <= n <= 20.
  double exponent = 2.0;
  /// dA, dnu, deta >= 0 1/J: loss of strength and stiffness, of strength alone, of stiffness alone.
  decltype(1.0 / units::J) loss_of_both{};
  decltype(1.0 / units::J) loss_of_strength{};   ///< dnu
  decltype(1.0 / units::J) loss_of_stiffness{};  ///< deta
  /// 0 <= zeta0 < 1; 0: no pinching.
  double pinching = 0.0;
  /// p >= 0 1/J.
  decltype(1.0 / units::J) pinching_rate{};
  /// 0 <= q < 1: where the loop pinches, as a share of z_u.
  double pinching_place = 0.1;
  /// psi0 > 0 m, dpsi >= 0 m/J, lambda > 0: the width of the pinch.
  Length pinching_width = 5.0 * units::cm;
  decltype(units::m / units::J) widening{};  ///< dpsi
  double coupling = 0.5;                     ///< lambda

  struct State {
    double deformation = 0.0;  ///< m
    double z = 0.0;            ///< m
    double energy = 0.0;       ///< e, J
    Course course{};           ///< Where the next corner of the loop lies.

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 1> quantities{{{.name = "ductility", .unit = "1"}}};

  static BaberNoori typical() {
    using namespace units;
    return {
        .stiffness = 100 * MN / m, .yield_drift = 2 * cm, .loss_of_strength = 2e-6 / J, .loss_of_stiffness = 1e-6 / J};
  }

  void check(const Check& check) const {
    check.positive("stiffness", stiffness);
    check.that(hardening_ratio >= 0.0 && hardening_ratio < 1.0, "hardening_ratio", hardening_ratio, "1", ">= 0 and < 1",
               "0.02 to 0.1 is usual.");
    check.positive("yield_drift", yield_drift);
    check.between("exponent", exponent, 1.0, 20.0, "1");
    check.not_negative("loss_of_both", loss_of_both.si(), "1/J");
    check.not_negative("loss_of_strength", loss_of_strength.si(), "1/J");
    check.not_negative("loss_of_stiffness", loss_of_stiffness.si(), "1/J");
    check.that(pinching >= 0.0 && pinching < 1.0, "pinching", pinching, "1", ">= 0 and < 1");
    check.not_negative("pinching_rate", pinching_rate.si(), "1/J");
    check.that(pinching_place >= 0.0 && pinching_place < 1.0, "pinching_place", pinching_place, "1", ">= 0 and < 1");
    check.positive("pinching_width", pinching_width);
    check.not_negative("widening", widening.si(), "m/J");
    check.positive("coupling", coupling, "1");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"stiffness", stiffness.si(), "N/m"},
            {"hardening_ratio", hardening_ratio, "1"},
            {"yield_drift", yield_drift.si(), "m"},
            {"exponent", exponent, "1"},
            {"loss_of_both", loss_of_both.si(), "1/J"},
            {"loss_of_strength", loss_of_strength.si(), "1/J"},
            {"loss_of_stiffness", loss_of_stiffness.si(), "1/J"},
            {"pinching", pinching, "1"},
            {"pinching_rate", pinching_rate.si(), "1/J"},
            {"pinching_place", pinching_place, "1"},
            {"pinching_width", pinching_width.si(), "m"},
            {"widening", widening.si(), "m/J"},
            {"coupling", coupling, "1"}};
  }

  Response evaluate(const State& committed, double deformation, double rate, State& trial) const {
    const double moved = deformation - committed.deformation;
    const double direction = moved != 0.0 ? std::copysign(1.0, moved) : rate < 0.0 ? -1.0 : 1.0;
    // z in the direction of the motion and e, along the distance.
    std::array<double, 2> y{direction * committed.z, committed.energy};
    if (moved != 0.0) y = follow(y, std::abs(moved));
    trial = {deformation, moved == 0.0 ? committed.z : direction * y[0], y[1],
             course_of_step(*this, committed, committed.deformation, moved)};
    const double elastic = hardening_ratio * stiffness.si(), hysteretic = stiffness.si() - elastic;
    return {elastic * deformation + hysteretic * trial.z, elastic + hysteretic * rates(y)[0], 0.0};
  }
  double stored_energy(const State&, double deformation) const {
    return 0.5 * hardening_ratio * stiffness.si() * deformation * deformation;
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    return (1.0 - hardening_ratio) * stiffness.si() * committed.z * rate;
  }
  double dissipated_energy(const State& from, const State& to) const { return to.energy - from.energy; }
  double linear_stiffness(StiffnessStage stage) const {
    return stage == StiffnessStage::initial ? stiffness.si() : hardening_ratio * stiffness.si();
  }
  double regime_margin(const State& committed, double deformation, double rate) const {
    return committed.course.margin(deformation, rate);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    return next_on_course(*this, committed, deformation, rate);
  }
  ReportedValue quantity(std::size_t, const State&, double deformation, double rate, double) const {
    return {deformation / yield_drift.si(), rate / yield_drift.si()};
  }

 private:
  // Derivatives of z (in the direction of the motion) and e along the distance.
  [[nodiscard]] std::array<double, 2> rates(const std::array<double, 2>& y) const {
    const double z = y[0], energy = std::max(y[1], 0.0);
    // A floor keeps the equation sound where all strength is lost.
    const double a = std::max(1.0 - loss_of_both.si() * energy, 1e-6), nu = 1.0 + loss_of_strength.si() * energy,
                 eta = 1.0 + loss_of_stiffness.si() * energy;
    // beta = gamma = d_y^-n/2: the term acts on loading only.
    const double reached = z > 0.0 ? std::pow(z / yield_drift.si(), exponent) * nu : 0.0;
    double slope = (a - reached) / eta;
    if (pinching > 0.0) {
      const double first = pinching * -std::expm1(-pinching_rate.si() * energy);
      const double second = (pinching_width.si() + widening.si() * energy) * (coupling + first);
      const double ultimate = yield_drift.si() * std::pow(a / nu, 1.0 / exponent);
      const double distance = (z - pinching_place * ultimate) / second;
      slope *= 1.0 - first * std::exp(-distance * distance);
    }
    return {slope, (1.0 - hardening_ratio) * stiffness.si() * z};
  }
  [[nodiscard]] std::array<double, 2> follow(const std::array<double, 2>& start, double distance) const {
    // Both over their sizes, so that one tolerance serves both.
    const double unit = yield_drift.si(), unit_energy = (1.0 - hardening_ratio) * stiffness.si() * unit * unit;
    const auto scaled = [&](const std::array<double, 2>& y) {
      const auto slopes = rates({y[0] * unit, y[1] * unit_energy});
      return std::array<double, 2>{slopes[0], slopes[1] * unit / unit_energy};
    };
    const auto end =
        integrate(std::cref(scaled), {start[0] / unit, start[1] / unit_energy}, distance / unit, 0.05, 1e-14);
    return {end[0] * unit, end[1] * unit_energy};
  }
};

}  // namespace moat
