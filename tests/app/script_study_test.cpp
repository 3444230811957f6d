// Studies of a script: they survive every interruption, and their file holds the results of an undisturbed run.

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "run_program.hpp"
#include "study/store.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing::ProgramResult;
using testing::text_of;

std::string answer_of(const fs::path& database, const char* query) {
  sqlite3* open = nullptr;
  std::string answer;
  EXPECT_EQ(sqlite3_open_v2(database.c_str(), &open, SQLITE_OPEN_READWRITE, nullptr), SQLITE_OK);
  const auto keep = [](void* text, int, char** values, char**) {
    *static_cast<std::string*>(text) += values[0] != nullptr ? values[0] : "null";
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(open, query, keep, &answer, nullptr), SQLITE_OK) << sqlite3_errmsg(open);
  sqlite3_close(open);
  return answer;
}

// Everything but times and places, in every bit.
std::string contents_of(const fs::path& file) {
  const StoredStudy study = read_study(file);
  std::ostringstream text;
  text << std::hexfloat;
  for (const auto& [key, value] : study.properties) text << key << "=" << value << "\n";
  for (std::size_t number = 0; number < study.result.outcomes().size(); ++number) {
    const CaseOutcome& outcome = study.result.outcomes()[number];
    text << StudyCase{study.result.cases(), number}.description() << ": " << name_of(outcome.state) << outcome.reason
         << outcome.record << outcome.record_sha256 << outcome.steps;
    for (const NamedNumber& each : outcome.results)
      text << " " << each.quantity << " " << each.where << " " << each.unit << " " << each.value;
    text << "\n";
  }
  return text.str();
}

class ScriptStudyRun : public testing::InTemporaryFolder {
 protected:
  ProgramResult run(std::vector<std::string> arguments) {
    return testing::run_program(STUDY_SCRIPT, std::move(arguments), folder);
  }
  ProgramResult study_command(std::vector<std::string> arguments) {
    return testing::run_program(STUDY_COMMAND, std::move(arguments), folder);
  }
  fs::path file(const std::string& out) const { return folder / out / "study.db"; }
  // The contents of a study that nothing disturbed, in another folder.
  std::string undisturbed(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--out", "undisturbed", "--quiet"});
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return contents_of(file("undisturbed"));
  }
};

TEST_F(ScriptStudyRun, LeavesItsFileAndATable) {
  const ProgramResult result = run({});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("Study of a mass: study, 40 cases"), std::string::npos) << result.output;
  EXPECT_NE(result.errors.find("100 % of 40 cases, "), std::string::npos) << result.errors;
  const std::string table = text_of(folder / "results/moat_study_script/study.csv");
  EXPECT_TRUE(table.starts_with("gap [cm],stiffness,state,reason,steps [1],energy_error [1],seconds [s],")) << table;
  EXPECT_NE(table.find("\"stiff, \"\"rigid\"\"\",done,"), std::string::npos) << table;
}

