// Every impact law, one line each.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "materials/any_contact.hpp"
#include "materials/impact_laws.hpp"

namespace moat::testing {

/// A law with e = `requested`, its stiffness in its own SI unit, between two bodies of the given effective mass.
struct ImpactCase {
  std::string name;
  std::function<AnyContact(double stiffness, double requested, double mass)> between;
  /// The restitution it delivers, as an exact function of the one requested.
  std::function<double(double requested)> delivered;
  bool may_pull = false;
  /// Smallest restitution that can be asked for.
  double least = 0.02;

  friend void PrintTo(const ImpactCase& impact, std::ostream* out) { *out << impact.name; }
};

namespace detail {

inline double same_value(double e) { return e; }
inline double elastic(double) { return 1.0; }

// F = k d^1.5 (1 + z d'/v0) with z(e).
inline std::function<double(double)> with_factor(double (*factor)(double)) {
  return [factor](double e) { return restitution_of_viscous_hertz(factor(e)); };
}
// A fraction of critical damping x(e), acting so that the contact delivers restitution(x).
inline std::function<double(double)> with_ratio(double (*restitution)(double), double (*ratio)(double)) {
  return [=](double e) { return restitution(ratio(e)); };
}

inline double equation_4(double e) { return -std::log(e) / std::hypot(std::numbers::pi, std::log(e)); }
inline double mahmoud_jankowski(double e) { return (1 - e * e) / (e * (e * (std::numbers::pi - 2) + 2)); }
// x = 2 xi/sqrt(5), see RootDampedHertz.
inline double jankowski(double e) { return 9 * (1 - e * e) / (e * (e * (9 * std::numbers::pi - 16) + 16)); }
inline double equation_27(double e) { return (1 - e * e) / (5 * e * e); }

template <class Law, class... More>
auto linear(More... more) {
  return [=](double k, double e, double mass) -> AnyContact { return Law{Stiffness{k}, e, more...}.between(mass); };
}
template <class Law, class... More>
auto hertz(More... more) {
  return [=](double k, double e, double mass) -> AnyContact {
    return Law{HertzStiffness{k}, e, more...}.between(mass);
  };
}

}  // namespace detail

inline std::vector<ImpactCase> all_impact_laws() {
  using namespace detail;
  const auto lankarani = [](double e) { return 0.75 * (1 - e * e); };
  const auto hunt = [](double e) { return 1.5 * (1 - e); };
  const auto ye = [](double e) { return 8 * (1 - e) / (5 * e); };
  const auto hu = [](double e) { return 3 * (1 - e) / (2 * e); };
  const auto gonthier = [](double e) { return (1 - e * e) / e; };
  const auto pulling = restitution_of_pulling_contact, clamped = restitution_of_clamped_contact,
             approach = restitution_of_approach_damping;
  return {
      {"LinearElastic", [](double k, double, double m) -> AnyContact { return LinearElastic{Stiffness{k}}.between(m); },
       elastic},
      {"Hertz", [](double k, double, double m) -> AnyContact { return Hertz{HertzStiffness{k}}.between(m); }, elastic},
      {"Kelvin", linear<Kelvin>(), with_ratio(clamped, equation_4)},
      {"KelvinThatPulls", linear<Kelvin>(true), same_value, true},
      {"Anagnostopoulos", linear<Anagnostopoulos>(), with_ratio(clamped, equation_4)},
      {"AnagnostopoulosThatPulls", linear<Anagnostopoulos>(true), same_value, true},
      {"ModifiedLinearViscoelastic", linear<ModifiedLinearViscoelastic>(), with_ratio(approach, mahmoud_jankowski)},
      {"ExactKelvin", linear<ExactKelvin>(), same_value},
      {"ExactKelvinThatPulls", linear<ExactKelvin>(true), same_value, true},
      {"HertzDamp", hertz<HertzDamp>(), with_factor(lankarani)},
      {"HertzDampThatPulls", hertz<HertzDamp>(true), with_factor(lankarani), true},
      {"LankaraniNikravesh", hertz<LankaraniNikravesh>(), with_factor(lankarani)},
      {"HuntCrossley", hertz<HuntCrossley>(), with_factor(hunt)},
      {"Ye2009", hertz<Ye2009>(), with_factor(ye)},
      {"HuGuo", hertz<HuGuo>(), with_factor(hu)},
      {"Gonthier", hertz<Gonthier>(), with_factor(gonthier)},
      {"ModifiedHertzDamp", hertz<ModifiedHertzDamp>(), with_factor(hu)},
      {"ExactHertzDamp", hertz<ExactHertzDamp>(), same_value},
      {"NonlinearViscoelastic", hertz<NonlinearViscoelastic>(), with_ratio(approach, jankowski)},
      {"ModifiedHertzDampPrinted", hertz<ModifiedHertzDampPrinted>(), with_ratio(approach, equation_27)},
      {"ModifiedHertzDampPrintedThroughout", hertz<ModifiedHertzDampPrinted>(ContactDamping::throughout),
       with_ratio(clamped, equation_27)},
      {"ModifiedHertzDampPrintedThatPulls", hertz<ModifiedHertzDampPrinted>(ContactDamping::may_pull),
       with_ratio(pulling, equation_27), true, 0.42},
  };
}

}  // namespace moat::testing
