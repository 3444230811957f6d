// Lead-rubber bearing whose lead heats and weakens.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "base/units.hpp"
#include "materials/response.hpp"

namespace moat {

/// Lead-rubber bearing with heating of the lead core.
///
///     F = k2 d + q,   |q| <= Q(T) = Q0 exp(-E2 T),   elastic with k1 - k2 below;   T = rise of the lead's temperature,
///     K
///
///     rho c h dT/dt = P/A - (k_s T/a) [1/F(t+) + 1.274 (t_s/a) (t+)^(-1/3)],   t+ = alpha_s t/a^2
///
/// P = Q |slip rate|, a and A the radius and area of the lead, h the height of rubber and shims, t_s the total
/// thickness of shims, t the time since the first slip. The steel conducts the heat away; F(t+) is the integral of its
/// response. d_y = Q/(k1 - k2) shrinks with Q. Without cooling Q/Q0 = 1/(1 + E2 Q0 S/(A rho c h)) after a slip path S:
/// a step follows this exactly, with the cooling taken at its middle, and the force at its end belongs to the
/// temperature there. Yield and unloading are located, as in LocatedBilinear.
///
/// Q0 is the strength of the first cycle, about 13 MPa times A; a bilinear model without heating takes the mean of
/// three cycles, 8 to 11 MPa. All is for one bearing: give a layer by Isolator::count. Sources: Kalpakidis &
/// Constantinou (2009), Kalpakidis, Constantinou & Whittaker (2010); constants as in LeadRubberX of OpenSees. F jumps
/// by -0.1 % at t+ = 0.6.
struct HeatedLeadRubber {
  static constexpr std::string_view name = "HeatedLeadRubber";
  static constexpr std::string_view formula = "bilinear with Q = Q0 exp(-E2 T), T of the lead by heat balance";
  static constexpr std::string_view assumption =
      "Heat flows from the lead into the steel plates; the parameters are those of one bearing.";

  /// Q0 > 0 N: at the temperature of the start.
  Required<Force> strength;
  /// d_y > 0 m, of the cold bearing; k1 - k2 = Q0/d_y.
  Required<Length> yield_displacement;
  /// k2 >= 0 N/m.
  Required<Stiffness> post_yield_stiffness;
  /// 2 a > 0 m.
  Required<Length> lead_diameter;
  /// h > 0 m: rubber and shims.
  Required<Length> lead_height;
  /// 0 < t_s < h, m: all shims.
  Required<Length> shim_thickness;
  /// E2 >= 0 1/K; 0: no weakening.
  double weakening = 0.0069;
  /// rho > 0.
  decltype(units::kg / units::m / units::m / units::m) lead_density =
      11200.0 * units::kg / (units::m * units::m * units::m);
  /// c > 0 J/(kg K).
  double lead_specific_heat = 130.0;
  /// k_s >= 0 W/(m K); 0: no cooling.
  double steel_conductivity = 50.0;
  /// alpha_s > 0 m^2/s.
  double steel_diffusivity = 1.41e-5;

  struct State {
    double slip = 0.0;          ///< m
    double temperature = 0.0;   ///< T, K
    double heating_time = 0.0;  ///< t, s; 0 before the first slip
    double heat = 0.0;          ///< J, dissipated so far
    int direction = 0;          ///< of sliding; 0: elastic

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 2> quantities{
      {{"lead_temperature_rise", "K"}, {"characteristic_strength", "N"}}};
  static constexpr double time_of_rate = 1.0, threshold = 1e-9;  ///< as LocatedBilinear

  /// The bearing of the experiment of Kalpakidis, Constantinou & Whittaker (2010): 508 mm wide, lead of 139.7 mm.
  static HeatedLeadRubber typical() {
    using namespace units;
    return {.strength = 204.75 * kN,
            .yield_displacement = 1 * cm,
            .post_yield_stiffness = 0.9 * MN / m,
            .lead_diameter = 139.7 * mm,
            .lead_height = 223.8 * mm,
            .shim_thickness = 71.4 * mm};
  }

