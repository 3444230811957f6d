// The results folder of a study: files of others in it, links out of it, files that disappear.

#include <gtest/gtest.h>

#include <fstream>

#include "study_runs.hpp"

namespace moat::testing {
namespace {

using StudyInFolder = StudyRuns;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream{path} << text;
}

fs::path any_picture(const fs::path& pictures) {
  for (const fs::directory_entry& each : fs::directory_iterator{pictures})
    if (each.path().extension() == ".svg") return each.path();
  return {};
}

const std::vector<std::string> in_a{"--out", "a", "--gaps", "3"};

TEST_F(StudyInFolder, ReplacesNoFileOfAnother) {
  for (const char* name : {"report.html", "study.csv", "pictures"}) {
    write(folder / "a" / name, "mine");
    const ProgramResult refused = run(in_a);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.errors.find(std::string{"a/"} + name + " was not written by a study of moat"), std::string::npos)
        << refused.errors;
    EXPECT_NE(refused.errors.find("--out"), std::string::npos) << refused.errors;
    EXPECT_EQ(text_of(folder / "a" / name), "mine");
    EXPECT_FALSE(fs::exists(file("a"))) << "nothing is computed";
    fs::remove(folder / "a" / name);
  }
  ASSERT_EQ(run(in_a).exit_code, 0);
  // Of a study that goes on too.
  for (const char* name : {"report.html", "study.csv"}) {
    const std::string own = text_of(folder / "a" / name);
    write(folder / "a" / name, "mine");
    EXPECT_EQ(run(in_a).exit_code, 1);
    EXPECT_EQ(text_of(folder / "a" / name), "mine");
    write(folder / "a" / name, own);
  }
  write(folder / "a/study.csv", "mine");
  EXPECT_EQ(study_command({"export", "a"}).exit_code, 1);
  EXPECT_EQ(text_of(folder / "a/study.csv"), "mine");
}

// Only the results say which tables a study has. Hours of computing are then not lost.
TEST_F(StudyInFolder, HasAReportWhereATableOfAnotherIsInTheWay) {
  write(folder / "a/study_statistics.csv", "mine\n");
  const ProgramResult refused = run({"--out", "a", "--pulses", "2"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.errors.find("a/study_statistics.csv is not this table"), std::string::npos) << refused.errors;
  EXPECT_EQ(text_of(folder / "a/study_statistics.csv"), "mine\n");
  EXPECT_NE(text_of(folder / "a/report.html").find("Study over its records"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "a/study.csv"));
  fs::remove(folder / "a/study_statistics.csv");
  ASSERT_EQ(run({"--out", "a", "--pulses", "2"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "a/study_statistics.csv"));
}

TEST_F(StudyInFolder, HasDesignSheets) {
  ::setenv("MOAT_TEST_SHEET", "1", 1);
  for (int i = 0; i < 2; ++i) {  // the second replaces the first
    const ProgramResult result = run(in_a);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_NE(result.output.find("gap needed: 1 m\n"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find(", design_sheet.html)"), std::string::npos) << result.output;
  }
  const std::string page = text_of(folder / "a/design_sheet.html");
  EXPECT_LT(page.find("<h2>first: a code</h2>"), page.find("<h2>second: another code</h2>"));
  EXPECT_NE(text_of(folder / "a/report.html").find("<p>gap needed: 1 m</p>"), std::string::npos);
  write(folder / "a/design_sheet.html", "mine");
  const ProgramResult refused = run(in_a);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.errors.find("a/design_sheet.html was not written by a study of moat"), std::string::npos);
  EXPECT_EQ(text_of(folder / "a/design_sheet.html"), "mine");
  ::unsetenv("MOAT_TEST_SHEET");
}

TEST_F(StudyInFolder, IsNotThatOfARun) {
  const ProgramResult ran = run_program(OBSERVER_SCRIPT, {"--out", "a", "--quiet"}, folder);
  ASSERT_TRUE(fs::exists(folder / "a/report.html")) << ran.errors;
  const std::string report = text_of(folder / "a/report.html");
  EXPECT_EQ(run(in_a).exit_code, 1);
  EXPECT_EQ(text_of(folder / "a/report.html"), report);
  EXPECT_FALSE(fs::exists(file("a")));
}

TEST_F(StudyInFolder, IsNotLeftThroughLinks) {
  write(folder / "victim/mine", "mine");
  for (const char* name : {"pictures", "report.html", "study.csv", "study.db"}) {
    fs::create_directories(folder / "a");
    const fs::path target = folder / "victim" / (std::string{name} == "pictures" ? "" : name);
    fs::create_symlink(target, folder / "a" / name);
    EXPECT_EQ(run(in_a).exit_code, 1) << name;
    EXPECT_EQ(std::distance(fs::directory_iterator{folder / "victim"}, {}), 1) << name;
    EXPECT_TRUE(fs::is_symlink(folder / "a" / name)) << name;
    fs::remove_all(folder / "a");
  }
  // A picture is replaced where it is.
  ASSERT_EQ(run(in_a).exit_code, 0);
  const fs::path picture = any_picture(folder / "a/pictures");
  fs::remove(picture);
  fs::create_symlink(folder / "victim/new", picture);
  ASSERT_EQ(run(in_a).exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "victim/new"));
  EXPECT_TRUE(fs::is_symlink(picture));
}

TEST_F(StudyInFolder, KeepsPicturesOfAnother) {
  ASSERT_EQ(run(in_a).exit_code, 0);
  const fs::path picture = any_picture(folder / "a/pictures");
  const std::string drawn = text_of(picture);
  write(picture, "mine");
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(run(in_a).exit_code, 0);
    EXPECT_EQ(text_of(picture), "mine");
    fs::path beside = picture;
    beside.replace_extension();
    EXPECT_EQ(text_of(beside.string() + "_2.svg"), drawn);
    EXPECT_FALSE(fs::exists(beside.string() + "_3.svg"));
  }
}

