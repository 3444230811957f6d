// Lines of a megabyte, as a missing line end or a damaged disk leaves them, in every reader of ground motions.

#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/text/text_file.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/read_motion.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr std::size_t megabyte = 1'000'000;

std::string repeated(const std::string& piece) {
  std::string text;
  while (text.size() < megabyte) text += piece;
  return text;
}

// Pieces that a reader takes one after the other, so that time of the square of the length would show as a test that
// does not end.
const std::vector<std::string> pieces{" ",          "0",       "1 ",       "a",     ".",
                                      "-",          "(",       "=",        ",",     "1E+0-",
                                      "Format=(8F", "units=,", "units=(4", "NPTS=", "(Format v1 with"};

const std::string numbers_of_header = [] {
  std::string text;
  for (int i = 1; i <= 100; ++i) text += i == 2 ? "       1" : i == 3 ? "       4" : "    -999";
  return text + "\n";
}();

std::string cosmos() {
  std::string reals;
  for (int i = 1; i <= 100; ++i) reals += i == 62 ? "    5.00" : " -999.00";
  return "Corrected acceleration (Format v01.20 with 2 text lines)\nsynthetic\n"
         " 100 Integer-header values follow on 1 line, Format= (100I8)\n" +
         numbers_of_header + " 100 Real-header values follow on 1 line, Format= (100F8.2)\n" + reals +
         "\n   1 Comment line(s) follow, each starting with a \"|\":\n| none\n"
         " 2 acceleration pts, approx 0 secs, units=cm/sec2 (04), Format=(8F10.5)\n   0.50000   0.10000\nEnd-of-data\n";
}

struct Reader {
  std::string name, text;
  std::vector<RecordChannel> (*read)(const TextFile& file);
};

const std::vector<Reader> readers{
    {"COSMOS", cosmos(), read_cosmos},
    {"PEER AT2", "SYNTHETIC\nTest\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2, DT= .02 SEC\n  .5E+00  .1E+01\n",
     read_peer_at2},
    {"ESM", "EVENT_NAME: test\nUNITS: cm/s^2\nDATA_TYPE: ACCELERATION\nSAMPLING_INTERVAL_S: 0.01\nNDATA: 2\n1.0\n2.0\n",
     read_dyna},
    {"two columns", "time acceleration\n0 0.5\n0.02 1\n",
     [](const TextFile& file) { return read_plain_text(file, {.unit = 1.0 * units::g}); }}};

// The message of a refusal, or nothing where the reader takes the text.
std::string refusal_of(const Reader& reader, const std::string& text) {
  try {
    (void)reader.read({"record", text, ""});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(LongLines, AreReadOrRefusedInAReadableMessage) {
  constexpr std::size_t longest_message = 1000;
  for (const Reader& reader : readers) {
    ASSERT_EQ(refusal_of(reader, reader.text), "") << reader.name;
    for (const std::string& piece : pieces) {
      const std::string filler = repeated(piece);
      // At the beginning of every line, and at its end.
      for (std::size_t end = reader.text.find('\n'), begin = 0; end != std::string::npos;
           begin = end + 1, end = reader.text.find('\n', begin))
        for (const std::size_t place : {begin, end}) {
          std::string text = reader.text;
          text.insert(place, filler);
          EXPECT_LT(refusal_of(reader, text).size(), longest_message)
              << reader.name << ": " << piece << " at " << place;
        }
    }
  }
}

TEST(LongLines, OfBlanksAreRead) {
  for (const Reader& reader : readers)
    for (std::size_t end = reader.text.find('\n'); end != std::string::npos; end = reader.text.find('\n', end + 1)) {
      std::string text = reader.text;
      text.insert(end, std::string(megabyte, ' '));
      EXPECT_EQ(refusal_of(reader, text), "") << reader.name << " at " << end;
    }
}

TEST(LongLines, OfValuesAreRead) {
  const std::string values = repeated("1.0E-01-1.0E-01 .1 ");
  const std::size_t count = 3 * values.size() / 19;
  const std::string header = "a\nb\nACCELERATION IN UNITS OF G\nNPTS= " + std::to_string(count) + ", DT= .02 SEC\n";
  EXPECT_EQ(read_peer_at2({"record", header + values + "\n", ""})[0].samples.size(), count);
}

// No number begins at any of the digits: a reader that scanned from each of them would not end.
TEST(LongLines, OfDigitsAreScannedOnce) {
  const std::string digits(megabyte, '1');
  for (const std::string& text : {digits, digits + "e", "." + digits + "e", digits + "e" + digits}) {
    EXPECT_FALSE(first_number(text));
    EXPECT_TRUE(numbers_in(text).empty());
  }
  EXPECT_EQ(first_number(digits + "e 25")->value, 25.0);
  EXPECT_EQ(numbers_in(digits + "e/25/" + digits + " 3"), (std::vector<double>{25.0, 3.0}));
}

class LongLinesOfFiles : public MotionFiles {};

TEST_F(LongLinesOfFiles, AreReadOrRefusedWhenTheContentDecides) {
  for (const Reader& reader : readers)
    for (const std::string piece : {" ", "0", "(Format v", "units of"}) {
      const auto file = write("record.txt", repeated(piece) + reader.text);
      try {
        (void)read_motion(file, 1.0 * units::g);
      } catch (const Error& error) {
        EXPECT_LT(std::string{error.what()}.size(), 1000u + file.string().size());
      }
    }
}

}  // namespace
}  // namespace moat
