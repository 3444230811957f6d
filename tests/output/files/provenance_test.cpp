#include "output/files/provenance.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace moat {
namespace {

TEST(Provenance, OfTheLibraryHasVersionCommitAndDate) {
  const Provenance provenance = provenance_of_library();
  EXPECT_TRUE(std::regex_match(provenance.moat_version, std::regex{R"(\d+\.\d+\.\d+)"})) << provenance.moat_version;
  EXPECT_TRUE(std::regex_match(provenance.date, std::regex{R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)"})) << provenance.date;
  // Empty where the source is no checkout of git.
  EXPECT_TRUE(std::regex_match(provenance.git_commit, std::regex{"([0-9a-f]{40}(-dirty)?)?"})) << provenance.git_commit;
}

}  // namespace
}  // namespace moat
