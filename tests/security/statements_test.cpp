// Statements of SQL are literals; values reach them as bound parameters. One file calls the library of SQLite.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>

#include "in_folder.hpp"

namespace moat {
namespace {

// Texts that are made, and prepared as a statement.
std::string made_statement_in(const std::string& source) {
  static const std::regex made{R"((prepare|\brun)\((?!R?"|schema\b)[^"\n;]*"[^\n]*|\bprepare\("[^"\n]*" *\+[^\n]*)"};
  std::smatch found;
  return std::regex_search(source, found, made) ? found.str() : "";
}

TEST(Statements, KnowTheirForms) {
  EXPECT_NE(made_statement_in("database.prepare(\"SELECT \" + name)"), "");
  EXPECT_NE(made_statement_in("database.run(std::string{\"DROP TABLE \"} + name)"), "");
  EXPECT_EQ(made_statement_in("database.prepare(\"SELECT value FROM study WHERE key = ?\")"), "");
  EXPECT_EQ(made_statement_in("row.run(i, axis.name, axis.unit);"), "");
}

TEST(Statements, AreLiterals) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{MOAT_SOURCE_DIR "/src"}) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string source = testing::read_file(entry.path());
    const bool is_door = entry.path().filename() == "sqlite.cpp";
    for (const char* call : {"sqlite3_exec", "sqlite3_prepare"})
      EXPECT_TRUE(is_door || source.find(call) == std::string::npos) << entry.path() << " calls " << call;
    if (entry.path().parent_path().filename() != "file" || is_door) continue;
    ++files;
    EXPECT_EQ(made_statement_in(source), "") << entry.path();
  }
  EXPECT_GT(files, 3);
}

}  // namespace
}  // namespace moat
