#include "study/file/study_sessions.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "message_of.hpp"
#include "run_program.hpp"
#include "study/file/sqlite.hpp"
#include "study/file/store.hpp"
#include "study/study_tables.hpp"

namespace moat {
namespace {

using StudySessions = testing::InTemporaryFolder;

TEST_F(StudySessions, RefuseADamagedVersion) {
  const std::filesystem::path file = folder / "study.db";
  {
    StudyStore store{file, StudyCases{{.name = "gap", .unit = "cm", .values = {10.0}}}, {{"script", "a"}}, {}};
    store.end_session("finished");
  }
  for (const std::string text : {"b", "-1", "0x", "1 ", "99999999999999999999999", "4000000000"}) {
    study_tables::set_property(sqlite::Database{file, sqlite::Database::Access::write}, "version", text);
    EXPECT_EQ(
        testing::message_of<FileError>([&] { (void)read_study(file); }),
        "study " + file.string() + ": its version is \"" + text +
            "\"; it must be a whole number. The file is damaged: restore a copy, or start again in another file.");
  }
}

}  // namespace
}  // namespace moat
