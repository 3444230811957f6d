// Lead-rubber bearing whose lead heats and weakens.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "materials/response.hpp"
#include "materials/steel_around_lead.hpp"

namespace moat {

/// Lead-rubber bearing with heating of the lead core.
///
///     F = k2 d + q,   |q| <= Q(T) = Q0 exp(-E2 T),   elastic with k1 - k2 below;   T = rise of the lead's temperature,
///     K
///
///     A rho c h dT/dt = P - J,   P = Q |slip rate|,   slip = d - q/(k1 - k2)
///
/// a and A are the radius and area of the lead, h the height of rubber and shims, t_s the total thickness of shims. J
/// is the flow of heat into the steel by the history of T (materials/steel_around_lead.hpp). d_y = Q/(k1 - k2) shrinks
/// with Q. Without cooling Q/Q0 = 1/(1 + E2 Q0 S/(A rho c h)) after a slip path S: a step follows this exactly, with
/// cooling of second order, and the force at its end belongs to the temperature there. Lead that cools while it slides
/// regains strength: its elastic part grows at the cost of the slip. Yield and unloading are located, as in
/// Bilinear.
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
    double slip = 0.0;                      ///< m
    double temperature = 0.0;               ///< T, K
    double heat = 0.0;                      ///< J, dissipated so far
    SteelAroundLead::Temperatures steel{};  ///< K, of the steel around the lead
    int direction = 0;                      ///< of sliding; 0: elastic

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 2> quantities{
      {{"lead_temperature_rise", "K"}, {"characteristic_strength", "N"}}};
  static constexpr double time_of_rate = 1.0, threshold = 1e-9;  ///< as Bilinear

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
    if (committed.direction == 0) {
      steel().rest(interval.length, trial.temperature, trial.steel);
      return {post_yield * deformation + elastic * (deformation - committed.slip), post_yield + elastic, 0.0};
    }
    if (interval.length == 0.0)
      return {post_yield * deformation + committed.direction * strength_at(committed.temperature), post_yield, 0.0};
    const SteelAroundLead::Step cooling{steel(), interval.length};
    const Slide slide =
        slide_to(committed, deformation, cooling.lost(committed.temperature, committed.steel), cooling.share());
    trial.temperature = slide.temperature;
    trial.heat += slide.heat;
    cooling.advance(committed.temperature, trial.temperature, trial.steel);
    const double limit = strength_at(trial.temperature);
    trial.slip = deformation - committed.direction * limit / elastic;
    return {post_yield * deformation + committed.direction * limit, post_yield - weakening * limit * slide.per_move,
            0.0};
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
    // A bearing at rest sticks: its force does not follow the strength that the lead regains.
    if (committed.direction != 0) return committed.direction * rate * time_of_rate - 1e-14;
    return strength_at(committed.temperature) / elastic_stiffness() * (1.0 + threshold) -
           std::abs(deformation - committed.slip);
  }
  State next_regime(const State& committed, double deformation, double) const {
    State next = committed;
    const int direction = committed.direction != 0 ? committed.direction : deformation > committed.slip ? 1 : -1;
    if (committed.direction != 0) {
      // The slide ends inside a step and has heated the lead until then.
      const Slide slide = slide_to(committed, deformation, 0.0, 0.0);
      next.temperature = slide.temperature;
      next.heat += slide.heat;
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

 private:
  [[nodiscard]] double elastic_stiffness() const { return strength.si() / yield_displacement.si(); }
  [[nodiscard]] SteelAroundLead steel() const {
    const double a = radius();
    return {.rate = steel_conductivity / (a * lead_density.si() * lead_specific_heat * lead_height.si()),
            .time = a * a / steel_diffusivity,
            .shims = 1.274 * shim_thickness.si() / a};
  }
  // K/s
  [[nodiscard]] double warming(const State& state, double rate) const {
    const double cooling = steel().cooling(state.temperature, state.steel);
    if (state.direction == 0) return -cooling;
    // The slip rate is the rate of the deformation less that of the elastic part, which follows the strength.
    const double limit = strength_at(state.temperature), per_slip = -weakening * limit * limit / heat_capacity();
    return (limit * state.direction * rate / heat_capacity() - cooling) / (1.0 + per_slip / elastic_stiffness());
  }
  [[nodiscard]] double radius() const { return 0.5 * lead_diameter.si(); }
  // A rho c h, J/K.
  [[nodiscard]] double heat_capacity() const {
    return std::numbers::pi * radius() * radius() * lead_density.si() * lead_specific_heat * lead_height.si();
  }

  struct Slide {
    double temperature;  // K
    double heat;         // J
    double per_move;     // of the temperature, K/m
  };
  // To a deformation. The temperature T1 at its end solves
  //     (1 + share) (T1 - T0) = R(S) - lost,   S = move + (Q(T0) - Q(T1))/(k1 - k2),
  // with the adiabatic rise R = ln(1 + E2 Q(T0) S/(A rho c h))/E2: the elastic part shrinks with the strength. The move
  // is counted from the slip, so that a slide that begins inside a step heats from there on.
  [[nodiscard]] Slide slide_to(const State& sliding, double deformation, double lost, double share) const {
    const double start = strength_at(sliding.temperature), elastic = elastic_stiffness(), capacity = heat_capacity();
    const double move = sliding.direction * (deformation - sliding.slip) - start / elastic;
    double rise = 0.0, adiabatic = 0.0, per_move = 0.0;
    constexpr int iterations = 20;
    for (int i = 0; i < iterations; ++i) {
      const double end = strength_at(sliding.temperature + rise);
      const double undiminished = start * (move + (start - end) / elastic) / capacity;
      const double softening = std::max(weakening * undiminished, -0.9);
      adiabatic = weakening > 0.0 ? std::log1p(softening) / weakening : undiminished;
      const double per_slip = start / (1.0 + softening) / capacity;  // K/m
      const double slope = std::max(1.0 + share - per_slip * weakening * end / elastic, 0.1);
      per_move = per_slip / slope;
      const double correction = ((1.0 + share) * rise + lost - adiabatic) / slope;
      rise -= correction;
      if (std::abs(correction) <= 1e-15 * (1.0 + sliding.temperature)) break;
    }
    return {sliding.temperature + rise, capacity * adiabatic, per_move};
  }
};

}  // namespace moat
