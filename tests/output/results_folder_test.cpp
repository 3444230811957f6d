#include "output/results_folder.hpp"

#include <fstream>

#include "output/summary.hpp"
#include "output_testing.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing_output::message_of;

class ResultsFolderTest : public testing_output::InFolder {
 protected:
  static void put(const fs::path& path) {
    fs::create_directories(path.parent_path());
    std::ofstream{path} << "something";
  }
  // The file by which a folder of moat's is known.
  static void put_summary(const fs::path& results) {
    put(results / "summary.json");
    write_summary_json({}, results / "summary.json");
  }
};

TEST_F(ResultsFolderTest, IsCreatedWithTheFoldersAbove) {
  const fs::path wanted = folder / "results" / "suite" / "x";
  for (const auto when : {WhenFolderExists::use_new_number, WhenFolderExists::overwrite, WhenFolderExists::refuse}) {
    fs::remove_all(folder / "results");
    EXPECT_EQ(make_results_folder(wanted, when), wanted);
    EXPECT_TRUE(fs::is_directory(wanted));
    EXPECT_EQ(make_results_folder(wanted, when), wanted) << "an empty folder is taken as it is";
  }
}

TEST_F(ResultsFolderTest, TakesTheNextFreeNumber) {
  put(folder / "x" / "summary.json");
  EXPECT_EQ(make_results_folder(folder / "x", WhenFolderExists::use_new_number), folder / "x_2");
  EXPECT_EQ(make_results_folder(folder / "x", WhenFolderExists::use_new_number), folder / "x_3");
  put(folder / "x_4");
  EXPECT_EQ(make_results_folder(folder / "x/", WhenFolderExists::use_new_number), folder / "x_5");
}

TEST_F(ResultsFolderTest, OverwritingKeepsWhatMoatDidNotWrite) {
  const fs::path x = folder / "x";
  for (const char* name : {"summary.json", "histories.csv", "histories.vtt", "impacts.csv", "frames.pvd", "report.html",
                           "frames/frame_000000.vtu", "frames/frame_1234567.vtu"}) {
    EXPECT_TRUE(is_results_file(name)) << name;
    put(x / name);
  }
  put_summary(x);
  const std::vector<fs::path> foreign{"notes.txt",
                                      "frame_000000.vtu",
                                      "frames/mine.vtu",
                                      "frames/a.csv",
                                      "frames/frame_00000.vtu",
                                      "frames/frame_00000a.vtu",
                                      "old/summary.json",
                                      "frames/deep/frame_000000.vtu"};
  for (const fs::path& name : foreign) {
    EXPECT_FALSE(is_results_file(name)) << name;
    put(x / name);
  }
  EXPECT_EQ(make_results_folder(x, WhenFolderExists::overwrite), x);
  std::size_t left = 0;
  for (const auto& entry : fs::recursive_directory_iterator{x}) left += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(left, foreign.size());
  for (const fs::path& name : foreign) EXPECT_TRUE(fs::exists(x / name)) << name;
}

TEST_F(ResultsFolderTest, OverwritingRemovesTheEmptyFramesFolder) {
  put(folder / "x" / "frames" / "frame_000000.vtu");
  make_results_folder(folder / "x", WhenFolderExists::overwrite);
  EXPECT_TRUE(fs::is_empty(folder / "x"));
}

TEST_F(ResultsFolderTest, OverwritingDoesNotFollowLinks) {
  put(folder / "elsewhere" / "frame_000000.vtu");
  put(folder / "x" / "notes.txt");
  fs::create_directory_symlink(folder / "elsewhere", folder / "x" / "frames");
  make_results_folder(folder / "x", WhenFolderExists::overwrite);
  EXPECT_TRUE(fs::exists(folder / "elsewhere" / "frame_000000.vtu"));
}

