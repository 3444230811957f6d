// How the peaks of a case move when its contacts change.
#pragma once

#include <cstdint>
#include <functional>

#include "analyses/case/error_bars.hpp"
#include "output/files/contact_sensitivity.hpp"

namespace moat {

/// When a run is followed by runs with changed contacts.
enum class ContactSensitivityMode : std::uint8_t {
  automatic,  ///< where their steps times elements are few (contact_sensitivity_is_cheap)
  always,
  never,
};

/// Whether so many runs of this model, each of which takes `solves` steps or Newton iterations, evaluate few enough
/// elements for the default: 2e6 together.
bool contact_sensitivity_is_cheap(const Model& model, double solves, std::size_t runs);

/// The runs with changed contacts up to now, for checkpoints.
struct ContactRuns {
  ContactSensitivity finished{};  ///< With the first `count` changes.
  std::size_t count = 0;          ///< Number of runs that have ended.
  RunUnderWay under_way{};        ///< The next one.

  void archive(auto& archive) { archive(finished, count, under_way); }  ///< StateArchive.
};

/// Runs the model with changed contacts (model/with_contacts.hpp), one change at a time for all contacts
/// together: stiffness / 3 and x 3, restitution - 0.1 and + 0.1, clearance - 10 % and + 10 %, and soil / 1.6 and x 1.6
/// where there is soil. Only parameters that the model has are changed. The motion and the options are those of the
/// main run; peaks alone are kept.
///
/// Without an impact in the main run, stiffness and restitution change nothing. If no gap came nearer to closing than
/// 90 % of its clearance, no run is made, because a clearance that stays open has no part in the motion: the reason
/// says how much smaller it may be. Otherwise the clearance - 10 % is run alone.
///
/// `main` has the peaks of the main run without errors. A changed run that fails has its reason. observer: gets every
/// step of these runs; null for none. stop: as for compute_peaks(). runs: has those that were made, which are not made
/// again.
ContactSensitivity contact_sensitivity(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                                       ContactSensitivityMode mode, const PeaksAndImpacts& main,
                                       StepObserver* observer = nullptr, const std::function<bool()>& stop = {},
                                       ContactRuns* runs = nullptr);

}  // namespace moat
