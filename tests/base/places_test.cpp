// Lists of places: indices and numbers outside them are refused.
#include "base/places.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <span>

#include "message_of.hpp"

namespace moat {
namespace {

using testing::message_of;
using Floors = Places<int, floors_remedy>;

TEST(Places, AreAVector) {
  Floors floors{10, 20};
  floors.push_back(30);
  EXPECT_EQ(floors, (std::vector<int>{10, 20, 30}));
  EXPECT_EQ(std::accumulate(floors.begin(), floors.end(), 0), 60);
  EXPECT_EQ(std::span<const int>{floors}[2], 30);
  EXPECT_EQ(floors.at(0), floors.front());
  EXPECT_EQ(floors.back(), 30);
  floors[1] = 21;
  const std::vector<int> copy = floors;
  EXPECT_EQ(Floors{copy}[1], 21);
  EXPECT_TRUE(Floors{}.empty());
}

TEST(Places, RefuseIndicesOutside) {
  const Floors floors{10, 20, 30};
  const std::string message =
      "Places: index = 3 is not allowed; it must be >= 0 and <= 2. floors[0] is \"floor 1\": take floor(3) for \"floor "
      "3\".";
  EXPECT_EQ(message_of([&] { return floors[3]; }), message);
  EXPECT_EQ(message_of([&] { return floors.at(3); }), message);
  EXPECT_EQ(message_of([&] { Floors{floors}[3] = 1; }), message);
  EXPECT_NE(message_of([&] { return floors[static_cast<std::size_t>(-1)]; }).find("index = -1 "), std::string::npos);
  EXPECT_NE(message_of([] { return Floors{}.front(); }).find("because there is none"), std::string::npos);
  EXPECT_NE(message_of([] { return Floors{}.back(); }).find("because there is none"), std::string::npos);
}

TEST(Places, HaveNumbersFromOne) {
  const Floors floors{10, 20, 30};
  const Check owner{"Building", "tower"};
  EXPECT_EQ(floors.numbered(1, owner, "floor"), 10);
  EXPECT_EQ(floors.numbered(3, owner, "floor"), 30);
  for (const int number : {-1, 0, 4})
    EXPECT_EQ(message_of([&] { return floors.numbered(number, owner, "floor"); }),
              "Building \"tower\": floor = " + std::to_string(number) +
                  " is not allowed; it must be >= 1 and <= 3. Give a number in "
                  "this range.");
}

}  // namespace
}  // namespace moat
