// Polygons in plan: areas, moments, containment, offsets, refusals.
#include "model/plan_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

PlanOutline polygon(std::initializer_list<PlanVector> points) {
  PlanOutline outline;
  for (const PlanVector& point : points) outline.corners.push_back({point.x * m, point.y * m});
  return outline;
}

TEST(PlanOutline, RectangleHasItsMoments) {
  const PlanOutline outline = rectangle(20 * m, 12 * m, {3 * m, -1 * m});
  EXPECT_DOUBLE_EQ(outline.area(), 240.0);
  EXPECT_NEAR(outline.centroid().x, 3.0, 1e-14);
  EXPECT_NEAR(outline.centroid().y, -1.0, 1e-14);
  EXPECT_NEAR(outline.gyration_squared(), (400.0 + 144.0) / 12.0, 1e-12);
}

TEST(PlanOutline, MomentsOfAnLShapeAreThoseOfItsParts) {
  const PlanOutline shape = polygon({{0, 0}, {8, 0}, {8, 3}, {2, 3}, {2, 7}, {0, 7}});
  // 8 x 3 at (4, 1.5) and 2 x 4 at (1, 5).
  const double a1 = 24.0, a2 = 8.0, area = a1 + a2;
  const double x = (a1 * 4.0 + a2 * 1.0) / area, y = (a1 * 1.5 + a2 * 5.0) / area;
  const auto part = [&](double a, double lx, double ly, double cx, double cy) {
    return a * ((lx * lx + ly * ly) / 12.0 + (cx - x) * (cx - x) + (cy - y) * (cy - y));
  };
  EXPECT_DOUBLE_EQ(shape.area(), area);
  EXPECT_NEAR(shape.centroid().x, x, 1e-14);
  EXPECT_NEAR(shape.centroid().y, y, 1e-14);
  EXPECT_NEAR(shape.gyration_squared(), (part(a1, 8, 3, 4, 1.5) + part(a2, 2, 4, 1, 5)) / area, 1e-12);
  EXPECT_TRUE(shape.contains({1.0, 6.0}));
  EXPECT_FALSE(shape.contains({3.0, 4.0}));
  EXPECT_TRUE(shape.contains({2.0, 5.0}));  // on the border
}

TEST(PlanOutline, OffsetKeepsDistancesOfEdges) {
  const PlanOutline wide = offset_outwards(turned(rectangle(20 * m, 12 * m), 0.3), 25 * cm);
  const PlanOutline expected = turned(rectangle(20.5 * m, 12.5 * m), 0.3);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(wide.corner(i).x, expected.corner(i).x, 1e-12);
    EXPECT_NEAR(wide.corner(i).y, expected.corner(i).y, 1e-12);
  }
  // Reflex corners too: an L grows by its perimeter times the distance and the squares at its corners.
  const PlanOutline shape = polygon({{0, 0}, {8, 0}, {8, 3}, {2, 3}, {2, 7}, {0, 7}});
  const double d = 0.5;
  EXPECT_NEAR(offset_outwards(shape, d * m).area(), 32.0 + 30.0 * d + 4.0 * d * d, 1e-12);
}

TEST(PlanOutline, OffsetOfASharpTriangleIsATriangleOfItsShape) {
  const double height = 6.0 * std::sqrt(3.0), inner_radius = height / 3.0;
  const PlanOutline small = polygon({{0, 0}, {12, 0}, {6, height}});
  const double grown = (inner_radius + 0.5) / inner_radius;
  EXPECT_NEAR(offset_outwards(small, 50 * cm).area(), grown * grown * small.area(), 1e-12 * small.area());
}

TEST(PlanOutline, BadPolygonsAreRefusedWithTheirMistake) {
  const Check check{"Diaphragm", "base"};
  const auto message = [&](const PlanOutline& outline) { return message_of([&] { outline.check(check, "outline"); }); };
  EXPECT_EQ(message(rectangle(2 * m, 1 * m)), "nothing was thrown");
  EXPECT_EQ(message(polygon({{0, 0}, {1, 0}})), "Diaphragm \"base\": outline has 2 corners. Give at least three.");
  EXPECT_EQ(message(polygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}})),
            "Diaphragm \"base\": outline is clockwise. Give the corners counter-clockwise, in reverse order.");
  EXPECT_EQ(message(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})),
            "Diaphragm \"base\": outline crosses itself: the edges from corner 1 and from corner 3 meet. Give the "
            "corners in their order around the polygon.");
  EXPECT_EQ(message(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 0}})),
            "Diaphragm \"base\": outline corner 1 and corner 4 are at the same place, (0, 0) m. Leave one of them out; "
            "the last corner is not the first again.");
  EXPECT_NE(message(polygon({{0, 0}, {NAN, 0}, {1, 1}})).find("outline corner 2 x"), std::string::npos);
}

}  // namespace
}  // namespace moat
