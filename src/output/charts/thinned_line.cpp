#include "output/charts/thinned_line.hpp"

#include <algorithm>
#include <cmath>

namespace moat {
namespace {

std::vector<Pixel> thinned_history(const std::vector<Pixel>& points) {
  std::vector<Pixel> kept{points.front()};
  const auto column = [](const Pixel& point) { return std::floor(point.x); };
  for (auto first = points.begin(), last = first; first != points.end(); first = last) {
    last = std::find_if(first, points.end(), [&](const Pixel& each) { return column(each) != column(*first); });
    const auto [lowest, highest] =
        std::minmax({std::min_element(first, last, [](const Pixel& a, const Pixel& b) { return a.y < b.y; }),
                     std::max_element(first, last, [](const Pixel& a, const Pixel& b) { return a.y < b.y; })});
    kept.push_back(*lowest);
    if (highest != lowest) kept.push_back(*highest);
  }
  kept.push_back(points.back());
  return kept;
}

/// From a point to a segment, not to its line: a loop returns to where it started.
double squared_distance(const Pixel& point, const Pixel& begin, const Pixel& end) {
  const double dx = end.x - begin.x, dy = end.y - begin.y, px = point.x - begin.x, py = point.y - begin.y;
  const double length_squared = dx * dx + dy * dy;
  const double along = length_squared > 0.0 ? std::clamp((px * dx + py * dy) / length_squared, 0.0, 1.0) : 0.0;
  const double x = px - along * dx, y = py - along * dy;
  return x * x + y * y;
}

std::vector<Pixel> thinned_loop(const std::vector<Pixel>& points) {
  constexpr double tolerance = 0.25;  // pixels
  constexpr int longest = 128;        // points left out at once, because each of them is tried again and again
  std::vector<Pixel> kept{points.front()};
  auto start = points.begin();
  for (auto end = start + 1; end != points.end(); ++end) {
    const bool straight = std::all_of(start + 1, end, [&](const Pixel& each) {
      return squared_distance(each, *start, *end) <= tolerance * tolerance;
    });
    if (straight && end - start < longest) continue;
    start = end - 1;
    kept.push_back(*start);
  }
  kept.push_back(points.back());
  return kept;
}

}  // namespace

std::vector<Pixel> thinned_line(const std::vector<Pixel>& points, std::size_t most) {
  if (points.size() <= most) return points;
  return std::ranges::is_sorted(points, {}, &Pixel::x) ? thinned_history(points) : thinned_loop(points);
}

}  // namespace moat
