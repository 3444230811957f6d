// Peaks of bodies that nothing connects.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "analyses/transient_options.hpp"
#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "output/case_result.hpp"
#include "output/step_observer.hpp"

namespace moat {

/// The bodies of a model that nothing connects (Model::unconnected_bodies), each with an analysis of its own.
///
/// In an analysis of the whole model all bodies share their steps: those of a contact, for example, make all others
/// more accurate too, and the last digits of a body's peaks depend on its company. Its own analysis has the steps that
/// it would have alone, so that no other body changes its peaks.
class UnconnectedBodies {
 public:
  /// Copies the bodies of a model, which is prepared here; nothing where all of it is connected.
  explicit UnconnectedBodies(Model& model);

  /// 0, or two and more.
  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  /// Runs every body once and replaces the peaks and clearances of an analysis of the whole model by those of the
  /// bodies. The observer, if any, gets every step of every body. stop: as in compute_peaks(). Throws as it does;
  /// peaks and clearances then stay as they were.
  void replace(std::vector<Peak>& peaks, std::vector<GapClearance>& clearances, const GroundMotion& motion,
               const TransientOptions& options, StepObserver* observer = nullptr,
               const std::function<bool()>& stop = {});

 private:
  std::vector<Model> bodies_;
};

}  // namespace moat
