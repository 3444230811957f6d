#include "analyses/case/run_under_way.hpp"

#include <optional>
#include <utility>

#include "base/error.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "output/recorders/clearance_recorder.hpp"
#include "output/recorders/impact_recorder.hpp"

namespace moat {

void RunUnderWay::run(Transient& transient, const std::function<bool()>& stop) {
  if (!state_.empty()) {
    StateArchive archive{std::exchange(state_, {})};
    transient.archive(archive);
    archive.require_end();
  }
  transient_ = &transient;
  try {
    transient.run(stop);
  } catch (...) {
    transient_ = nullptr;
    throw;
  }
  transient_ = nullptr;
}

void RunUnderWay::archive(StateArchive& archive) {
  StateArchive own;
  if (transient_ != nullptr) transient_->archive(own);
  std::string state = own.take();
  archive(state);
  if (archive.reads()) state_ = std::move(state);
}

PeaksAndImpacts compute_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                              std::initializer_list<StepObserver*> observers, const std::function<bool()>& stop,
                              RunUnderWay* under_way) {
  std::optional<Transient> transient{std::in_place, model, motion, options};
  PeakRecorder peaks{model};
  ImpactRecorder touches{false};
  ClearanceRecorder clearances{model};
  transient->attach(peaks);
  transient->attach(touches);
  transient->attach(clearances);
  for (StepObserver* observer : observers)
    if (observer != nullptr) transient->attach(*observer);
  RunUnderWay alone;
  (under_way == nullptr ? alone : *under_way).run(*transient, stop);
  if (!transient->finished()) throw Error{"it was stopped."};
  PeaksAndImpacts result{
      {}, touches.impacts(), transient->statistics(), clearances.clearances(), transient->collapsed()};
  transient.reset();  // This frees its memory for the peaks.
  result.peaks = peaks.peaks();
  return result;
}

}  // namespace moat
