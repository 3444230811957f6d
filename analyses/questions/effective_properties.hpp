// Effective stiffness and damping of a loop.
#pragma once

#include <span>

namespace moat {

/// Effective stiffness k = (|F+| + |F-|)/(|D+| + |D-|) and damping ratio beta = E/(2 pi k D^2), D = (|D+| + |D-|)/2, of
/// one closed loop with the area E; D+ and D- are its extreme deformations, F+ and F- the forces there.
///
/// For a bilinear loop k = k2 + Q/D and beta = 2 Q (D - d_y)/(pi k D^2). Source: ASCE/SEI 7, chapter 17 (recalled).
struct EffectiveProperties {
  double stiffness = 0.0;      ///< N/m
  double damping_ratio = 0.0;  ///< 1
  double amplitude = 0.0;      ///< D, m
};

/// Returns the properties of a loop of points in the order of time, m and N; the last point is joined to the first. The
/// area is that of the polygon: give some hundred points. Throws InputError for fewer than three points, different
/// numbers of both, or a loop that has no width.
EffectiveProperties effective_properties(std::span<const double> deformations, std::span<const double> forces);

}  // namespace moat
