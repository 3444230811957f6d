// A single run goes on from its checkpoint, with the results of one that nothing stopped.

#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/script/checkpoint_file.hpp"
#include "in_folder.hpp"
#include "message_of.hpp"
#include "random_draws.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class ResumedRun : public testing::InTemporaryFolder {
 protected:
  // A run of seconds, with a companion.
  static std::vector<std::string> arguments(const std::string& out, std::vector<std::string> more = {}) {
    std::vector<std::string> all{"--quiet", "--check",          "--no-sensitivity", "--step", "1e-4 s", "--end",
                                 "5 s",     "--frame-interval", "0.25 s",           "--out",  out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  testing::ProgramResult run(const std::string& out, std::vector<std::string> more = {}) {
    return testing::run_program(FIRST_TOUR, arguments(out, std::move(more)), folder);
  }
  // Starts a run that writes checkpoints as often as it may, and ends it by a signal after its first one.
  testing::ProgramResult ended_behind_checkpoint(int signal, std::vector<std::string> more = {},
                                                 const std::string& at = "out") {
    more.insert(more.end(), {"--checkpoint", "1 ms"});
    const testing::RunningProgram run{FIRST_TOUR, arguments("out", std::move(more)), folder};
    while (!fs::exists(folder / at / "checkpoint")) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    run.send(signal);
    return run.wait();
  }
  // The same after some time.
  testing::ProgramResult ended(int signal, std::chrono::milliseconds moment, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--checkpoint", "1 ms"});
    const testing::RunningProgram run{FIRST_TOUR, arguments("out", std::move(more)), folder};
    std::this_thread::sleep_for(moment);
    run.send(signal);
    return run.wait();
  }
  // Kills a run behind its first checkpoint.
  void kill_one() {
    const testing::RunningProgram run{FIRST_TOUR, arguments("out", {"--checkpoint", "1 ms"}), folder};
    while (!fs::exists(folder / "out/checkpoint")) std::this_thread::sleep_for(std::chrono::milliseconds{5});
    std::this_thread::sleep_for(std::chrono::milliseconds{200});
    run.send(SIGKILL);
    run.wait();
  }
  static json summary_without_times(const fs::path& results) {
    json summary = json::parse(testing::text_of(results / "summary.json"));
    summary.erase("provenance");
    const json flat = summary.flatten();
    for (const auto& [name, value] : flat.items())
      if (name.ends_with("/cpu_seconds")) summary.at(json::json_pointer{name}) = 0;
    return summary;
  }
  void expect_results_of_whole(const std::string& out) {
    EXPECT_EQ(summary_without_times(folder / out), summary_without_times(folder / "whole"));
    for (const auto& entry : fs::recursive_directory_iterator{folder / "whole"}) {
      const fs::path name = entry.path().lexically_relative(folder / "whole");
      if (entry.is_directory() || name == "summary.json" || name == "report.html") continue;
      EXPECT_TRUE(testing::text_of(folder / out / name) == testing::text_of(entry.path())) << name;
    }
    EXPECT_FALSE(fs::exists(folder / out / "checkpoint"));
    EXPECT_FALSE(fs::exists(folder / out / "unfinished"));
  }
};

TEST_F(ResumedRun, IsThatOfAnUndisturbedOneHoweverOftenItIsKilled) {
  ASSERT_EQ(run("whole").exit_code, 0);
  testing::RandomDraws random{20};
  std::vector<std::string> resume;
  for (int kill = 0; kill < 20; ++kill) {
    const testing::ProgramResult killed = ended(SIGKILL, std::chrono::milliseconds{random.integer(50, 500)}, resume);
    if (killed.exit_code == 0) break;
    EXPECT_EQ(killed.exit_code, -1) << killed.errors;
    if (fs::exists(folder / "out/checkpoint"))
      resume = {"--resume"};
    else
      fs::remove_all(folder / "out");
  }
  if (fs::exists(folder / "out/checkpoint")) {
    const testing::ProgramResult last = run("out", {"--resume"});
    ASSERT_EQ(last.exit_code, 0) << last.errors;
  }
  expect_results_of_whole("out");
}

TEST_F(ResumedRun, FollowsTheCommandThatAStoppedRunPrints) {
  ASSERT_EQ(run("whole").exit_code, 0);
  const testing::ProgramResult stopped = ended_behind_checkpoint(SIGTERM);
  ASSERT_EQ(stopped.exit_code, 143) << stopped.errors;
  EXPECT_TRUE(fs::exists(folder / "out/summary.json"));
  const std::string key = "moat: to go on: ";
  const std::size_t at = stopped.errors.find(key);
  ASSERT_NE(at, std::string::npos) << stopped.errors;
  const std::string command = stopped.errors.substr(at + key.size(), stopped.errors.find('\n', at) - at - key.size());
  const testing::ProgramResult resumed = testing::run_program("/bin/sh", {"-c", command}, folder);
  EXPECT_EQ(resumed.exit_code, 0) << command << "\n" << resumed.errors;
  expect_results_of_whole("out");
}

TEST_F(ResumedRun, ReplacesOldResultsAtItsEndOnly) {
  ASSERT_EQ(run("whole").exit_code, 0);
  ASSERT_EQ(run("out", {"--gap", "9 cm"}).exit_code, 0);
  const std::string old = testing::text_of(folder / "out/summary.json");
  ended_behind_checkpoint(SIGKILL, {"--force"}, "out.new");
  EXPECT_EQ(testing::text_of(folder / "out/summary.json"), old);
  const testing::ProgramResult resumed = run("out", {"--force", "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
  expect_results_of_whole("out");
  EXPECT_FALSE(fs::exists(folder / "out.new"));
}

TEST_F(ResumedRun, HasTheHistoriesUpToTheLastFlush) {
  ASSERT_EQ(run("whole").exit_code, 0);
  kill_one();
  const std::string whole = testing::text_of(folder / "whole/histories.csv"),
                    part = testing::text_of(folder / "out/histories.csv");
  const std::string lines = part.substr(0, part.rfind('\n') + 1);
  EXPECT_GT(std::ranges::count(lines, '\n'), 2);
  EXPECT_TRUE(whole.starts_with(lines));
}

TEST_F(ResumedRun, RefusesADamagedOrAnotherCheckpoint) {
  kill_one();
  const fs::path file = folder / "out/checkpoint";
  const std::string good = testing::text_of(file);
  const auto refusal = [&](std::vector<std::string> more = {}) {
    more.emplace_back("--resume");
    const testing::ProgramResult result = run("out", more);
    EXPECT_EQ(result.exit_code, 1) << result.errors;
    return result.errors;
  };
  const auto refusal_of = [&](const std::string& bytes) {
    std::ofstream{file, std::ios::binary} << bytes;
    const std::string message = refusal();
    EXPECT_NE(message.find("checkpoint \"out/checkpoint\": "), std::string::npos) << message;
    EXPECT_NE(message.find("Compute the run again, without --resume."), std::string::npos) << message;
    EXPECT_TRUE(testing::text_of(file) == bytes);
    return message;
  };
  for (const std::string& none : {std::string{}, good.substr(0, 7), "x" + good.substr(1), std::string{"a text"}})
    EXPECT_NE(refusal_of(none).find("this is no checkpoint of moat"), std::string::npos);
  std::string newer = good;
  newer.replace(newer.find("1\n"), 1, "2");
  EXPECT_NE(refusal_of(newer).find("another version of moat wrote it, in another format"), std::string::npos);
  for (const std::size_t place : {std::size_t{20}, std::size_t{90}, good.size() / 2, good.size() - 1}) {
    std::string flipped = good;
    flipped[place] = static_cast<char>(flipped[place] ^ 1);
    EXPECT_NE(refusal_of(flipped).find("it is damaged: its checksum is another one"), std::string::npos) << place;
  }
  for (const std::size_t size : {std::size_t{40}, good.size() / 2, good.size() - 1})
    EXPECT_NE(refusal_of(good.substr(0, size)).find("it is damaged"), std::string::npos) << size;
  std::ofstream{file, std::ios::binary} << good;
  EXPECT_NE(refusal({"--gap", "12 cm"}).find("option --gap: 0.1 m -> 12 cm"), std::string::npos);
  EXPECT_NE(run("elsewhere", {"--resume"}).errors.find("has no checkpoint"), std::string::npos);
  // Of another program: its hash differs.
  const testing::ProgramResult other = testing::run_program(OPTION_SCRIPT, {"--out", "out", "--resume"}, folder);
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.errors.find("it is of another run:"), std::string::npos) << other.errors;
  EXPECT_NE(other.errors.find("program: "), std::string::npos) << other.errors;
  // It was refused, and nothing was changed.
  const testing::ProgramResult resumed = run("out", {"--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
}

TEST_F(ResumedRun, SaysWhyThereIsNoCheckpoint) {
  const testing::RunningProgram run{"/usr/bin/env", {"MOAT_TEST_PAUSE=1", OBSERVER_SCRIPT, "--out", "out"}, folder};
  while (!fs::exists(folder / "out/unfinished")) std::this_thread::sleep_for(std::chrono::milliseconds{5});
  std::this_thread::sleep_for(std::chrono::milliseconds{100});
  run.send(SIGTERM);
  const testing::ProgramResult stopped = run.wait();
  EXPECT_EQ(stopped.exit_code, 143) << stopped.errors;
  EXPECT_NE(stopped.errors.find("moat: This run had no checkpoints. An observer of this script has no archive("),
            std::string::npos)
      << stopped.errors;
  EXPECT_FALSE(fs::exists(folder / "out/checkpoint"));
}

TEST(Checkpoint, NamesAllThatDiffers) {
  std::string pattern = (fs::temp_directory_path() / "moat_test_XXXXXX").string();
  const fs::path file = fs::path{mkdtemp(pattern.data())} / "checkpoint";
  write_checkpoint(file, {{"library", "a"}, {"program", "b"}, {"file r.AT2", "c"}},
                   [](StateArchive& archive) { archive.require_same("state", ""); });
  const std::string message = testing::message_of([&] {
    read_checkpoint(file, {{"library", "x"}, {"program", "b"}, {"file r.AT2", "y"}});
  });
  EXPECT_NE(message.find("it is of another run:\n  file r.AT2: c -> y\n  library: a -> x\n"), std::string::npos)
      << message;
  StateArchive state = read_checkpoint(file, {{"library", "a"}, {"program", "b"}, {"file r.AT2", "c"}});
  state.require_same("state", "the state is lost");
  fs::remove_all(file.parent_path());
}

}  // namespace
}  // namespace moat
