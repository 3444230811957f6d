#include "law_tables.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string_view>
#include <variant>

#include "in_folder.hpp"
#include "law_pictures.hpp"
#include "message_of.hpp"
#include "moat.hpp"

namespace moat::testing {
namespace {

int lines_that_begin(std::string_view begin) {
  std::istringstream tables{impact_law_tables()};
  int count = 0;
  for (std::string line; std::getline(tables, line);) count += line.starts_with(begin) ? 1 : 0;
  return count;
}

TEST(ImpactLawTables, HaveATableForEveryFormAndARowForEveryLaw) {
  EXPECT_EQ(lines_that_begin("|---"), std::variant_size_v<AnyContact::Form>)
      << "a form of contact needs a table in tests/documentation/law_tables.cpp";
  EXPECT_EQ(lines_that_begin("| [`"), AllImpactLaws::size);
}

TEST(Reference, HasTheTablesOfLaws) {
  const auto expect_in = [](const std::string& page, const std::string& tables) {
    EXPECT_NE(read_file(MOAT_SOURCE_DIR "/docs/reference/" + page).find(tables), std::string::npos)
        << page << " does not show the laws as they are. Write its tables again:\n"
        << "    cmake --build build/release --target guide_tables";
  };
  expect_in("impact_laws.md", impact_law_tables());
  expect_in("isolators_and_storeys.md", spring_law_tables());
}

TEST(Reference, HasTheLoopsOfLaws) {
  const auto expect_same = [](const std::string& picture, const std::string& drawn) {
    EXPECT_TRUE(read_file(MOAT_SOURCE_DIR "/docs/images/" + picture) == drawn)
        << picture << " is of other laws: cmake --build build/release --target guide_tables";
  };
  expect_same("impact_laws.svg", impact_law_picture());
  expect_same("spring_laws.svg", spring_law_picture());
}

// The name of every parameter is that of a field, and the typical values are allowed.
TEST(AllSpringLaws, AllowTheirTypicalValues) {
  AllSpringLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    EXPECT_EQ(message_of([] { Law::typical().check(Check{"Isolator", "bearings"}); }), "nothing was thrown");
    EXPECT_FALSE(Law::typical().parameters().empty());
    static_assert(ForceLaw<Law> || WeightBearing<Law>);
  });
}

}  // namespace
}  // namespace moat::testing
