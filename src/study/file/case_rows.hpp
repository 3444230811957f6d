// Outcomes of cases as rows of the file of a study. Included by .cpp files alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "study/cases.hpp"
#include "study/file/sqlite.hpp"
#include "study/result.hpp"

namespace moat {

/// Writes cases into the tables of a study, each in a transaction of its own.
class CaseRows {
 public:
  /// Database and cases must outlive it.
  CaseRows(const sqlite::Database& database, const StudyCases& cases);

  /// Throws InputError where a file of the case has another content than for an earlier case, FileError where the case
  /// is there already or the disk is full.
  void write(std::size_t number, const CaseOutcome& outcome, std::int64_t session);
  /// Removes the cases that are not done, and those whose rows were changed.
  void forget_failures();

 private:
  void put(std::size_t number, const CaseOutcome& outcome, std::int64_t session);
  std::int64_t number_of(const FileRead& file);

  const sqlite::Database* database_;
  const StudyCases* cases_;
  sqlite::Statement row_, name_, value_, file_, known_file_, case_file_;
};

/// The rows of all cases.
struct StoredCases {
  StudyResult result;                  ///< Cases that the file lacks are open.
  std::vector<std::int64_t> sessions;  ///< That computed each case; 0 for open ones.
  std::set<std::int64_t> changed{};    ///< Cases whose rows are not those that were written.
};

namespace case_rows {

/// Throws FileError that names the cases of which a row was changed.
StoredCases read(const sqlite::Database& database, const StudyCases& cases);
/// The files that cases read, each with the content that the study goes on with.
std::vector<FileRead> files_of(const sqlite::Database& database);
/// Goes on with these contents of files; earlier cases keep theirs.
void accept_files(const sqlite::Database& database, const std::vector<FileRead>& files);

}  // namespace case_rows
}  // namespace moat
