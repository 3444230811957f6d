// Angles of incidence and accidental eccentricities: questions to every model in plan.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analyses/questions/study.hpp"
#include "motions/plan_motion.hpp"

namespace moat {

/// The largest value of one result over the cases of a study.
struct EnvelopeEntry {
  std::string quantity, where, unit;  ///< As in Peak.
  double value = 0.0;                 ///< In `unit`.
  std::string at;                     ///< the case that reached it: "incidence = 30 deg"
};

/// All cases of a study and the largest of every result.
struct EnvelopeStudy {
  StudyResult cases;                    ///< One for every angle.
  std::vector<EnvelopeEntry> envelope;  ///< Largest value of every peak over the angles.

  /// Throws InputError for an unknown result.
  [[nodiscard]] const EnvelopeEntry& largest(std::string_view quantity, std::string_view where) const;
};

/// Peaks of the model for angles of incidence 0, step, 2 step ... below 360 degrees, added to that of the motion, on
/// all cores. 180 degrees would do for models, moats and motions with such symmetries only.
///
///     const EnvelopeStudy study = incidence_study(model, PlanMotion{fault_normal, fault_parallel});
///     study.largest("corner_displacement", "base").at;    // "incidence = 45 deg"
///
/// Throws InputError unless 360 degrees are a whole multiple of the step, > 0; StudyError if a case failed.
EnvelopeStudy incidence_study(const Model& model, const PlanMotion& motion, Angle step = 15.0 * units::deg,
                              const StudyOptions& options = {});

/// Peaks of a building for the four cases of accidental eccentricity and without: `make` builds the model with all
/// centres of mass moved by these shares of its extent along x and y.
///
///     const EnvelopeStudy study = eccentricity_study([&](PlanVector share) {
///       Model model;
///       const auto tower = add(model, with_eccentricity(building, share.x, share.y));
///       add(model, PlanMoat{.around = tower.base, ...});
///       return model;
///     }, motion);
///
/// `share` > 0 is 5 % by default. `make` is called from several threads at once. Throws InputError for a share that is
/// not > 0; StudyError if a case failed.
EnvelopeStudy eccentricity_study(const std::function<Model(PlanVector)>& make, const GroundMotion& motion,
                                 double share = 0.05, const StudyOptions& options = {});

}  // namespace moat
