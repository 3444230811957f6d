// Thinning a curve for drawing without a visible change.
#pragma once

#include <vector>

namespace moat {

/// Points of a curve.
struct Curve {
  std::vector<double> x, y;  ///< of equal length
};

/// Thins a curve for a picture of `width` x `height` pixels (both > 0); x and y of equal length, finite.
///
/// Where x never decreases, each column of pixels keeps its first smallest and its first largest y in the order they
/// occur, so that every peak survives, and the first and last point of the curve: about 2 points per pixel. Any other
/// curve (a loop) keeps the points without which it would move by more than a quarter of a pixel (Ramer, Douglas and
/// Peucker). A curve of at most 2 * width points comes back unchanged.
Curve thin_out(const Curve& curve, int width, int height);

}  // namespace moat
