#include "base/text/type_name.hpp"

#include <gtest/gtest.h>

namespace moat {

struct Outer {
  struct Inner {};
};
template <class T>
struct Wrapped {};

namespace {

struct Hidden {};

TEST(TypeName, IsThatOfTheSourceWithoutNamespaces) {
  struct Local {};
  EXPECT_EQ(type_name<Outer>(), "Outer");
  EXPECT_EQ(type_name<Outer::Inner>(), "Inner");
  EXPECT_EQ(type_name<Hidden>(), "Hidden");
  EXPECT_EQ(type_name<Local>(), "Local");
  // The arguments stand as the compiler writes them.
  EXPECT_TRUE(type_name<Wrapped<Outer>>().starts_with("Wrapped<")) << type_name<Wrapped<Outer>>();
  EXPECT_EQ(type_name<double>(), "double");
}

}  // namespace
}  // namespace moat
