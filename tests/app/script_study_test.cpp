// Studies of a script: their file, the inputs they depend on, their parts and states.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <regex>

#include "study_runs.hpp"

namespace moat::testing {
namespace {

using ScriptStudyRun = StudyRuns;

TEST_F(ScriptStudyRun, LeavesItsFileAndATable) {
  const ProgramResult result = run({});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("Study of a mass: study, 40 cases"), std::string::npos) << result.output;
  const std::string table = text_of(folder / "results/moat_study_script/study.csv");
  EXPECT_TRUE(table.starts_with("case [1],gap [cm],stiffness,state,reason,steps [1],energy_error [1],seconds [s],"))
      << table;
  EXPECT_NE(table.find("\"stiff, \"\"rigid\"\"\",done,"), std::string::npos) << table;
}

TEST_F(DisturbedStudy, WritesItsProgressToALog) {
  // 40 cases of more than 30 ms: more than the second in which nothing is written.
  const ProgramResult result = run({"--threads", "1"});
  EXPECT_NE(result.errors.find("100 % of 40 cases, "), std::string::npos) << result.errors;
}

TEST_F(ScriptStudyRun, GoesOnFromItsFile) {
  ASSERT_EQ(run({"--out", "a"}).exit_code, 0);
  const std::string before = contents_of(file("a"));
  EXPECT_EQ(std::distance(fs::directory_iterator{folder / "a"}, {}), 4) << "study.db, study.csv, report.html, pictures";
  const ProgramResult again = run({"--out", "a", "--threads", "1"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_EQ(contents_of(file("a")), before);
  EXPECT_EQ(answer_of(file("a"), "SELECT count(DISTINCT session) FROM cases"), "1") << "nothing was computed again";
  EXPECT_EQ(again.output.substr(again.output.find('\n')), run({"--out", "a"}).output.substr(again.output.find('\n')));
}

TEST_F(ScriptStudyRun, SeesAChangedScriptProgramAndLibrary) {
  const fs::path script = folder / "tower.cpp", program = folder / "program",
                 library = folder / fs::path{LIBRARY}.filename();
  std::ofstream{script} << "one";
  fs::copy_file(STUDY_SCRIPT, program);
  fs::copy_file(LIBRARY, library);
  for (const auto& [input, name] : {std::pair{script, "script"}, {program, "program"}, {library, "library"}}) {
    const std::vector<std::string> command{"MOAT_SCRIPT=" + script.string(), "LD_LIBRARY_PATH=" + folder.string(),
                                           program.string(), "--out", std::string{"out of "} + name};
    ASSERT_EQ(run_program("/usr/bin/env", command, folder).exit_code, 0);
    ASSERT_EQ(run_program("/usr/bin/env", command, folder).exit_code, 0);
    std::ofstream{input, std::ios::app} << "changed";
    const ProgramResult other = run_program("/usr/bin/env", command, folder);
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_NE(other.errors.find(std::string{"\n  "} + name + ": "), std::string::npos) << other.errors;
  }
}

// Of a record that an option names, and of one that is read inside of every case.
TEST_F(ScriptStudyRun, SeesARecordThatChangedOrIsMissing) {
  for (const std::string option : {"--record", "--inside"}) {
    const std::string record = write_record("r.AT2", "0.0 0.1 -0.1 0.0");
    const std::vector<std::string> arguments{"--out", option.substr(2), option, "r.AT2"};
    ASSERT_EQ(run(arguments).exit_code, 0);
    const ProgramResult same = run({"--out", option.substr(2), option, record});
    EXPECT_EQ(same.exit_code, 0) << "the same file, written in another way: " << same.errors;
    write_record("r.AT2", "0.0 0.2 -0.1 0.0");
    const ProgramResult other = run(arguments);
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_NE(other.errors.find("\n  file " + record + ": "), std::string::npos) << other.errors;
    fs::remove(record);
    const ProgramResult missing = run(arguments);
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_NE(missing.errors.find("r.AT2"), std::string::npos) << missing.errors;
  }
}

TEST_F(ScriptStudyRun, SeesEveryFileOfAFolderAndOfPairs) {
  fs::create_directories(folder / "records");
  for (const char* name : {"records/A090.AT2", "records/A180.AT2", "records/B000.AT2", "records/B090.AT2"})
    write_record(name, "0.0 0.1 -0.1 0.0");
  for (const char* question : {"--records", "--pairs"}) {
    const std::string out = std::string{question}.substr(2);
    const std::vector<std::string> arguments{"--out", out, question, "records"};
    ASSERT_EQ(run(arguments).exit_code, 0);
    ASSERT_EQ(run(arguments).exit_code, 0);
    // The second component of a pair.
    write_record("records/A180.AT2", "0.0 0.2 -0.1 0.0");
    EXPECT_NE(run(arguments).errors.find("records/A180.AT2: "), std::string::npos);
    write_record("records/A180.AT2", "0.0 0.1 -0.1 0.0");
    ASSERT_EQ(run(arguments).exit_code, 0) << "the former state is restored";
    for (const char* name : {"records/C000.AT2", "records/C090.AT2"}) write_record(name, "0.0 0.1 -0.1 0.0");
    const ProgramResult added = run(arguments);
    EXPECT_EQ(added.exit_code, 1);
    EXPECT_NE(added.errors.find(question == std::string{"--pairs"} ? ", new: C090" : ", new: C000"), std::string::npos)
        << added.errors;
    for (const char* name : {"records/C000.AT2", "records/C090.AT2"}) fs::remove(folder / name);
    fs::rename(folder / "records/B090.AT2", folder / "B090.AT2");
    const ProgramResult missing = run(arguments);
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_NE(missing.errors.find(", missing: B0"), std::string::npos) << missing.errors;
    fs::rename(folder / "B090.AT2", folder / "records/B090.AT2");
  }
}

TEST_F(ScriptStudyRun, GoesOnWithMotionsMadeInTheProgram) {
  ASSERT_EQ(run({"--out", "a", "--pulses", "3"}).exit_code, 0);
  const ProgramResult again = run({"--out", "a", "--pulses", "3"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_EQ(answer_of(file("a"), "SELECT count(DISTINCT session) FROM cases"), "1");
  // The same names, another amplitude.
  ::setenv("MOAT_TEST_AMPLITUDE", "0.5", 1);
  const ProgramResult other = run({"--out", "a", "--pulses", "3"});
  ::unsetenv("MOAT_TEST_AMPLITUDE");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.errors.find("\n  motion near-fault pulse 1 s: "), std::string::npos) << other.errors;
}

TEST_F(ScriptStudyRun, RefusesTwoStudiesOfOneName) {
  const ProgramResult result = run({"--out", "a", "--pulses", "1", "--times", "2"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.errors.find("there is a study of this name. Give every study of a script a name of its own"),
            std::string::npos)
      << result.errors;
}

TEST_F(ScriptStudyRun, GoesOnAfterAChangeThatIsAccepted) {
  write_record("r.AT2", "0.0 0.1 -0.1 0.0");
  ASSERT_EQ(run({"--out", "a", "--inside", "r.AT2", "--failing", "3"}).exit_code, 1);
  write_record("r.AT2", "0.0 0.2 -0.1 0.0");
  const std::vector<std::string> changed{"--out", "a", "--inside", "r.AT2", "--failing", "4", "--retry"};
  EXPECT_EQ(run(changed).exit_code, 1);
  std::vector<std::string> accepted = changed;
  accepted.emplace_back("--accept-changes");
  ASSERT_EQ(run(accepted).exit_code, 0) << "case 4 was computed before, and case 3 is computed now";
  ASSERT_EQ(run({"--out", "a", "--inside", "r.AT2", "--failing", "4"}).exit_code, 0) << "accepted once";
  EXPECT_EQ(answer_of(file("a"), "SELECT group_concat(number) FROM case_versions WHERE version = 1"), "3");
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM case_versions WHERE version = 0"), "39");
  EXPECT_EQ(answer_of(file("a"), "SELECT count(DISTINCT sha256) FROM files JOIN case_files USING (file)"), "2");
  const ProgramResult shown = study_command({"show", "a/study.db"});
  EXPECT_NE(shown.output.find("changes were accepted before this run:\n  file "), std::string::npos) << shown.output;
  EXPECT_NE(shown.output.find("option --failing: 3 -> 4"), std::string::npos) << shown.output;
  // Other axes cannot be accepted, and the message does not offer it.
  const ProgramResult other_axes = run({"--out", "a", "--gaps", "21", "--accept-changes"});
  EXPECT_EQ(other_axes.exit_code, 1);
  EXPECT_NE(other_axes.errors.find("Give another folder (--out), restore the former state"), std::string::npos)
      << other_axes.errors;
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
  const ProgramResult beyond = run({"--cases", "38:50", "--out", "q"});
  EXPECT_EQ(beyond.exit_code, 0) << beyond.errors;
  EXPECT_NE(beyond.output.find("Cases 38 to 39 are in q/study.cases_38_40.db"), std::string::npos) << beyond.output;
  for (const char* wrong : {"3:3", "5", "40:41", "a:b", "-1:3"}) {
    const ProgramResult refused = run({"--cases", wrong, "--out", "q"});
    EXPECT_EQ(refused.exit_code, 1) << wrong;
    EXPECT_NE(refused.errors.find("is not allowed"), std::string::npos) << refused.errors;
  }
}

TEST_F(ScriptStudyRun, SaysHowLongItTookAndHowMuchMemory) {
  const std::vector<std::string> arguments{"--out", "a", "--gaps", "3", "--threads", "1"};
  const ProgramResult first = run(arguments);
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  const std::regex cost{"\n6 cases in [0-9.e-]+ s on 1 thread; largest memory ([0-9]+) MB\n"};
  std::smatch found;
  ASSERT_TRUE(std::regex_search(first.output, found, cost)) << first.output;
  EXPECT_GE(std::stoi(found[1]), 1);
  EXPECT_EQ(run(arguments).output.find("largest memory"), std::string::npos) << "nothing was computed";
}

TEST_F(ScriptStudyRun, ASuiteHasStatisticsFloorSpectraClearancesAndLoops) {
  const ProgramResult result = run({"--suite", "2", "--out", "a"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("Results: a/  (report.html, suite.csv, suite.db, suite_statistics.csv, "
                               "suite_floor_spectra.csv)"),
            std::string::npos)
      << result.output;
  EXPECT_TRUE(text_of(folder / "a/suite_floor_spectra.csv")
                  .starts_with("floor,place,direction,group,damping [1],period [s],mean [m/s^2],"))
      << text_of(folder / "a/suite_floor_spectra.csv");
  EXPECT_TRUE(fs::exists(folder / "a/suite_statistics.csv"));
  EXPECT_TRUE(fs::exists(folder / "a/pictures/suite_clearance_left.svg"));
  std::size_t loops = 0;
  for (const fs::directory_entry& each : fs::directory_iterator{folder / "a/pictures"})
    if (each.path().extension() == ".svg" &&
        each.path().filename().string().starts_with("suite_loops_of_the_isolators"))
      ++loops;
  EXPECT_EQ(loops, 3U) << "of the lower, the nominal and the upper bound";
}

// Profiles and statistics are those of the other records.
TEST_F(ScriptStudyRun, TheFirstRecordMayFail) {
  const ProgramResult result = run({"--pulses", "3", "--failing", "0", "--out", "a"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.output.find("Results: a/"), std::string::npos) << result.output << result.errors;
  EXPECT_NE(text_of(folder / "a/report.html").find("1 have no result"), std::string::npos);
  EXPECT_NE(text_of(folder / "a/study_statistics.csv").find(",2,0,1,"), std::string::npos) << "solved, unsolved";
}

TEST_F(ScriptStudyRun, FailuresAreStatesAndCanBeRetried) {
  const ProgramResult result = run({"--failing", "3", "--stuck", "7", "--out", "a"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.errors.find("2 of 40 cases failed, 1 of them did not converge.\n  case 3, gap = "),
            std::string::npos)
      << result.errors;
  const ProgramResult shown = study_command({"show", "a/study.db"});
  EXPECT_NE(shown.output.find("of these 38 done, 1 failed, 1 not converged, 0 open"), std::string::npos)
      << shown.output;
  EXPECT_NE(shown.output.find("this case is stuck"), std::string::npos) << shown.output;
  EXPECT_NE(shown.output.find("slowest cases"), std::string::npos) << shown.output;
  ASSERT_EQ(study_command({"export", "a", "--out", "b.csv"}).exit_code, 0);
  EXPECT_EQ(text_of(folder / "b.csv"), text_of(folder / "a/study.csv"));
  EXPECT_EQ(run({"--failing", "3", "--stuck", "7", "--out", "a", "--retry"}).exit_code, 3);
  EXPECT_EQ(answer_of(file("a"), "SELECT count(DISTINCT session) FROM cases"), "2");
  EXPECT_EQ(answer_of(file("a"), "SELECT count(*) FROM cases"), "40");
}

TEST_F(ScriptStudyRun, ChecksItsOptions) {
  const ProgramResult help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* option : {"--last-gap", "--cases", "--threads", "--retry", "--record", "--accept-changes"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;
  // Files that a script reads before its study may be missing.
  ::setenv("MOAT_TEST_RECORDS", "nowhere", 1);
  const ProgramResult early = run({"--help"});
  EXPECT_EQ(run({}).exit_code, 1);
  ::unsetenv("MOAT_TEST_RECORDS");
  EXPECT_EQ(early.exit_code, 0) << early.errors;
  EXPECT_NE(early.output.find("--records"), std::string::npos) << early.output;
  EXPECT_NE(early.output.find("nowhere"), std::string::npos) << early.output;
  EXPECT_EQ(run({"--nonsense"}).exit_code, 2);
  EXPECT_EQ(run({"--gaps", "x"}).exit_code, 1);
  for (const char* wrong : {"-1", "two", "100000", "99999999999999999999"}) {
    const ProgramResult refused = run({"--threads", wrong});
    EXPECT_NE(
        refused.errors.find("--threads: \"" + std::string{wrong} + "\" is not allowed; it must be a whole number"),
        std::string::npos)
        << refused.errors;
  }
  EXPECT_NE(run({"--out", ""}).errors.find("--out: the name of the folder is empty"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "results"));
}

}  // namespace
}  // namespace moat::testing
