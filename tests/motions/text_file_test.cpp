#include "base/text/text_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <iostream>
#include <random>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "base/units.hpp"
#include "motion_files.hpp"
#include "motions/readers/read_motion.hpp"

namespace moat {
namespace {

class ReadTextFile : public MotionFiles {};

TEST_F(ReadTextFile, KnowsTheFileAgain) {
  const std::string content =
      "\xEF\xBB\xBF"
      "0 1\n";
  const TextFile file = read_text_file(write("a.txt", content));
  EXPECT_EQ(file.text, "0 1\n");
  EXPECT_EQ(file.sha256, sha256_of(content)) << "of the whole file, with its byte order mark";
  EXPECT_EQ(file_of(file).path, path("a.txt").string());
  EXPECT_EQ(file_of(file).sha256, file.sha256);
}

TEST_F(ReadTextFile, KnowsLinesOfOldMacintoshPrograms) {
  EXPECT_EQ(read_text_file(write("a.txt", "0 1\r0.1 2\r")).text, "0 1\n0.1 2\n");
  EXPECT_EQ(read_text_file(write("b.txt", "0 1\r\n0.1 2\r\n")).text, "0 1\r\n0.1 2\r\n");
}

TEST_F(ReadTextFile, RefusesWhatMayNeverEnd) {
  EXPECT_EQ(message_of<FileError>([] { (void)read_text_file("/dev/zero"); }),
            "/dev/zero: this is a device or a pipe, not a regular file. Save its content as a file.");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_THROW((void)read_text_file(path("pipe")), FileError);
}

// Compressed data look like random bytes.
std::string random_bytes(std::size_t count) {
  std::mt19937 random{7};
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(random() & 0xFFU);
  return bytes;
}

TEST_F(ReadTextFile, RefusesFilesThatAreNoPlainText) {
  using namespace std::string_literals;
  std::string columns;
  for (int i = 0; i < 1000; ++i) columns += std::to_string(i) + " 0.5\n";
  std::string utf_16 = "\xFF\xFE";
  for (const char letter : columns) utf_16 += letter + "\0"s;
  // "0 1" as gzip packs it.
  const std::string gzip = "\x1F\x8B\x08\0\0\0\0\0\0\x03\x33\x50\x30\xE4\x02\0\x3D\x60\x83\xF9\x04\0\0\0"s;
  // The header of an archive that holds the text as it is.
  const std::string tar = "record.txt" + std::string(90, '\0') + "0000644\0" + std::string(400, '\0') + columns;
  // The same of unzip.
  const std::string zip =
      "PK\x03\x04\x14\0\0\0\0\0\x74\x9F\x7B\x5D\xE3\xF6\xD8\x54\x40\x9C\0\0\x40\x9C\0\0\x07\0\0\0"s + "rec.txt" +
      columns;
  for (const std::string& content :
       {gzip, tar, zip, utf_16, "\x1F\x8B\x08" + random_bytes(100'000), "BZh91AY&SY" + random_bytes(500),
        "(\xB5/\xFD" + random_bytes(2000), std::string(1000, '\0')}) {
    const auto file = write("record.AT2", content);
    const std::string message =
        file.string() +
        ": this is no plain text: it holds many control characters. If the file is compressed or an archive, unpack it "
        "(gunzip, unzip, tar) and give the file in it; else save it as text in UTF-8.";
    EXPECT_EQ(message_of<FileError>([&] { (void)read_motion(file); }), message);
    EXPECT_EQ(message_of<FileError>([&] { (void)read_motion(file, 1.0 * units::g); }), message);
  }
}

TEST_F(ReadTextFile, TakesTextWithAControlCharacterAndOtherLetters) {
  for (const char* content : {"# Z\xC3\xBCrich\n0 1\n0.1 2\n", "# Z\xFCrich\n0 1\n0.1 2\n",
                              "# \x1B[31m red\n0 1\n0.1 2\n", "0\t1\r\n0.1\t2\r\n\f"})
    EXPECT_EQ(read_text_file(write("a.txt", content)).text, content);
}

TEST_F(ReadTextFile, SaysThatTheMemoryIsTooSmall) {
  const auto large = write("large.txt", "0 1\n");
  std::filesystem::resize_file(large, 900'000'000);
  const auto read_with_little_memory = [&] {
    std::size_t pages = 0;
    std::ifstream{"/proc/self/statm"} >> pages;
    const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + 100'000'000;
    const rlimit limit{most, most};
    setrlimit(RLIMIT_AS, &limit);
    std::cerr << message_of<FileError>([&] { (void)read_motion(large); });
    std::_Exit(0);
  };
  EXPECT_EXIT(read_with_little_memory(), ::testing::ExitedWithCode(0),
              "large.txt: the memory is too small for this record. Cut the record, or end other programs.");
}

TEST_F(ReadTextFile, RefusesHugeFiles) {
  const auto huge = write("huge.txt", "0 1\n");
  std::filesystem::resize_file(huge, 1'000'000'001);
  EXPECT_EQ(message_of<FileError>([&] { (void)read_text_file(huge); }),
            huge.string() + ": the file has more than 1 GB. Give one record, or one table.");
}

TEST(NumberText, ReadsWhatFortranAndCWrite) {
  EXPECT_EQ(parse_number("-.1234E-03").value, -0.1234e-3);
  EXPECT_EQ(parse_number("0.1D-02").value, 0.1e-2);
  EXPECT_EQ(parse_number("1.5d+1").value, 15.0);
  EXPECT_EQ(parse_number("+5.").value, 5.0);
  EXPECT_EQ(parse_number("12").value, 12.0);
  EXPECT_EQ(parse_number("1e10").value, 1e10);
  EXPECT_EQ(parse_number("6.5114120E-005").value, 6.511412e-5);
  for (const char* text : {"-.1234E-03", "0.1D-02", "+5.", "12"})
    EXPECT_EQ(parse_number(text).problem, nullptr) << text;
}

TEST(NumberText, RefusesEverythingElse) {
  for (const char* text :
       {"", "-", ".", "+.", "nan", "inf", "-Infinity", "****", "abc", "0x10", "1,5", "1.2.3", "--1", "1 2", " 1", "1 "})
    EXPECT_STREQ(parse_number(text).problem, "is not a number") << '"' << text << '"';
  EXPECT_STREQ(parse_number("1.0E").problem, "has no digits in its exponent");
  EXPECT_STREQ(parse_number("1.0E+").problem, "has no digits in its exponent");
  EXPECT_STREQ(parse_number("1.0E-0312").problem, "has more than three digits in its exponent");
  EXPECT_STREQ(parse_number("1E400").problem, "is too large or too small for a double");
  EXPECT_STREQ(parse_number("1E-400").problem, "is too large or too small for a double");
}

TEST(NumberText, StopsBehindTheFirstNumber) {
  const ScannedNumber with_exponent = scan_number("-.123E-03-.456E-03");
  EXPECT_EQ(with_exponent.value, -0.123e-3);
  EXPECT_EQ(with_exponent.length, std::string{"-.123E-03"}.size());
  EXPECT_TRUE(with_exponent.has_exponent);
  const ScannedNumber without_exponent = scan_number("0.5-3");
  EXPECT_EQ(without_exponent.length, 3u);
  EXPECT_FALSE(without_exponent.has_exponent);
}

}  // namespace
}  // namespace moat
