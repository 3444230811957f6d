// The part of a series that a chart draws.
#pragma once

#include "output/charts/chart.hpp"
#include "output/charts/envelope.hpp"

namespace moat {

/// The points inside the x range, thinned for a plot area of `width` x `height` pixels. Throws as svg_text does.
Curve drawn_curve(const Chart& chart, const Series& series, int width, int height);

}  // namespace moat
