#include "spring_law_tables.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/check.hpp"
#include "materials/carried_weight.hpp"
#include "materials/spring_laws.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

TEST(Guide, HasTheTablesOfSpringLaws) {
  std::ifstream file{MOAT_SOURCE_DIR "/docs/guide.md"};
  std::ostringstream guide;
  guide << file.rdbuf();
  EXPECT_NE(guide.str().find(spring_law_tables()), std::string::npos)
      << "docs/guide.md does not show these laws as they are. Write its tables again:\n"
         "    cmake --build build/release --target guide_tables";
}

TEST(AllSpringLaws, AreTheHeadersInTheirFolders) {
  EXPECT_EQ(spring_law_headers(), spring_law_names())
      << "every header in these folders has the name of its law, and a place in AllSpringLaws "
         "(materials/spring_laws.hpp)";
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
