// Backfill behind a wall.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "materials/response.hpp"

namespace moat {

/// The face of a wall that presses into soil.
struct BackfilledWall {
  Required<Length> height;  ///< h > 0 m.
  Required<Length> width;   ///< b > 0 m.
};

/// Soil behind a wall: passive pressure that grows along a hyperbola, and a gap where the wall comes back.
///
///     F ^        .---  F = y/(1/K_max + R_f y/F_ult)       y = deformation, into the soil
///       |     .-'/
///       |   .'  / K_ur        unloads and reloads along K_ur from the largest y_m; no tension
///     --+--/---/-----> y
///           gap
///
/// Its regimes are located: virgin (on the hyperbola), elastic (on the line), open. Compression positive. The asymptote
/// is F_ult/R_f. Stored energy F^2/(2 K_ur). `soil_gap` [m] is reported, the deformation up to which no force acts.
/// Sources: Duncan & Mokwa (2001); Shamsabadi, Rollins & Kapuskar (2007), whose form F = C y/(1 + D y) has K_max = C
/// and R_f/F_ult = D/C; HyperbolicGapMaterial of OpenSees.
struct HyperbolicBackfill {
  static constexpr std::string_view name = "HyperbolicBackfill";
  static constexpr std::string_view formula = "F = y/(1/K_max + R_f y/F_ult); unloads along K_ur; no tension";
  static constexpr std::string_view assumption = "No tension: a gap stays where the wall comes back.";

  /// K_max > 0 N/m: at first loading.
  Required<Stiffness> initial_stiffness;
  /// F_ult > 0 N: passive capacity.
  Required<Force> ultimate_force;
  /// 0 < R_f <= 1.
  double failure_ratio = 0.7;
  /// K_ur >= K_max, N/m; K_max if left out.
  Stiffness unloading_stiffness{};

  /// Regimes of the contact of wall and soil.
  enum class Regime : int { open, elastic, virgin };
  struct State {
    double largest = 0.0;          ///< y_m, m
    Regime regime = Regime::open;  ///< The regime that holds now.

    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr std::array<ReportedQuantity, 1> quantities{{{"soil_gap", "m"}}};
  static constexpr double time_of_rate = 1.0;  ///< s: a rate in a margin
  static constexpr double threshold = 1e-10;   ///< m: round-off must not switch a regime

  /// A backwall of 1.68 m per metre of width, from tests at UCSD, 10 m wide.
  static HyperbolicBackfill typical() {
    using namespace units;
    return {.initial_stiffness = 203 * MN / m, .ultimate_force = 3.26 * MN};
  }

  /// Dense soil behind a wall: K_max = 20.3 MN/m^2 (h/1.68 m) b, F_ult = 326 kN/m (h/1.68 m)^2 b. Other tests and soils
  /// are 1.6 times softer to 1.6 times stiffer. Sources: the tests at UCSD as in typical(); the growth with the height
  /// is that of Caltrans' design criteria, recalled. Throws InputError for a length that is not > 0 m.
  static HyperbolicBackfill behind(const BackfilledWall& wall) {
    using namespace units;
    const Check check{"HyperbolicBackfill::behind", ""};
    check.positive("height", wall.height);
    check.positive("width", wall.width);
    const double tests = wall.height.value() / (1.68 * m), wide = wall.width.value() / (1 * m);
    return {.initial_stiffness = 20.3 * tests * wide * MN / m, .ultimate_force = 326 * tests * tests * wide * kN};
  }

  void check(const Check& check) const {
    check.positive("initial_stiffness", initial_stiffness);
    check.positive("ultimate_force", ultimate_force);
    check.above_up_to("failure_ratio", failure_ratio, 0.0, 1.0, "1", "0.7 to 0.95 is usual.");
    check.that(unloading_stiffness == Stiffness{} || unloading_stiffness.si() >= initial_stiffness.si(),
               "unloading_stiffness", unloading_stiffness.si(), "N/m",
               ">= initial_stiffness = " + to_text(initial_stiffness.si()) + " N/m",
               "A softer line would give back more energy than went in.");
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return {{"initial_stiffness", initial_stiffness.si(), "N/m"},
            {"ultimate_force", ultimate_force.si(), "N"},
            {"failure_ratio", failure_ratio, "1"},
            {"unloading_stiffness", unloading(), "N/m"}};
  }

