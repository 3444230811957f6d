// A rubber bearing in plan under a weight that changes.
#pragma once

#include "materials/plan/biaxial_bilinear.hpp"
#include "materials/rubber_under_weight.hpp"

namespace moat {

/// RubberUnderWeight in plan: k_2 is the same in all directions, and q that of BiaxialBilinear. P_cr belongs to the
/// smallest overlap so far, at the ends of steps. A round bearing has it at the largest resultant, a rectangle at both
/// components of one instant. Where it begins and ends to fall is not located in plan.
struct PlanarRubberUnderWeight : SofteningLaw<BiaxialBilinear, PlanVector> {
  static constexpr std::string_view name = "PlanarRubberUnderWeight";

  PlanarAxialResponse evaluate(const State& committed, PlanVector deformation, PlanVector rate, double interval,
                               AxialForce axial, State& trial) const {
    const auto overlap = [&](PlanVector d) { return rubber.overlap(d.x * units::m, d.y * units::m); };
    PlanarAxialResponse response{bilinear.evaluate(committed.yielding, deformation, rate, interval, trial.yielding)};
    trial.grows = overlap(deformation) <= overlap(committed.farthest);
    trial.farthest = trial.grows ? deformation : committed.farthest;
    trial.compression = axial.compression;
    const AxialSoftening softening = at(trial);
    const double change = k_20() * (softening.factor - 1.0);
    const PlanVector by_deformation = k_20() * deformation;
    response.force += change * deformation;
    response.stiffness = response.stiffness + PlanMatrix::diagonal(change);
    if (trial.grows)
      response.stiffness = response.stiffness + PlanMatrix::product(by_deformation, softening.by_displacement);
    response.force_rate += change * rate + fall(trial, softening.by_displacement, rate) * by_deformation;
    response.by_compression = response.rate_by_compression = softening.by_compression * by_deformation;
    return response;
  }
};

}  // namespace moat
