#include "structures/static_weights.hpp"

#include <cmath>

#include "base/units.hpp"
#include "model/weight/axial_distribution.hpp"

namespace moat {

std::vector<Force> static_weights(const Check& check, const AxialForces& options,
                                  const std::vector<BearingPlace>& bearings, Force weight, PlanVector centre,
                                  bool in_plan) {
  using Span = AxialDistribution::Span;
  int count = 0;
  for (const BearingPlace& bearing : bearings) count += bearing.count;
  const auto all_or_none = [&](const char* field, auto value) {
    int given = 0;
    for (const BearingPlace& bearing : bearings)
      if ((bearing.*value).si() > 0.0) given += bearing.count;
    check.that(given == 0 || given == count,
               "axial_forces: " + std::to_string(given) + " of " + std::to_string(count) + " bearings have a " + field +
                   " of their own.",
               std::string{"Give the "} + field + " of every bearing, or of none.");
    return given > 0;
  };
  const bool given = all_or_none("weight", &BearingPlace::own_weight);
  const bool stiff = all_or_none("vertical_stiffness", &BearingPlace::vertical_stiffness);
  std::vector<Force> weights;
  std::vector<PlanVector> places;
  std::vector<double> stiffnesses;
  Force sum{};
  for (const BearingPlace& bearing : bearings) {
    check.not_negative("weight of a bearing", bearing.own_weight);
    check.not_negative("vertical_stiffness of a bearing", bearing.vertical_stiffness);
    weights.push_back(given ? bearing.own_weight : double(bearing.count) / count * weight);
    sum += weights.back();
    places.push_back(bearing.at);
    stiffnesses.push_back(stiff ? bearing.vertical_stiffness.si() : bearing.count);
  }
  check.that(std::abs((sum - weight).si()) <= 1e-6 * weight.si(), "axial_forces: the weights on its bearings", sum.si(),
             "N", "that of its floors and base, " + to_text(weight.si()) + " N",
             "Leave them out to share it, or correct the masses.");
  check.that(carries_moments(places, in_plan ? Span::plan : Span::line),
             in_plan ? "axial_forces: all bearings stand in a row, and cannot carry a moment about it."
                     : "axial_forces: all bearings stand at one position, and cannot carry a moment.",
             in_plan ? "Give bearings beside that row." : "Give isolators at two positions (.at) at least.");
  if (given || options.shares == AxialForces::Shares::equal) return weights;
  const std::vector<double> balanced =
      balanced_shares(places, stiffnesses, weight.si(), centre, in_plan ? Span::plan : Span::line);
  for (std::size_t i = 0; i < balanced.size(); ++i) {
    check.that(balanced[i] > 0.0,
               "axial_forces: bearing " + std::to_string(i + 1) + " would be pulled at rest, by " +
                   to_text(-balanced[i]) + " N: the centre of mass is at (" + to_text(centre.x) + ", " +
                   to_text(centre.y) + ") m.",
               "Move bearings, or give the weight on each.");
    weights[i] = balanced[i] * units::N;
  }
  return weights;
}

void check_axial_forces(const Check& check, const AxialForces& options, bool heights_are_given) {
  check.that(heights_are_given, "axial_forces are asked, and storey_height is left out.",
             "Give the heights of its storeys: overturning follows them.");
  check.not_negative("axial_forces.base_height", options.base_height);
  check.not_negative("axial_forces.may_pull", options.may_pull);
  const double period = options.vertical_period.si(), damping = options.vertical_damping;
  check.that(period == 0.0 || (period >= 0.01 && period <= 1.0), "axial_forces.vertical_period", period, "s",
             ">= 0.01 and <= 1", "Leave it out: the building then moves vertically with the ground.");
  check.that(damping >= 0.0 && damping < 1.0, "axial_forces.vertical_damping", damping, "1", ">= 0 and < 1");
  check.that(damping == 0.0 || period > 0.0, "axial_forces.vertical_damping is given without vertical_period.",
             "Give the period of the vertical mode, or leave the damping out.");
}

}  // namespace moat
