#include "launcher/designated_list.hpp"

#include <gtest/gtest.h>

namespace moat::launcher {
namespace {

TEST(DesignatedList, HasTypeNamesAndValues) {
  const std::string source =
      "add(model, Moat{.name = \"a } b\",  // {\n  .law = Hertz{.stiffness = f(1, 2)}, .sides = x});";
  const DesignatedList list = list_around(source, source.size() - 3);
  EXPECT_EQ(list.type, "Moat");
  ASSERT_EQ(list.fields.size(), 3u);
  EXPECT_EQ(list.fields[0].name, "name");
  EXPECT_EQ(list.fields[0].value, "\"a } b\"");
  EXPECT_EQ(list.fields[1].value, "Hertz{.stiffness = f(1, 2)}");
  EXPECT_EQ(list.fields[2].name, "sides");
  EXPECT_EQ(list.fields[2].value, "x");
  EXPECT_EQ(list.fields[2].offset, source.find(".sides"));
  EXPECT_EQ(list_around(source, source.find("f(")).type, "Hertz");
}

TEST(DesignatedList, HasTheTypeOfAVariable) {
  for (const std::string front :
       {"Moat", "const Moat moat", "return Moat", "const auto x = moat::Moat", "Moat<Hertz> x ="}) {
    const std::string source = "int i = 0; " + front + "{.a = 1}";
    EXPECT_EQ(list_around(source, source.size() - 1).type, "Moat") << front;
  }
}

TEST(DesignatedList, IsAnArgumentOfACall) {
  const std::string source = "g({.a = 1}); f(x, {}, {\n .b = h({.c = 3}), });";
  const DesignatedList list = list_in_call(source, source.find("(x"));
  EXPECT_EQ(list.type, "");
  ASSERT_EQ(list.fields.size(), 1u);
  EXPECT_EQ(list.fields[0].name, "b");
  EXPECT_EQ(list.fields[0].value, "h({.c = 3})");
  EXPECT_TRUE(list_in_call("f({.a = 1}, {.b = 2});", 1).fields.empty()) << "either may be meant";
}

TEST(DesignatedList, IsEmptyWhereNoneIs) {
  EXPECT_TRUE(list_around("f(1)", 3).fields.empty());
  EXPECT_TRUE(list_around("", 0).fields.empty());
  EXPECT_TRUE(list_in_call("f({1, 2})", 1).fields.empty());
  EXPECT_TRUE(list_in_call("f(1); g({.a = 2})", 1).fields.empty());
  EXPECT_TRUE(list_in_call("({", 0).fields.empty());
  EXPECT_TRUE(list_in_call("{", 7).fields.empty());
  EXPECT_EQ(list_around("Moat{.a = \"open", 11).fields.size(), 0u);
}

TEST(PlaceInSource, CountsTabulatorsAndLettersAsTheCompiler) {
  EXPECT_EQ(offset_of("ab\ncd", 2, 2), 4u);
  EXPECT_EQ(offset_of("\tx", 1, 9), 1u);
  EXPECT_EQ(offset_of("a\tx", 1, 9), 2u);
  EXPECT_EQ(offset_of("\xC3\xA4x", 1, 2), 2u);
  EXPECT_EQ(offset_of("ab", 3, 1), 2u);
  EXPECT_EQ(offset_of("ab\ncd", 1, 9), 5u);
}

TEST(DesignatedList, HasItems) {
  EXPECT_EQ(items_of("{500 * tonne, f(1, 2),\n {3, 4} }"),
            (std::vector<std::string>{"500 * tonne", "f(1, 2)", "{3, 4}"}));
  EXPECT_TRUE(items_of("{}").empty());
  EXPECT_TRUE(items_of("f({1})").empty());
  EXPECT_TRUE(items_of("{1} + {2}").empty());
}

TEST(WrongBracket, IsTheFirstThatDoesNotFit) {
  const std::string source = "f(Moat{.a = 1);";
  const auto wrong = first_wrong_bracket(source);
  ASSERT_TRUE(wrong.has_value());
  EXPECT_EQ(wrong->opening, source.find('{'));
  EXPECT_EQ(wrong->closing, source.find(')'));
  EXPECT_EQ(first_wrong_bracket("f(); }")->opening, std::nullopt);
  EXPECT_FALSE(first_wrong_bracket("f({[]}, '{', '\\'', \"(\", 1'000);  // )"));
  EXPECT_FALSE(first_wrong_bracket("f(R\"x(\")} \" )x\");"));
  EXPECT_FALSE(first_wrong_bracket("int main() {"));
}

}  // namespace
}  // namespace moat::launcher
