// Charts side by side on a page.
#pragma once

#include <string>
#include <vector>

#include "output/charts/chart.hpp"

namespace moat::html {

/// Every chart as a picture of its own, `width` by `height` pixels: side by side where there is room, below each other
/// on a phone, where letters of one wide picture could not be read.
std::string chart_grid(const std::vector<Chart>& charts, int width, int height);

/// A picture as wide as the page; on a phone it keeps a readable size and scrolls sideways.
std::string wide_picture(const std::string& svg);

}  // namespace moat::html