  void check(const Check& check) const {
    check.positive("strength", strength);
    check.positive("yield_displacement", yield_displacement);
    check.not_negative("post_yield_stiffness", post_yield_stiffness);
    check.positive("lead_diameter", lead_diameter);
    check.positive("lead_height", lead_height);
    check.that(shim_thickness.si() > 0.0 && shim_thickness.si() < lead_height.si(), "shim_thickness",
               shim_thickness.si(), "m", "> 0 and below lead_height = " + to_text(lead_height.si()) + " m",
               "Give the sum over all shims.");
    check.not_negative("weakening", weakening, "1/K");
    check.positive("lead_density", lead_density.si(), "kg/m^3");
    check.positive("lead_specific_heat", lead_specific_heat, "J/(kg K)");
    check.not_negative("steel_conductivity", steel_conductivity, "W/(m K)");
    check.positive("steel_diffusivity", steel_diffusivity, "m^2/s");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"strength", strength.si(), "N"},
            {"yield_displacement", yield_displacement.si(), "m"},
            {"post_yield_stiffness", post_yield_stiffness.si(), "N/m"},
            {"lead_diameter", lead_diameter.si(), "m"},
            {"lead_height", lead_height.si(), "m"},
            {"shim_thickness", shim_thickness.si(), "m"},
            {"weakening", weakening, "1/K"},
            {"lead_density", lead_density.si(), "kg/m^3"},
            {"lead_specific_heat", lead_specific_heat, "J/(kg K)"},
            {"steel_conductivity", steel_conductivity, "W/(m K)"},
            {"steel_diffusivity", steel_diffusivity, "m^2/s"}};
  }

  Response evaluate(const State& committed, double deformation, double, Interval interval, State& trial) const {
    const double post_yield = post_yield_stiffness.si(), elastic = elastic_stiffness();
    trial = committed;
    const double cooling = cooling_of(committed, interval.length);
    if (committed.heating_time > 0.0 || committed.direction != 0) trial.heating_time += interval.length;
    if (committed.direction == 0) {
      trial.temperature = cooled(committed.temperature, committed.temperature, cooling);
      return {post_yield * deformation + elastic * (deformation - committed.slip), post_yield + elastic, 0.0};
    }
    const Warmed warmed = warm(committed, deformation);
    if (interval.length == 0.0)
      return {post_yield * deformation + committed.direction * strength_at(committed.temperature), post_yield, 0.0};
    trial.temperature = cooled(committed.temperature, warmed.temperature, cooling);
    trial.heat = committed.heat + heat_capacity() * (warmed.temperature - committed.temperature);
    const double limit = strength_at(trial.temperature), uncooled = strength_at(warmed.temperature);
    // The lead that cools regains strength: its elastic part grows at the cost of the slip.
    trial.heat -= 0.5 * (limit * limit - uncooled * uncooled) / elastic;
    trial.slip = deformation - committed.direction * limit / elastic;
    const double slope = trial.temperature > 0.0 ? -weakening * limit * (1.0 - 0.5 * cooling) * warmed.per_move : 0.0;
    return {post_yield * deformation + committed.direction * limit, post_yield + slope, 0.0};
  }
  double force_rate(const State& state, double, double rate, double) const {
    const double post_yield = post_yield_stiffness.si();
    if (state.direction == 0) return (post_yield + elastic_stiffness()) * rate;
    return post_yield * rate - state.direction * weakening * strength_at(state.temperature) * warming(state, rate);
  }
  double stored_energy(const State& committed, double deformation) const {
    const double stretch = deformation - committed.slip;
    return 0.5 * post_yield_stiffness.si() * deformation * deformation + 0.5 * elastic_stiffness() * stretch * stretch;
  }
  double dissipation_rate(const State& committed, double, double rate) const {
    return committed.direction * rate > 0.0 ? strength_at(committed.temperature) * std::abs(rate) : 0.0;
  }
  double dissipated_energy(const State& from, const State& to) const { return to.heat - from.heat; }
  double linear_stiffness(StiffnessStage stage) const {
    return post_yield_stiffness.si() + (stage == StiffnessStage::initial ? elastic_stiffness() : 0.0);
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    if (committed.direction != 0) return committed.direction * rate * time_of_rate;
    return strength_at(committed.temperature) / elastic_stiffness() * (1.0 + threshold) -
           std::abs(deformation - committed.slip);
  }
  State next_regime(const State& committed, double deformation, double) const {
    State next = committed;
    const int direction = committed.direction != 0 ? committed.direction : deformation > committed.slip ? 1 : -1;
    if (committed.direction != 0) {
      // Of a slide that ends inside a step.
      next.temperature = warm(committed, deformation).temperature;
      next.heat += heat_capacity() * (next.temperature - committed.temperature);
    }
    next.slip = deformation - direction * strength_at(next.temperature) / elastic_stiffness();
    next.direction = committed.direction != 0 ? 0 : direction;
    return next;
  }
  ReportedValue quantity(std::size_t index, const State& state, double, double rate, double) const {
    const double left = strength_at(state.temperature), temperature_rate = warming(state, rate);
    if (index == 0) return {state.temperature, temperature_rate};
    return {left, -weakening * left * temperature_rate};
  }