TEST_F(ScriptStudyRun, GoesOnFromItsFile) {
  ASSERT_EQ(run({"--out", "a"}).exit_code, 0);
  const std::string before = contents_of(file("a")), sessions = "SELECT count(*) FROM sessions";
  const ProgramResult again = run({"--out", "a", "--wait", "0 s", "--threads", "1"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_EQ(contents_of(file("a")), before);
  EXPECT_EQ(answer_of(file("a"), "SELECT count(DISTINCT session) FROM cases"), "1") << "nothing was computed again";
  EXPECT_EQ(again.output.substr(again.output.find('\n')), run({"--out", "a"}).output.substr(again.output.find('\n')));
}

TEST_F(ScriptStudyRun, RefusesAnotherQuestion) {
  ASSERT_EQ(run({"--out", "a"}).exit_code, 0);
  const std::string before = contents_of(file("a"));
  const ProgramResult other = run({"--out", "a", "--last-gap", "35 cm"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.errors.find("axis gap: its values (20 -> 20)"), std::string::npos) << other.errors;
  EXPECT_NE(other.errors.find("option --last-gap: 0.3 m -> 35 cm"), std::string::npos) << other.errors;
  EXPECT_EQ(contents_of(file("a")), before);
}

TEST_F(ScriptStudyRun, SeesAChangedScript) {
  std::ofstream{folder / "tower.cpp"} << "one";
  const std::vector<std::string> command{"MOAT_SCRIPT=" + (folder / "tower.cpp").string(), STUDY_SCRIPT, "--out", "a"};
  ASSERT_EQ(testing::run_program("/usr/bin/env", command, folder).exit_code, 0);
  ASSERT_EQ(testing::run_program("/usr/bin/env", command, folder).exit_code, 0);
  std::ofstream{folder / "tower.cpp"} << "two";
  const ProgramResult other = testing::run_program("/usr/bin/env", command, folder);
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.errors.find("\n  script: "), std::string::npos) << other.errors;
}

TEST_F(ScriptStudyRun, SeesAChangedProgram) {
  const fs::path program = folder / "program";
  fs::copy_file(STUDY_SCRIPT, program);
  ASSERT_EQ(testing::run_program(program, {"--out", "a"}, folder).exit_code, 0);
  std::ofstream{program, std::ios::app} << "changed";
  const ProgramResult other = testing::run_program(program, {"--out", "a"}, folder);
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.errors.find("\n  program: "), std::string::npos) << other.errors;
}

TEST_F(ScriptStudyRun, SeesAChangedLibrary) {
  const fs::path library = folder / fs::path{LIBRARY}.filename();
  fs::copy_file(LIBRARY, library);
  const std::vector<std::string> command{"LD_LIBRARY_PATH=" + folder.string(), STUDY_SCRIPT, "--out", "a"};
  ASSERT_EQ(testing::run_program("/usr/bin/env", command, folder).exit_code, 0);
  ASSERT_EQ(testing::run_program("/usr/bin/env", command, folder).exit_code, 0);
  std::ofstream{library, std::ios::app} << "changed";
  const ProgramResult other = testing::run_program("/usr/bin/env", command, folder);
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.errors.find("\n  library: "), std::string::npos) << other.errors;
}

TEST_F(ScriptStudyRun, SeesAChangedRecord) {
  std::ofstream{folder / "r.AT2"} << "PEER NGA STRONG MOTION DATABASE RECORD\nsynthetic\nACCELERATION TIME SERIES IN "
                                     "UNITS OF G\nNPTS= 4, DT= .1 SEC\n 0.0 0.1 -0.1 0.0\n";
  const std::vector<std::string> arguments{"--out", "a", "--record", (folder / "r.AT2").string()};
  ASSERT_EQ(run(arguments).exit_code, 0);
  ASSERT_EQ(run(arguments).exit_code, 0);
  std::ofstream{folder / "r.AT2"} << "PEER NGA STRONG MOTION DATABASE RECORD\nsynthetic\nACCELERATION TIME SERIES IN "
                                     "UNITS OF G\nNPTS= 4, DT= .1 SEC\n 0.0 0.2 -0.1 0.0\n";
  const ProgramResult other = run(arguments);
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.errors.find("\n  record " + (folder / "r.AT2").string()), std::string::npos) << other.errors;
}

TEST_F(ScriptStudyRun, SurvivesBeingKilledTenTimes) {
  const std::vector<std::string> question{"--gaps", "60", "--wait", "0.03 s"};
  std::mt19937 random{20260101};
  std::uniform_real_distribution<double> seconds{0.02, 0.35};
  std::vector<std::string> arguments = question;
  arguments.insert(arguments.end(), {"--out", "a", "--threads", "2"});
  for (int kill = 0; kill < 10; ++kill) {
    const testing::RunningProgram study{STUDY_SCRIPT, arguments, folder};
    std::this_thread::sleep_for(std::chrono::duration<double>{seconds(random)});
    study.send(SIGKILL);
    study.wait();
    if (!fs::exists(file("a"))) continue;
    EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
  }
  EXPECT_NE(answer_of(file("a"), "SELECT count(*) FROM cases"), "0") << "killed too early to test anything";
  ASSERT_EQ(run(arguments).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed(question));
  EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM cases"), "120");
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM results"),
            answer_of(file("undisturbed"), "SELECT count(*) FROM results"));
}

#ifdef MPIRUN
class StudyOnRanks : public ScriptStudyRun {
 protected:
  static std::vector<std::string> job(int ranks, std::vector<std::string> arguments) {
    std::vector<std::string> words{"-n", std::to_string(ranks), "--oversubscribe", "--bind-to", "none"};
    if (::geteuid() == 0) words.emplace_back("--allow-run-as-root");
    words.emplace_back(STUDY_SCRIPT);
    words.insert(words.end(), arguments.begin(), arguments.end());
    return words;
  }
};

