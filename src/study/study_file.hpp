// The file of a study, open for writing by one process. Included by .cpp files alone.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "study/case_rows.hpp"
#include "study/cases.hpp"
#include "study/file_lock.hpp"
#include "study/sqlite.hpp"
#include "study/study_sessions.hpp"

namespace moat {

/// A database in WAL mode, locked against other processes. At its orderly end one file remains.
class StudyFile {
 public:
  /// Makes the file, or opens it. Throws as StudyStore does, except for differences.
  StudyFile(const std::filesystem::path& file, StudyCases cases, const std::string& title);
  ~StudyFile();
  StudyFile(const StudyFile&) = delete;
  StudyFile& operator=(const StudyFile&) = delete;

  [[nodiscard]] const sqlite::Database& database() const { return database_; }
  [[nodiscard]] const StudyCases& cases() const { return cases_; }
  /// Whether no process has begun to compute cases.
  [[nodiscard]] bool is_new() const { return is_new_; }
  /// Of the axes in the file from those of the cases; nothing may be written then.
  [[nodiscard]] const std::string& axis_differences() const { return axis_differences_; }
  CaseRows& rows() { return *rows_; }
  /// After a change of the files that cases read.
  void read_rows_again() { rows_ = std::make_unique<CaseRows>(database_, cases_); }

  /// Throws InputError with all differences.
  [[noreturn]] void refuse(const std::string& differences) const;

 private:
  FileLock lock_;  // first: held until the database is closed
  StudyCases cases_;
  sqlite::Database database_;
  bool is_new_ = false;
  std::string axis_differences_;
  std::unique_ptr<CaseRows> rows_;
};

/// Of this machine.
std::string host_name();

}  // namespace moat
