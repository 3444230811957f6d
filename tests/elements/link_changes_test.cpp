// The list of links that change inside a step.

#include "elements/line/link_changes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace moat {
namespace {

using Changes = LinkChanges<int>;
using Links = std::vector<std::size_t>;

Links links(Changes& changes) { return {changes.links().begin(), changes.links().end()}; }

TEST(LinkChanges, AreListedByLinkAndInTheirOrder) {
  Changes changes;
  changes.add({5, 1, 0.25, 0.0});
  changes.add({2, 7, 0.75, 0.0});
  changes.add({5, 2, 0.5, 0.0});
  ASSERT_EQ(changes.of(5).size(), 2U);
  EXPECT_EQ(changes.of(5)[0].before, 1);
  EXPECT_EQ(changes.of(5)[1].before, 2);
  EXPECT_EQ(changes.of(2).size(), 1U);
  EXPECT_TRUE(changes.of(3).empty());
  EXPECT_EQ(links(changes), (Links{2, 5}));
}

TEST(LinkChanges, AreRememberedForTwoSteps) {
  Changes changes;
  changes.add({4, 0, 0.5, 0.0});
  changes.commit();
  EXPECT_TRUE(changes.of_step().empty());
  changes.add({1, 0, 0.5, 0.0});
  EXPECT_EQ(links(changes), (Links{1, 4}));
  changes.commit();
  EXPECT_EQ(links(changes), (Links{1, 4}));
  changes.commit();
  EXPECT_EQ(links(changes), Links{1});
  changes.commit();
  EXPECT_TRUE(links(changes).empty());
}

TEST(LinkChanges, OfAStepThatIsTriedAgainAreGone) {
  Changes changes;
  changes.add({4, 0, 0.5, 0.0});
  changes.clear();
  EXPECT_TRUE(links(changes).empty());
  changes.commit();
  EXPECT_TRUE(links(changes).empty());
}

}  // namespace
}  // namespace moat
