#include "output/charts/envelope.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moat {
namespace {

TEST(Envelope, KeepsEveryPeakOfAHistory) {
  Curve curve;
  for (int i = 0; i <= 100'000; ++i) {
    curve.x.push_back(0.001 * i);
    curve.y.push_back(std::sin(0.01 * i));
  }
  curve.y[34'567] = 9.0;
  curve.y[34'569] = -7.0;
  const Curve thin = thin_out(curve, 500, 300);
  EXPECT_LE(thin.x.size(), 2u * 500u + 2u);
  EXPECT_TRUE(std::is_sorted(thin.x.begin(), thin.x.end()));
  EXPECT_EQ(thin.x.front(), curve.x.front());
  EXPECT_EQ(thin.x.back(), curve.x.back());
  for (const std::size_t spike : {34'567u, 34'569u}) {
    const auto found = std::find(thin.y.begin(), thin.y.end(), curve.y[spike]);
    ASSERT_NE(found, thin.y.end());
    EXPECT_EQ(thin.x[static_cast<std::size_t>(found - thin.y.begin())], curve.x[spike]);
  }
}

TEST(Envelope, LeavesAShortCurveAlone) {
  const Curve curve{{0.0, 1.0, 2.0}, {5.0, 5.0, 5.0}};
  const Curve thin = thin_out(curve, 300, 300);
  EXPECT_EQ(thin.x, curve.x);
  EXPECT_EQ(thin.y, curve.y);
}

TEST(Envelope, KeepsALoopWithinAQuarterPixel) {
  // A shrinking ellipse, whose shape is known between the points that were kept.
  Curve curve;
  for (int i = 0; i <= 20'000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 2'000.0;
    const double size = 1.0 - 1e-5 * i;
    curve.x.push_back(size * std::cos(angle));
    curve.y.push_back(1e6 * size * std::sin(angle));
  }
  const int width = 600;
  const int height = 400;
  const Curve thin = thin_out(curve, width, height);
  EXPECT_LT(thin.x.size(), curve.x.size() / 10);
  const auto [left, right] = std::minmax_element(curve.x.begin(), curve.x.end());
  const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
  const double per_x = width / (*right - *left);
  const double per_y = height / (*high - *low);

  double farthest = 0.0;
  std::size_t segment = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    while (segment + 2 < thin.x.size() && curve.x[i] == thin.x[segment + 1] && curve.y[i] == thin.y[segment + 1])
      ++segment;
    const double ax = (thin.x[segment + 1] - thin.x[segment]) * per_x;
    const double ay = (thin.y[segment + 1] - thin.y[segment]) * per_y;
    const double px = (curve.x[i] - thin.x[segment]) * per_x;
    const double py = (curve.y[i] - thin.y[segment]) * per_y;
    farthest = std::max(farthest, std::abs(ax * py - ay * px) / std::hypot(ax, ay));
  }
  EXPECT_LE(farthest, 0.25 + 1e-9);
  EXPECT_GT(farthest, 0.0);
}

}  // namespace
}  // namespace moat
