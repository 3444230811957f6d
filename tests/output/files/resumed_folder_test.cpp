// Results folders of runs that were killed or stopped.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "in_folder.hpp"
#include "message_of.hpp"
#include "output/files/folder_exchange.hpp"
#include "output/files/results_folder.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing::message_of;

class ResumedFolder : public testing::InFolder {
 protected:
  static void put(const fs::path& path, const std::string& text = "something") {
    fs::create_directories(path.parent_path());
    std::ofstream{path} << text;
  }
  // Complete results, as of a run that a signal stopped.
  static void put_results(const fs::path& results, const std::vector<std::string>& names) {
    ResultsFolder run{results, WhenFolderExists::use_new_number};
    for (const std::string& name : names) put(run.path() / name);
    run.finish();
  }
  static std::set<std::string> names_in(const fs::path& results) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator{results})
      names.insert(entry.path().lexically_relative(results).string());
    return names;
  }
  void go_on() const { ResultsFolder{x, WhenFolderExists::go_on}; }

  const fs::path x = folder / "x";
};

TEST_F(ResumedFolder, IsTheFirstOneWithACheckpoint) {
  EXPECT_NE(message_of([&] { go_on(); }).find(" has no checkpoint of a run that was killed or stopped."),
            std::string::npos);
  put_results(folder / "disk/x", {"summary.json"});
  put(folder / "disk/x.new/report.html");
  put(folder / "disk/x.new_2/checkpoint");
  put(folder / "disk/x.new_2/unfinished", std::string{about_unfinished} + "folder: x.new_2\n");
  fs::create_directory_symlink("disk/x", x);
  EXPECT_EQ(folder_with_checkpoint(x), fs::canonical(folder) / "disk/x.new_2");
  ResultsFolder run{x, WhenFolderExists::go_on};
  EXPECT_EQ(run.path(), fs::canonical(folder) / "disk/x.new_2");
  run.finish();
  EXPECT_TRUE(fs::is_symlink(x));
  EXPECT_EQ(names_in(folder / "disk"),
            (std::set<std::string>{"x", "x/.moat", "x/checkpoint", "x.new", "x.new/report.html"}));
}

TEST_F(ResumedFolder, IsTakenByOneRunAlone) {
  put_results(x, {"summary.json", "checkpoint"});
  const std::string refusal = "results folder " + x.string() + ": another run computes there. Wait for its end.";
  // A run that replaces these results has locked their list.
  const int list = lock_file(x / results_file::list);
  EXPECT_EQ(message_of([&] { go_on(); }), refusal);
  close(list);
  EXPECT_EQ(names_in(x), (std::set<std::string>{"summary.json", "checkpoint", ".moat"}));
  ResultsFolder run{x, WhenFolderExists::go_on}, other{x, WhenFolderExists::overwrite};
  EXPECT_EQ(message_of([&] { go_on(); }), refusal);
  other.finish();
  EXPECT_EQ(other.final_path(), folder / "x_2");
  run.finish();
  EXPECT_EQ(names_in(x), (std::set<std::string>{"summary.json", "checkpoint", ".moat"}));
  fs::remove(x / results_file::list);
  fs::create_symlink("elsewhere", x / results_file::list);
  EXPECT_NE(message_of<FileError>([&] { go_on(); }).find("cannot be locked (Too many levels of symbolic links)"),
            std::string::npos);
}

TEST_F(ResumedFolder, KeepsNeitherChartsNorHalfFiles) {
  for (const bool was_killed : {false, true}) {
    SCOPED_TRACE(was_killed);
    fs::remove_all(x);
    put_results(x, {"summary.json", "checkpoint", "checkpoint.unfinished-7", "charts/gap.svg", "charts/gap.csv",
                    "frames/frame_000000.vtu", "frames/frame_000001.vtu.unfinished-7"});
    put(x / "draft.unfinished-7");  // of the user
    if (was_killed) {
      fs::remove(x / results_file::list);
      put(x / results_file::unfinished, about_unfinished);
    }
    const ResultsFolder run{x, WhenFolderExists::go_on};
    EXPECT_EQ(names_in(x), (std::set<std::string>{"summary.json", "checkpoint", "charts", "draft.unfinished-7",
                                                  "frames", "frames/frame_000000.vtu", "unfinished"}));
  }
}

// A run was killed behind the exchange, and another one has taken the name of the old results.
TEST_F(ResumedFolder, OfAnotherRunIsNotRemoved) {
  put_results(x, {"summary.json"});
  put(x / results_file::unfinished, std::string{about_unfinished} + "folder: x.new\n");
  put(folder / "x.new/unfinished", about_unfinished);
  put(folder / "x.new/impacts.csv");
  const int lock = lock_file(folder / "x.new/unfinished");
  const ResultsFolder third{x, WhenFolderExists::overwrite};
  EXPECT_EQ(third.path(), folder / "x.new_2");
  EXPECT_EQ(names_in(folder / "x.new"), (std::set<std::string>{"impacts.csv", "unfinished"}));
  EXPECT_EQ(names_in(x), (std::set<std::string>{"summary.json", ".moat"}));
  close(lock);
}

}  // namespace
}  // namespace moat
