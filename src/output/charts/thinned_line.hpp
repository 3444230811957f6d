// Thinning a line for drawing without a visible change.
#pragma once

#include <vector>

#include "output/charts/svg_writer.hpp"

namespace moat {

/// Thins the line through finite points, where it has more than `most` of them.
///
/// Where x never decreases, each column of pixels keeps its first smallest and its first largest y in the order they
/// occur, so that every peak survives, and the first and last point of the line: about 2 points per pixel. Any other
/// line (a loop) keeps the points without which it would move by more than a quarter of a pixel.
std::vector<Pixel> thinned_line(const std::vector<Pixel>& points, std::size_t most);

}  // namespace moat
