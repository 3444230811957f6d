#include "output/charts/thinned_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moat {
namespace {

TEST(ThinnedLine, KeepsEveryPeakOfAHistory) {
  std::vector<Pixel> points;
  for (int i = 0; i <= 100'000; ++i) points.push_back({0.005 * i, std::sin(0.01 * i)});
  points[34'567].y = 9.0;
  points[34'569].y = -7.0;
  const std::vector<Pixel> thin = thinned_line(points, 1000);
  EXPECT_LE(thin.size(), 2u * 501u + 2u);
  EXPECT_TRUE(std::ranges::is_sorted(thin, {}, &Pixel::x));
  EXPECT_EQ(thin.front().x, 0.0);
  EXPECT_EQ(thin.back().x, 500.0);
  for (const std::size_t spike : {34'567u, 34'569u}) {
    const auto found = std::ranges::find(thin, points[spike].y, &Pixel::y);
    ASSERT_NE(found, thin.end());
    EXPECT_EQ(found->x, points[spike].x);
  }
}

TEST(ThinnedLine, LeavesAShortLineAlone) {
  EXPECT_EQ(thinned_line({{0.0, 5.0}, {1.0, 5.0}, {2.0, 5.0}}, 3).size(), 3u);
}

TEST(ThinnedLine, KeepsALoopWithinAQuarterPixel) {
  // A shrinking ellipse, whose shape is known between the points that were kept.
  std::vector<Pixel> points;
  for (int i = 0; i <= 20'000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 2'000.0, size = 1.0 - 1e-5 * i;
    points.push_back({300.0 * size * std::cos(angle), 200.0 * size * std::sin(angle)});
  }
  const std::vector<Pixel> thin = thinned_line(points, 1200);
  EXPECT_LT(thin.size(), points.size() / 10);
  double farthest = 0.0;
  std::size_t segment = 0;
  for (const Pixel& point : points) {
    while (segment + 2 < thin.size() && point.x == thin[segment + 1].x && point.y == thin[segment + 1].y) ++segment;
    const Pixel &begin = thin[segment], &end = thin[segment + 1];
    const double ax = end.x - begin.x, ay = end.y - begin.y;
    farthest = std::max(farthest, std::abs(ax * (point.y - begin.y) - ay * (point.x - begin.x)) / std::hypot(ax, ay));
  }
  EXPECT_LE(farthest, 0.25 + 1e-9);
  EXPECT_GT(farthest, 0.0);
}

TEST(ThinnedLine, KeepsTheTurnsOfALoopOnOneLine) {
  // To and fro between 0 and 40 pixels: every point lies on the line through any two others.
  std::vector<Pixel> points;
  for (int i = 0; i <= 2000; ++i) {
    const double way = std::abs(i % 80 - 40);
    points.push_back({0.8 * way, 0.6 * way});
  }
  const std::vector<Pixel> thin = thinned_line(points, 100);
  ASSERT_EQ(thin.size(), 51u);
  for (std::size_t turn = 0; turn < thin.size(); ++turn) EXPECT_EQ(thin[turn].x, turn % 2 == 0 ? 32.0 : 0.0) << turn;
}

}  // namespace
}  // namespace moat
