#include "output/file_io.hpp"

#include <string>
#include <string_view>
#include <vector>

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
  // More than the kernel takes at once, and empty ones among them.
  std::string expected;
  std::vector<std::string> texts;
  for (int i = 0; i < 5000; ++i)
    texts.push_back(std::string(static_cast<std::size_t>(i % 7), static_cast<char>('a' + i % 26)));
  std::vector<std::string_view> pieces;
  for (const std::string& text : texts) {
    pieces.push_back(text);
    expected += text;
  }
  write_file(folder / "a.txt", pieces);
  EXPECT_EQ(read_file(folder / "a.txt"), expected);
  write_unlisted_file(folder / "b.txt", pieces);
  EXPECT_EQ(read_file(folder / "b.txt"), expected);
  EXPECT_EQ(files(), 2u);
}

TEST_F(WriteFile, RemovesWhatHasTheNameOfAnUnlistedFile) {
  const std::vector<std::string_view> pieces{"new"};
  write_file(folder / "victim.txt", "mine");
  fs::create_symlink("victim.txt", folder / "a.txt");
  write_unlisted_file(folder / "a.txt", pieces);
  EXPECT_EQ(read_file(folder / "victim.txt"), "mine");
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
  fs::create_directories(folder / "taken" / "inside");
  EXPECT_NE(message_of<FileError>([&] { write_unlisted_file(folder / "taken", pieces); }).find("cannot be created"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
