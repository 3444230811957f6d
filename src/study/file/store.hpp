// A study on disk: one SQLite file, from which it goes on after any interruption.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "study/cases.hpp"
#include "study/outcome.hpp"
#include "study/result.hpp"

namespace moat {

/// The inputs of the numbers of a study besides its axes, by their names: hashes of script, program, library and
/// files, options of the script.
using StudyIdentity = std::map<std::string, std::string>;

/// The identity with the hashes behind the values of axes: "record KBU000".
StudyIdentity with_hashes_of_axes(StudyIdentity identity, const StudyCases& cases);

/// One line for each difference, empty if there is none:
///
///     script: 3f2a... -> 77b1...
std::string differences(const StudyIdentity& before, const StudyIdentity& now);

/// Differences of names, units, values and labels.
std::string differences(const StudyCases& before, const StudyCases& now);

/// Where and by whom cases are computed.
struct StudySession {
  std::string title{};         ///< of the study
  std::string command_line{};  ///< that started it
  std::string moat_version{};  ///< that computes
  std::string git_commit{};    ///< of the library
  std::string date{};          ///< UTC
  std::string engine{};        ///< "2 threads", "4 ranks"
};

/// A session as it is in the file of a study.
struct StoredSession : StudySession {
  std::string host{};  ///< name of the machine
  /// "finished", "stopped by SIGINT", "part 0:100 finished"; empty while it runs, and where it was killed.
  std::string ending{};
  std::size_t version = 0;  ///< index of its StudyIdentity
  std::size_t cases = 0;    ///< that it computed, and no later session again
};

/// Whether a study goes on although something changed on which its numbers depend.
enum class StudyChanges {
  refuse,  ///< with an InputError that names them
  accept   ///< earlier cases stay; the file knows which version computed each case
};

/// A study in a file. Every case is written when it ends, in a transaction of its own: after `kill -9` at any moment
/// the file holds all cases that had ended. After a power cut it may lack those of the last seconds; all others are
/// whole. While a study runs, FILE-wal and FILE-shm belong to it, and FILE.lock keeps a second process away; at an
/// orderly end FILE alone remains. Tables:
///
///     study          key, value: title, number of cases, current version
///     axes           axis, name, unit, cases_group      axis_values   axis, position, value, label
///     versions       version, name, value: the inputs of the numbers
///     sessions       session, date, command, moat_version, git_commit, engine, host, version, ending
///     cases          number, parameters (JSON), state, reason, steps, energy_error, seconds, session, checksum
///     files          file, path, sha256                 case_files    number, file
///     result_names   result, quantity, place, unit      results       number, position, result, value (NULL: NaN)
///     case_results   view: number, quantity, place, unit, value
///     case_versions  view: number, version, session, date, moat_version, git_commit
///
/// The checksum of a case is of all that its rows hold, and is compared whenever they are read: FileError names the
/// cases that were changed or damaged.
class StudyStore {
 public:
  /// Creates the file, or goes on with it. Throws InputError
  ///
  ///   - where the file holds a study of other axes,
  ///   - where the identity, the hash of an axis value or a file that a case has read has changed, or such a file is
  ///     missing, unless changes are accepted,
  ///   - where another process computes the study now.
  ///
  /// The first two name every difference. Throws FileError where the file cannot be read or written, or is no study.
  StudyStore(const std::filesystem::path& file, const StudyCases& cases, const StudyIdentity& identity,
             const StudySession& session, StudyChanges changes = StudyChanges::refuse);
  ~StudyStore();
  StudyStore(const StudyStore&) = delete;
  StudyStore& operator=(const StudyStore&) = delete;

  /// The results of all cases up to now; those that are missing are open. Throws FileError for cases that were changed.
  [[nodiscard]] StudyResult result() const;
  /// Throws FileError, with all earlier cases intact, where the disk is full; InputError where a file that the case has
  /// read differs from that of an earlier case. FileError where the file was removed or replaced meanwhile;
  /// FILE.kept.db has all cases then.
  void write(std::size_t number, const CaseOutcome& outcome);
  /// Removes the cases that failed or did not converge, or were changed, so that they are computed again.
  void forget_failures();
  /// How this session ended: "finished", "stopped by SIGINT". Throws as write().
  void end_session(const std::string& ending);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A study as it is in its file, for reading.
struct StoredStudy {
  std::string title;                    ///< Title of the script.
  std::vector<StudyIdentity> versions;  ///< All versions that computed cases.
  std::size_t current_version = 0;      ///< Index of the last one.
  std::vector<StoredSession> sessions;  ///< The runs that computed it.
  /// The session that computed each case; 0 is the first. Of no meaning for open cases.
  std::vector<std::size_t> session_of_case;
  StudyResult result;  ///< Results of all cases up to now.
};
/// Throws FileError where the file cannot be read or is no study.
StoredStudy read_study(const std::filesystem::path& file);

/// Puts the cases of parts into one study, a new file or one that holds the same study. A case that several files have
/// must be equal in all. Throws InputError where the studies differ, FileError as above; nothing is written then.
void merge_studies(const std::filesystem::path& into, const std::vector<std::filesystem::path>& parts);

}  // namespace moat
