// The file of a study in the folder of its user: links, other files, and removal while it is written.

#include "study/file/study_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <vector>

#include "base/error.hpp"
#include "message_of.hpp"
#include "run_program.hpp"
#include "study/file/store.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing::message_of;

class FileOfAStudy : public testing::InTemporaryFolder {
 protected:
  const StudyCases cases{{.name = "gap", .unit = "cm", .values = {1.0, 2.0, 3.0, 4.0}}};
  const fs::path place = folder / "results", file = place / "study.db";

  FileOfAStudy() { fs::create_directories(place); }
  StudyStore open() const { return {file, cases, {}, {.title = "A study"}}; }
  static CaseOutcome done(double value) { return {.state = CaseState::done, .results = {{"x", "", "1", value}}}; }
};

TEST_F(FileOfAStudy, IsKeptWhereItIsRemovedOrReplaced) {
  const auto remove = [&] { fs::remove(file); };
  const auto remove_all = [&] { fs::remove_all(place); };
  const auto replace = [&] {
    std::ofstream{place / "other"} << "of another";
    fs::rename(place / "other", file);
  };
  const auto move = [&] { fs::rename(file, folder / "moved.db"); };
  for (const std::function<void()>& disturb : std::vector<std::function<void()>>{remove, remove_all, replace, move}) {
    fs::remove_all(place);
    fs::create_directories(place);
    {
      StudyStore store = open();
      store.write(0, done(0.5));
      disturb();
      const std::string next = message_of<FileError>([&] { store.write(1, done(1.5)); });
      EXPECT_NE(next.find("study.db: the file was removed or replaced while the study ran"), std::string::npos) << next;
      EXPECT_NE(next.find((place / "study.kept.db").string()), std::string::npos) << next;
      const std::string end = message_of<FileError>([&] { store.end_session("finished"); });
      EXPECT_NE(end.find((place / "study.kept_2.db").string()), std::string::npos) << end;
    }
    for (const char* name : {"study.kept.db", "study.kept_2.db"}) {
      const StudyResult kept = read_study(place / name).result;
      EXPECT_EQ(kept.count(CaseState::done), 2U);
      EXPECT_EQ(kept.values("x", "")[1], 1.5);
    }
    if (fs::exists(file)) {
      EXPECT_EQ(testing::read_file(file), "of another");
    }
    // As the message says.
    fs::rename(place / "study.kept.db", file);
    EXPECT_EQ(open().result().state(1), CaseState::done);
  }
}

TEST_F(FileOfAStudy, IsNoLink) {
  const fs::path other = folder / "other.db";
  for (const bool exists : {true, false}) {
    if (exists)
      std::ofstream{other};
    else
      fs::remove(other);
    for (const char* name : {"study.db", "study.db.lock", "study.db-wal", "study.db-shm", "study.db-journal"}) {
      const fs::path link = place / name;
      fs::create_symlink(other, link);
      try {
        open().write(0, done(1.0));
      } catch (const Error& error) {
        EXPECT_NE(std::string{error.what()}.find("study.db"), std::string::npos) << error.what();
      }
      EXPECT_EQ(fs::exists(other), exists) << name;
      if (exists) {
        EXPECT_EQ(fs::file_size(other), 0U) << name;
      }
      fs::remove_all(place);
      fs::create_directories(place);
    }
  }
  fs::create_symlink(other, file);
  EXPECT_NE(message_of<InputError>([&] { open(); }).find("study.db: this is a link"), std::string::npos);
  const fs::path part = folder / "part.db";
  { StudyStore{part, cases, {}, {}}.write(0, done(1.0)); }
  EXPECT_NE(message_of<InputError>([&] { merge_studies(file, {part}); }).find("study.db: this is a link"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(other));
}

TEST_F(FileOfAStudy, LeavesAnotherDatabaseInEveryByte) {
  {
    const sqlite::Database other{file, sqlite::Database::Access::write};
    other.run("CREATE TABLE cases (mine)");
  }
  const std::string before = testing::read_file(file);
  EXPECT_NE(message_of<FileError>([&] { open(); }).find("this is another database"), std::string::npos);
  EXPECT_EQ(testing::read_file(file), before);
}

}  // namespace
}  // namespace moat
