// A single run goes on from its checkpoint, with the results of one that nothing stopped.

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "app/script/checkpoint_file.hpp"
#include "app/script/frames_of_script.hpp"
#include "base/units.hpp"
#include "in_folder.hpp"
#include "message_of.hpp"
#include "model/model.hpp"
#include "random_draws.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class ResumedRun : public testing::InTemporaryFolder {
 protected:
  // A run of about a second, with a companion.
  static std::vector<std::string> arguments(const std::string& out, std::vector<std::string> more = {}) {
    std::vector<std::string> all{"--quiet", "--check",          "--no-sensitivity", "--step", "2e-5 s", "--end",
                                 "5 s",     "--frame-interval", "0.25 s",           "--out",  out};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  testing::ProgramResult run(const std::string& out, std::vector<std::string> more = {}) {
    return testing::run_program(FIRST_TOUR, arguments(out, std::move(more)), folder);
  }
  // False if that does not happen within a minute.
  static bool wait_for(const std::function<bool()>& event) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes{1};
    while (!event() && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
    return event();
  }
  // Starts a run that writes checkpoints as often as it may, and sends it a signal behind an event, or some time later.
  testing::ProgramResult ended_behind(const std::function<bool()>& event, int signal,
                                      std::vector<std::string> more = {}, std::chrono::milliseconds later = {}) {
    more.insert(more.end(), {"--checkpoint", "1 ms"});
    const testing::RunningProgram run{FIRST_TOUR, arguments("out", std::move(more)), folder};
    EXPECT_TRUE(wait_for(event));
    std::this_thread::sleep_for(later);
    run.send(signal);
    return run.wait();
  }
  [[nodiscard]] std::function<bool()> checkpoint_in(const std::string& name) const {
    return [file = folder / name / "checkpoint"] { return fs::exists(file); };
  }
  static std::set<std::string> names_in(const fs::path& results) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator{results})
      names.insert(entry.path().lexically_relative(results).string());
    return names;
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
    EXPECT_EQ(names_in(folder / out), names_in(folder / "whole"));
    EXPECT_EQ(summary_without_times(folder / out), summary_without_times(folder / "whole"));
    for (const std::string& name : names_in(folder / "whole")) {
      const fs::path file = folder / "whole" / name;
      if (fs::is_directory(file) || name == "summary.json" || name == "report.html") continue;
      EXPECT_TRUE(testing::text_of(folder / out / name) == testing::text_of(file)) << name;
    }
  }
};

TEST_F(ResumedRun, IsThatOfAnUndisturbedOneHoweverOftenItIsKilled) {
  ASSERT_EQ(run("whole").exit_code, 0);
  testing::RandomDraws random{20};
  const auto time_of_checkpoint = [&] {
    std::error_code none;
    return fs::last_write_time(folder / "out/checkpoint", none);
  };
  // A run that was killed behind its last step has no checkpoint any more.
  const auto resume = [&]() -> std::vector<std::string> {
    if (checkpoint_in("out")()) return {"--resume"};
    fs::remove_all(folder / "out");
    return {};
  };
  // Every run gets ahead by a checkpoint at least. The first ones are killed so soon that none reaches its end.
  int resumes = 0, exit_code = -1;
  for (int kill = 0; kill < 20 && exit_code != 0; ++kill) {
    const std::vector<std::string> more = resume();
    resumes += more.empty() ? 0 : 1;
    const auto is_new = [&, before = time_of_checkpoint()] { return time_of_checkpoint() != before; };
    const std::chrono::milliseconds later{random.integer(0, 15 * kill)};
    const testing::ProgramResult killed = ended_behind(is_new, SIGKILL, more, later);
    exit_code = killed.exit_code;
    ASSERT_LE(exit_code, 0) << killed.errors;
  }
  EXPECT_GE(resumes, 5);
  if (exit_code != 0) {
    const testing::ProgramResult last = run("out", resume());
    ASSERT_EQ(last.exit_code, 0) << last.errors;
  }
  expect_results_of_whole("out");
}

TEST_F(ResumedRun, FollowsTheCommandThatAStoppedRunPrints) {
  ASSERT_EQ(run("whole").exit_code, 0);
  const testing::ProgramResult stopped = ended_behind(checkpoint_in("out"), SIGTERM);
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
  ended_behind(checkpoint_in("out.new"), SIGKILL, {"--force"});
  EXPECT_EQ(testing::text_of(folder / "out/summary.json"), old);
  const testing::ProgramResult resumed = run("out", {"--force", "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
  expect_results_of_whole("out");
  EXPECT_FALSE(fs::exists(folder / "out.new"));
}

TEST_F(ResumedRun, HasTheHistoriesUpToTheLastFlush) {
  ASSERT_EQ(run("whole").exit_code, 0);
  const auto lines = [&] {
    const fs::path file = folder / "out/histories.csv";
    const std::string part = fs::exists(file) ? testing::text_of(file) : "";
    return part.substr(0, part.rfind('\n') + 1);
  };
  ended_behind([&] { return std::ranges::count(lines(), '\n') > 2; }, SIGKILL);
  EXPECT_TRUE(testing::text_of(folder / "whole/histories.csv").starts_with(lines()));
}

TEST_F(ResumedRun, RefusesADamagedOrAnotherCheckpoint) {
  ended_behind(checkpoint_in("out"), SIGKILL);
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
  // Its steps are so short that it would take minutes.
  const testing::RunningProgram run{OBSERVER_SCRIPT, {"--out", "out", "--step", "1e-6 s", "--end", "30 s"}, folder};
  EXPECT_TRUE(wait_for([&] { return fs::exists(folder / "out/unfinished"); }));
  run.send(SIGTERM);
  const testing::ProgramResult stopped = run.wait();
  EXPECT_EQ(stopped.exit_code, 143) << stopped.errors;
  EXPECT_NE(
      stopped.errors.find("moat: The last checkpoint was not written: An observer of this script has no archive("),
      std::string::npos)
      << stopped.errors;
  EXPECT_FALSE(fs::exists(folder / "out/checkpoint"));
}

using FramesOfResumedRun = testing::InTemporaryFolder;

TEST_F(FramesOfResumedRun, ThatFailDoNotHideTheStateBehindThem) {
  Model model;
  add(model, Node{.name = "body", .mass = 1 * units::kg});
  std::ofstream{folder / "file"} << "in the way";
  for (const auto& [before, now] : {std::pair{"out", "file"}, {"file", "out"}, {"file", "file"}, {"out", "out"}}) {
    StateArchive archive;
    int behind = 7;
    FramesOfScript written{model, folder / before, 0.1};
    written.archive(archive);
    archive(behind);
    StateArchive saved{archive.take()};
    behind = 0;
    FramesOfScript read{model, folder / now, 0.1};
    read.archive(saved);
    saved(behind);
    EXPECT_EQ(behind, 7);
    saved.require_end();
    EXPECT_EQ(read.failure().empty(), before == std::string{"out"} && now == std::string{"out"}) << read.failure();
  }
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
