// The recipe "How to add a motion format" of CONTRIBUTING.md.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "message_of.hpp"
#include "motions/esm_text.hpp"

namespace moat::testing {
namespace {

TextFile synthetic(const std::string& units, const std::string& values) {
  return {.path = "synthetic.asc",
          .text = "EVENT_NAME: none\nSAMPLING_INTERVAL_S: 0.005\nUNITS: " + units + "\n" + values,
          .sha256 = {}};
}

TEST(MotionFormatRecipe, ReadsAFileOfTheFormat) {
  const TextFile file = synthetic("cm/s^2", "0.0\n-98.0665\n12.5\n");
  ASSERT_TRUE(is_esm_text(file));
  const GroundMotion motion = parse_esm_text(file);
  EXPECT_EQ(motion.name(), "synthetic");
  EXPECT_EQ(motion.time_step(), 0.005);
  ASSERT_EQ(motion.samples().size(), 3U);
  EXPECT_DOUBLE_EQ(motion.samples()[1], -0.980665);
}

TEST(MotionFormatRecipe, RefusesWhatIsNotOfTheFormat) {
  EXPECT_FALSE(is_esm_text({.path = "columns.txt", .text = "0.0 0.1\n", .sha256 = {}}));
  EXPECT_EQ(message_of<FileError>([] { parse_esm_text(synthetic("g", "0.0\n0.1\n")); }),
            "synthetic.asc: the header must say \"UNITS: cm/s^2\". Convert the file.");
  EXPECT_TRUE(message_of<FileError>([] {
                parse_esm_text(synthetic("cm/s^2", "0.0\nx\n"));
              }).starts_with("synthetic.asc, line 5: \"x\""));
}

}  // namespace
}  // namespace moat::testing
