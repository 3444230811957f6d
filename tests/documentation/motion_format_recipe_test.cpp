// The recipe "How to add a motion format" of CONTRIBUTING.md.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "message_of.hpp"
#include "motions/readers/knet_text.hpp"

namespace moat::testing {
namespace {

TextFile synthetic(const std::string& scale, const std::string& counts) {
  return {.path = "synthetic.EW",
          .text = "Origin Time       none\nSampling Freq(Hz) 100Hz\n" + scale + "Memo.\n" + counts,
          .sha256 = {}};
}
const std::string scale = "Scale Factor      2000(gal)/4000\n";

TEST(MotionFormatRecipe, ReadsAFileOfTheFormat) {
  const TextFile file = synthetic(scale, " 100 300 -100\n 100\n");
  ASSERT_TRUE(is_knet(file));
  const GroundMotion motion = parse_knet(file);
  EXPECT_EQ(motion.name(), "synthetic");
  EXPECT_DOUBLE_EQ(motion.time_step(), 0.01);
  ASSERT_EQ(motion.samples().size(), 4U);
  // Half a gal per count, and the mean of 100 counts taken off.
  EXPECT_DOUBLE_EQ(motion.samples()[0], 0.0);
  EXPECT_DOUBLE_EQ(motion.samples()[1], 1.0);
  EXPECT_DOUBLE_EQ(motion.samples()[2], -1.0);
}

TEST(MotionFormatRecipe, RefusesWhatIsNotOfTheFormat) {
  EXPECT_FALSE(is_knet({.path = "columns.txt", .text = "0.0 0.1\n", .sha256 = {}}));
  EXPECT_EQ(message_of<FileError>([] { parse_knet(synthetic("", "1 2\n")); }),
            "synthetic.EW: the header must give \"Scale Factor 3920(gal)/6182761\".");
  EXPECT_EQ(message_of<FileError>([] { parse_knet(synthetic(scale, "1 x\n")); }),
            "synthetic.EW, line 5: \"x\" is not a number.");
}

}  // namespace
}  // namespace moat::testing