TEST_F(StudyOnRanks, HasTheSameContentsForAnyNumberOfRanks) {
  ASSERT_EQ(run({"--failing", "3", "--stuck", "7", "--out", "threads", "--threads", "2"}).exit_code, 3);
  const std::string contents = contents_of(file("threads"));
  for (const int ranks : {1, 2, 3}) {
    const std::string out = "ranks_" + std::to_string(ranks);
    const ProgramResult result =
        testing::run_program(MPIRUN, job(ranks, {"--failing", "3", "--stuck", "7", "--out", out}), folder);
    EXPECT_EQ(result.exit_code, 3) << result.errors;
    EXPECT_EQ(contents_of(file(out)), contents) << ranks;
    EXPECT_EQ(result.output.find("impacts\n"), result.output.rfind("impacts\n")) << "one rank speaks";
    EXPECT_NE(result.output.find("impacts\n"), std::string::npos) << result.output;
    EXPECT_TRUE(answer_of(file(out), "SELECT engine FROM sessions").starts_with(std::to_string(ranks) + " rank"));
  }
}

TEST_F(StudyOnRanks, ARankThatIsKilledLeavesItsCasesOpen) {
  const std::vector<std::string> question{"--gaps", "60", "--wait", "0.03 s"};
  std::vector<std::string> arguments = question;
  arguments.insert(arguments.end(), {"--out", "a", "--threads", "1"});
  std::mt19937 random{7};
  for (int kill = 0; kill < 10; ++kill) {
    const testing::RunningProgram study{MPIRUN, job(2, arguments), folder};
    // The ranks are children of mpirun. Both ranks take their turn.
    std::vector<pid_t> ranks;
    for (int wait = 0; wait < 200 && ranks.size() < 2; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
      const std::string id = std::to_string(study.id());
      std::ifstream children{"/proc/" + id + "/task/" + id + "/children"};
      ranks.clear();
      for (pid_t child = 0; children >> child;) ranks.push_back(child);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{std::uniform_int_distribution<int>{200, 700}(random)});
    if (ranks.size() == 2) ::kill(ranks[static_cast<std::size_t>(kill % 2)], SIGKILL);
    const ProgramResult result = study.wait();
    if (result.exit_code == 0) break;  // it had ended before
    EXPECT_NE(result.errors.find("signal 9"), std::string::npos) << result.errors;
    if (fs::exists(file("a"))) {
      EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
    }
  }
  EXPECT_NE(answer_of(file("a"), "SELECT count(*) FROM cases"), "0") << "killed too early to test anything";
  ASSERT_EQ(testing::run_program(MPIRUN, job(2, arguments), folder).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed(question));
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM cases"), "120");
}

TEST_F(StudyOnRanks, EndsInOrderAtASignal) {
  const std::vector<std::string> question{"--gaps", "40", "--wait", "0.05 s"};
  std::vector<std::string> arguments = question;
  arguments.insert(arguments.end(), {"--out", "a"});
  const testing::RunningProgram study{MPIRUN, job(2, arguments), folder};
  while (!fs::exists(file("a"))) std::this_thread::sleep_for(std::chrono::milliseconds{5});
  std::this_thread::sleep_for(std::chrono::milliseconds{500});
  study.send(SIGTERM);
  const ProgramResult result = study.wait();
  EXPECT_NE(result.exit_code, 0);
  EXPECT_EQ(answer_of(file("a"), "PRAGMA integrity_check"), "ok");
  ASSERT_EQ(testing::run_program(MPIRUN, job(3, arguments), folder).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed(question));
}
#endif

TEST_F(ScriptStudyRun, EndsInOrderAtASignal) {
  const std::vector<std::string> question{"--gaps", "30", "--wait", "0.05 s"};
  std::vector<std::string> arguments = question;
  arguments.insert(arguments.end(), {"--out", "a"});
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
    const testing::RunningProgram study{STUDY_SCRIPT, arguments, folder};
    while (!fs::exists(file("a"))) std::this_thread::sleep_for(std::chrono::milliseconds{5});
    std::this_thread::sleep_for(std::chrono::milliseconds{300});
    study.send(signal);
    const ProgramResult result = study.wait();
    EXPECT_EQ(result.exit_code, code) << result.errors;
    EXPECT_NE(result.errors.find("The study was stopped: "), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find("to go on: "), std::string::npos) << result.errors;
    EXPECT_FALSE(fs::exists(folder / "a/study.db-wal")) << "the file is complete by itself";
  }
  ASSERT_EQ(run(arguments).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed(question));
}

