#include "motions/text_file.hpp"

#include <sys/stat.h>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "motion_files.hpp"

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
            "/dev/zero: this is a device or a pipe, not a regular file. Save the record as a file.");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_THROW((void)read_text_file(path("pipe")), FileError);
}

TEST_F(ReadTextFile, RefusesHugeFiles) {
  const auto huge = write("huge.txt", "0 1\n");
  std::filesystem::resize_file(huge, 1'000'000'001);
  EXPECT_EQ(message_of<FileError>([&] { (void)read_text_file(huge); }),
            huge.string() + ": the file has more than 1 GB. Give one record of one component.");
}

}  // namespace
}  // namespace moat