TEST_F(ResultsFolderTest, OverwritingUnlinksTheNamesOfItsFiles) {
  // What is written to a link lands elsewhere.
  const fs::path x = folder / "x";
  put_summary(x);
  put(folder / "victim.txt");
  put(folder / "elsewhere" / "mine.txt");
  fs::create_symlink("../victim.txt", x / "report.html");
  fs::create_symlink("../nothing", x / "charts.svg");
  fs::create_symlink("../victim.txt", x / "notes.txt");
  fs::create_directory_symlink("../elsewhere", x / "frames");
  EXPECT_EQ(make_results_folder(x, WhenFolderExists::overwrite), x);
  for (const char* name : {"report.html", "charts.svg", "frames"})
    EXPECT_EQ(fs::symlink_status(x / name).type(), fs::file_type::not_found) << name;
  EXPECT_TRUE(fs::is_symlink(x / "notes.txt"));
  EXPECT_EQ(testing_output::read_file(folder / "victim.txt"), "something");
  EXPECT_TRUE(fs::exists(folder / "elsewhere" / "mine.txt"));
}

TEST_F(ResultsFolderTest, OverwritingRefusesFilesThatMoatDidNotWrite) {
  const fs::path x = folder / "x";
  put(x / "report.html");
  put(x / "histories.csv");
  const auto overwrite = [&] { make_results_folder(x, WhenFolderExists::overwrite); };
  const std::string refusal = "results folder " + x.string() +
                              " has files with the names of results, but no summary.json of moat beside them: they may "
                              "not be results. Choose another folder, or remove them.";
  EXPECT_EQ(message_of<InputError>(overwrite), refusal);
  put(x / "summary.json");
  EXPECT_EQ(message_of<InputError>(overwrite), refusal) << "of another program";
  EXPECT_EQ(testing_output::read_file(x / "report.html"), "something");
  put_summary(x);
  EXPECT_EQ(make_results_folder(x, WhenFolderExists::overwrite), x);
  EXPECT_FALSE(fs::exists(x / "report.html"));
}

TEST_F(ResultsFolderTest, GivesDotsTheNameOfTheirFolder) {
  const fs::path real = fs::canonical(folder);
  put(folder / "x" / "notes.txt");
  fs::create_directory(folder / "x" / "empty");
  EXPECT_EQ(make_results_folder(folder / "x" / ".", WhenFolderExists::use_new_number), real / "x_2");
  EXPECT_EQ(make_results_folder(folder / "x" / "./", WhenFolderExists::use_new_number), real / "x_3");
  EXPECT_EQ(make_results_folder(folder / "x" / "empty" / "..", WhenFolderExists::use_new_number), real / "x_4");
  EXPECT_EQ(make_results_folder(folder / "x" / ".", WhenFolderExists::overwrite), real / "x");
  EXPECT_FALSE(fs::exists(folder / "x" / "._2"));
  EXPECT_EQ(message_of<InputError>([] { make_results_folder("/", WhenFolderExists::use_new_number); }),
            "results folder /: this is the root of all folders. Give a folder in it, for example results/run.");
}

TEST_F(ResultsFolderTest, RefusesAndSaysWhatToDo) {
  put(folder / "x" / "notes.txt");
  EXPECT_EQ(message_of<InputError>([&] { make_results_folder(folder / "x", WhenFolderExists::refuse); }),
            "results folder " + (folder / "x").string() +
                " exists and is not empty. Choose another folder, remove this one, or allow overwriting or a new "
                "number.");
  EXPECT_TRUE(fs::exists(folder / "x" / "notes.txt"));
  EXPECT_THROW(make_results_folder("", WhenFolderExists::overwrite), InputError);
}

TEST_F(ResultsFolderTest, ReportsAFileInTheWay) {
  put(folder / "x");
  for (const auto when : {WhenFolderExists::use_new_number, WhenFolderExists::overwrite, WhenFolderExists::refuse}) {
    EXPECT_NE(message_of<FileError>([&] { make_results_folder(folder / "x", when); }).find((folder / "x").string()),
              std::string::npos);
    EXPECT_THROW(make_results_folder(folder / "x" / "inside", when), FileError);
  }
  EXPECT_TRUE(fs::is_regular_file(folder / "x"));
}

}  // namespace
}  // namespace moat
