#include "output/files/file_io.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>

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
  std::string expected, piece;
  int count = 0;
  write_file(folder / "a.txt", [&]() -> std::string_view {
    piece =
        count < 5000 ? std::string(static_cast<std::size_t>(count % 7 + 1), static_cast<char>('a' + count % 26)) : "";
    ++count;
    expected += piece;
    return piece;
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

}  // namespace
}  // namespace moat
