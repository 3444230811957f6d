#include "output/files/results_folder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <barrier>
#include <fstream>
#include <set>
#include <thread>

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
  // Complete results, which moat knows by the list of their files.
  static void put_results(const fs::path& results, const std::vector<std::string>& names = {"summary.json"}) {
    ResultsFolder run{results, WhenFolderExists::use_new_number};
    for (const std::string& name : names) put(run.path() / name);
    run.finish();
  }
  static std::set<std::string> names_in(const fs::path& path) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator{path}) names.insert(entry.path().filename().string());
    return names;
  }
  // As a run that is killed behind `work`.
  static void killed(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child == 0) {
      work();
      _exit(0);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
  }
  // As a run does that leaves nothing.
  static void overwrite(const fs::path& results) { ResultsFolder{results, WhenFolderExists::overwrite}.finish(); }
};

TEST_F(ResultsFolderTest, IsCreatedWithTheFoldersAbove) {
  const fs::path wanted = folder / "results" / "suite" / "x";
  for (const auto when : {WhenFolderExists::use_new_number, WhenFolderExists::overwrite}) {
    fs::remove_all(folder / "results");
    EXPECT_EQ(ResultsFolder(wanted, when).path(), wanted);
    EXPECT_TRUE(fs::is_directory(wanted));
    EXPECT_EQ(ResultsFolder(wanted, when).path(), wanted) << "an empty folder is taken as it is";
  }
}

TEST_F(ResultsFolderTest, TakesTheNextFreeNumber) {
  put(folder / "x" / "summary.json");
  EXPECT_EQ(ResultsFolder(folder / "x", WhenFolderExists::use_new_number).path(), folder / "x_2");
  EXPECT_EQ(ResultsFolder(folder / "x", WhenFolderExists::use_new_number).path(), folder / "x_3");
  put(folder / "x_4");
  ResultsFolder fifth{folder / "x/", WhenFolderExists::use_new_number};
  EXPECT_EQ(fifth.path(), folder / "x_5");
  fifth.finish();
  EXPECT_EQ(fifth.final_path(), folder / "x_5");
}

TEST_F(ResultsFolderTest, OldResultsStayUntilNewOnesAreComplete) {
  const fs::path x = folder / "x";
  put_results(x, {"report.html", "charts.svg", "frames/frame_000000.vtu", "summary.json"});
  {
    const ResultsFolder stopped{x, WhenFolderExists::overwrite};
    put(stopped.path() / "frames" / "frame_000000.vtu");
    put(stopped.path() / "report.html");
  }
  for (const char* name : {"summary.json", "report.html", "charts.svg", "frames/frame_000000.vtu"})
    EXPECT_EQ(testing_output::read_file(x / name), "something") << name;

  ResultsFolder complete{x, WhenFolderExists::overwrite};
  EXPECT_EQ(complete.path(), folder / "x.new") << "the folder of the stopped run is taken over";
  EXPECT_EQ(names_in(complete.path()), std::set<std::string>{"unfinished"});
  std::ofstream{complete.path() / "summary.json"} << "new";
  std::ofstream{complete.path() / "report.html"} << "new";
  fs::create_directory(complete.path() / "frames");
  std::ofstream{complete.path() / "frames" / "frame_000001.vtu"} << "new";
  complete.finish();
  complete.finish();
  EXPECT_EQ(complete.path(), x);
  for (const char* name : {"summary.json", "report.html", "frames/frame_000001.vtu"})
    EXPECT_EQ(testing_output::read_file(x / name), "new") << name;
  for (const char* name : {"charts.svg", "frames/frame_000000.vtu"}) EXPECT_FALSE(fs::exists(x / name)) << name;
  EXPECT_FALSE(fs::exists(folder / "x.new"));
}

