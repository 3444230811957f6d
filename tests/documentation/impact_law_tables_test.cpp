#include "impact_law_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "materials/impact_laws.hpp"
#include "materials/named_impact_law.hpp"

namespace moat::testing {
namespace {

TEST(ImpactLawTables, HaveARowForEveryLaw) {
  const std::string tables = impact_law_tables();
  const auto rows = static_cast<int>(std::ranges::count(tables, '\n')) - 4 * 4 - 3;
  EXPECT_EQ(rows, AllImpactLaws::size) << "a law with a form of contact of its own needs a table";
}

TEST(Guide, HasTheTablesOfImpactLaws) {
  std::ifstream file{MOAT_SOURCE_DIR "/docs/guide.md"};
  std::ostringstream guide;
  guide << file.rdbuf();
  EXPECT_NE(guide.str().find(impact_law_tables()), std::string::npos)
      << "docs/guide.md does not show the impact laws as they are. Write its tables anew:\n"
         "    cmake --build build/release --target guide_tables";
}

TEST(AllImpactLaws, AreTheHeadersInTheFolderOfImpactLaws) {
  std::set<std::string> headers, laws;
  for (const auto& entry : std::filesystem::directory_iterator{MOAT_SOURCE_DIR "/materials/impact"})
    headers.insert(entry.path().stem());
  AllImpactLaws::for_each([&]<class Law>() { laws.insert(option_name(Law::name)); });
  EXPECT_EQ(headers, laws) << "every header in materials/impact has the name of its law, and a place in AllImpactLaws "
                              "(materials/impact_laws.hpp)";
}

}  // namespace
}  // namespace moat::testing
