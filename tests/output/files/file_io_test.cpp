#include "output/files/file_io.hpp"

#include <cerrno>
#include <fstream>
#include <string>

#include "output_testing.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing_output::message_of;
using testing_output::read_file;

class WriteFile : public testing_output::InFolder {
 protected:
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator{folder}, fs::directory_iterator{}));
  }
};

TEST_F(WriteFile, ReplacesTheWholeFile) {
  write_file(folder / "a.txt", "a long text");
  write_file(folder / "a.txt", "short");
  EXPECT_EQ(read_file(folder / "a.txt"), "short");
  EXPECT_EQ(files(), 1u);
}

TEST_F(WriteFile, ReplacesALinkAndNotItsTarget) {
  write_file(folder / "victim.txt", "mine");
  fs::create_symlink("victim.txt", folder / "a.txt");
  write_file(folder / "a.txt", "new");
  EXPECT_EQ(read_file(folder / "victim.txt"), "mine");
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
}

TEST_F(WriteFile, LeavesTheOldFileWhereTheNewOneFails) {
  fs::create_directory(folder / "taken");
  EXPECT_NE(message_of<FileError>([&] { write_file(folder / "taken", "text"); }).find("cannot be put in its place"),
            std::string::npos);
  EXPECT_EQ(files(), 1u) << "nothing unfinished is left";
  EXPECT_NE(message_of<FileError>([&] { write_file(folder / "none" / "a.txt", "text"); }).find("cannot be created"),
            std::string::npos);
}

TEST_F(WriteFile, PutsPiecesOneAfterAnother) {
  std::string expected;
  write_file(folder / "a.txt", [&](std::ostream& file) {
    for (int i = 0; i < 5000; ++i) {
      const std::string piece(static_cast<std::size_t>(i % 7 + 1), static_cast<char>('a' + i % 26));
      file << piece;
      expected += piece;
    }
  });
  EXPECT_EQ(read_file(folder / "a.txt"), expected);
  EXPECT_EQ(files(), 1u);
}

TEST_F(WriteFile, LeavesTheOldFileWhereAnotherLibraryFailsToWrite) {
  write_file(folder / "a.txt", "old");
  const auto write_half = [&](int reason) {
    write_file(folder / "a.txt", [&](const std::string& unfinished) {
      std::ofstream{unfinished} << "half";
      return reason;
    });
  };
  EXPECT_EQ(message_of<FileError>([&] { write_half(ENOSPC); }),
            (folder / "a.txt").string() +
                ": cannot be written completely (No space left on device). Check that the "
                "folder exists, may be written to, and that the disk is not full.");
  EXPECT_EQ(read_file(folder / "a.txt"), "old");
  EXPECT_EQ(files(), 1u) << "nothing unfinished is left";
  write_half(0);
  EXPECT_EQ(read_file(folder / "a.txt"), "half");
}

TEST(FileName, HasSmallLettersDigitsAndUnderscores) {
  EXPECT_EQ(file_name_of("Impacts over gap"), "impacts_over_gap");
  EXPECT_EQ(file_name_of("2.659 s, moat left (A)"), "2_659_s_moat_left_a");
  EXPECT_EQ(file_name_of("../etc/passwd"), "etc_passwd");
  EXPECT_EQ(file_name_of(std::string(100000, 'A')), std::string(100, 'a'));
  EXPECT_EQ(file_name_of("H\u00f6he"), "h_he");
}

TEST(FileName, IsNeverEmpty) {
  for (const char* title : {"", "  ", "\u00e4\u00f6"}) EXPECT_EQ(file_name_of(title), "chart") << title;
}

}  // namespace
}  // namespace moat
