// The recipe "How to add a motion format" of CONTRIBUTING.md.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/text/text_file.hpp"
#include "message_of.hpp"
#include "motions/readers/record_channel.hpp"

namespace moat {

// The recipe declares them in a header of the library.
bool is_laboratory(const TextFile& file);
std::vector<RecordChannel> read_laboratory(const TextFile& file);

namespace testing {
namespace {

TextFile synthetic(const std::string& rate, const std::string& values) {
  return {.path = "table.txt", .text = "LABORATORY: A\nDIRECTION: N80W\nLARGEST: 300\n" + rate + values, .sha256 = {}};
}

TEST(MotionFormatRecipe, ReadsAFileOfTheFormat) {
  const TextFile file = synthetic("RATE: 100 Hz\n", "100\n -300\n 0\n");
  ASSERT_TRUE(is_laboratory(file));
  const RecordChannel channel = read_laboratory(file).at(0);
  EXPECT_EQ(channel.station, "A");
  EXPECT_EQ(channel.azimuth, 280.0);
  EXPECT_DOUBLE_EQ(channel.step, 0.01);
  EXPECT_EQ(channel.samples, (std::vector<double>{1.0, -3.0, 0.0}));
  EXPECT_DOUBLE_EQ(channel.stated_peak, 3.0);
}

TEST(MotionFormatRecipe, RefusesWhatIsNotOfTheFormat) {
  EXPECT_FALSE(is_laboratory({.path = "columns.txt", .text = "0.0 0.1\n", .sha256 = {}}));
  EXPECT_NE(message_of<FileError>([] { read_laboratory(synthetic("", "1\n")); }).find("does not give RATE"),
            std::string::npos);
  EXPECT_EQ(message_of<FileError>([] { read_laboratory(synthetic("RATE: 100 Hz\n", "x\n")); }),
            "table.txt, line 5: \"x\" is not a number. Each line must hold one acceleration.");
}

}  // namespace
}  // namespace testing
}  // namespace moat
