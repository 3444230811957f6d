// Every law of AllImpactLaws as the tests of all laws try it.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/quantity.hpp"
#include "materials/any_contact.hpp"
#include "materials/impact_laws.hpp"
#include "materials/restitution_formulas.hpp"

namespace moat::testing {

// Exact forms of the damping, written from the sources of the laws and not from their headers.

// F = k d^1.5 (1 + z d'/v0).
inline double by_factor(double z) { return restitution_of_viscous_hertz(z); }
// c = 2 xi sqrt(k m) beside a linear spring.
inline double by_ratio(double xi, bool may_pull) {
  return may_pull ? restitution_of_pulling_contact(xi) : restitution_of_clamped_contact(xi);
}
inline double ratio_of_equation_4(double e) { return -std::log(e) / std::hypot(std::numbers::pi, std::log(e)); }

/// The restitution that a law delivers in a free impact. A law of the list without a line here does not compile.
inline double expected_restitution(const Hertz&) { return 1.0; }
inline double expected_restitution(const HertzDamp& law) {
  return by_factor(3.0 / 4.0 * (1.0 - std::pow(law.restitution, 2)));
}
inline double expected_restitution(const HuntCrossley& law) { return by_factor(3.0 / 2.0 * (1.0 - law.restitution)); }
inline double expected_restitution(const Gonthier& law) {
  return by_factor((1.0 - std::pow(law.restitution, 2)) / law.restitution);
}
inline double expected_restitution(const Ye2009& law) {
  return by_factor(8.0 * (1.0 - law.restitution) / (5.0 * law.restitution));
}
inline double expected_restitution(const HuGuo& law) {
  return by_factor(3.0 * (1.0 - law.restitution) / (2.0 * law.restitution));
}
inline double expected_restitution(const ExactHertzDamp& law) { return law.restitution; }
inline double expected_restitution(const NonlinearViscoelastic& law) {
  const double e = law.restitution;
  return restitution_of_approach_damping(9.0 * (1.0 - e * e) / (e * (e * (9.0 * std::numbers::pi - 16.0) + 16.0)));
}
inline double expected_restitution(const ModifiedHertzDampPrinted& law) {
  const double x = (1.0 - std::pow(law.restitution, 2)) / (5.0 * std::pow(law.restitution, 2));  // 2 xi/sqrt(5)
  return law.approach_only ? restitution_of_approach_damping(x) : by_ratio(x, law.may_pull);
}
inline double expected_restitution(const LinearElastic&) { return 1.0; }
inline double expected_restitution(const Kelvin& law) {
  return by_ratio(ratio_of_equation_4(law.restitution), law.may_pull);
}
inline double expected_restitution(const KelvinByDampingRatio& law) {
  return by_ratio(law.damping_ratio, law.may_pull);
}
inline double expected_restitution(const ModifiedLinearViscoelastic& law) {
  const double e = law.restitution;
  return restitution_of_approach_damping((1.0 - e * e) / (e * (e * (std::numbers::pi - 2.0) + 2.0)));
}
inline double expected_restitution(const ExactKelvin& law) { return law.restitution; }

/// Stiffness or HertzStiffness.
template <class Law>
using StiffnessOf = std::remove_cvref_t<decltype(std::declval<Law>().stiffness.value())>;

/// A law with its stiffness in its own SI unit and a restitution; one that is given by a damping ratio gets that of
/// Kelvin.
template <class Law>
Law impact_law(double stiffness, double restitution) {
  const StiffnessOf<Law> k{stiffness};
  if constexpr (requires { Law{.stiffness = k, .restitution = restitution}; })
    return Law{.stiffness = k, .restitution = restitution};
  else if constexpr (requires { Law{.stiffness = k, .damping_ratio = 0.0}; })
    return Law{.stiffness = k, .damping_ratio = ratio_of_equation_4(restitution)};
  else
    return Law{.stiffness = k};
}

/// A law, in one of the ways in which its contact can act.
struct ImpactCase {
  std::string name;
  std::function<AnyContact(double stiffness, double restitution, double mass)> between;
  std::function<double(double restitution)> delivered;
  /// Whether the law can be given this restitution.
  std::function<bool(double restitution)> accepts;
  bool may_pull = false;

  friend void PrintTo(const ImpactCase& impact, std::ostream* out) { *out << impact.name; }
};

template <class Law>
ImpactCase impact_case(const std::string& way, bool may_pull, void (*set)(Law&)) {
  const auto law = [set](double stiffness, double restitution) {
    Law made = impact_law<Law>(stiffness, restitution);
    set(made);
    return made;
  };
  return {std::string{Law::name} + way,
          [law](double k, double e, double mass) { return AnyContact{law(k, e).between(mass)}; },
          [law](double e) { return expected_restitution(law(1e9, e)); },
          [law](double e) {
            try {
              law(1e9, e).check(Check{"law", ""});
              return true;
            } catch (const InputError&) {
              return false;
            }
          },
          may_pull};
}

inline std::vector<ImpactCase> all_impact_cases() {
  std::vector<ImpactCase> cases;
  AllImpactLaws::for_each([&]<class Law>() {
    cases.push_back(impact_case<Law>("", false, [](Law&) {}));
    constexpr bool chooses_damping = requires(Law law) { law.approach_only; };
    if constexpr (chooses_damping) {
      cases.push_back(impact_case<Law>("Throughout", false, [](Law& law) { law.approach_only = false; }));
    }
    if constexpr (requires(Law law) { law.may_pull; }) {
      cases.push_back(impact_case<Law>("ThatPulls", true, [](Law& law) {
        law.may_pull = true;
        if constexpr (chooses_damping) law.approach_only = false;
      }));
    }
  });
  return cases;
}

}  // namespace moat::testing
