#include "impact_law_tables.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>
#include <variant>

#include "materials/contact/any_contact.hpp"
#include "materials/contact/impact_laws.hpp"
#include "materials/contact/named_impact_law.hpp"

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
      << "a form of contact needs a table in tests/documentation/impact_law_tables.cpp";
  EXPECT_EQ(lines_that_begin("| [`"), AllImpactLaws::size);
}

TEST(Guide, HasTheTablesOfImpactLaws) {
  std::ifstream file{MOAT_SOURCE_DIR "/docs/guide.md"};
  std::ostringstream guide;
  guide << file.rdbuf();
  EXPECT_NE(guide.str().find(impact_law_tables()), std::string::npos)
      << "docs/guide.md does not show the impact laws as they are. Write its tables again:\n"
         "    cmake --build build/release --target guide_tables";
}

TEST(AllImpactLaws, AreTheHeadersInTheFolderOfImpactLaws) {
  std::set<std::string> headers, laws;
  for (const auto& entry : std::filesystem::directory_iterator{MOAT_SOURCE_DIR "/materials/impact"})
    headers.insert(entry.path().stem());
  AllImpactLaws::for_each([&]<class Law>() { laws.insert(option_name(Law::name)); });
  EXPECT_EQ(headers, laws) << "every header in materials/impact has the name of its law, and a place in AllImpactLaws "
                              "(materials/contact/impact_laws.hpp)";
}

}  // namespace
}  // namespace moat::testing
