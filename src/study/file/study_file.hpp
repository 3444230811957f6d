// The file of a study, open for writing by one process. Included by .cpp files alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "study/cases.hpp"
#include "study/file/case_rows.hpp"
#include "study/file/sqlite.hpp"

namespace moat {

/// The file FILE.lock, locked until this object or its process ends, however it ends. Removed at its orderly end.
class FileLock {
 public:
  /// Throws InputError where another process holds the lock, FileError where the file cannot be made.
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

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
  /// Differences of the axes in the file from those of the cases; nothing may be written if there are any.
  [[nodiscard]] const std::string& axis_differences() const { return axis_differences_; }
  CaseRows& rows() { return *rows_; }
  /// Throws FileError where another file or none has taken the place of this one, which has no name then: its cases are
  /// written to FILE.kept.db before.
  void require_in_its_place() const;

  /// Throws InputError with all differences.
  [[noreturn]] void refuse(const std::string& differences, bool can_be_accepted) const;

 private:
  FileLock lock_;  // first: held until the database is closed
  StudyCases cases_;
  sqlite::Database database_;
  bool is_new_ = false;
  std::filesystem::path place_;  // absolute
  std::uintmax_t inode_ = 0;     // of the file
  std::string axis_differences_;
  std::optional<CaseRows> rows_;
};

}  // namespace moat