  Response evaluate(const State& committed, double deformation, double, State& trial) const {
    trial = committed;
    switch (committed.regime) {
      case Regime::open:
        return {};
      case Regime::elastic:
        return {on_line(committed, deformation), unloading(), 0.0};
      case Regime::virgin:
        break;
    }
    trial.largest = deformation;
    const double flexibility = first() + decline() * deformation;
    return {deformation / flexibility, first() / (flexibility * flexibility), 0.0};
  }
  double stored_energy(const State& committed, double deformation) const {
    const double force = committed.regime == Regime::open      ? 0.0
                         : committed.regime == Regime::elastic ? on_line(committed, deformation)
                                                               : envelope(deformation);
    return 0.5 * force * force / unloading();
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    if (committed.regime != Regime::virgin || rate <= 0.0) return 0.0;
    const double force = envelope(deformation), flexibility = first() + decline() * deformation;
    return force * (1.0 - first() / (flexibility * flexibility) / unloading()) * rate;
  }
  double dissipated_energy(const State& from, const State& to) const {
    return dissipated_up_to(to.largest) - dissipated_up_to(from.largest);
  }
  double linear_stiffness(StiffnessStage stage) const {
    return stage == StiffnessStage::initial ? initial_stiffness.si() : 0.0;
  }

  double regime_margin(const State& committed, double deformation, double rate) const {
    switch (committed.regime) {
      case Regime::open:
        return gap(committed) - deformation + threshold;
      case Regime::elastic:
        return std::min(committed.largest - deformation, deformation - gap(committed)) + 2.0 * threshold;
      case Regime::virgin:
        break;
    }
    return rate * time_of_rate;
  }
  State next_regime(const State& committed, double deformation, double) const {
    switch (committed.regime) {
      case Regime::open:
        return {committed.largest, committed.largest > 0.0 ? Regime::elastic : Regime::virgin};
      case Regime::elastic:
        if (deformation < committed.largest - 0.5 * (committed.largest - gap(committed)))
          return {committed.largest, Regime::open};
        return {committed.largest, Regime::virgin};
      case Regime::virgin:
        break;
    }
    return {std::max(deformation, 0.0), deformation > 0.0 ? Regime::elastic : Regime::open};
  }
  ReportedValue quantity(std::size_t, const State& state, double, double rate, double) const {
    const double flexibility = first() + decline() * state.largest;
    return {gap(state),
            state.regime == Regime::virgin ? (1.0 - first() / (flexibility * flexibility) / unloading()) * rate : 0.0};
  }

 private:
  [[nodiscard]] double first() const { return 1.0 / initial_stiffness.si(); }
  [[nodiscard]] double decline() const { return failure_ratio / ultimate_force.si(); }
  [[nodiscard]] double unloading() const {
    return unloading_stiffness.si() > 0.0 ? unloading_stiffness.si() : initial_stiffness.si();
  }
  [[nodiscard]] double envelope(double y) const { return y / (first() + decline() * y); }
  [[nodiscard]] double on_line(const State& state, double y) const {
    return envelope(state.largest) - unloading() * (state.largest - y);
  }
  // Where the line reaches zero.
  [[nodiscard]] double gap(const State& state) const { return state.largest - envelope(state.largest) / unloading(); }
  // The integral of the envelope less the energy that comes back.
  [[nodiscard]] double dissipated_up_to(double y) const {
    if (y <= 0.0) return 0.0;
    const double a = first(), b = decline(), force = envelope(y), x = b * y / a;
    return a / (b * b) * (x - std::log1p(x)) - 0.5 * force * force / unloading();
  }
};

}  // namespace moat