TEST_F(StudyInFolder, IsItsOwnAgain) {
  ASSERT_EQ(run(in_a).exit_code, 0);
  const std::string table = text_of(folder / "a/study.csv");
  fs::resize_file(folder / "a/study.csv", table.size() / 2);
  ASSERT_EQ(run(in_a).exit_code, 0);
  EXPECT_EQ(text_of(folder / "a/study.csv"), table) << "replaced";
  // The remedy of a refused study.
  fs::remove(file("a"));
  ASSERT_EQ(run({"--out", "a", "--gaps", "4"}).exit_code, 0);
  EXPECT_NE(text_of(folder / "a/study.csv"), table);
}

TEST_F(StudyInFolder, DamagedCasesAreComputedAgain) {
  ASSERT_EQ(run(in_a).exit_code, 0);
  const std::string before = contents_of(file("a"));
  answer_of(file("a"),
            "UPDATE results SET value = 2 * value WHERE number = 1 AND value > 0; "
            "DELETE FROM results WHERE number = 4");
  for (const ProgramResult& refused : {run(in_a), study_command({"show", "a"}), study_command({"export", "a"}),
                                       study_command({"merge", "b.db", "a/study.db"})}) {
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.errors.find("the results of case 1, 4 are not those that were written"), std::string::npos)
        << refused.errors;
  }
  std::vector<std::string> again = in_a;
  again.emplace_back("--retry");
  ASSERT_EQ(run(again).exit_code, 0);
  EXPECT_EQ(contents_of(file("a")), before);
  EXPECT_EQ(answer_of(file("a"), "SELECT group_concat(number) FROM cases WHERE session > 1"), "1,4");
}

TEST_F(StudyInFolder, NamesTheFilesOfRecordsThatItLeavesOut) {
  fs::create_directories(folder / "r");
  for (const char* name : {"r/A000.AT2", "r/A090.AT2", "r/A-UP.AT2", "r/B000.AT2"})
    write_record(name, "0.0 0.1 -0.1 0.0");
  write(folder / "r/notes.md", "Records of two stations.\n");
  const ProgramResult result = run({"--out", "a", "--pairs", "r"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const std::string report = text_of(folder / "a/report.html");
  for (const char* words :
       {"A-UP.AT2 is left out: its name says", "B000.AT2 is left out", "notes.md is left out", "A090.AT2 is x of"}) {
    EXPECT_NE(result.output.find(words), std::string::npos) << result.output;
    EXPECT_NE(report.find(words), std::string::npos) << words;
  }
  write_record("r/one.AT2", "0.0 0.1 -0.1 0.0");
  const ProgramResult undecided = run({"--out", "b", "--pairs", "r"});
  EXPECT_EQ(undecided.exit_code, 1);
  EXPECT_NE(undecided.errors.find("neither header nor name says whether one.AT2"), std::string::npos)
      << undecided.errors;
}

TEST_F(DisturbedStudy, SeesThatItsFileWasRemoved) {
  const RunningProgram study{STUDY_SCRIPT, {"--out", "a", "--threads", "1"}, folder};
  ASSERT_TRUE(wait_for_cases(5));
  fs::remove(file("a"));
  const ProgramResult result = study.wait();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.errors.find("the file was removed or replaced while the study ran"), std::string::npos)
      << result.errors;
  EXPECT_LT(computed_cases(), 12U) << "at the next case";
  EXPECT_GE(read_study(folder / "a/study.kept.db").result.count(CaseState::done), 4U);
}

}  // namespace
}  // namespace moat::testing
