#include "law_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>
#include <variant>
#include <vector>

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

// The points of the curves of a picture stand apart from its text.
struct Picture {
  explicit Picture(const std::string& svg) {
    std::istringstream between_quotes{svg};
    for (std::string part; std::getline(between_quotes, part, '"'); text += '"') {
      if (!text.ends_with(" points=\"")) {
        text += part;
        continue;
      }
      std::ranges::replace(part, ',', ' ');
      std::istringstream numbers{part};
      std::copy(std::istream_iterator<double>{numbers}, {}, std::back_inserter(points));
      text += std::to_string(points.size());
    }
  }
  std::string text;
  std::vector<double> points;
};

TEST(Reference, HasTheLoopsOfLaws) {
  const auto expect_same = [](const std::string& picture, const std::string& drawn) {
    SCOPED_TRACE(picture + " is of other laws: cmake --build build/release --target guide_tables");
    const Picture given{read_file(MOAT_SOURCE_DIR "/docs/images/" + picture)}, now{drawn};
    EXPECT_TRUE(given.text == now.text);
    ASSERT_EQ(given.points.size(), now.points.size());
    ASSERT_GT(now.points.size(), 1000U);
    // Another processor may round to the next digit.
    for (std::size_t i = 0; i < now.points.size(); ++i) EXPECT_NEAR(given.points[i], now.points[i], 0.01 + 1e-9);
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
