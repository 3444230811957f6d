// Bouc-Wen hysteresis.
#pragma once

#include <array>
#include <cmath>

#include "materials/course.hpp"
#include "materials/integrate.hpp"
#include "materials/response.hpp"

namespace moat {

/// Bouc-Wen hysteresis: a lead-rubber or high-damping bearing whose yield is rounded.
///
///     F = k2 d + Q z + k3 sgn(d) |d|^mu,      Q = F_y - k2 d_y
///     d_y dz = [1 - |z|^n (gamma + beta sgn(z dd))] dd,      gamma = 1 - beta,   -1 <= z <= 1
///
///         F ^            ________ k2              F_y, d_y, k2 as in Bilinear, which is the limit n = infinity.
///           |      .-'''                          n = 1 ... 2 rounds the corner.
///           |    /
///     ------+--/------------> d                   Tension positive.
///
/// Sources: Bouc (1967), Wen (1976). The state follows exactly for beta = 1/2 and n = 1 or 2, for any length of the
/// step; else by a Runge-Kutta method with an error below 1e-12. Stored energy: k2 d^2/2 + Q d_y z^2/2 and that of the
/// hardening term. Turns are located. For beta >= 1/2 no cycle gains energy; smaller values are refused.
struct BoucWen {
  static constexpr std::string_view name = "BoucWen";
  static constexpr std::string_view formula = "F = k2 d + Q z + k3 sgn(d) abs(d)^mu; z rounds the yield";

  /// F_y > 0 N: force at d_y of the bilinear limit.
  Required<Force> yield_force;
  /// d_y > 0 m.
  Required<Length> yield_displacement;
  /// 0 <= k2 < F_y/d_y, N/m.
  Required<Stiffness> post_yield_stiffness;
  /// 1 <= n <= 50.
  double exponent = 2.0;
  /// 1/2 <= beta <= 10; gamma = 1 - beta. 1/2: elastic unloading.
  double beta = 0.5;
  /// k3 d_3^(mu - 1) >= 0 N/m: the hardening term is this stiffness times d at |d| = hardening_displacement; 0 without.
  Stiffness hardening_stiffness{};
  /// d_3 > 0 m.
  Length hardening_displacement = 1.0 * units::m;
  /// 1 < mu <= 10.
  double hardening_exponent = 3.0;

  struct State {
    double deformation = 0.0;  ///< m
    double z = 0.0;            ///< 1
    double heat = 0.0;         ///< J, dissipated so far
    Course course{};           ///< Where the next corner of the loop lies.

    friend bool operator==(const State&, const State&) = default;
  };

  /// Lead-rubber bearings under 30 MN: Q/W = 5.8 %, a period of 2.5 s after yield.
  static BoucWen typical() {
    using namespace units;
    return {.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};
  }

