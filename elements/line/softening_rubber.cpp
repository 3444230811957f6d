#include "elements/line/softening_rubber.hpp"

namespace moat {
namespace {

Bilinear under(const LeadRubberBearing& bearing, Force) {
  return {bearing.yield_force, bearing.yield_displacement, bearing.post_yield_stiffness};
}
Bilinear under(const BearingDesign& design, Force load) { return design.carrying(load); }
Bilinear under(const Bilinear& law, Force) { return law; }

}  // namespace

void SofteningRubber::check(const Check& check) const {
  if (const auto* design = std::get_if<BearingDesign>(&bearing)) {
    design->check(check);
    check.that(design->weight == Force{}, "bearing.weight", design->weight.si(), "N", "left out",
               "Give the weight of the SofteningRubber, which its critical load is compared with.");
  } else {
    under_changing_weight({}).bilinear.check(check);  // of any weight: these laws do not depend on it
  }
  rubber.check(check);
}

std::vector<Parameter> SofteningRubber::parameters() const {
  const auto* design = std::get_if<BearingDesign>(&bearing);
  std::vector<Parameter> list =
      design != nullptr ? design->parameters() : under_changing_weight({}).bilinear.parameters();
  list.push_back({"critical_load", rubber.critical_load().si(), "N"});
  return list;
}

RubberUnderWeight SofteningRubber::under_changing_weight(Force static_weight) const {
  return {
      {std::visit([&](const auto& law) { return under(law, static_weight); }, bearing), rubber, static_weight.si()}};
}

PlanarRubberUnderWeight in_plan_under_changing_weight(const SofteningRubber& bearing, Force static_weight) {
  bearing.check(Check{SofteningRubber::name, ""});
  const Bilinear line = bearing.under_changing_weight(static_weight).bilinear;
  return {{{line.yield_force, line.yield_displacement, line.post_yield_stiffness}, bearing.rubber, static_weight.si()}};
}

}  // namespace moat
