// Every law of AllImpactLaws as the tests of all laws try it.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "expected_restitution.hpp"
#include "moat.hpp"

namespace moat::testing {

/// Stiffness or HertzStiffness.
template <class Law>
using StiffnessOf = std::remove_cvref_t<decltype(std::declval<Law>().stiffness.value())>;

/// A law with its stiffness in its own SI unit and a restitution; one that is given by a damping ratio gets that of
/// Kelvin, and one that needs an indentation 2 cm.
template <class Law>
Law impact_law(double stiffness, double restitution) {
  const StiffnessOf<Law> k{stiffness};
  if constexpr (requires { Law{.stiffness = k, .restitution = restitution, .expected_indentation = Length{0.02}}; })
    return Law{.stiffness = k, .restitution = restitution, .expected_indentation = Length{0.02}};
  else if constexpr (requires { Law{.stiffness = k, .restitution = restitution}; })
    return Law{.stiffness = k, .restitution = restitution};
  else if constexpr (requires { Law{.stiffness = k, .damping_ratio = 0.0}; })
    return Law{.stiffness = k, .damping_ratio = ratio_of_equation_4(restitution)};
  else
    return Law{.stiffness = k};
}

/// The restitution that a law must deliver for a mass, kg, and a speed, m/s; most laws deliver the same for all.
template <class Law>
double delivered_by(const Law& law, [[maybe_unused]] double mass, [[maybe_unused]] double speed) {
  if constexpr (requires { expected_restitution(law, mass, speed); })
    return expected_restitution(law, mass, speed);
  else
    return expected_restitution(law);
}

/// A law, in one of the ways in which its contact can act.
struct ImpactCase {
  std::string name;
  std::function<AnyContact(double stiffness, double restitution, double mass)> between;
  std::function<double(double stiffness, double restitution, double mass, double speed)> delivered;
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
          [law](double k, double e, double mass, double speed) {
            Law given = law(k, e);
            if constexpr (requires { given.restitution; }) given.restitution = given.restitution.value().at(speed);
            return delivered_by(given, mass, speed);
          },
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
    if constexpr (requires(Law law) { law.restitution; }) {
      cases.push_back(impact_case<Law>("ThatFalls", false, [](Law& law) {
        law.restitution = FallingRestitution{.restitution = e_of(law), .at_speed = Speed{0.3}, .largest = 1.0};
      }));
    }
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