  /// Q(T), N.
  [[nodiscard]] double strength_at(double temperature) const {
    return strength.si() * std::exp(-weakening * temperature);
  }
  /// F(t+) of the steel.
  static double steel_response(double t) {
    constexpr double pi = std::numbers::pi, change = 0.6;
    if (t < change) {
      const double quarter = 0.25 * t;
      return 2.0 * std::sqrt(t / pi) -
             t / pi * (2.0 - quarter - quarter * quarter - 3.75 * quarter * quarter * quarter);
    }
    const double x = 1.0 / (4.0 * t);
    return 8.0 / (3.0 * pi) - 0.5 / std::sqrt(pi * t) * (1.0 - x / 3.0 + x * x / 6.0 - x * x * x / 12.0);
  }

 private:
  [[nodiscard]] double elastic_stiffness() const { return strength.si() / yield_displacement.si(); }
  // K/s
  [[nodiscard]] double warming(const State& state, double rate) const {
    const double cooling = state.temperature * cooling_rate(state.heating_time);
    if (state.direction == 0) return -cooling;
    const double limit = strength_at(state.temperature), per_slip = -weakening * limit * limit / heat_capacity();
    const double slip_rate = state.direction * rate / (1.0 + per_slip / elastic_stiffness());
    return limit * slip_rate / heat_capacity() - cooling;
  }
  [[nodiscard]] double radius() const { return 0.5 * lead_diameter.si(); }
  // A rho c h, J/K.
  [[nodiscard]] double heat_capacity() const {
    return std::numbers::pi * radius() * radius() * lead_density.si() * lead_specific_heat * lead_height.si();
  }

  struct Warmed {
    double temperature;  // K, without cooling
    double per_move;     // K/m
  };
  // After sliding to a deformation. The slip is longer than the move, because the elastic part shrinks with the
  // strength: S = move + (Q(T0) - Q(T1))/(k1 - k2), with 1/Q(T1) = 1/Q(T0) + E2 S/(A rho c h). The move is counted from
  // the slip, so that a slide that begins inside a step heats from there on.
  [[nodiscard]] Warmed warm(const State& sliding, double deformation) const {
    const double temperature = sliding.temperature, start = strength_at(temperature);
    const double move = sliding.direction * (deformation - sliding.slip) - start / elastic_stiffness();
    const double rate = weakening / heat_capacity();
    // Together these are square Q1^2 - sum Q1 + 1 = 0.
    const double square = rate / elastic_stiffness();
    const double sum = std::max(1.0 / start + rate * move + square * start, 2.0 * std::sqrt(square));
    const double end = 2.0 / (sum + std::sqrt(sum * sum - 4.0 * square));
    const double slip = move + (start - end) / elastic_stiffness();
    const double per_slip = -rate * end * end;  // dQ/dS
    const double slip_per_move = 1.0 / (1.0 + per_slip / elastic_stiffness());
    const double rise = weakening > 0.0 ? std::log(start / end) / weakening : start * slip / heat_capacity();
    return {temperature + rise, end / heat_capacity() * slip_per_move};
  }

  // The share of the temperature that is lost in a second, at a time since the first slip.
  [[nodiscard]] double cooling_rate(double time) const {
    if (time <= 0.0 || steel_conductivity == 0.0) return 0.0;
    const double a = radius(), t = steel_diffusivity * time / (a * a);
    return steel_conductivity / (a * lead_density.si() * lead_specific_heat * lead_height.si()) *
           (1.0 / steel_response(t) + 1.274 * shim_thickness.si() / a / std::cbrt(t));
  }
  // The share of the mean temperature that a step loses.
  [[nodiscard]] double cooling_of(const State& committed, double length) const {
    const bool has_slipped = committed.heating_time > 0.0 || committed.direction != 0;
    return has_slipped ? length * cooling_rate(committed.heating_time + 0.5 * length) : 0.0;
  }
  static double cooled(double before, double warmed, double cooling) {
    return std::max(warmed - 0.5 * cooling * (before + warmed), 0.0);
  }
};

}  // namespace moat
