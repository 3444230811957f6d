// Runs of the study script, and the contents of its file.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "run_program.hpp"
#include "study/file/store.hpp"

namespace moat::testing {

namespace fs = std::filesystem;

inline std::string answer_of(const fs::path& database, const char* query) {
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

/// Everything but times and places, in every bit.
inline std::string contents_of(const fs::path& file) {
  const StoredStudy study = read_study(file);
  std::ostringstream text;
  text << std::hexfloat << study.title << "\n";
  for (const auto& [name, value] : study.versions[study.current_version]) text << name << "=" << value << "\n";
  for (std::size_t number = 0; number < study.result.cases().count(); ++number) {
    const CaseOutcome outcome = study.result.outcome(number);
    text << StudyCase{study.result.cases(), number}.description() << ": " << name_of(outcome.state) << outcome.reason
         << outcome.steps;
    for (const FileRead& each : outcome.files) text << " " << each.path << " " << each.sha256;
    for (const NamedNumber& each : outcome.results)
      text << " " << each.quantity << " " << each.where << " " << each.unit << " " << each.value;
    text << "\n";
  }
  return text.str();
}

class StudyRuns : public InTemporaryFolder {
 protected:
  ProgramResult run(std::vector<std::string> arguments) const {
    return run_program(STUDY_SCRIPT, std::move(arguments), folder);
  }
  ProgramResult study_command(std::vector<std::string> arguments) const {
    return run_program(STUDY_COMMAND, std::move(arguments), folder);
  }
  fs::path file(const std::string& out) const { return folder / out / "study.db"; }
  /// The contents of a study that nothing disturbed, in another folder.
  std::string undisturbed(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--out", "undisturbed", "--quiet"});
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return contents_of(file("undisturbed"));
  }

  std::string write_record(const std::string& name, const std::string& values) const {
    std::ofstream{folder / name} << "PEER NGA STRONG MOTION DATABASE RECORD\nsynthetic\nACCELERATION TIME SERIES IN "
                                    "UNITS OF G\nNPTS= 4, DT= .1 SEC\n "
                                 << values << "\n";
    return (folder / name).string();
  }
};

/// Studies whose cases are slow and counted, so that they can be disturbed after a certain case.
class DisturbedStudy : public StudyRuns {
 protected:
  DisturbedStudy() { ::setenv("MOAT_TEST_LOG", (folder / "log").c_str(), 1); }
  ~DisturbedStudy() override { ::unsetenv("MOAT_TEST_LOG"); }

  std::size_t computed_cases() const {
    std::error_code none;
    const auto size = fs::file_size(folder / "log", none);
    return none ? 0 : size;
  }
  /// False if that does not happen within a minute.
  bool wait_for_cases(std::size_t count) const {
    for (int i = 0; i < 30000 && computed_cases() < count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds{2});
    return computed_cases() >= count;
  }
  void end_of_disturbances() { ::unsetenv("MOAT_TEST_LOG"); }
};

}  // namespace moat::testing
