#include "base/copyable_pointer.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace moat {
namespace {

TEST(CopyablePointer, CopiesAPlainObject) {
  const CopyablePointer<const int> pointer{std::make_unique<const int>(3)};
  CopyablePointer<const int> copy{pointer};
  EXPECT_EQ(*copy, 3);
  EXPECT_NE(copy.get(), pointer.get());
  copy = CopyablePointer<const int>{};
  EXPECT_FALSE(copy);
  EXPECT_TRUE(pointer);
}

struct Shape {
  Shape() = default;
  Shape(const Shape&) = delete;
  virtual ~Shape() = default;
  [[nodiscard]] virtual std::unique_ptr<Shape> clone() const = 0;
};

struct Square : Shape {
  explicit Square(double its_side) : side{its_side} {}
  [[nodiscard]] std::unique_ptr<Shape> clone() const override { return std::make_unique<Square>(side); }
  double side;
};

TEST(CopyablePointer, ClonesAnObjectThatCanBeCloned) {
  const CopyablePointer<Shape> pointer{std::make_unique<Square>(2.0)}, copy{pointer};
  EXPECT_NE(copy.get(), pointer.get());
  EXPECT_EQ(dynamic_cast<const Square&>(*copy).side, 2.0);
}

TEST(CopyablePointer, CopiesNone) { EXPECT_EQ((CopyablePointer<int>{CopyablePointer<int>{}}.get()), nullptr); }

}  // namespace
}  // namespace moat