TEST_F(ScriptStudyRun, AFullDiskLeavesAllFinishedCases) {
  const fs::path disk = folder / "disk";
  fs::create_directories(disk);
  const std::string in_disk =
      "mount -t tmpfs -o size=200k none '" + disk.string() + "' && cd '" + disk.string() + "' && ";
  if (testing::run_program("/usr/bin/unshare", {"-rm", "sh", "-c", in_disk + "true"}, folder).exit_code != 0)
    GTEST_SKIP() << "this user may not mount a small disk (unshare -rm)";
  const std::string study = std::string{STUDY_SCRIPT} + " --gaps 200 --out a --quiet";
  const ProgramResult full = testing::run_program(
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
  ASSERT_EQ(run({"--gaps", "200", "--out", "a"}).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), undisturbed({"--gaps", "200"}));
}

TEST_F(ScriptStudyRun, PartsMergedAreTheWhole) {
  ASSERT_EQ(run({"--cases", "0:11", "--out", "p"}).exit_code, 0);
  ASSERT_EQ(run({"--case", "11", "--out", "p"}).exit_code, 0);
  const ProgramResult last = run({"--cases", "12:40", "--out", "p"});
  ASSERT_EQ(last.exit_code, 0) << last.errors;
  EXPECT_NE(last.output.find("moat study merge p/study.db"), std::string::npos) << last.output;
  EXPECT_EQ(last.output.find("impacts\n"), std::string::npos) << "a part has no answer";
  const ProgramResult merged = study_command(
      {"merge", "p/study.db", "p/study.cases_0_11.db", "p/study.cases_11_12.db", "p/study.cases_12_40.db"});
  EXPECT_EQ(merged.exit_code, 0) << merged.errors;
  EXPECT_NE(merged.output.find("cases: 40, of these 40 done, 0 failed, 0 not converged, 0 open"), std::string::npos)
      << merged.output;
  EXPECT_EQ(contents_of(file("p")), undisturbed({}));
  ASSERT_EQ(run({"--out", "p"}).exit_code, 0);
  EXPECT_EQ(answer_of(file("p"), "SELECT count(DISTINCT session) FROM cases"), "3") << "nothing was computed again";
  for (const char* wrong : {"3:3", "5", "30:41", "a:b", "-1:3"}) {
    const ProgramResult refused = run({"--cases", wrong, "--out", "q"});
    EXPECT_EQ(refused.exit_code, 1) << wrong;
    EXPECT_NE(refused.errors.find("is not allowed"), std::string::npos) << refused.errors;
  }
}

TEST_F(ScriptStudyRun, FailuresAreStatesAndCanBeRetried) {
  const ProgramResult result = run({"--failing", "3", "--stuck", "7", "--out", "a"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.errors.find("2 of 40 cases failed, 1 of them did not converge.\n  gap = "), std::string::npos)
      << result.errors;
  const ProgramResult shown = study_command({"show", "a/study.db"});
  EXPECT_NE(shown.output.find("of these 38 done, 1 failed, 1 not converged, 0 open"), std::string::npos)
      << shown.output;
  EXPECT_NE(shown.output.find("this case is stuck"), std::string::npos) << shown.output;
  EXPECT_NE(shown.output.find("slowest cases"), std::string::npos) << shown.output;
  ASSERT_EQ(study_command({"export", "a/study.db", "--out", "b.csv"}).exit_code, 0);
  EXPECT_EQ(text_of(folder / "b.csv"), text_of(folder / "a/study.csv"));
  EXPECT_EQ(run({"--failing", "3", "--stuck", "7", "--out", "a", "--retry"}).exit_code, 3);
  EXPECT_EQ(answer_of(file("a"), "SELECT count(DISTINCT session) FROM cases"), "2");
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM cases"), "40");
}

TEST_F(ScriptStudyRun, ChecksItsOptions) {
  const ProgramResult help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* option : {"--last-gap", "--cases", "--threads", "--retry", "--record"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;
  EXPECT_EQ(run({"--nonsense"}).exit_code, 2);
  EXPECT_EQ(run({"--gaps", "x"}).exit_code, 1);
  EXPECT_FALSE(fs::exists(folder / "results"));
}

TEST_F(ScriptStudyRun, TheCommandRefusesOtherFiles) {
  std::ofstream{folder / "x.db"} << "no database";
  EXPECT_EQ(study_command({"show", "x.db"}).exit_code, 1);
  EXPECT_EQ(study_command({"show", "none.db"}).exit_code, 1);
  EXPECT_FALSE(fs::exists(folder / "none.db"));
}

}  // namespace
}  // namespace moat
