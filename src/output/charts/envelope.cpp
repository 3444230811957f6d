#include "output/charts/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace moat {
namespace {

Curve pick(const Curve& curve, const std::vector<char>& keep) {
  Curve kept;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i] == 0) continue;
    kept.x.push_back(curve.x[i]);
    kept.y.push_back(curve.y[i]);
  }
  return kept;
}

std::vector<char> keep_envelope(const Curve& curve, int width) {
  const std::size_t n = curve.x.size();
  std::vector<char> keep(n, 0);
  keep.front() = keep.back() = 1;
  const double columns_per_x = width / (curve.x.back() - curve.x.front());
  const auto column = [&](std::size_t i) {
    return std::min(width - 1, static_cast<int>((curve.x[i] - curve.x.front()) * columns_per_x));
  };
  std::size_t start = 0;
  while (start < n) {
    std::size_t lowest = start;
    std::size_t highest = start;
    std::size_t i = start;
    for (; i < n && column(i) == column(start); ++i) {
      if (curve.y[i] < curve.y[lowest]) lowest = i;
      if (curve.y[i] > curve.y[highest]) highest = i;
    }
    keep[lowest] = keep[highest] = 1;
    start = i;
  }
  return keep;
}

/// Marks the points that are needed between two kept ones; distances in pixels.
void keep_shape(const Curve& pixels, std::size_t first, std::size_t last, double tolerance, std::vector<char>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    const double dx = pixels.x[end] - pixels.x[begin];
    const double dy = pixels.y[end] - pixels.y[begin];
    const double length_squared = dx * dx + dy * dy;
    std::size_t farthest = begin;
    double largest = tolerance;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const double px = pixels.x[i] - pixels.x[begin];
      const double py = pixels.y[i] - pixels.y[begin];
      // Distance to the segment, not to its line: a loop returns to where it started.
      const double along = length_squared > 0.0 ? std::clamp((px * dx + py * dy) / length_squared, 0.0, 1.0) : 0.0;
      const double distance = std::hypot(px - along * dx, py - along * dy);
      if (distance > largest) {
        largest = distance;
        farthest = i;
      }
    }
    if (farthest == begin) continue;
    keep[farthest] = 1;
    open.emplace_back(begin, farthest);
    open.emplace_back(farthest, end);
  }
}

std::vector<char> keep_loop(const Curve& curve, int width, int height) {
  const auto [left, right] = std::minmax_element(curve.x.begin(), curve.x.end());
  const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
  const double x_scale = *right > *left ? width / (*right - *left) : 0.0;
  const double y_scale = *high > *low ? height / (*high - *low) : 0.0;
  const std::size_t n = curve.x.size();
  Curve pixels;
  pixels.x.reserve(n);
  pixels.y.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    pixels.x.push_back(curve.x[i] * x_scale);
    pixels.y.push_back(curve.y[i] * y_scale);
  }
  std::vector<char> keep(n, 0);
  // The method is quadratic at worst, so long curves are cut into pieces first.
  constexpr std::size_t piece = 512;
  for (std::size_t first = 0; first + 1 < n; first += piece) {
    const std::size_t last = std::min(first + piece, n - 1);
    keep[first] = keep[last] = 1;
    keep_shape(pixels, first, last, 0.25, keep);
  }
  return keep;
}

}  // namespace

Curve thin_out(const Curve& curve, int width, int height) {
  if (curve.x.size() <= 2 * static_cast<std::size_t>(width)) return curve;
  const bool forward = std::is_sorted(curve.x.begin(), curve.x.end()) && curve.x.back() > curve.x.front();
  return pick(curve, forward ? keep_envelope(curve, width) : keep_loop(curve, width, height));
}

}  // namespace moat
