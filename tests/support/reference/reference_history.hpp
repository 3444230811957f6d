// An independent program for pounding: explicit Runge-Kutta steps, events by bisection, no code of moat.
#pragma once

#include <string>
#include <vector>

#include "plain_model.hpp"

namespace moat::testing {

struct ReferenceOptions {
  /// Longest step times the fastest frequency of the current regimes.
  double largest_phase = 0.05;
  /// Error of one step in displacement and velocity of a node, relative to its largest so far.
  double tolerance = 1e-10;
};

struct ReferencePeak {
  std::string quantity, where;
  double value = 0.0;  ///< largest magnitude over continuous time, SI
  double time = 0.0;   ///< s
};

struct ReferenceTouch {
  std::string gap;
  double time = 0.0;            ///< s
  double approach_speed = 0.0;  ///< m/s
};

struct ReferenceResult {
  std::vector<ReferencePeak> peaks;
  std::vector<ReferenceTouch> touches;
  std::vector<double> displacement, velocity;  ///< of the nodes at the end
};

/// Dormand and Prince's fifth-order method in steps that end on the samples of the motion and on every event: touch,
/// end of contact, opening, reload, yield, unloading, and the turn of contacts that are damped in approach only. An
/// event is located by bisecting the length of the step that ends there, to round-off. After it the steps begin very
/// short, because forces may rise with infinite slope. Peaks are those of the cubics through value and rate at both
/// ends of every step.
ReferenceResult reference_history(const PlainModel& model, const ReferenceOptions& options = {});

/// The reference with the estimate of its own error.
struct CheckedReference {
  ReferenceResult result;            ///< of the finer run
  std::vector<double> peak_changes;  ///< relative, from a run with twice the steps and 32 times the tolerance
  bool same_touches = true;          ///< both runs saw the same gaps touch in the same order
  double largest_change = 0.0;       ///< of the peaks that count; see `counting_peaks`

  [[nodiscard]] bool settled(double relative) const { return same_touches && largest_change <= relative; }
};

/// Runs the reference twice.
CheckedReference checked_reference(const PlainModel& model, const ReferenceOptions& options = {});

/// For each peak, whether it counts in comparisons: those of at least a thousandth of the largest peak of their
/// quantity in the model.
std::vector<bool> counting_peaks(const std::vector<ReferencePeak>& peaks);

}  // namespace moat::testing
