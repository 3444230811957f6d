// The report is written by the real CTest, so that a change of its format shows.

#include "launcher/skipped_tests.hpp"

#include <gtest/gtest.h>

#include "launcher/process.hpp"
#include "launcher/text.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

using SkippedTests = moat::testing::InTemporaryFolder;

TEST_F(SkippedTests, AreListedWithTheirReason) {
  write_text(folder / "CTestTestfile.cmake", R"(
add_test(passes true)
add_test(motions.Reader.Real printf "[ RUN      ] Reader.Real\nreader_test.cpp:7: Skipped\nSet MOAT_RECORDS to the\nfolder of <records>.\n\n[  SKIPPED ] Reader.Real (0 ms)\n")
set_tests_properties(motions.Reader.Real PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
add_test(switched_off true)
set_tests_properties(switched_off PROPERTIES DISABLED TRUE)
)");
  const std::filesystem::path report = folder / "report.xml";
  ASSERT_EQ(run_into(folder / "log", {CTEST_PROGRAM, "--test-dir", folder, "--output-junit", report}), 0)
      << text_of(folder / "log");
  const std::vector<SkippedTest> skipped = skipped_tests(report);
  ASSERT_EQ(skipped.size(), 2U) << text_of(report);
  EXPECT_EQ(skipped[0].name, "motions.Reader.Real");
  EXPECT_EQ(skipped[0].reason, "Set MOAT_RECORDS to the folder of <records>.");
  EXPECT_EQ(skipped[1].name, "switched_off");
  EXPECT_FALSE(skipped[1].reason.empty());
}

TEST_F(SkippedTests, AreNoneWithoutAReport) { EXPECT_TRUE(skipped_tests(folder / "report.xml").empty()); }

}  // namespace
}  // namespace moat::launcher
