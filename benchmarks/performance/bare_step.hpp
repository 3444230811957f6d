// The least that a history of one building can cost: everything in one loop, no library.
#pragma once

#include <vector>

#include "motions/ground_motion.hpp"

namespace moat::performance {

struct BareHistory {
  long steps = 0, solves = 0, newton_iterations = 0, factorisations = 0, events = 0;
  /// Peaks in the order of Channels (output/channels.hpp).
  std::vector<double> peaks;
  /// Rows at the motion's interval: time, ground acceleration, all channels, six energies.
  std::vector<double> rows;
  double largest_input = 0.0, largest_kinetic = 0.0;  ///< energies, J
  double integration_error = 0.0;                     ///< work less what was stored and dissipated, J
};

/// The five-storey building of the first tour in its moat of 10 cm, computed as Transient with a fixed step computes
/// it and recorded as CaseRun records it, but written for this one building:
///
///   - Newmark's average acceleration in accelerations, Newton until the forces balance to 1e-10 of the largest;
///   - one bilinear bearing, two Hertz-damp gaps, touches and separations located to 1e-12 m by solving again;
///   - factors L D L^T without fill, kept while the tangent is the same;
///   - work and dissipation of every element in every step, peaks of all channels with their vertices between steps,
///     histories with energies.
///
/// step: s, > 0, a whole fraction of the motion's interval.
BareHistory bare_history(const GroundMotion& motion, double step);

}  // namespace moat::performance
