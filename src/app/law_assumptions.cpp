#include "app/law_assumptions.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "elements/line/isolator.hpp"
#include "materials/contact/impact_laws.hpp"
#include "materials/spring_laws.hpp"

namespace moat {

std::vector<std::string> law_assumptions(const ModelFacts& model) {
  std::set<std::string_view> used;
  for (const ElementFacts& element : model.elements) used.insert(element.law);
  std::vector<std::string> sentences;
  const auto add = [&]<class Law>() {
    if (constexpr std::string_view assumption = assumption_of<Law>(); !assumption.empty() && used.contains(Law::name))
      sentences.push_back(std::string{Law::name} + ": " + std::string{assumption});
  };
  AllSpringLaws::for_each(add);
  AllSpringLaws::for_each([&]<class Law>() {
    if constexpr (BearsChangingWeight<Law>) {
      const auto is_constant = [](const ElementFacts& element) {
        return element.law == Law::name &&
               std::ranges::count(element.parameters, "static_weight", &ParameterFacts::name) == 0;
      };
      if (std::ranges::any_of(model.elements, is_constant))
        sentences.push_back(std::string{Law::name} + ": The weight on it is constant; neither vertical motion nor " +
                            "overturning acts.");
    }
  });
  AllImpactLaws::for_each(add);
  std::set<std::string_view> silent;
  for (const ElementFacts& element : model.elements)
    if (std::ranges::all_of(element.parameters, [](const ParameterFacts& each) { return each.name == "clearance"; }))
      silent.insert(element.law);
  for (const std::string_view law : silent)
    sentences.push_back(std::string{law} + ": a law of the script. It lists no parameters(), so results lack them.");
  return sentences;
}

}  // namespace moat
