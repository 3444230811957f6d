// Inputs and results of analyses that the design sheets of all codes take.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyses/questions/property_bounds.hpp"
#include "base/quantity.hpp"
#include "base/required.hpp"
#include "elements/line/lead_rubber_bearing.hpp"
#include "materials/isolation/friction_pendulum.hpp"
#include "model/plan_outline.hpp"

namespace moat {

/// The loop of all isolators together, as two lines.
///
///     F |        ___---  k_2      F = (Q/d_y + k_2) d up to d_y, then Q + k_2 d
///       |  ___---                 K = F/d, secant stiffness
///     Q | /                       beta = 2 Q (d - d_y)/(pi K d^2), equivalent viscous damping
///       |/_______________ d
///        d_y
struct IsolationLoop {
  /// Q > 0 N: the force at zero displacement after yield.
  Required<Force> characteristic_strength;
  /// k_2 > 0 N/m.
  Required<Stiffness> post_yield_stiffness;
  /// d_y > 0 m.
  Required<Length> yield_displacement;

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const;
  /// Q and k_2 times these factors; d_y stays.
  [[nodiscard]] IsolationLoop times(const PropertyFactors& factors) const;
  [[nodiscard]] Force yield_force() const;                     ///< Q + k_2 d_y
  [[nodiscard]] Force force(Length displacement) const;        ///< F on the monotone way out; displacement > 0 m.
  [[nodiscard]] Stiffness stiffness(Length amplitude) const;   ///< K = F/d; amplitude > 0 m.
  [[nodiscard]] double damping_ratio(Length amplitude) const;  ///< beta; 0 for an amplitude of at most d_y.
};

/// Laws with a yield force, a yield displacement and a stiffness after yield: Bilinear, BoucWen, LeadRubberBearing.
template <class Law>
concept YieldingLaw = requires(const Law& law) {
  { law.yield_force.value() } -> std::convertible_to<Force>;
  { law.yield_displacement.value() } -> std::convertible_to<Length>;
  { law.post_yield_stiffness.value() } -> std::convertible_to<Stiffness>;
};

/// The isolators of a sheet: a loop, or a law from which it follows. Numbers are those of all isolators together.
class SheetIsolation {
 public:
  SheetIsolation(IsolationLoop loop);    ///< The loop itself.
  SheetIsolation(BearingDesign design);  ///< Under the weight of the sheet, unless it has its own.
  SheetIsolation(FrictionPendulum law);  ///< Q = mu W at high speed and k_2 = W/R, likewise.
  /// Q = F_y - k_2 d_y.
  template <YieldingLaw Law>
  SheetIsolation(const Law& law)
      : SheetIsolation{
            IsolationLoop{law.yield_force.value() - law.post_yield_stiffness.value() * law.yield_displacement.value(),
                          law.post_yield_stiffness.value(), law.yield_displacement.value()}} {}

  /// The loop under this weight. Throws InputError for a bad parameter.
  [[nodiscard]] IsolationLoop under(Force weight, const Check& check) const;

 private:
  std::function<IsolationLoop(Force weight, const Check& check)> loop_;
};

/// A floor above the isolators.
struct SheetFloor {
  /// w > 0 N, of the floor with its share of storeys.
  Force weight{};
  /// h > 0 m, above the base level.
  Length height{};
};

/// Results of histories for one set of isolator properties, each zero where there is none.
struct SuiteValues {
  Length displacement{};         ///< Isolators at the centre of mass, >= 0 m; in plan the resultant.
  Length corner_displacement{};  ///< Resultant of the corner that moves most, with accidental eccentricity, >= 0 m.
  Force base_shear{};            ///< Through all isolators, >= 0 N; in plan the smaller of x and y, for minima.
  Force storey_shear{};          ///< First storey above the base, not reduced, >= 0 N; in plan as base_shear.
  double drift = 0.0;            ///< Largest drift over height of the storey, >= 0.
  std::size_t touching = 0;      ///< Records with an impact.
};

/// Results of a suite of histories that a sheet compares with its minima: the mean, or the largest of few.
struct SuiteForSheet {
  std::string statistic;                    ///< "mean of 7 records"
  SuiteValues lower{}, nominal{}, upper{};  ///< by bound
  /// Whether base_shear has the forces of impacts too, which are not those of the isolators.
  bool base_shear_has_impacts = false;
  std::vector<std::string> scaling{};  ///< ScaledSuite::description(), for the notes of the sheet.
};

/// A building on isolators, as the design sheets of all codes take it.
struct SheetBuilding {
  std::string name{};  ///< The title of the sheet has it.
  /// W > 0 N, of everything on the isolators, with the base level.
  Required<Force> weight;
  /// From the first above the base upwards. The sum of their weights is W_s <= W.
  std::vector<SheetFloor> floors{};
  /// All isolators together.
  Required<SheetIsolation> isolation;
  /// Factors of lower and upper bounds.
  PropertyBounds bounds{};
  /// b > 0 m and d >= b m: the sides of the plan.
  Required<Length> shorter_side, longer_side;
  /// Places of all isolators, which are taken as alike. Distances count from their centre.
  std::vector<PlanPosition> bearings{};
  /// Distance from the centre of mass to that of the isolators, >= 0 m; 5 % of d are added to it.
  Length eccentricity{};
  /// y > 0 m, from the centre of the isolators to the corner, across the load; 0: d/2.
  Length corner_distance{};
  /// T_fb > 0 s, of the superstructure on a fixed base.
  Required<Time> fixed_base_period;
  /// Free distance to the moat wall or the neighbour, >= 0 m.
  std::optional<Length> clearance{};
  /// Results of histories.
  std::optional<SuiteForSheet> suite{};

  /// Throws InputError for a parameter outside its range.
  void check(const Check& check) const;
};

}  // namespace moat
