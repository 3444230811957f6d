// Studies on ranks of MPI.

#include <gtest/gtest.h>

#include <random>

#include "study_runs.hpp"

#ifndef MPIRUN
#define MPIRUN ""
#endif

namespace moat::testing {
namespace {

class StudyOnRanks : public DisturbedStudy {
 protected:
  void SetUp() override {
    if (std::string{MPIRUN}.empty())
      GTEST_SKIP() << "moat was built without MPI, or there is no mpirun (cmake/packages/mpi.txt)";
  }
  static std::vector<std::string> job(int ranks, const std::vector<std::string>& arguments,
                                      const char* script = STUDY_SCRIPT) {
    std::vector<std::string> words{"-n", std::to_string(ranks), "--oversubscribe", "--bind-to", "none"};
    // Open MPI keeps memory in plugins that it unloads: a sanitizer could name neither as known.
    words.insert(words.end(), {"-x", "ASAN_OPTIONS=detect_leaks=0"});
    if (::geteuid() == 0) words.emplace_back("--allow-run-as-root");
    words.emplace_back(script);
    words.insert(words.end(), arguments.begin(), arguments.end());
    return words;
  }
  ProgramResult run_ranks(int ranks, const std::vector<std::string>& arguments) const {
    return run_program(MPIRUN, job(ranks, arguments), folder);
  }
};

TEST_F(StudyOnRanks, HasTheSameContentsForAnyNumberOfRanks) {
  end_of_disturbances();
  ASSERT_EQ(run({"--failing", "3", "--stuck", "7", "--out", "threads", "--threads", "2"}).exit_code, 3);
  const std::string contents = contents_of(file("threads"));
  for (const int ranks : {1, 2, 3}) {
    const std::string out = "ranks_" + std::to_string(ranks);
    const ProgramResult result = run_ranks(ranks, {"--failing", "3", "--stuck", "7", "--out", out});
    EXPECT_EQ(result.exit_code, 3) << result.errors;
    EXPECT_EQ(contents_of(file(out)), contents) << ranks;
    EXPECT_EQ(result.output.find("impacts\n"), result.output.rfind("impacts\n")) << "one rank speaks";
    EXPECT_NE(result.output.find("impacts\n"), std::string::npos) << result.output;
    EXPECT_TRUE(answer_of(file(out), "SELECT engine FROM sessions").starts_with(std::to_string(ranks) + " rank"));
  }
}

TEST_F(StudyOnRanks, OfRandomModelsHasTheSameBitsForAnyNumberOfRanks) {
  std::mt19937 random{20261128};
  for (int study = 0; study < 3; ++study) {
    const std::string first = std::to_string(std::uniform_int_distribution<int>{0, 1'000'000}(random));
    const ProgramResult alone =
        run_program(RANDOM_STUDY_SCRIPT, {"--first", first, "--threads", "1", "--out", "alone" + first}, folder);
    ASSERT_EQ(alone.exit_code, 0) << alone.errors;
    const int ranks = std::uniform_int_distribution<int>{2, 4}(random);
    const ProgramResult shared =
        run_program(MPIRUN, job(ranks, {"--first", first, "--out", "ranks" + first}, RANDOM_STUDY_SCRIPT), folder);
    ASSERT_EQ(shared.exit_code, 0) << shared.errors;
    EXPECT_EQ(contents_of(file("ranks" + first)), contents_of(file("alone" + first))) << first << " on " << ranks;
  }
}

TEST_F(StudyOnRanks, KnowsTheFilesThatOtherRanksRead) {
  end_of_disturbances();
  write_record("r.AT2", "0.0 0.1 -0.1 0.0");
  ASSERT_EQ(run_ranks(2, {"--inside", "r.AT2", "--out", "a"}).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed({"--inside", "r.AT2"}));
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM case_files"), "40");
}

TEST_F(StudyOnRanks, ARankThatIsKilledLeavesItsCasesOpen) {
  const std::vector<std::string> arguments{"--gaps", "200", "--out", "a", "--threads", "1"};
  std::mt19937 random{7};
  for (int kill = 0; kill < 6; ++kill) {
    const std::size_t after = computed_cases() + std::uniform_int_distribution<std::size_t>{2, 8}(random);
    const RunningProgram study{MPIRUN, job(2, arguments), folder};
    ASSERT_TRUE(wait_for_cases(after));
    // The ranks are children of mpirun. Both ranks take their turn.
    std::vector<pid_t> ranks;
    const std::string id = std::to_string(study.id());
    std::ifstream children{"/proc/" + id + "/task/" + id + "/children"};
    for (pid_t child = 0; children >> child;) ranks.push_back(child);
    ASSERT_EQ(ranks.size(), 2u);
    ::kill(ranks[static_cast<std::size_t>(kill % 2)], SIGKILL);
    const ProgramResult result = study.wait();
    EXPECT_NE(result.exit_code, 0);
    EXPECT_NE(result.errors.find("signal 9"), std::string::npos) << result.errors;
    EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
  }
  EXPECT_GT(read_study(file("a")).result.count(CaseState::open), 0u);
  end_of_disturbances();
  ASSERT_EQ(run_ranks(2, arguments).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed({"--gaps", "200"}));
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM cases"), "400");
}

TEST_F(StudyOnRanks, EndsInOrderAtTheSignalThatMpirunHandsOn) {
  const std::vector<std::string> arguments{"--gaps", "200", "--out", "a"};
  const RunningProgram study{MPIRUN, job(2, arguments), folder};
  ASSERT_TRUE(wait_for_cases(6));
  study.send(SIGUSR1);
  const ProgramResult result = study.wait();
  EXPECT_EQ(result.exit_code, 138) << result.errors;
  EXPECT_NE(result.errors.find("moat: to go on: cd "), std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find(" && mpirun -n 2 "), std::string::npos) << result.errors;
  EXPECT_EQ(read_study(file("a")).result.count(CaseState::done), computed_cases()) << "cases in flight ended";
  EXPECT_FALSE(fs::exists(folder / "a/study.db-wal"));
  end_of_disturbances();
  ASSERT_EQ(run_ranks(3, arguments).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed({"--gaps", "200"}));
}

// mpirun itself kills the ranks at SIGTERM, within two seconds: the cases in flight may be lost, and no others.
TEST_F(StudyOnRanks, IsWholeAfterMpirunWasTerminated) {
  const std::vector<std::string> arguments{"--gaps", "200", "--out", "a"};
  const RunningProgram study{MPIRUN, job(2, arguments), folder};
  ASSERT_TRUE(wait_for_cases(6));
  study.send(SIGTERM);
  EXPECT_NE(study.wait().exit_code, 0);
  EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
  end_of_disturbances();
  ASSERT_EQ(run_ranks(2, arguments).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed({"--gaps", "200"}));
}

}  // namespace
}  // namespace moat::testing