TEST_F(ResultsFolderTest, IncompleteResultsGetTheNextNumber) {
  const fs::path x = folder / "x";
  put_results(x, {"report.html", "summary.json"});
  put(folder / "x_2");
  ResultsFolder stopped{x, WhenFolderExists::overwrite};
  put(stopped.path() / "charts.svg");
  put(stopped.path() / "frames" / "frame_000000.vtu");
  EXPECT_TRUE(stopped.finish_incomplete());
  EXPECT_EQ(stopped.final_path(), folder / "x_3");
  EXPECT_EQ(stopped.path(), folder / "x_3");
  EXPECT_FALSE(stopped.finish_incomplete()) << "they have their place";
  stopped.finish();
  for (const char* name : {"x/report.html", "x/summary.json", "x_3/charts.svg", "x_3/frames/frame_000000.vtu"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  for (const char* name : {"x/charts.svg", "x_3/report.html", "x.new", "x_4"})
    EXPECT_FALSE(fs::exists(folder / name)) << name;
}

TEST_F(ResultsFolderTest, IncompleteResultsStayWhereNoneWere) {
  for (const auto when : {WhenFolderExists::use_new_number, WhenFolderExists::overwrite}) {
    ResultsFolder stopped{folder / "x", when};
    EXPECT_FALSE(stopped.finish_incomplete());
    EXPECT_EQ(stopped.final_path(), folder / "x");
  }
}

// Runs that start at one moment, as of a shell's loop or of an array of jobs.
TEST_F(ResultsFolderTest, RunsThatStartTogetherHaveFoldersOfTheirOwn) {
  constexpr int runs = 8;
  for (const auto when : {WhenFolderExists::use_new_number, WhenFolderExists::overwrite})
    for (const bool exists : {false, true})
      for (int round = 0; round < 25; ++round) {
        fs::remove_all(folder / "x");
        for (const auto& entry : fs::directory_iterator{folder}) fs::remove_all(entry.path());
        if (exists) fs::create_directory(folder / "x");
        std::vector<std::unique_ptr<ResultsFolder>> folders(runs);
        std::barrier start{runs};
        std::vector<std::thread> threads;
        for (int run = 0; run < runs; ++run)
          threads.emplace_back([&, run] {
            start.arrive_and_wait();
            folders[run] = std::make_unique<ResultsFolder>(folder / "x", when);
          });
        for (std::thread& thread : threads) thread.join();
        std::set<fs::path> paths;
        for (const auto& each : folders) EXPECT_TRUE(paths.insert(each->path()).second) << each->path();
        EXPECT_TRUE(paths.contains(folder / "x"));
      }
}

TEST_F(ResultsFolderTest, NamesItsRunUntilItIsFinished) {
  put_results(folder / "old");
  for (const char* name : {"x", "old"}) {
    ResultsFolder results{folder / name, WhenFolderExists::overwrite, "moat run tower.cpp --out 'x y'"};
    std::array<char, 256> host{};
    ASSERT_EQ(gethostname(host.data(), host.size()), 0);
    const std::string text = testing_output::read_file(results.path() / "unfinished");
    for (const std::string& part :
         {std::string{"\ncommand: moat run tower.cpp --out 'x y'\n"}, "\nhost: " + std::string{host.data()} + "\n",
          "\nprocess: " + std::to_string(getpid()) + "\n", std::string{"\nstart: 20"}})
      EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
    put(results.path() / "report.html");
    results.finish();
    EXPECT_EQ(names_in(folder / name), (std::set<std::string>{"report.html", ".moat"}));
  }
}

TEST_F(ResultsFolderTest, OfAKilledRunStaysUnfinished) {
  killed([&] {
    const auto* run = new ResultsFolder{folder / "x", WhenFolderExists::use_new_number};
    put(run->path() / "frames" / "frame_000000.vtu");
  });
  EXPECT_TRUE(fs::exists(folder / "x" / "unfinished"));
  EXPECT_EQ(ResultsFolder(folder / "x", WhenFolderExists::use_new_number).path(), folder / "x_2");
  put(folder / "x" / "report.html");
  put(folder / "x" / "mine.txt");
  ResultsFolder forced{folder / "x", WhenFolderExists::overwrite};
  put(forced.path() / "summary.json");
  forced.finish();
  EXPECT_EQ(names_in(folder / "x"), (std::set<std::string>{"summary.json", "mine.txt", ".moat"}));
}

TEST_F(ResultsFolderTest, OfAKilledRunBesideIsTakenOver) {
  put_results(folder / "x");
  killed([&] {
    const auto* run = new ResultsFolder{folder / "x", WhenFolderExists::overwrite};
    put(run->path() / "report.html");
  });
  EXPECT_EQ(names_in(folder / "x.new"), (std::set<std::string>{"unfinished", "report.html"}));
  ResultsFolder forced{folder / "x", WhenFolderExists::overwrite, "another command"};
  EXPECT_EQ(forced.path(), folder / "x.new");
  EXPECT_EQ(names_in(forced.path()), std::set<std::string>{"unfinished"});
  EXPECT_NE(testing_output::read_file(forced.path() / "unfinished").find("another command"), std::string::npos);
}

TEST_F(ResultsFolderTest, AnExceptionLeavesItUnfinished) {
  try {
    const ResultsFolder run{folder / "x", WhenFolderExists::use_new_number};
    throw FileError{"a full disk"};
  } catch (const FileError&) {
  }
  EXPECT_TRUE(fs::exists(folder / "x" / "unfinished"));
  { const ResultsFolder run{folder / "y", WhenFolderExists::use_new_number}; }
  EXPECT_TRUE(fs::is_empty(folder / "y")) << "finish() was forgotten";
}

TEST_F(ResultsFolderTest, ResultsOfARunThatGoesOnAreNotReplaced) {
  ResultsFolder first{folder / "x", WhenFolderExists::overwrite}, second{folder / "x", WhenFolderExists::overwrite};
  EXPECT_EQ(second.path(), folder / "x.new");
  put(first.path() / "impacts.csv");
  put(second.path() / "report.html");
  second.finish();
  EXPECT_EQ(second.final_path(), folder / "x_2");
  put(first.path() / "summary.json");
  first.finish();
  EXPECT_EQ(names_in(folder / "x"), (std::set<std::string>{"summary.json", "impacts.csv", ".moat"}));
  EXPECT_EQ(names_in(folder / "x_2"), (std::set<std::string>{"report.html", ".moat"}));
  EXPECT_FALSE(fs::exists(folder / "x.new"));
}

// The last one wins, and no two mix.
TEST_F(ResultsFolderTest, RunsThatEndTogetherReplaceEachOther) {
  constexpr int runs = 4;
  for (int round = 0; round < 6; ++round) {
    fs::remove_all(folder / "x");
    put_results(folder / "x");
    std::barrier end{runs};
    std::vector<std::thread> threads;
    for (int run = 0; run < runs; ++run)
      threads.emplace_back([&, run] {
        ResultsFolder results{folder / "x", WhenFolderExists::overwrite};
        for (const char* name :
             {"summary.json", "report.html", "frames/frame_000000.vtu", "charts/a.svg", "charts/a.csv"}) {
          put(results.path() / name);
          std::ofstream{results.path() / name} << "of run " << run;
        }
        end.arrive_and_wait();
        results.finish();
        EXPECT_EQ(results.final_path(), folder / "x");
      });
    for (std::thread& thread : threads) thread.join();
    std::set<std::string> texts;
    for (const char* name : {"summary.json", "report.html", "frames/frame_000000.vtu", "charts/a.svg", "charts/a.csv"})
      texts.insert(testing_output::read_file(folder / "x" / name));
    EXPECT_EQ(texts.size(), 1u);
    EXPECT_EQ(names_in(folder), std::set<std::string>{"x"});
    EXPECT_EQ(names_in(folder / "x"),
              (std::set<std::string>{"summary.json", "report.html", "frames", "charts", ".moat"}));
  }
}

TEST_F(ResultsFolderTest, WhatStandsBesideIsNotTaken) {
  put_results(folder / "x");
  put(folder / "victim" / "report.html");
  put(folder / "x.new_2" / "report.html");
  fs::create_directory_symlink("victim", folder / "x.new");
  ResultsFolder results{folder / "x", WhenFolderExists::overwrite};
  EXPECT_EQ(results.path(), folder / "x.new_3");
  results.finish();
  for (const char* name : {"victim", "x.new_2"})
    EXPECT_EQ(names_in(folder / name), std::set<std::string>{"report.html"}) << name;
}

TEST_F(ResultsFolderTest, AFileOfTheUserIsNoMark) {
  for (const char* name : {"unfinished", ".moat"}) {
    put(folder / name / name);
    EXPECT_THROW(overwrite(folder / name), InputError);
    EXPECT_EQ(testing_output::read_file(folder / name / name), "something");
  }
}

TEST_F(ResultsFolderTest, OverwritingKeepsWhatMoatDidNotWrite) {
  const fs::path x = folder / "x";
  put_results(x, {"summary.json", "histories.csv", "frames.pvd", "report.html", "frames/frame_000000.vtu",
                  "charts/drift.svg", "charts/drift.csv"});
  const std::vector<fs::path> foreign{"notes.txt",        "impacts.csv",      "frame_000000.vtu",
                                      "frames/mine.vtu",  "old/summary.json", "charts/drift_2020.svg",
                                      "charts/notes.txt", "charts/drift"};
  for (const fs::path& name : foreign) put(x / name);
  // Twice: they are no files of moat's after the first time either.
  for (const char* frame : {"frames/frame_000000.vtu", "frames/frame_000001.vtu"}) {
    ResultsFolder results{x, WhenFolderExists::overwrite};
    put(results.path() / frame);
    results.finish();
    std::size_t left = 0;
    for (const auto& entry : fs::recursive_directory_iterator{x}) left += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(left, foreign.size() + 2) << "the frame and the list";
    for (const fs::path& name : foreign) EXPECT_TRUE(fs::exists(x / name)) << name;
    EXPECT_TRUE(fs::exists(x / frame));
    EXPECT_FALSE(fs::exists(folder / "x.new"));
  }
}

TEST_F(ResultsFolderTest, OverwritingRemovesTheEmptyFramesFolder) {
  put_results(folder / "x", {"frames/frame_000000.vtu"});
  overwrite(folder / "x");
  EXPECT_EQ(names_in(folder / "x"), std::set<std::string>{".moat"});
}

TEST_F(ResultsFolderTest, OverwritingUnlinksTheNamesOfItsFiles) {
  // A write to a link changes a file outside the folder.
  const fs::path x = folder / "x";
  put_results(x, {"report.html", "charts.svg", "frames/frame_000000.vtu"});
  put(folder / "victim.txt");
  put(folder / "elsewhere" / "frame_000000.vtu");
  fs::remove_all(x / "frames");
  for (const char* name : {"report.html", "charts.svg"}) fs::remove(x / name);
  fs::create_symlink("../victim.txt", x / "report.html");
  fs::create_symlink("../nothing", x / "charts.svg");
  fs::create_symlink("../victim.txt", x / "unfinished");
  fs::create_symlink("../victim.txt", x / "notes.txt");
  fs::create_directory_symlink("../elsewhere", x / "frames");
  fs::create_directory_symlink("../elsewhere", x / "charts");
  ResultsFolder results{x, WhenFolderExists::overwrite};
  put(results.path() / "frames" / "frame_000000.vtu");
  put(results.path() / "charts" / "frame_000000.vtu");
  results.finish();
  for (const char* name : {"report.html", "charts.svg", "unfinished"})
    EXPECT_EQ(fs::symlink_status(x / name).type(), fs::file_type::not_found) << name;
  for (const char* name : {"frames", "charts"}) EXPECT_FALSE(fs::is_symlink(x / name)) << name;
  EXPECT_TRUE(fs::is_symlink(x / "notes.txt"));
  EXPECT_EQ(testing_output::read_file(folder / "victim.txt"), "something");
  EXPECT_EQ(names_in(folder / "elsewhere"), std::set<std::string>{"frame_000000.vtu"});
}

TEST_F(ResultsFolderTest, OverwritingKeepsTheFilesOfTheUserAndTheRightsOfTheFolder) {
  const fs::path x = folder / "x";
  put_results(x);
  put(x / "notes.txt");
  fs::create_hard_link(x / "notes.txt", folder / "same");
  const fs::perms rights = fs::perms::owner_all | fs::perms::group_all;
  fs::permissions(x, rights);
  overwrite(x);
  EXPECT_TRUE(fs::equivalent(x / "notes.txt", folder / "same")) << "no copy";
  EXPECT_EQ(fs::hard_link_count(x / "notes.txt"), 2u);
  EXPECT_EQ(fs::status(x).permissions(), rights);
}

TEST_F(ResultsFolderTest, AFileOfTheUserIsNotReplacedByAResultOfItsName) {
  const fs::path x = folder / "x";
  put_results(x);
  for (const char* name : {"notes.txt", "impacts.csv"}) put(x / name);
  ResultsFolder results{x, WhenFolderExists::overwrite};
  for (const char* name : {"summary.json", "impacts.csv"}) std::ofstream{results.path() / name} << "new";
  results.finish();
  EXPECT_EQ(results.final_path(), folder / "x_2");
  EXPECT_EQ(names_in(folder / "x_2"), (std::set<std::string>{"summary.json", "impacts.csv", ".moat"}));
  EXPECT_EQ(names_in(x), (std::set<std::string>{"summary.json", "notes.txt", "impacts.csv", ".moat"}));
  EXPECT_EQ(testing_output::read_file(x / "summary.json"), "something");
  EXPECT_EQ(testing_output::read_file(x / "impacts.csv"), "something");
}

TEST_F(ResultsFolderTest, OverwritingReplacesTheResultsBehindALink) {
  put_results(folder / "disk" / "x");
  fs::create_directory_symlink("disk/x", folder / "x");
  ResultsFolder results{folder / "x", WhenFolderExists::overwrite};
  std::ofstream{results.path() / "summary.json"} << "new";
  results.finish();
  EXPECT_TRUE(fs::is_symlink(folder / "x"));
  EXPECT_EQ(testing_output::read_file(folder / "x" / "summary.json"), "new");
  EXPECT_EQ(names_in(folder / "disk"), std::set<std::string>{"x"});
}

TEST_F(ResultsFolderTest, ResultsThatTheUserRemovedMeanwhileAreNoObstacle) {
  put_results(folder / "x");
  ResultsFolder results{folder / "x", WhenFolderExists::overwrite};
  put(results.path() / "report.html");
  fs::remove_all(folder / "x");
  results.finish();
  EXPECT_EQ(results.final_path(), folder / "x");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"x"});
  EXPECT_EQ(names_in(folder / "x"), (std::set<std::string>{"report.html", ".moat"}));
}