  void check(const Check& check) const {
    check.positive("yield_force", yield_force);
    check.positive("yield_displacement", yield_displacement);
    check.not_negative("post_yield_stiffness", post_yield_stiffness);
    check.that(
        post_yield_stiffness.si() < initial_stiffness(), "post_yield_stiffness", post_yield_stiffness.si(), "N/m",
        "below the initial stiffness yield_force / yield_displacement = " + to_text(initial_stiffness()) + " N/m",
        "Check the exponents of the three parameters.");
    check.between("exponent", exponent, 1.0, 50.0, "1", "1 to 2 is usual; 50 is nearly bilinear.");
    check.between("beta", beta, 0.5, 10.0, "1", "Below 1/2 small cycles would gain energy.");
    check.not_negative("hardening_stiffness", hardening_stiffness);
    check.positive("hardening_displacement", hardening_displacement);
    check.above_up_to("hardening_exponent", hardening_exponent, 1.0, 10.0, "1");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"yield_force", yield_force.si(), "N"},
            {"yield_displacement", yield_displacement.si(), "m"},
            {"post_yield_stiffness", post_yield_stiffness.si(), "N/m"},
            {"exponent", exponent, "1"},
            {"beta", beta, "1"},
            {"hardening_stiffness", hardening_stiffness.si(), "N/m"},
            {"hardening_displacement", hardening_displacement.si(), "m"},
            {"hardening_exponent", hardening_exponent, "1"}};
  }

  [[nodiscard]] double initial_stiffness() const { return yield_force.si() / yield_displacement.si(); }
  /// Q = F_y - k2 d_y, N.
  [[nodiscard]] double characteristic_strength() const {
    return yield_force.si() - post_yield_stiffness.si() * yield_displacement.si();
  }

  Response evaluate(const State& committed, double deformation, double rate, State& trial) const {
    const double moved = deformation - committed.deformation;
    const double direction = moved != 0.0 ? std::copysign(1.0, moved) : rate != 0.0 ? std::copysign(1.0, rate) : 0.0;
    const double limit = yield_displacement.si(), strength = characteristic_strength();
    const Progress end = progress(direction * committed.z, std::abs(moved) / limit);
    trial = {.deformation = deformation,
             .z = moved == 0.0 ? committed.z : direction * end.z,
             .heat = committed.heat + strength * limit * end.heat,
             .course = course_of_step(*this, committed, committed.deformation, moved)};
    const double slope = direction == 0.0 ? 0.5 * (slope_at(committed.z) + slope_at(-committed.z)) : slope_at(end.z);
    return {post_yield_stiffness.si() * deformation + strength * trial.z + hardening_force(deformation),
            post_yield_stiffness.si() + strength / limit * slope + hardening_tangent(deformation), 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    return 0.5 * post_yield_stiffness.si() * deformation * deformation +
           0.5 * characteristic_strength() * yield_displacement.si() * committed.z * committed.z +
           hardening_force(deformation) * deformation / (hardening_exponent + 1.0);
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    const double along = rate < 0.0 ? -committed.z : committed.z;
    return characteristic_strength() * std::abs(rate) * along * (1.0 - slope_at(along));
  }
  /// Exact for any path from one state to the other.
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const {
    return stage == StiffnessStage::initial ? initial_stiffness() : post_yield_stiffness.si();
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    return committed.course.margin(deformation, rate);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    return next_on_course(*this, committed, deformation, rate);
  }

 private:
  // z in the direction of the motion, and the heat over Q d_y.
  struct Progress {
    double z, heat;
  };

  // dz/ds for motion in the direction of positive z, s = distance/d_y.
  [[nodiscard]] double slope_at(double z) const {
    return 1.0 - power(std::abs(z)) * (z > 0.0 ? 1.0 : 1.0 - 2.0 * beta);
  }
  [[nodiscard]] double power(double z) const {
    return exponent == 2.0 ? z * z : exponent == 1.0 ? z : std::pow(z, exponent);
  }

  [[nodiscard]] Progress progress(double z, double distance) const {
    if (beta != 0.5 || (exponent != 1.0 && exponent != 2.0)) return progress_by_steps(z, distance);
    double heat = 0.0;
    // Elastic until z = 0.
    if (z < 0.0) {
      if (distance <= -z) return {z + distance, 0.0};
      distance += z;
      z = 0.0;
    }
    const double decay = std::exp(-(exponent == 1.0 ? 1.0 : 2.0) * distance);
    if (exponent == 1.0) {
      const double end = 1.0 - (1.0 - z) * decay;
      heat = distance + (1.0 - z) * std::expm1(-distance) - 0.5 * (end - z) * (end + z);
      return {end, heat};
    }
    // z = tanh(s + atanh z0), and the integral of z is ln[cosh(s + atanh z0)/cosh(atanh z0)].
    const double slope = std::tanh(distance), end = (z + slope) / (1.0 + z * slope);
    heat = distance + std::log1p(0.5 * (1.0 - z) * std::expm1(-2.0 * distance)) - 0.5 * (end - z) * (end + z);
    return {end, std::max(heat, 0.0)};
  }
  [[nodiscard]] Progress progress_by_steps(double z, double distance) const {
    if (distance == 0.0) return {z, 0.0};
    constexpr double longest = 0.05, tolerance = 1e-13;
    const auto rates = [&](const std::array<double, 2>& y) {
      const double slope = slope_at(y[0]);
      return std::array<double, 2>{slope, y[0] * (1.0 - slope)};
    };
    // The rate has a corner at z = 0: the path is cut there.
    double heat = 0.0;
    if (z < 0.0) {
      const double to_zero = distance_to_zero(z);
      if (distance < to_zero) {
        const auto end = integrate(rates, {z, 0.0}, distance, longest, tolerance);
        return {end[0], end[1]};
      }
      heat = integrate(rates, {z, 0.0}, to_zero, longest, tolerance)[1];
      distance -= to_zero;
      z = 0.0;
    }
    const auto end = integrate(rates, {z, 0.0}, distance, longest, tolerance);
    return {end[0], heat + end[1]};
  }
  // ds = dz/slope.
  [[nodiscard]] double distance_to_zero(double z) const {
    const auto rates = [&](const std::array<double, 2>& y) { return std::array<double, 2>{1.0, 1.0 / slope_at(y[0])}; };
    return integrate(rates, {z, 0.0}, -z, 0.05, 1e-13)[1];
  }

  [[nodiscard]] double hardening_force(double d) const {
    if (hardening_stiffness.si() == 0.0) return 0.0;
    return hardening_stiffness.si() * d * std::pow(std::abs(d) / hardening_displacement.si(), hardening_exponent - 1.0);
  }
  [[nodiscard]] double hardening_tangent(double d) const {
    if (hardening_stiffness.si() == 0.0) return 0.0;
    return hardening_exponent * hardening_stiffness.si() *
           std::pow(std::abs(d) / hardening_displacement.si(), hardening_exponent - 1.0);
  }
};

}  // namespace moat
