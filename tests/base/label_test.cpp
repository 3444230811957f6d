#include "base/label.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace moat {
namespace {

TEST(Label, HoldsItsText) {
  EXPECT_EQ(Label{"drift"}.text(), "drift");
  EXPECT_TRUE(Label{}.empty());
  EXPECT_FALSE(Label{"drift"}.empty());
}

TEST(Label, WithoutTextIsTheOneOfAnEmptyText) {
  EXPECT_EQ(Label{}.text(), "");
  EXPECT_EQ(Label{}, Label{""});
  EXPECT_EQ(Label{}, Label{std::string{}});
}

TEST(Label, IsEqualWhereTheTextIs) {
  const std::string text = "storey_shear";
  EXPECT_EQ(Label{text}, Label{"storey_shear"});
  EXPECT_FALSE(Label{text} == Label{"storey"});
}

TEST(Label, TakesThePlaceOfANumberOnly) { EXPECT_EQ(sizeof(Label), 4U); }

TEST(Label, IsTheSameOnEveryThread) {
  std::vector<Label> labels(8);
  {
    std::vector<std::jthread> threads;
    for (Label& label : labels)
      threads.emplace_back([&label] {
        for (int i = 0; i < 200; ++i) label = Label{"text " + std::to_string(i)};
      });
  }
  for (const Label label : labels) EXPECT_EQ(label, labels.front());
}

}  // namespace
}  // namespace moat