TEST_F(ResultsFolderTest, OverwritingRefusesAFolderWithoutTheListOfItsFiles) {
  const fs::path x = folder / "x";
  for (const char* name : {"report.html", "histories.csv", "summary.json"}) put(x / name);
  EXPECT_EQ(message_of<InputError>([&] { overwrite(x); }),
            "results folder " + x.string() +
                " has no list of files that moat wrote (.moat), and is not replaced. Choose another folder, or remove "
                "this one.");
  EXPECT_EQ(testing_output::read_file(x / "report.html"), "something");
}

TEST_F(ResultsFolderTest, GivesDotsTheNameOfTheirFolder) {
  const fs::path real = fs::canonical(folder);
  const auto numbered = [](const fs::path& wanted) {
    return ResultsFolder{wanted, WhenFolderExists::use_new_number}.path();
  };
  put(folder / "x" / "notes.txt");
  fs::create_directory(folder / "x" / "empty");
  EXPECT_EQ(numbered(folder / "x" / "."), real / "x_2");
  EXPECT_EQ(numbered(folder / "x" / "./"), real / "x_3");
  EXPECT_EQ(numbered(folder / "x" / "empty" / ".."), real / "x_4");
  EXPECT_FALSE(fs::exists(folder / "x" / "._2"));
  EXPECT_EQ(message_of<InputError>([&] { (void)numbered("/"); }),
            "results folder /: this is the root of all folders. Give a folder in it, for example results/run.");
  EXPECT_THROW(ResultsFolder("", WhenFolderExists::overwrite), InputError);
}

TEST_F(ResultsFolderTest, ReportsAFileInTheWay) {
  put(folder / "x");
  for (const auto when : {WhenFolderExists::use_new_number, WhenFolderExists::overwrite}) {
    EXPECT_NE(message_of<FileError>([&] { ResultsFolder(folder / "x", when); }).find((folder / "x").string()),
              std::string::npos);
    EXPECT_THROW(ResultsFolder(folder / "x" / "inside", when), FileError);
  }
  EXPECT_TRUE(fs::is_regular_file(folder / "x"));
}

}  // namespace
}  // namespace moat
