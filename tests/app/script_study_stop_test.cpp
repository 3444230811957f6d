// Studies survive every interruption: their file then holds the results of an undisturbed run.

#include <gtest/gtest.h>

#include <random>

#include "study_runs.hpp"

namespace moat::testing {
namespace {

using StoppedStudy = DisturbedStudy;

const std::vector<std::string> question{"--gaps", "200"};
const std::vector<std::string> in_a{"--gaps", "200", "--out", "a", "--threads", "2"};

TEST_F(StoppedStudy, SurvivesBeingKilledTenTimes) {
  std::mt19937 random{20260101};
  for (int kill = 0; kill < 10; ++kill) {
    const std::size_t after = computed_cases() + std::uniform_int_distribution<std::size_t>{0, 7}(random);
    const RunningProgram study{STUDY_SCRIPT, in_a, folder};
    ASSERT_TRUE(wait_for_cases(after));
    std::this_thread::sleep_for(std::chrono::microseconds{std::uniform_int_distribution<int>{0, 40000}(random)});
    study.send(SIGKILL);
    study.wait();
    if (!fs::exists(file("a"))) continue;
    EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
  }
  EXPECT_LT(read_study(file("a")).result.count(CaseState::done), 400u);
  end_of_disturbances();
  ASSERT_EQ(run(in_a).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed(question));
  EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
  EXPECT_GT(answer_of(file("a"), "SELECT count(DISTINCT session) FROM cases"), "1");
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM cases"), "400");
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM results"),
            answer_of(file("undisturbed"), "SELECT count(*) FROM results"));
}

/// The last line of the messages, behind "to go on: ".
std::string command_to_go_on(const std::string& errors) {
  const std::string before = "moat: to go on: ";
  const std::size_t at = errors.rfind(before);
  if (at == std::string::npos) return "";
  return errors.substr(at + before.size(), errors.find('\n', at) - at - before.size());
}

TEST_F(StoppedStudy, EndsInOrderAtASignal) {
  const std::vector<std::string> arguments{"--gaps", "200", "--out", "it's my study", "--threads", "2", "--retry"};
  std::string command;
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}, std::pair{SIGUSR1, 138}}) {
    const std::size_t before = computed_cases();
    const RunningProgram study{STUDY_SCRIPT, arguments, folder};
    ASSERT_TRUE(wait_for_cases(before + 4));
    study.send(signal);
    const ProgramResult result = study.wait();
    EXPECT_EQ(result.exit_code, code) << result.errors;
    EXPECT_NE(result.errors.find("The study was stopped: "), std::string::npos) << result.errors;
    const fs::path out = folder / "it's my study";
    for (const char* name : {"study.db", "study.csv", "report.html"}) EXPECT_TRUE(fs::exists(out / name)) << name;
    for (const char* name : {"study.db-wal", "study.db-shm", "study.db.lock"})
      EXPECT_FALSE(fs::exists(out / name)) << "the file is complete by itself, without " << name;
    EXPECT_EQ(read_study(out / "study.db").result.count(CaseState::done), computed_cases()) << "cases in flight ended";
    command = command_to_go_on(result.errors);
  }
  EXPECT_EQ(command.find("--retry"), std::string::npos) << command;
  const ProgramResult shown = study_command({"show", "it's my study/study.db"});
  for (const char* ending : {"stopped by SIGINT", "stopped by SIGTERM", "stopped by SIGUSR1"})
    EXPECT_NE(shown.output.find(ending), std::string::npos) << shown.output;
  end_of_disturbances();
  // As a user pastes it, in any folder.
  const ProgramResult pasted = run_program("/bin/sh", {"-c", "cd / && " + command}, folder);
  ASSERT_EQ(pasted.exit_code, 0) << command << "\n" << pasted.errors;
  EXPECT_EQ(contents_of(file("it's my study")), undisturbed(question));
}

TEST_F(StoppedStudy, AFullDiskLeavesAllFinishedCases) {
  end_of_disturbances();
  const fs::path disk = folder / "disk";
  fs::create_directories(disk);
  const std::string in_disk =
      "mount -t tmpfs -o size=250k none '" + disk.string() + "' && cd '" + disk.string() + "' && ";
  if (run_program("/usr/bin/unshare", {"-rm", "sh", "-c", in_disk + "true"}, folder).exit_code != 0)
    GTEST_SKIP() << "this user may not mount a small disk (unshare -rm)";
  const std::string study = std::string{STUDY_SCRIPT} + " --gaps 300 --out a --quiet";
  const ProgramResult full = run_program(
      "/usr/bin/unshare",
      {"-rm", "sh", "-c", in_disk + study + "; code=$?; cp -r a '" + folder.string() + "/'; exit $code"}, folder);
  EXPECT_EQ(full.exit_code, 1) << full.errors;
  EXPECT_NE(full.errors.find("disk is full. All finished cases are intact. Make room"), std::string::npos)
      << full.errors;
  EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
  const StudyResult result = read_study(file("a")).result;
  EXPECT_GT(result.count(CaseState::done), 0u);
  EXPECT_GT(result.count(CaseState::open), 0u);
  // With room, the same command goes on.
  ASSERT_EQ(run({"--gaps", "300", "--out", "a"}).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed({"--gaps", "300"}));
}

}  // namespace
}  // namespace moat::testing
