#include "motions/readers/read_motion.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/sha256.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"
#include "motions/readers/record.hpp"

namespace moat {
namespace {

using namespace units;

const std::string synthetic_at2 =
    "SYNTHETIC\nTest\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2, DT= .02 SEC\n  .5E+00  .1E+01\n";

class ReadMotion : public MotionFiles {};

TEST_F(ReadMotion, KnowsAt2ByItsContent) {
  for (const char* name : {"a.AT2", "a.at2", "a.txt", "a"}) {
    const GroundMotion motion = read_motion(write(name, synthetic_at2));
    EXPECT_DOUBLE_EQ(motion.samples()[0], 0.5 * 9.80665) << name;
    EXPECT_EQ(motion.time_step(), 0.02) << name;
  }
}

TEST_F(ReadMotion, ReadsTwoColumnsWithAUnitUnderAnyName) {
  for (const char* name : {"a.csv", "a.txt", "a.AT2"}) {
    const GroundMotion motion = read_motion(write(name, "0.02, 0.5\n0.04, 1\n"), 1 * g);
    EXPECT_DOUBLE_EQ(motion.samples()[0], 0.5 * 9.80665) << name;
  }
  const std::string talks_of_units = "# one\n# two\n# acceleration in units of g, NPTS 2\n# NPTS= 2\n0 0.5\n0.02 1\n";
  EXPECT_EQ(read_motion(write("commented.txt", talks_of_units), 1 * g).samples().size(), 2u);
}

TEST_F(ReadMotion, RemembersTheFile) {
  const std::string columns = "0 0.5\n0.02 1\n";
  EXPECT_EQ(read_motion(write("a.AT2", synthetic_at2)).file().sha256, sha256_of(synthetic_at2));
  const GroundMotion motion = read_motion(write("a.txt", columns), 1 * g);
  EXPECT_EQ(motion.file().sha256, sha256_of(columns));
  EXPECT_EQ(motion.file().path, path("a.txt").string());
}

TEST_F(ReadMotion, NotesAVerticalRecord) {
  const auto vertical = [&](const char* name, const std::string& content) {
    const GroundMotion motion =
        read_motion(write(name, content), content == synthetic_at2 ? std::nullopt : std::optional{1 * g});
    const std::string& last = motion.notes().empty() ? "" : motion.notes().back();
    const std::size_t at = last.find(vertical_record);
    return at == std::string::npos ? "" : last.substr(at + std::string_view{vertical_record}.size());
  };
  const std::string columns = "0 0.5\n0.02 1\n";
  EXPECT_EQ(vertical("KBU-UP.AT2", synthetic_at2), "its name says \"UP\".");
  EXPECT_EQ(vertical("KJMUP.csv", columns), "its name says \"UP\".");
  EXPECT_EQ(vertical("TCU068-V.csv", columns), "its name says \"V\".");
  EXPECT_EQ(vertical("amt_z.csv", columns), "its name says \"Z\".");
  for (const char* name : {"KBU-000.csv", "TCU068-E.csv", "pickup.csv", "V.csv.txt"})
    EXPECT_EQ(vertical(name, columns), "") << name;
  EXPECT_EQ(vertical("a.csv", "# vertical component\n" + columns), "") << "comments are no header";
  const std::string at2 =
      std::string{synthetic_at2}.replace(synthetic_at2.find("Test"), 4, "Kobe, 1/16/1995, KJMA, UP");
  EXPECT_NE(read_motion(write("a.AT2", at2)).notes().back().find("its header says \"UP\""), std::string::npos);
}

TEST_F(ReadMotion, SaysItsFormats) {
  EXPECT_EQ(motion_formats(),
            "K-NET, AFAD, ESM (DYNA), CWA, GeoNet, COSMOS, RENADIC, BHRC, SMC, CSMIP V2, UNAM, PEER AT2, or columns of "
            "text");
}

TEST_F(ReadMotion, AsksForTheUnitOfTwoColumns) {
  for (const char* name : {"a.csv", "a.AT2"}) {
    const auto file = write(name, "0 0.5\n0.02 1\n");
    EXPECT_EQ(
        message_of<MissingUnit>([&] { (void)read_motion(file); }),
        "read_motion \"" + file.string() +
            "\": plain text does not say the unit of its accelerations. Give the unit: read_motion(file, 1 * g), or 1 "
            "* m / s / s.");
  }
}

TEST_F(ReadMotion, RefusesAnotherUnitThanTheHeaderSays) {
  const auto file = write("a.AT2", synthetic_at2);
  EXPECT_DOUBLE_EQ(read_motion(file, 1 * g).samples()[0], 0.5 * 9.80665);
  EXPECT_EQ(
      message_of<InputError>([&] { (void)read_motion(file, m / s / s); }),
      "read_motion \"" + file.string() +
          "\": a unit of 1 m/s^2 was given, but this file (PEER AT2) holds accelerations in g. Leave the unit out, "
          "and use scaled_by() if the values are to be multiplied.");
}

// --record-step and --record-columns are never left unused.
TEST_F(ReadMotion, RefusesAnotherStepAndColumnsThanTheFileHas) {
  const auto file = write("a.AT2", synthetic_at2);
  const double step = read_motion(file).time_step();
  EXPECT_EQ(read_motion(file, TextColumns{.step = step * s}).time_step(), step);
  for (const auto& [text, words] : std::vector<std::pair<TextColumns, std::string>>{
           {{.step = 2.0 * step * s}, " s was given, but this file (PEER AT2) has one of " + to_text(step) + " s."},
           {{.columns = "time,x"}, "columns were named, \"time,x\", but this file (PEER AT2) names its own."}})
    for (const bool is_record : {false, true}) {
      const std::string message = message_of<InputError>([&] {
        if (is_record)
          (void)read_record({file}, {.text = text});
        else
          (void)read_motion(file, text);
      });
      EXPECT_NE(message.find(words), std::string::npos) << message;
    }
}

TEST_F(ReadMotion, ExplainsABrokenAt2HeaderAsSuch) {
  const auto file = write("a.AT2", "SYNTHETIC\nTest\nno units here\nnor counts\n.5 .6\n");
  EXPECT_NE(
      message_of<FileError>([&] { (void)read_motion(file); }).find("line 3: this line of a PEER AT2 file must say"),
      std::string::npos);
}

TEST_F(ReadMotion, SaysThatAFileIsMissing) {
  EXPECT_EQ(message_of<FileError>([&] { (void)read_motion(path("none.AT2")); }),
            path("none.AT2").string() + ": there is no such file. Check the path.");
}

}  // namespace
}  // namespace moat
