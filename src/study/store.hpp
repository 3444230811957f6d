// A study on disk: one SQLite file, from which it goes on after any interruption.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "study/cases.hpp"
#include "study/outcome.hpp"
#include "study/result.hpp"

namespace moat {

/// What the numbers of a study depend on besides its axes, as pairs of name and value: hashes of script, program and
/// library, options of the script.
using StudyIdentity = std::vector<std::pair<std::string, std::string>>;

/// Where and by whom cases are computed.
struct StudySession {
  std::string title{};
  std::string command_line{};
  std::string moat_version{};
  std::string git_commit{};
  std::string date{};    ///< UTC
  std::string engine{};  ///< "2 threads", "4 ranks"
};

/// A study in a file. Every case is written when it ends, in a transaction of its own: after `kill -9` at any moment
/// the file holds all cases that had ended. After a power cut it may lack those of the last seconds; what it has is
/// whole. The empty file FILE.lock beside it keeps a second process away. Tables:
///
///     study          key, value: title, number of cases, and the identity as "identity.script" ...
///     axes           axis, name, unit, cases_group      axis_values   axis, position, value, label, sha256
///     sessions       session, date, command, moat_version, git_commit, engine, host
///     records        path, sha256
///     cases          number, parameters (JSON), state, reason, record, steps, energy_error, seconds, session
///     result_names   result, quantity, place, unit          results   number, position, result, value (NULL: NaN)
///     case_results   view: number, quantity, place, unit, value
class StudyStore {
 public:
  /// Creates the file, or goes on with it. Throws InputError, naming every difference, where the file holds a study of
  /// other axes, another identity or records that have changed since, and where another process computes it now;
  /// FileError where the file cannot be read or written, or is no study.
  StudyStore(const std::filesystem::path& file, const StudyCases& cases, const StudyIdentity& identity,
             const StudySession& session);
  ~StudyStore();
  StudyStore(const StudyStore&) = delete;
  StudyStore& operator=(const StudyStore&) = delete;

  /// One for every case; those that are missing are open.
  [[nodiscard]] std::vector<CaseOutcome> outcomes() const;
  /// Throws FileError, with all earlier cases intact, where the disk is full.
  void write(std::size_t number, const CaseOutcome& outcome);
  /// Removes the cases that failed or did not converge, so that they are computed again.
  void forget_failures();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A study as it is in its file, for reading.
struct StoredStudy {
  std::vector<std::pair<std::string, std::string>> properties;  ///< of the table `study`
  std::vector<StudySession> sessions;
  StudyResult result;
};
/// Throws FileError where the file cannot be read or is no study.
StoredStudy read_study(const std::filesystem::path& file);

/// Puts the cases of parts into one study, a new file or one that holds the same study. A case that several files have
/// must be equal in all. Throws InputError where the studies differ, FileError as above.
void merge_studies(const std::filesystem::path& into, const std::vector<std::filesystem::path>& parts);

}  // namespace moat
