#include "analyses/questions/property_bounds.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moat {
namespace {

constexpr double of_ageing = 0.75;

}  // namespace

void check_factors(const PropertyBounds& bounds) {
  const Check check{"PropertyBounds", ""};
  check.above_up_to("lower.strength", bounds.lower.strength, 0.0, 1.0, "1");
  check.above_up_to("lower.stiffness", bounds.lower.stiffness, 0.0, 1.0, "1");
  const auto at_least_one = [&](std::string_view field, double factor) {
    check.between(field, factor, 1.0, 10.0, "1", "The nominal properties lie between the bounds.");
  };
  at_least_one("upper.strength", bounds.upper.strength);
  at_least_one("upper.stiffness", bounds.upper.stiffness);
}

double PropertyBounds::asce_7_upper(const Lambda& lambda, bool qualified_by_tests) {
  constexpr double least = 1.8;
  const double product = (1.0 + of_ageing * (lambda.ageing - 1.0)) * lambda.test * lambda.specification;
  return qualified_by_tests ? product : std::max(product, least);
}

double PropertyBounds::asce_7_lower(const Lambda& lambda, bool qualified_by_tests) {
  constexpr double most = 0.6;
  const double product = (1.0 - of_ageing * (1.0 - lambda.ageing)) * lambda.test * lambda.specification;
  return qualified_by_tests ? product : std::min(product, most);
}

const BoundedResult::Governing& BoundedResult::governing(const std::string& quantity, const std::string& where) const {
  const auto found = std::ranges::find_if(
      envelope, [&](const Governing& each) { return each.peak.quantity == quantity && each.peak.where == where; });
  if (found == envelope.end())
    throw InputError{"BoundedResult: there is no peak " + quantity + " at \"" + where + "\"."};
  return *found;
}

BoundedResult run_bounds(const PropertyBounds& bounds, const std::function<Model(const PropertyFactors&)>& model_with,
                         const GroundMotion& motion, const CaseOptions& options) {
  check_factors(bounds);
  BoundedResult result;
  const std::array<PropertyFactors, 3> factors{PropertyFactors{}, bounds.lower, bounds.upper};
  for (std::size_t i = 0; i < factors.size(); ++i) {
    Model model = model_with(factors[i]);
    result.cases[i] = run_case(model, motion, options);
    for (const Peak& peak : result.cases[i].peaks) {
      const auto known = std::ranges::find_if(result.envelope, [&](const BoundedResult::Governing& each) {
        return each.peak.quantity == peak.quantity && each.peak.where == peak.where;
      });
      if (known == result.envelope.end())
        result.envelope.push_back({peak, BoundedResult::names[i]});
      else if (peak.magnitude() > known->peak.magnitude())
        *known = {peak, BoundedResult::names[i]};
    }
  }
  return result;
}

}  // namespace moat
